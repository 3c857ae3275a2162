/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Problem: columns side by side on the ground; the friction at which they just hold each other, and
 * the force that the toe lacks with the friction that there is.
 *
 * Method: Goodman and Bray (1976), as section 9.4 of Wyllie and Mah (2004) has it. Column n,
 * counted from the toe, bears the force P_n from the column above, at the top of the contact, and
 * friction tan(phi) P_n there, which presses it down; it passes P_(n-1) on to the next. From the
 * last column on, P_N = 0, each passes on what keeps it from toppling about the lower end of its
 * base, P_(n-1,t) = (P_n (M_n - dx tan(phi_d)) + W_n/2 (y_n sin(psi) - dx cos(psi))) / L_n,    (1)
 * and from sliding with the friction of base and both sides spent,
 *     P_(n-1,s) = P_n - W_n (cos(psi) tan(phi_p) - sin(psi)) / (1 - tan(phi_p) tan(phi_d)),  (2)
 * whichever is more, or nothing. M_n and L_n are the heights of these forces above the base. Here
 * moments and forces are summed by vectors, of which (1) and (2) are the case of rectangles on
 * bases normal to their sides, and sides may each have their own friction: with e the normal of the
 * sides towards the toe, d their direction upwards, t the base up the slope and n its normal, the
 * column above acts by P_n (e - mu_n d) and the one below by -P_(n-1) (e - mu_(n-1) d).
 *
 * The factor of safety is tan(phi) over that at which P_0 = 0. It is searched by halving outwards
 * from 1, and given at the end of the bracket that holds. A support acts on the toe horizontally,
 * as their anchor that does not plunge.
 *
 * Forces on the toe, as an anchor has put there, are added to its weight; loads on other columns
 * the method does not know.
 *
 * Validity: rows of columns (column_row.h) without cohesion. Where tan(phi_p) tan(phi_d) >= 1 no
 * force on the side stops a column that slides, and none is needed by one that does not.
 *
 * Error: doubles, some 1e-12 of the greatest force a column; without a bound. Cost: that of N
 * columns for each of some 100 numbers. */

#include "block_system/goodman_bray.h"

#include "block_system/column_row.h"
#include "common/outside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double degrees = 57.29577951308232;

/* A force with its moment about the edge that a column topples about. */
typedef struct row_force {
  tp_row_vector force;
  double moment;
} row_force;

typedef struct equilibrium {
  const tp_column_row *row;
  tp_row_vector pull; /* of a weight of one, with the earthquake */
  row_force on_toe;   /* loads besides weights, which act on the toe alone */
  double divisor;     /* of tan(phi) of all joints */
} equilibrium;

static double cross(tp_row_vector a, tp_row_vector b) {
  return a.u * b.v - a.v * b.u;
}

static double dot(tp_row_vector a, tp_row_vector b) {
  return a.u * b.u + a.v * b.v;
}

static tp_row_vector plus(tp_row_vector a, double factor, tp_row_vector b) {
  return (tp_row_vector){a.u + factor * b.u, a.v + factor * b.v};
}

/* e - mu d. */
static tp_row_vector push_along(const equilibrium *x, double side_tangent) {
  const tp_row_vector d = x->row->along_sides, e = {-d.v, d.u};
  return plus(e, -side_tangent / x->divisor, d);
}

static tp_row_vector weight_of(const equilibrium *x, const tp_row_column *c) {
  const tp_row_vector zero = {0, 0};
  return plus(zero, c->weight_n_m, x->pull);
}

/* By how much a force drives a column down its base beyond what friction holds of it. */
static double drive(const equilibrium *x, const tp_row_column *c, tp_row_vector force) {
  const tp_row_vector t = c->along_base, n = {-t.v, t.u};
  return -dot(force, t) + c->base_tangent / x->divisor * dot(force, n);
}

/* What a force of 1 must be multiplied by to hold `excess`, of which it holds `share`: not above
 * zero where none is needed. False where it does not hold any, and is needed. */
static bool hold(double *force, double excess, double share) {
  *force = share > 0 ? excess / share : 0;
  return share > 0 || excess <= 0;
}

/* What acts on a column: its weight, other loads, the column above; and its force on the next one
 * per unit. */
typedef struct acting {
  tp_row_vector weight;
  row_force load;
  tp_row_vector above, below;
} acting;

