/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Column generation. The program of a round is
 *
 *     maximise o . x  subject to  T x = b,  x >= 0
 *
 * with a column for every force and one for t; rows are turned so that b >= 0. Slacks measure by
 * how much a row is not met: first their sum is brought to zero, then the aim is climbed. The dual
 * y with y . T_j >= o_j is the twist; where the rows cannot be met it is that of the sum of slacks,
 * for which y . b < 0. */

#include "solid_contacts/hold_search.h"

#include "contact_modes/dense_program.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AROUND = 8, ROUNDS = 80, ROWS = TP_WRENCH + 1 };

/* Of forces with a normal part of one: those as near to one that is there change a hull by its
 * square. And what is zero. */
static const double nearest = 3e-8, nothing = 1e-10, enough = 1e-6;

/* ---- forces ------------------------------------------------------------------------------------
 */

static bool add_force(tp_hold_search *s, long cone, const double force[3]) {
  if (s->count == s->room) {
    const long room = s->room > 0 ? 2 * s->room : (AROUND + 4) * s->cones->count + 16;
    tp_cone_force *own = realloc(s->forces, (size_t)room * sizeof *own);
    if (own == NULL) return false;
    s->forces = own;
    s->room = room;
  }
  tp_cone_force *own = s->forces + s->count++;
  own->cone = cone;
  memcpy(own->force, force, sizeof own->force);
  tp_friction_cone_column(own->column, s->cones->cones + cone, force);
  return true;
}

/* The normal, and some about it on the cone. */
static bool add_first(tp_hold_search *s, long cone, double turn) {
  const tp_friction_cone *own = s->cones->cones + cone;
  double side[3] = {0}, force[3];
  int least = 0;
  for (int k = 1; k < 3; k++) least = fabs(own->unit[k]) < fabs(own->unit[least]) ? k : least;
  side[least] = 1;
  if (!add_force(s, cone, own->unit)) return false;
  if (tp_near_is_zero(own->friction)) return true;
  for (int k = 0; k < AROUND; k++) {
    const int i = (least + 1) % 3, j = (least + 2) % 3;
    side[least] = cos(turn + 2 * M_PI * k / AROUND);
    side[i] = sin(turn + 2 * M_PI * k / AROUND);
    side[j] = 0;
    (void)tp_friction_cone_worst(force, own, side, s->friction);
    if (!add_force(s, cone, force)) return false;
  }
  return true;
}

bool tp_hold_search_init(tp_hold_search *search, const tp_friction_cones *cones, double friction,
                         double turn) {
  *search = (tp_hold_search){.cones = cones, .friction = friction};
  for (long n = 0; n < cones->count; n++) {
    if (!add_first(search, n, turn)) return false;
  }
  return true;
}

void tp_hold_search_clear(tp_hold_search *search) {
  free(search->forces);
  *search = (tp_hold_search){.count = 0};
}

static bool is_there(const tp_hold_search *s, long cone, const double force[3]) {
  for (long k = s->count - 1; k >= 0; k--) {
    const double *own = s->forces[k].force;
    if (s->forces[k].cone != cone) continue;
    const double x = own[0] - force[0], y = own[1] - force[1], z = own[2] - force[2];
    if (x * x + y * y + z * z < nearest * nearest) return true;
  }
  return false;
}

/* Of each cone the force that the twist does most against, where that is less than `least`. */
static bool add_worst(long *added, tp_hold_search *s, const double twist[TP_WRENCH], double least) {
  *added = 0;
  for (long n = 0; n < s->cones->count; n++) {
    double motion[3], force[3];
    tp_friction_cone_motion(motion, s->cones->cones + n, twist);
    const double gain = tp_friction_cone_worst(force, s->cones->cones + n, motion, s->friction);
    if (gain >= least || is_there(s, n, force)) continue;
    if (!add_force(s, n, force)) return false;
    ++*added;
  }
  return true;
}

/* ---- the program of a round --------------------------------------------------------------------
 */

typedef struct question {
  tp_hold_aim aim;
  double target[TP_WRENCH]; /* b */
  double extra[TP_WRENCH];  /* the column of t */
  double sign[TP_WRENCH];   /* of rows that were turned */
} question;

