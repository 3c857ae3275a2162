/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Both proofs are tried of every iterate of the interior point method; the best of each are kept.
 */

#include "assemblage/load_bracket.h"

#include "assemblage/held_forces.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct proving {
  const tp_force_program *p;
  const tp_ground_tree *tree;
  tp_load_bracket *bracket;
  tp_near *lacks;  /* by row: what each block lacks for equilibrium, with all that hangs on it */
  double *stilled; /* by row: room for twists */
  const tp_bracket_aim *aim;
} proving;

/* ---- above -------------------------------------------------------------------------------------
 */

static tp_near power_of(const tp_near *wrenches, const double *twists, long rows) {
  tp_near sum = {0, 0};
  for (long r = 0; r < rows; r++) {
    sum = tp_near_plus(sum, tp_near_times(wrenches[r], (tp_near){twists[r], 0}));
  }
  return sum;
}

/* No force does work on the twists: A^T v <= 0; but for those that are bounded, of which the work
 * is added up. */
static bool opens_all(tp_near *work, const tp_force_program *p, const double *twists) {
  *work = (tp_near){0, 0};
  for (long k = 0; k < p->count; k++) {
    const tp_force_column *c = p->columns + k;
    tp_near sum = {0, 0};
    for (int side = 0; side < 2; side++) {
      if (c->row[side] >= 0) {
        sum = tp_near_plus(sum, power_of(c->entry[side], twists + c->row[side], 3));
      }
    }
    if (isfinite(c->most.value)) {
      const tp_near own = tp_near_mul(tp_near_larger(sum, (tp_near){0, 0}), c->most);
      *work = tp_near_plus(*work, own);
    } else if (!(sum.value <= -sum.error)) {
      return false;
    }
  }
  return true;
}

/* Of what is held w0 . v + s w1 . v = -f . A^T v >= -work, so that s <= (w0 . v + work) / -w1 . v.
 */
static bool find_bound(double *bound, const tp_force_program *p, const double *twists) {
  const tp_near live = tp_near_neg(power_of(p->live, twists, p->rows));
  tp_near work;
  if (tp_near_sign(live) <= 0 || !opens_all(&work, p, twists)) return false;
  const tp_near dead = tp_near_plus(power_of(p->dead, twists, p->rows), work);
  const tp_near own = tp_near_div(dead, live);
  *bound = nextafter(own.value + own.error, INFINITY);
  return isfinite(*bound);
}

/* All but the blocks that move by less than so much; false: those move by nothing already. */
static bool still(double *stilled, const double *twists, long rows, double least) {
  bool changes = false;
  for (long r = 0; r < rows; r += 3) {
    const double *own = twists + r;
    const double size = fabs(own[0]) + fabs(own[1]) + fabs(own[2]);
    changes = changes || (size < least && size > 0);
    for (int e = 0; e < 3; e++) stilled[r + e] = size < least ? 0 : own[e];
  }
  return changes;
}

/* A block that others wedge, as one between two parallel faces of ground, is at rest in every
 * collapse: no twists open its contacts, and those of iterates only come near to none. So blocks
 * that nearly rest are put at rest, by one measure of nearly after the other. Whatever is, the
 * bound is proven of the twists that this leaves. */
static bool find_bound_at_rest(double *bound, proving *s, const double *twists) {
  static const double least = 1e-14, tenth = 0.1;
  double most = 0;
  for (long r = 0; r < s->p->rows; r++) most = fmax(most, fabs(twists[r]));
  for (double share = tenth; share > least && isfinite(most); share *= tenth) {
    if (!still(s->stilled, twists, s->p->rows, share * most)) break;
    if (find_bound(bound, s->p, s->stilled)) return true;
  }
  return false;
}

static void keep_forces(proving *s, const tp_interior_iterate *at) {
  memcpy(s->bracket->forces, at->forces, (size_t)s->p->count * sizeof *at->forces);
}

static bool holds(proving *s, const tp_interior_iterate *at) {
  return tp_forces_hold(s->lacks, s->p, s->tree, at->forces, (tp_near){at->load, 0});
}

static bool try_forces(proving *s, const tp_interior_iterate *at) {
  tp_load_bracket *b = s->bracket;
  if ((b->is_held && at->load <= b->held) || !holds(s, at)) return false;
  b->is_held = true;
  b->held = at->load;
  keep_forces(s, at);
  return true;
}

double tp_load_width(const tp_load_bracket *b, double share) {
  static const double least = 1e-3;
  return share * fmax(fabs(b->bound), least);
}

static double width_of(const proving *s) {
  return tp_load_width(s->bracket, s->aim->share);
}

static bool is_narrow(const proving *s) {
  const tp_load_bracket *b = s->bracket;
  return b->is_held && b->is_bounded && b->bound - b->held <= width_of(s);
}

static bool is_enough(const proving *s) {
  const tp_load_bracket *b = s->bracket;
  return b->is_held && b->held >= fmin(s->aim->enough, TP_MOST_LOAD);
}