/* The toe has no column below it: as on its upper side. */
static acting acting_on(const equilibrium *x, long k, double above) {
  const tp_row_column *c = x->row->columns + k;
  const tp_row_column *side = k > 0 ? c - 1 : c;
  const tp_row_vector zero = {0, 0};
  const row_force none = {{0, 0}, 0};
  return (acting){.weight = weight_of(x, c),
                  .load = k == 0 ? x->on_toe : none,
                  .above = plus(zero, above, push_along(x, c->side_tangent)),
                  .below = push_along(x, side->side_tangent)};
}

static double moment_of(const tp_row_column *c, const acting *a) {
  return cross(c->centroid, a->weight) + a->load.moment + cross(c->upper, a->above);
}

/* By how much all that acts on a column drives it down its base. */
static double drive_of(const equilibrium *x, const tp_row_column *c, const acting *a) {
  return drive(x, c, a->weight) + drive(x, c, a->load.force) + drive(x, c, a->above);
}

/* The forces that a column passes on, P_(n-1,t), P_(n-1,s) and P_(n-1). False where none holds it.
 */
static bool pass_on(tp_goodman_bray_column *own, const equilibrium *x, long k, double above) {
  const tp_row_column *c = x->row->columns + k;
  const acting a = acting_on(x, k, above);
  const double excess = drive_of(x, c, &a);
  const bool held = hold(&own->toppling_n_m, moment_of(c, &a), cross(c->lower, a.below)) &&
                    hold(&own->sliding_n_m, excess, drive(x, c, a.below));
  own->push_n_m = fmax(0, fmax(own->toppling_n_m, own->sliding_n_m));
  return held;
}

/* P_0; infinite where some column is held by nothing. */
static double toe_force(const equilibrium *x) {
  tp_goodman_bray_column own = {.push_n_m = 0};
  for (long k = x->row->count - 1; k >= 0; k--) {
    if (!pass_on(&own, x, k, own.push_n_m)) return INFINITY;
  }
  return own.push_n_m;
}

/* ---- the factor --------------------------------------------------------------------------------
 */

static bool stands(equilibrium *x, double log_factor) {
  x->divisor = exp(log_factor);
  return toe_force(x) <= 0;
}

/* From 1 outwards in steps to where it changes, then by halving; `*holds` at the end that does.
 * False: it does not change within the range. */
static bool find_change(double *holds, equilibrium *x, bool stands_at_first) {
  enum { STEPS = 160, HALVINGS = 50 };
  static const double most = 6.907755278982137; /* log 1000 */
  const double step = (stands_at_first ? most : -most) / STEPS;
  for (int k = 1; k <= STEPS; k++) {
    double near = (k - 1) * step, far = k * step;
    if (stands(x, far) == stands_at_first) continue;
    for (int n = 0; n < HALVINGS; n++) {
      const double middle = near + (far - near) / 2;
      if (stands(x, middle) == stands_at_first) {
        near = middle;
      } else {
        far = middle;
      }
    }
    *holds = stands_at_first ? near : far;
    return true;
  }
  *holds = stands_at_first ? most : -most;
  return false;
}

/* tan(phi) of all joints; below zero where they differ. */
static double same_tangent(const tp_column_row *row) {
  const double first = row->columns->base_tangent;
  for (long k = 0; k < row->count; k++) {
    const tp_row_column *c = row->columns + k;
    if (c->base_tangent != first || (k + 1 < row->count && c->side_tangent != first)) return -1;
  }
  return first;
}

static void set_factor(tp_goodman_bray *own, equilibrium *x) {
  double log_factor = 0;
  const bool stands_at_first = stands(x, 0);
  const bool changes = find_change(&log_factor, x, stands_at_first);
  const double tangent = same_tangent(x->row);
  own->has_fos = changes || stands_at_first;
  own->fos_is_least = stands_at_first && !changes;
  own->fos = exp(log_factor);
  own->has_friction_angle = changes && tangent > 0;
  own->friction_angle_deg = atan(tangent / own->fos) * degrees;
}

/* ---- the forces --------------------------------------------------------------------------------
 */

static void set_base(tp_goodman_bray_column *own, const equilibrium *x, long k, double above) {
  static const double rounding = 1e-9;
  const tp_row_column *c = x->row->columns + k;
  const acting a = acting_on(x, k, above);
  const tp_row_vector t = c->along_base, n = {-t.v, t.u};
  const tp_row_vector loads = plus(a.weight, 1, a.load.force);
  const tp_row_vector all = plus(plus(loads, 1, a.above), -own->push_n_m, a.below);
  const double slack = rounding * (c->weight_n_m + above + own->push_n_m);
  own->base_normal_n_m = -dot(all, n);
  own->base_shear_n_m = -dot(all, t);
  own->base_holds =
      own->base_normal_n_m >= -slack &&
      fabs(own->base_shear_n_m) <= c->base_tangent / x->divisor * own->base_normal_n_m + slack;
}

