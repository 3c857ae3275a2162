/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of unknowns times enclosed numbers, and a constant each, one after another. */

#ifndef TP_CONTACT_MODES_LINEAR_FORMS_H
#define TP_CONTACT_MODES_LINEAR_FORMS_H

#include "number/near.h"
#include "topple_basics.h"

#include <stddef.h>

typedef struct tp_linear_form {
  tp_near constant;
  long first, end; /* its terms; an unknown may be in several */
} tp_linear_form;

typedef struct tp_linear_forms {
  long count, room, term_count, term_room;
  tp_linear_form *forms;
  long *unknown;
  tp_near *factor;
  bool failed; /* memory is exhausted */
} tp_linear_forms;

void tp_linear_forms_clear(tp_linear_forms *forms);
void tp_linear_forms_begin(tp_linear_forms *forms, tp_near constant);
/* To the last one. Exact zeros are left out, and unknowns below 0, which there are not. */
void tp_linear_forms_add(tp_linear_forms *forms, long unknown, tp_near factor);
void tp_linear_forms_add_constant(tp_linear_forms *forms, tp_near constant);

tp_near tp_linear_forms_value(const tp_linear_forms *forms, long form, const double *unknowns);

#endif
