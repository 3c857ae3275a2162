/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rounds of linear programs with under-relaxed normal forces. They have settled where the factors
 * of the last rounds differ by little; where they still wander after all rounds, but not far, the
 * mean is an estimate too. */

#include "block_system/undilated.h"

#include "assemblage/constant_shear.h"
#include "block_system/state_limits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LAST = 8, FEW = 4, MOST_ROUNDS = 60 };

typedef struct rounds {
  const tp_undilated_task *task;
  long contact_count;
  double *normals; /* by contact: compression plus tensile strength, in units of its columns */
  double *shear;   /* and the strength against shear that follows from it */
  double *nothing;
  tp_contact_strength *none;
  double factors[LAST];   /* of the last rounds, in turn */
  tp_force_program loads; /* without strengths, of which the loads are taken; where they are live */
} rounds;

/* ---- where rounds begin ------------------------------------------------------------------------
 */

static void take_normals(rounds *r, const tp_force_program *p, const double *forces,
                         double divisor) {
  const tp_assemblage *a = &r->task->system->assemblage;
  for (long k = 0; k < r->contact_count; k++) {
    const tp_near tangent = tp_built_system_strength(r->task->system, k, divisor).tangent;
    const int exponent = tp_contact_frame_of(a, k, (tp_near){0, 0}).exponent;
    const int of_cone = tp_contact_frame_of(a, k, tangent).exponent;
    r->normals[k] = ldexp(tp_constant_shear_normal(p, forces, k), exponent - of_cone);
  }
}

/* Forces of the program with friction at its greatest load. */
static tp_status begin(bool *is_known, rounds *r, tp_message *message) {
  const tp_undilated_task *t = r->task;
  const tp_bracket_aim aim = {.share = 1e-4, .bound_alone = true, .enough = INFINITY};
  tp_force_program p;
  tp_load_bracket b = {.forces = NULL};
  tp_status status = tp_built_system_program(&p, t->system, t->loads, t->divisor, message);
  if (status != TP_OK) return status;
  if (t->forces == NULL) status = tp_load_bracket_find(&b, &p, &aim, message);
  *is_known = status == TP_OK && (t->forces != NULL || b.is_bounded);
  if (*is_known) take_normals(r, &p, t->forces != NULL ? t->forces : b.forces, t->divisor);
  tp_load_bracket_clear(&b);
  tp_force_program_clear(&p);
  return status;
}

/* ---- one round ---------------------------------------------------------------------------------
 */

static void set_shear(rounds *r) {
  const tp_built_system *s = r->task->system;
  for (long k = 0; k < r->contact_count; k++) {
    const tp_contact_strength *strength = s->strengths + k;
    const double length = tp_contact_frame_of(&s->assemblage, k, (tp_near){0, 0}).length.value;
    r->shear[k] = strength->cohesion.value * length + strength->tangent.value * r->normals[k];
  }
}

/* All loads become live. */
static void multiply_all(tp_force_program *p, const rounds *r) {
  const tp_force_program *loads = &r->loads;
  for (long k = 0; k < p->rows; k++) {
    p->dead[k] = tp_near_minus(p->dead[k], loads->dead[k]);
    p->live[k] = tp_near_plus(loads->dead[k], tp_near_times(r->task->live, loads->live[k]));
  }
}

static tp_status init_program(tp_force_program *p, rounds *r, tp_message *message) {
  const tp_undilated_task *t = r->task;
  set_shear(r);
  const tp_status status = tp_constant_shear_program(
      p, &t->system->assemblage, t->system->strengths, r->shear, t->loads, message);
  if (status == TP_OK && !t->on_driving) multiply_all(p, r);
  return status;
}