/* The size of a force on the toe with such a direction, at such a place from the edge that it
 * topples about: against toppling and sliding, whichever is more. False where none holds it. */
static bool hold_toe(double *force, const equilibrium *x, double above, tp_row_vector at,
                     tp_row_vector direction) {
  const tp_row_column *toe = x->row->columns;
  const acting a = acting_on(x, 0, above);
  double toppling = 0, sliding = 0;
  const bool held = hold(&toppling, moment_of(toe, &a), -cross(at, direction)) &&
                    hold(&sliding, drive_of(x, toe, &a), -drive(x, toe, direction));
  *force = fmax(0, fmax(toppling, sliding));
  return held;
}

/* Horizontal where the scene is tilted by an angle. */
static void set_support(tp_goodman_bray *own, const equilibrium *x, double tilt) {
  const tp_row_vector level = {cos(tilt), -sin(tilt)};
  const bool held =
      hold_toe(&own->support_n_m, x, own->columns[1].push_n_m, x->row->columns->lower, level);
  own->has_support = own->has_forces && held;
}

/* False where some column is held by nothing. */
static bool set_columns(tp_goodman_bray *own, const equilibrium *x) {
  double above = 0;
  bool held = true;
  for (long k = x->row->count - 1; k >= 0 && held; k--) {
    tp_goodman_bray_column *c = own->columns + k;
    held = pass_on(c, x, k, above);
    c->block = (size_t)x->row->columns[k].block;
    c->state = !(c->push_n_m > 0)                  ? TP_COLUMN_STABLE
               : c->toppling_n_m >= c->sliding_n_m ? TP_COLUMN_TOPPLES
                                                   : TP_COLUMN_SLIDES;
    set_base(c, x, k, above);
    above = c->push_n_m;
  }
  return held;
}

