/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A tolerance of the contact decides which corners bear. A factor of safety is a step function of
 * it: 1.24 to 1.25 at distances up to 0.05 m and 1.78 at 0.09 m, where one more corner becomes a
 * support. Half of the distance is compared, which a user who measured to that distance accepts
 * just as well. */

#include "stability/half_tolerance.h"

#include "common/notes.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Results that differ by less than this share of the larger one are alike. */
static const double alike = 0.01;

enum { DIFFERENCE = 200 };

static bool differ(double one, double other) {
  return fabs(one - other) > alike * fmax(fabs(one), fabs(other));
}

const char *tp_caution_fos(char out[TP_NUMBER_SIZE], const tp_case *own) {
  const tp_fos *fos = &own->governing_fos.fos;
  switch (fos->state) {
  case TP_FOS_NUMBER:
    return tp_text_fixed_down(out, fos->value, 3);
  case TP_FOS_NO_OVERTURNING:
    return "unbounded";
  case TP_FOS_UNDEFINED:
    return "none";
  default:
    return "undecided";
  }
}

/* What is different in a direction; empty if nothing is. */
static void tell_difference(char text[DIFFERENCE], const tp_case *own, const tp_case *half) {
  const tp_fos *fos = &own->governing_fos.fos, *other = &half->governing_fos.fos;
  const char *towards = tp_direction_name(own->towards);
  char n[2][TP_NUMBER_SIZE];
  text[0] = '\0';
  if (own->mechanism != half->mechanism) {
    snprintf(text, DIFFERENCE, "towards the %s the block %s, and not: it %s", towards,
             tp_mechanism_name(half->mechanism), tp_mechanism_name(own->mechanism));
  } else if (fos->state != other->state ||
             (fos->state == TP_FOS_NUMBER && differ(fos->value.value, other->value.value))) {
    snprintf(text, DIFFERENCE, "towards the %s the factor of safety is %s, and not %s", towards,
             tp_caution_fos(n[0], half), tp_caution_fos(n[1], own));
  } else if (own->has_first_angle && half->has_first_angle &&
             differ(own->first_angle_deg.value, half->first_angle_deg.value)) {
    snprintf(text, DIFFERENCE, "towards the %s it begins to move at %s°, and not at %s°", towards,
             tp_text_fixed_down(n[0], half->first_angle_deg, 2),
             tp_text_fixed_down(n[1], own->first_angle_deg, 2));
  }
}

static tp_status compare(tp_solution *solution, const tp_solution *half, tp_place place,
                         tp_message *message) {
  for (size_t k = 0; k < solution->case_count && k < half->case_count; k++) {
    char difference[DIFFERENCE];
    tell_difference(difference, solution->cases + k, half->cases + k);
    if (difference[0] == '\0') continue;
    return tp_notes_add(&solution->notes, message, TP_CAUTION, place,
                        "the answer depends on this distance: with half of it %s", difference);
  }
  return TP_OK;
}

tp_status tp_half_tolerance_check(tp_solution *solution, const tp_scene *scene,
                                  const tp_solve_options *options, tp_half_tolerance_solve *solve,
                                  tp_message *message) {
  const tp_quantity *within = &scene->base.within;
  if (!within->given) return TP_OK;
  tp_scene half = *scene; /* borrows all but the distance */
  half.base.all_poses = false;
  fmpq_init(half.base.within.value);
  fmpq_div_2exp(half.base.within.value, within->value, 1);
  tp_solution *other = NULL;
  tp_message why = {.text = ""};
  tp_status status = solve(&other, &half, options, &why);
  fmpq_clear(half.base.within.value);
  if (status == TP_OK) {
    status = compare(solution, other, within->place, message);
    tp_solution_free(other);
    return status;
  }
  if (status == TP_OUT_OF_MEMORY) {
    if (message != NULL) *message = why;
    return status;
  }
  return tp_notes_add(&solution->notes, message, TP_CAUTION, within->place,
                      "with half of this distance there is no answer to compare with");
}
