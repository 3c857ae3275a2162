/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A force that acts at the centroid, exactly and in doubles. */

#ifndef TP_SOLID_CONTACTS_HOLD_LOAD_H
#define TP_SOLID_CONTACTS_HOLD_LOAD_H

#include "solid_contacts/friction_cones.h"

/* The number that a double is. */
void tp_hold_double(fmpq_t number, double value);

typedef struct tp_hold_load {
  fmpq exact[3];
  double error[3]; /* of the exact numbers: by which the true ones may differ, at most */
  tp_near near[3];
  double nearest[3];
} tp_hold_load;

void tp_hold_load_init(tp_hold_load *load);
void tp_hold_load_settle(tp_hold_load *load); /* the doubles by the exact numbers */
void tp_hold_load_clear(tp_hold_load *load);

/* What a twist gains on a load. */
tp_near tp_hold_gain(const double twist[TP_WRENCH], const tp_hold_load *load);

#endif