static void clear_forces(tp_goodman_bray *own) {
  for (size_t k = 0; k < own->column_count; k++) {
    tp_goodman_bray_column *c = own->columns + k;
    c->toppling_n_m = c->sliding_n_m = c->push_n_m = c->base_normal_n_m = c->base_shear_n_m = 0;
  }
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status refuse(tp_goodman_bray *own, const char *why, tp_message *message) {
  own->applies = false;
  own->why_not = strdup(why);
  return own->why_not != NULL ? TP_OK : tp_fail_memory(message, "the columns");
}

/* Across the sides, or down the base of some column. */
static bool presses(const equilibrium *x) {
  const tp_row_vector d = x->row->along_sides, e = {-d.v, d.u};
  bool down = dot(x->pull, e) > 0;
  for (long k = 0; k < x->row->count && !down; k++) {
    down = dot(x->pull, x->row->columns[k].along_base) < 0;
  }
  return down;
}

/* In axes of the row, of which u points away from the side that columns are pressed to. */
static tp_row_vector in_row(const tp_resultant *r, double along_x, double along_y) {
  return (tp_row_vector){r->left ? along_x : -along_x, along_y};
}

static tp_row_vector pull_of(const tp_resultant *r) {
  double along[2];
  for (int axis = 0; axis < 2; axis++) {
    along[axis] = r->loads.dead[axis].value + r->target.value * r->loads.live[axis].value;
  }
  return in_row(r, along[0], along[1]);
}

/* ---- loads -------------------------------------------------------------------------------------
 */

enum { ROWS = 3 }; /* of a block: along x, along y, its turn */

static double applied_at(const tp_resultant *r, long row) {
  const tp_applied_load *own = r->applied + row;
  return own->steady.value + own->down[0].value * r->loads.down[0].value +
         own->down[1].value * r->loads.down[1].value;
}

/* Other loads act on the toe alone, as one force. */
static bool take_loads(equilibrium *x, const tp_built_system *s, const tp_resultant *r) {
  const tp_assemblage *a = &s->assemblage;
  const tp_row_column *toe = x->row->columns;
  const long of_toe = ROWS * a->blocks[toe->block].number;
  if (r->applied == NULL) return true;
  for (long row = 0; row < ROWS * a->free_count; row++) {
    if (applied_at(r, row) != 0 && (row < of_toe || row >= of_toe + ROWS)) return false;
  }
  static const double newtons = 1000; /* in a kN */
  const double force = ldexp(newtons, (int)a->weight_exponent);
  const double metre = ldexp(fmpq_get_d(a->lattice.step_m), (int)a->length_exponent);
  const double turn = force * metre * applied_at(r, of_toe + 2);
  x->on_toe.force = in_row(r, force * applied_at(r, of_toe), force * applied_at(r, of_toe + 1));
  x->on_toe.moment = (r->left ? turn : -turn) + cross(toe->reference, x->on_toe.force);
  return true;
}

static tp_status solve(tp_goodman_bray *own, equilibrium *x, double tilt, tp_message *message) {
  const size_t count = (size_t)x->row->count;
  own->columns = calloc(count, sizeof *own->columns);
  if (own->columns == NULL) return tp_fail_memory(message, "the columns");
  own->applies = true;
  own->column_count = count;
  set_factor(own, x);
  x->divisor = 1;
  if (!set_columns(own, x)) {
    own->column_count = 0;
    return TP_OK;
  }
  set_support(own, x, tilt);
  if (!own->has_forces) clear_forces(own);
  return TP_OK;
}

static tp_status find(tp_goodman_bray *own, const tp_column_row *row, const tp_built_system *s,
                      const tp_resultant *r, tp_message *message) {
  equilibrium x = {.row = row, .pull = pull_of(r), .divisor = 1};
  if (row->count == 0) return refuse(own, row->why_not, message);
  if (!take_loads(&x, s, r)) {
    return refuse(
        own,
        "it knows no loads besides weights, an earthquake and forces on the toe, and this "
        "scene has",
        message);
  }
  for (long k = 0; k < row->count; k++) row->columns[k].weight_n_m *= r->along_normal;
  if (r->beyond) return refuse(own, "the loads do not press the columns onto their bases", message);
  if (!presses(&x)) {
    return refuse(own, "the loads do not press the columns to this side", message);
  }
  return solve(own, &x, arf_get_d(arb_midref(r->tilt_deg), ARF_RND_NEAR) / degrees, message);
}

tp_status tp_goodman_bray_find(tp_goodman_bray *own, const tp_built_system *s,
                               const tp_resultant *r, bool weighed, tp_message *message) {
  tp_column_row row;
  own->has_forces = weighed;
  if (s->has_cohesion) {
    return refuse(own, "it has no cohesion or tensile strength, and joints here have", message);
  }
  tp_status status = tp_column_row_find(&row, s, r->left, message);
  if (status != TP_OK) return status;
  status = find(own, &row, s, r, message);
  tp_column_row_clear(&row);
  return status;
}

/* ---- the support that is asked for -------------------------------------------------------------
 */

/* From the edge that the toe topples about, in metres. */
static tp_row_vector place_on_toe(const tp_column_row *row, const tp_built_system *s,
                                  const tp_resultant *r, const tp_system_support *support) {
  const tp_row_column *toe = row->columns;
  const tp_rigid_block *block = s->assemblage.blocks + toe->block;
  fmpq_t own;
  fmpq_init(own);
  tp_lattice_metres_x(own, &s->assemblage.lattice, block->x);
  const double x = support->x_m.value - fmpq_get_d(own);
  tp_lattice_metres_y(own, &s->assemblage.lattice, block->y);
  const double y = support->y_m.value - fmpq_get_d(own);
  fmpq_clear(own);
  return plus(toe->reference, 1, in_row(r, x, y));
}

/* With friction divided by the factor that is wanted. */
static void set_asked(tp_system_support *support, const tp_column_row *row,
                      const tp_built_system *s, const tp_resultant *r) {
  equilibrium x = {.row = row, .pull = pull_of(r), .divisor = support->fos.value};
  const double angle = support->direction_deg.value / degrees;
  tp_goodman_bray_column above = {.push_n_m = 0};
  if (row->count == 0 || (size_t)row->columns->block != support->block) return;
  if (!take_loads(&x, s, r) || r->beyond) return;
  for (long k = 0; k < row->count; k++) row->columns[k].weight_n_m *= r->along_normal;
  if (!presses(&x)) return;
  for (long k = row->count - 1; k > 0; k--) {
    if (!pass_on(&above, &x, k, above.push_n_m)) return;
  }
  support->has_goodman_bray =
      hold_toe(&support->goodman_bray_n_m, &x, above.push_n_m, place_on_toe(row, s, r, support),
               in_row(r, cos(angle), sin(angle)));
}

tp_status tp_goodman_bray_support(tp_system_case *own, const tp_built_system *s,
                                  const tp_resultant *r, tp_message *message) {
  tp_column_row row;
  if (!own->has_support || !own->goodman_bray.applies) return TP_OK;
  const tp_status status = tp_column_row_find(&row, s, r->left, message);
  if (status != TP_OK) return status;
  set_asked(&own->support, &row, s, r);
  tp_column_row_clear(&row);
  return TP_OK;
}