/* Towards the normal forces of the solution; of multiplied loads they are multiplied too. */
static void relax(rounds *r, const tp_force_program *p, const tp_load_bracket *b) {
  static const double share = 0.3;
  const double multiple = r->task->on_driving ? 1 : b->bound;
  for (long k = 0; k < r->contact_count; k++) {
    const double normal = tp_constant_shear_normal(p, b->forces, k) / multiple;
    r->normals[k] += share * (normal - r->normals[k]);
  }
}

/* A factor above zero, or zero where there is none. */
static tp_status go_round(double *factor, rounds *r, tp_message *message) {
  const tp_bracket_aim aim = {.share = 1e-4, .bound_alone = true, .enough = INFINITY};
  tp_force_program p;
  tp_load_bracket b;
  *factor = 0;
  tp_status status = init_program(&p, r, message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(&b, &p, &aim, message);
  if (status == TP_OK) {
    if (b.is_settled && b.is_bounded && b.bound > 0 && b.bound < TP_MOST_FACTOR) {
      *factor = b.bound;
      relax(r, &p, &b);
    }
    tp_load_bracket_clear(&b);
  }
  tp_force_program_clear(&p);
  return status;
}

/* ---- rounds ------------------------------------------------------------------------------------
 */

/* The mean of so many. */
static void take_last(tp_undilated *result, const rounds *r, int count) {
  double least = INFINITY, most = 0, sum = 0;
  for (int k = 1; k <= count; k++) {
    const double factor = r->factors[(result->rounds - k) % LAST];
    least = fmin(least, factor);
    most = fmax(most, factor);
    sum += factor;
  }
  result->factor = sum / count;
  result->spread = most - least;
}

/* Few rounds will do where each differs from the next by a tenth of what is allowed of eight. */
static bool is_settled(tp_undilated *result, const rounds *r) {
  static const double settled = 5e-3, soon = 3e-4;
  if (result->rounds >= FEW) {
    take_last(result, r, FEW);
    if (result->spread <= soon * result->factor) return true;
  }
  if (result->rounds < LAST) return false;
  take_last(result, r, LAST);
  return result->spread <= settled * result->factor;
}

static tp_status go_on(tp_undilated *result, rounds *r, tp_message *message) {
  static const double near_enough = 5e-2;
  tp_status status = TP_OK;
  while (status == TP_OK && result->rounds < MOST_ROUNDS) {
    double *factor = r->factors + result->rounds % LAST;
    status = go_round(factor, r, message);
    if (status != TP_OK || *factor == 0) return status;
    result->rounds++;
    result->has_factor = is_settled(result, r);
    if (result->has_factor) return TP_OK;
  }
  result->has_factor = status == TP_OK && result->spread <= near_enough * result->factor;
  return status;
}

tp_status tp_undilated_find(tp_undilated *result, const tp_undilated_task *t, tp_message *message) {
  const long count = t->system->assemblage.contact_count;
  const size_t room = (size_t)count + 1;
  memset(result, 0, sizeof *result);
  if (count > TP_MOST_UNDILATED) return TP_OK;
  rounds r = {.task = t,
              .contact_count = count,
              .normals = calloc(room, sizeof *r.normals),
              .shear = calloc(room, sizeof *r.shear),
              .nothing = calloc(room, sizeof *r.nothing),
              .none = calloc(room, sizeof *r.none)};
  bool is_known = false;
  tp_status status = TP_OK;
  if (r.normals == NULL || r.shear == NULL || r.nothing == NULL || r.none == NULL) {
    status = tp_fail_memory(message, "the forces between blocks");
  }
  if (status == TP_OK) status = begin(&is_known, &r, message);
  if (status == TP_OK && is_known && !t->on_driving) {
    status = tp_constant_shear_program(&r.loads, &t->system->assemblage, r.none, r.nothing,
                                       t->loads, message);
  }
  if (status == TP_OK && is_known) status = go_on(result, &r, message);
  if (is_known && !t->on_driving) tp_force_program_clear(&r.loads);
  free(r.normals);
  free(r.shear);
  free(r.nothing);
  free(r.none);
  return status;
}
