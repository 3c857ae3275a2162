/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Room for terms and forms doubles as they are added. */

#include "contact_modes/linear_forms.h"

#include <stdlib.h>
#include <string.h>

void tp_linear_forms_clear(tp_linear_forms *f) {
  free(f->forms);
  free(f->unknown);
  free(f->factor);
  memset(f, 0, sizeof *f);
}

void tp_linear_forms_begin(tp_linear_forms *f, tp_near constant) {
  enum { FIRST_ROOM = 256 };
  if (f->count == f->room && !f->failed) {
    const long room = f->room == 0 ? FIRST_ROOM : 2 * f->room;
    tp_linear_form *more = realloc(f->forms, (size_t)room * sizeof *more);
    f->failed = more == NULL;
    if (!f->failed) {
      f->forms = more;
      f->room = room;
    }
  }
  if (f->failed) return;
  f->forms[f->count++] = (tp_linear_form){constant, f->term_count, f->term_count};
}

static void make_room(tp_linear_forms *f) {
  enum { FIRST_ROOM = 4096 };
  const long room = f->term_room == 0 ? FIRST_ROOM : 2 * f->term_room;
  long *unknown = realloc(f->unknown, (size_t)room * sizeof *unknown);
  if (unknown != NULL) f->unknown = unknown;
  tp_near *factor = realloc(f->factor, (size_t)room * sizeof *factor);
  if (factor != NULL) f->factor = factor;
  f->failed = unknown == NULL || factor == NULL;
  if (!f->failed) f->term_room = room;
}

void tp_linear_forms_add(tp_linear_forms *f, long unknown, tp_near factor) {
  if (unknown < 0 || tp_near_is_zero(factor)) return;
  if (f->term_count == f->term_room && !f->failed) make_room(f);
  if (f->failed) return;
  f->unknown[f->term_count] = unknown;
  f->factor[f->term_count++] = factor;
  f->forms[f->count - 1].end = f->term_count;
}

void tp_linear_forms_add_constant(tp_linear_forms *f, tp_near constant) {
  if (f->failed) return;
  tp_near *sum = &f->forms[f->count - 1].constant;
  *sum = tp_near_plus(*sum, constant);
}

tp_near tp_linear_forms_value(const tp_linear_forms *f, long form, const double *unknowns) {
  const tp_linear_form *of = f->forms + form;
  tp_near sum = of->constant;
  for (long k = of->first; k < of->end; k++) {
    const tp_near unknown = {unknowns[f->unknown[k]], 0};
    sum = tp_near_plus(sum, tp_near_times(f->factor[k], unknown));
  }
  return sum;
}
