/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Locked-in stresses of the scene given to all contacts on the facet that each names. */

#include "tilt/tractions.h"

#include "common/message.h"

#include <stdlib.h>

static const double pa_per_kpa = 1e3;

static double pascal(const tp_quantity *kpa) {
  return pa_per_kpa * fmpq_get_d(kpa->value);
}

/* To all of the contact on its facet; false where there is none. Ends of facets follow each other,
 * points stand alone. */
static bool put(tp_path_traction *tractions, const tp_rigid_body *body,
                const tp_traction_description *given) {
  bool found = false;
  long k = 0;
  for (tp_path_traction *own = tractions; k < body->closed_count; own++) {
    const tp_closed_point *end = body->closed + k;
    k += end->share_m == 0 ? 1 : 2;
    if (end->facet != given->facet) continue;
    *own = (tp_path_traction){pascal(&given->first_kpa), pascal(&given->last_kpa),
                              pascal(&given->shear_kpa)};
    found = true;
  }
  return found;
}

tp_status tp_tilt_tractions_of(tp_path_traction **tractions, const tp_rigid_body *body,
                               const tp_tilt_test_description *test, tp_message *message) {
  if (test->traction_count == 0) return TP_OK;
  tp_path_traction *own = calloc((size_t)body->closed_count + 1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the tractions");
  for (long k = 0; k < test->traction_count; k++) {
    const tp_traction_description *given = test->tractions + k;
    if (put(own, body, given)) continue;
    free(own);
    return tp_refuse(message, TP_FAULT_GEOMETRY, given->place,
                     "no stress can be locked in on facet %ld: none of the block rests on it",
                     given->facet);
  }
  *tractions = own;
  return TP_OK;
}