/* So far from what is asked for that this tells by how much. */
static bool is_far(const proving *s) {
  static const double share = 0.05;
  const tp_load_bracket *b = s->bracket;
  return s->aim->asks && b->is_held && b->is_bounded &&
         b->bound - b->held <= share * fabs(b->bound - s->aim->asked);
}

/* No load that is looked for. */
static bool is_never_held(const tp_load_bracket *b) {
  return b->is_bounded && b->bound < TP_LEAST_LOAD;
}

/* Forces that are not proven to hold are kept too: to begin from, where none are. */
static bool watch(void *context, const tp_interior_iterate *at) {
  static const double far_apart = 1e-2;
  proving *s = context;
  tp_load_bracket *b = s->bracket;
  double bound = 0;
  if (!try_forces(s, at) && !b->is_held && !s->aim->bound_alone) keep_forces(s, at);
  const bool opens = find_bound(&bound, s->p, at->twists);
  if ((opens || find_bound_at_rest(&bound, s, at->twists)) &&
      (!b->is_bounded || bound < b->bound)) {
    const double *twists = opens ? at->twists : s->stilled;
    b->is_bounded = true;
    b->bound = bound;
    memcpy(b->twists, twists, (size_t)s->p->rows * sizeof *b->twists);
    if (s->aim->bound_alone) keep_forces(s, at);
  }
  /* nearer than that roundings follow, and forces are found by the other way; a bound that is still
   * far above them tells nothing of the limit */
  const bool is_near = b->is_bounded && at->gap <= width_of(s) / 8 &&
                       b->bound - at->load <= tp_load_width(b, far_apart);
  b->is_settled = is_near || is_never_held(b) || is_enough(s) || is_narrow(s) || is_far(s);
  return b->is_settled;
}

static bool watch_centre(void *context, const tp_interior_iterate *at) {
  return try_forces(context, at);
}

/* From the nearest forces to ones that hold a load, if there are any. */
static tp_status hold(proving *s, double load, tp_message *message) {
  tp_load_bracket *b = s->bracket;
  if (load <= TP_LEAST_LOAD || load >= b->bound || (b->is_held && load <= b->held)) return TP_OK;
  return tp_interior_centre(s->p, b->forces, load, watch_centre, s, message);
}

/* A little below the bound forces are found once more; where roundings keep them from that, a
 * little farther away. */
static tp_status hold_nearer(proving *s, tp_message *message) {
  static const double farther = 16, farthest = 2;
  tp_load_bracket *b = s->bracket;
  tp_status status = TP_OK;
  const double size = fabs(b->bound);
  for (double away = width_of(s) / 2; away < farthest * size && status == TP_OK; away *= farther) {
    const bool was_held = b->is_held;
    status = hold(s, b->bound - away, message);
    if (b->is_held && (!was_held || b->held >= b->bound - away)) break;
  }
  return status;
}

static bool is_done(const proving *s) {
  const tp_load_bracket *b = s->bracket;
  if (s->aim->bound_alone) return b->is_settled;
  return is_narrow(s) || is_enough(s) || is_never_held(b);
}

static tp_status search(bool *began_near, proving *s, const tp_interior_from *from,
                        tp_message *message) {
  const tp_load_bracket *b = s->bracket;
  tp_status status = tp_interior_point(began_near, s->p, from, watch, s, message);
  if (status == TP_OK && b->is_bounded && !s->aim->bound_alone && !is_done(s)) {
    status = isfinite(s->aim->enough) ? hold(s, s->aim->enough, message) : hold_nearer(s, message);
  }
  return status;
}

/* Where points of other states do not lead to all that is asked for, from nothing. */
static tp_status search_twice(proving *s, tp_message *message) {
  static const tp_interior_from nothing = {.start = NULL};
  bool began_near = false;
  const tp_status status = search(&began_near, s, &s->aim->from, message);
  if (status != TP_OK || !began_near || is_done(s)) return status;
  return search(&began_near, s, &nothing, message);
}

tp_status tp_load_bracket_find(tp_load_bracket *b, const tp_force_program *p,
                               const tp_bracket_aim *aim, tp_message *message) {
  memset(b, 0, sizeof *b);
  tp_ground_tree tree = {.links = NULL};
  proving s = {.p = p, .tree = &tree, .bracket = b, .aim = aim};
  b->forces = calloc((size_t)p->count + 1, sizeof *b->forces);
  b->twists = calloc((size_t)p->rows + 1, sizeof *b->twists);
  s.lacks = calloc((size_t)p->rows + 1, sizeof *s.lacks);
  s.stilled = calloc((size_t)p->rows + 1, sizeof *s.stilled);
  const bool made = b->forces != NULL && b->twists != NULL && s.lacks != NULL &&
                    s.stilled != NULL && tp_ground_tree_init(&tree, p);
  tp_status status =
      made ? search_twice(&s, message) : tp_fail_memory(message, "the forces between blocks");
  tp_ground_tree_clear(&tree);
  free(s.lacks);
  free(s.stilled);
  if (status != TP_OK) tp_load_bracket_clear(b);
  return status;
}

void tp_load_bracket_clear(tp_load_bracket *b) {
  free(b->forces);
  free(b->twists);
  memset(b, 0, sizeof *b);
}