static void set_question(question *q, const tp_hold_search *s, tp_hold_aim aim,
                         const double load[3], const double way[3]) {
  double normals[TP_WRENCH] = {0}, own[TP_WRENCH];
  *q = (question){.aim = aim};
  for (long n = 0; n < s->cones->count; n++) {
    tp_friction_cone_column(own, s->cones->cones + n, s->cones->cones[n].unit);
    for (int r = 0; r < TP_WRENCH; r++) normals[r] += own[r];
  }
  for (int r = 0; r < TP_WRENCH; r++) {
    q->target[r] = aim == TP_HOLD_APART ? normals[r] / (double)s->cones->count
                   : r < 3              ? -load[r]
                                        : 0;
    q->extra[r] = aim == TP_HOLD_DEEPEST             ? normals[r]
                  : aim == TP_HOLD_FARTHEST && r < 3 ? way[r]
                                                     : 0;
    q->sign[r] = q->target[r] < 0 ? -1 : 1;
  }
}

static void set_column(tp_dense_program *p, const question *q, long column,
                       const double entries[TP_WRENCH]) {
  double sum = 0;
  for (int r = 0; r < TP_WRENCH; r++) {
    const double own = q->sign[r] * entries[r];
    *tp_dense_program_entry(p, r, column) = own;
    sum += own;
  }
  *tp_dense_program_entry(p, ROWS, column) = sum; /* of all slacks */
}

static bool set_program(tp_dense_program *p, const question *q, const tp_hold_search *s) {
  if (!tp_dense_program_init(p, ROWS, s->count + 1)) return false;
  for (long k = 0; k < s->count; k++) {
    set_column(p, q, k, s->forces[k].column);
    if (q->aim == TP_HOLD_APART) *tp_dense_program_entry(p, ROWS + 1, k) = 1;
  }
  set_column(p, q, s->count, q->extra);
  *tp_dense_program_entry(p, TP_WRENCH, s->count) = q->aim == TP_HOLD_DEEPEST;
  *tp_dense_program_entry(p, ROWS + 1, s->count) = q->aim != TP_HOLD_APART;
  for (int r = 0; r < TP_WRENCH; r++) {
    *tp_dense_program_right(p, r) = fabs(q->target[r]);
    p->exact[r] = true;
  }
  *tp_dense_program_right(p, TP_WRENCH) = 1;
  return true;
}

/* By how much rows are not met. */
static double unmet(const tp_dense_program *p) {
  double sum = 0;
  for (long r = 0; r < p->rows; r++) {
    const long variable = p->basic[r] - p->columns;
    if (variable >= 0 && p->exact[variable])
      sum += fabs(p->entries[r * (p->columns + 1) + p->columns]);
  }
  return sum;
}

/* ---- its basis ---------------------------------------------------------------------------------
 */

/* What ends a round, solved for anew: pivots of the program may have been small. */
typedef struct basis {
  double columns[ROWS][ROWS]; /* column k of the basis: columns[k] */
  double costs[ROWS];
} basis;

/* Of the first objective, where slacks cost one, or of the second. */
static void set_basis(basis *b, const tp_dense_program *p, const question *q,
                      const tp_hold_search *s, int objective) {
  *b = (basis){.costs = {0}};
  for (int k = 0; k < ROWS; k++) {
    const long own = p->basic[k];
    double *column = b->columns[k];
    if (own > s->count) { /* a slack */
      column[own - p->columns] = 1;
      b->costs[k] = objective == 0 && p->exact[own - p->columns] ? -1 : 0;
      continue;
    }
    const double *entries = own < s->count ? s->forces[own].column : q->extra;
    for (int r = 0; r < TP_WRENCH; r++) column[r] = q->sign[r] * entries[r];
    column[TP_WRENCH] = own == s->count && q->aim == TP_HOLD_DEEPEST;
    if (objective == 0) continue;
    b->costs[k] = (q->aim == TP_HOLD_APART) == (own < s->count);
  }
}

/* rows[i] . x = right[i], by elimination with pivots; false: singular. */
static bool solve_rows(double x[ROWS], double rows[ROWS][ROWS], double right[ROWS]) {
  for (int k = 0; k < ROWS; k++) {
    int best = k;
    for (int i = k + 1; i < ROWS; i++) best = fabs(rows[i][k]) > fabs(rows[best][k]) ? i : best;
    if (!(fabs(rows[best][k]) > 0)) return false;
    for (int j = 0; j < ROWS && best != k; j++) {
      const double own = rows[k][j];
      rows[k][j] = rows[best][j];
      rows[best][j] = own;
    }
    const double own = right[k];
    right[k] = right[best];
    right[best] = best != k ? own : right[k];
    for (int i = k + 1; i < ROWS; i++) {
      const double factor = rows[i][k] / rows[k][k];
      for (int j = k; j < ROWS; j++) rows[i][j] -= factor * rows[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (int k = ROWS - 1; k >= 0; k--) {
    x[k] = right[k];
    for (int j = k + 1; j < ROWS; j++) x[k] -= rows[k][j] * x[j];
    x[k] /= rows[k][k];
  }
  return true;
}

static bool set_twist(double twist[TP_WRENCH], const basis *b, const question *q) {
  double rows[ROWS][ROWS], right[ROWS], dual[ROWS];
  memcpy(rows, b->columns, sizeof rows);
  memcpy(right, b->costs, sizeof right);
  if (!solve_rows(dual, rows, right)) return false;
  for (int r = 0; r < TP_WRENCH; r++) twist[r] = q->sign[r] * dual[r];
  return true;
}

static bool set_forces(tp_hold_answer *answer, const basis *b, const tp_dense_program *p,
                       const tp_hold_search *s, const question *q) {
  double rows[ROWS][ROWS], right[ROWS], x[ROWS];
  for (int r = 0; r < ROWS; r++) {
    for (int k = 0; k < ROWS; k++) rows[r][k] = b->columns[k][r];
    right[r] = r < TP_WRENCH ? fabs(q->target[r]) : 1;
  }
  if (!solve_rows(x, rows, right)) return false;
  answer->t = 0;
  for (int k = 0; k < ROWS; k++) answer->t = p->basic[k] == s->count ? x[k] : answer->t;
  for (long n = 0; n < s->cones->count && answer->forces != NULL; n++) {
    const double own = q->aim == TP_HOLD_DEEPEST ? answer->t : 0;
    for (int i = 0; i < 3; i++) answer->forces[n][i] = own * s->cones->cones[n].unit[i];
  }
  for (int k = 0; k < ROWS && answer->forces != NULL; k++) {
    if (p->basic[k] >= s->count) continue;
    const tp_cone_force *own = s->forces + p->basic[k];
    for (int i = 0; i < 3; i++) answer->forces[own->cone][i] += fmax(0, x[k]) * own->force[i];
  }
  return true;
}

/* One round; `*least` is what forces have to gain by the twist. */
static bool solve_round(tp_hold_answer *answer, double *least, const tp_hold_search *s,
                        const question *q) {
  tp_dense_program p;
  if (!set_program(&p, q, s)) return false;
  basis b;
  *least = q->aim == TP_HOLD_APART ? 0.5 : 0;
  bool told = tp_dense_program_climb(&p, 0);
  if (told && unmet(&p) > nothing) {
    answer->outcome = TP_HOLD_NONE;
    *least = 0;
    set_basis(&b, &p, q, s, 0);
    told = set_twist(answer->twist, &b, q);
  } else if (told) {
    answer->outcome = tp_dense_program_climb(&p, 1) ? TP_HOLD_FOUND : TP_HOLD_ENDLESS;
    set_basis(&b, &p, q, s, 1);
    told = set_twist(answer->twist, &b, q) && set_forces(answer, &b, &p, s, q);
  }
  if (!told) answer->outcome = TP_HOLD_STUCK;
  tp_dense_program_clear(&p);
  return true;
}

bool tp_hold_find(tp_hold_answer *answer, tp_hold_search *search, tp_hold_aim aim,
                  const double load[3], const double way[3]) {
  question q;
  set_question(&q, search, aim, load, way);
  for (int round = 0; round < ROUNDS; round++) {
    double least;
    long added;
    if (!solve_round(answer, &least, search, &q)) return false;
    const bool ended = answer->outcome == TP_HOLD_STUCK || answer->outcome == TP_HOLD_ENDLESS;
    const bool deep =
        aim == TP_HOLD_DEEPEST && answer->outcome == TP_HOLD_FOUND && answer->t > enough;
    if (ended || deep) return true;
    if (!add_worst(&added, search, answer->twist, least)) return false;
    if (added == 0) return true;
  }
  return true;
}
