/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mechanism is the twist v of two columns, an edge and another edge, a shear or a pull, with
 * v . e > 0 of all edges off their face. Cohesion and bonds bear K = sum of |v . shear| + max(0,
 * -v . pull) against it, times 1 / cos(tilt), so that nothing holds where v . b + K < 0. Where that
 * is zero, and b less these at their bounds is a sum of the two columns with factors within theirs,
 * forces hold. A shear through the point that is turned about does no work: how much of it bears is
 * proposed by a linear program, as are all factors where b is to be borne at other tilts; what is
 * proposed is proven by the edges alone, which bear the rest. */

#include "case_filter/strong_limit.h"

#include "linear_program/simplex.h"

static const tp_near zero = {0, 0};

/* ---- factors that are proposed -----------------------------------------------------------------
 */

enum { COLUMNS = TP_FILTER_EDGES + 3 * TP_PLAN_CAPACITIES };

/* Of shears from -1 to 1, of pulls from 0 to 1. */
typedef struct factors {
  double shear[TP_PLAN_CAPACITIES], pull[TP_PLAN_CAPACITIES];
} factors;

/* A program of columns of size one, moments over a length of the contact. */
typedef struct proposal {
  double columns[COLUMNS][3], most[COLUMNS], sizes[COLUMNS];
  bool at_most[COLUMNS];
  double length;
  int count;
} proposal;

static void begin(proposal *p, const tp_edge_set *set) {
  p->count = 0;
  p->length = DBL_MIN;
  for (int k = 0; k < set->plan->point_count; k++) {
    const tp_shape_point *own = set->shape->points + k;
    p->length = fmax(p->length, fmax(fabs(own->x.value), fabs(own->y.value)));
  }
}

static void add_column(proposal *p, const tp_near of[3], double sign, bool bounded, double scale) {
  double *own = p->columns[p->count];
  for (int e = 0; e < 3; e++) own[e] = sign * of[e].value / (e == 2 ? p->length : 1);
  const double size = sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
  for (int e = 0; e < 3; e++) own[e] /= size;
  p->sizes[p->count] = size;
  p->most[p->count] = bounded ? scale * size : INFINITY;
  p->at_most[p->count++] = false;
}

static double factor_of(const proposal *p, const tp_simplex_answer *answer, int k, double scale) {
  double factor = p->at_most[k] ? p->most[k] : 0;
  for (int row = 0; row < 3; row++) {
    if (answer->basis[row] == k) factor = answer->values[row];
  }
  return fmin(fmax(factor / p->sizes[k] / scale, 0), 1);
}

/* What may bear beside edges: those of some of the capacities alone. */
typedef struct choice {
  bool shear[TP_PLAN_CAPACITIES], pull[TP_PLAN_CAPACITIES];
} choice;

static bool acts(const tp_near force[3]) {
  return !(tp_near_is_zero(force[0]) && tp_near_is_zero(force[1]));
}

static choice all_of(const tp_filter_capacities *c) {
  choice own = {{false}, {false}};
  for (int k = 0; k < c->count; k++) {
    own.shear[k] = acts(c->items[k].shear);
    own.pull[k] = acts(c->items[k].pull);
  }
  return own;
}

/* With what is left for the edges as far within their cone as can be; false where doubles see no
 * way. */
static bool propose(factors *of, const tp_edge_set *set, const int *edges, int edge_count,
                    const choice *own, const tp_near b[3], double scale) {
  const tp_filter_capacities *c = set->capacities;
  proposal p;
  begin(&p, set);
  tp_simplex_program program = {.columns = (const double(*)[3])p.columns, .most = p.most};
  for (int k = 0; k < edge_count; k++) {
    add_column(&p, set->of[edges[k]], 1, false, scale);
    for (int e = 0; e < 3; e++) program.direction[e] += p.columns[k][e] / edge_count;
  }
  for (int k = 0; k < c->count; k++) {
    if (own->shear[k]) add_column(&p, c->items[k].shear, 1, true, scale);
    if (own->shear[k]) add_column(&p, c->items[k].shear, -1, true, scale);
    if (own->pull[k]) add_column(&p, c->items[k].pull, 1, true, scale);
  }
  program.count = p.count;
  for (int e = 0; e < 3; e++) program.target[e] = b[e].value / (e == 2 ? p.length : 1);
  const tp_simplex_answer answer = tp_simplex_solve(&program, p.at_most);
  *of = (factors){{0}, {0}};
  if (answer.outcome == TP_SIMPLEX_UNBOUNDED) return true; /* the edges alone bear anything */
  if (answer.outcome != TP_SIMPLEX_OPTIMAL || answer.t <= 0) return false;
  int at = edge_count;
  for (int k = 0; k < c->count; k++) {
    if (own->shear[k]) {
      of->shear[k] = factor_of(&p, &answer, at, scale) - factor_of(&p, &answer, at + 1, scale);
      at += 2;
    }
    if (own->pull[k]) of->pull[k] = factor_of(&p, &answer, at++, scale);
  }
  return true;
}

/* b less the capacities times their factors. */
static void take_off(tp_near b[3], const tp_filter_capacities *c, const factors *of,
                     tp_near scale) {
  for (int k = 0; k < c->count; k++) {
    const tp_near shear = tp_near_times(scale, (tp_near){of->shear[k], 0});
    const tp_near pull = tp_near_times(scale, (tp_near){of->pull[k], 0});
    for (int e = 0; e < 3; e++) {
      b[e] = tp_near_minus(b[e], tp_near_times(shear, c->items[k].shear[e]));
      b[e] = tp_near_minus(b[e], tp_near_times(pull, c->items[k].pull[e]));
    }
  }
}

bool tp_strong_limit_bears(const tp_edge_set *set, const tp_near b[3], tp_near scale) {
  int edges[TP_FILTER_EDGES];
  factors of;
  tp_near rest[3] = {b[0], b[1], b[2]};
  const choice all = all_of(set->capacities);
  for (int k = 0; k < set->plan->edge_count; k++) edges[k] = k;
  if (!propose(&of, set, edges, set->plan->edge_count, &all, b, scale.value)) return false;
  take_off(rest, set->capacities, &of, scale);
  return tp_edges_bear(set, rest);
}

/* ---- mechanisms --------------------------------------------------------------------------------
 */

/* The twist of an edge and another column: an edge, or the shear or the pull of a capacity. */
typedef struct face {
  int edge, other; /* -1: none */
  int shear, pull; /* -1: none */
  tp_near v[3];
  tp_near held; /* K */
  factors full; /* at their bounds; */
  choice idle;  /* and what does no work */
} face;

static bool is_on(const face *f, const tp_edge_set *set, int edge) {
  return f->other >= 0 ? tp_edges_hold_third(set, f->edge, f->other, edge) : edge == f->edge;
}

static double work_of(const tp_near v[3], const tp_near e[3]) {
  return v[0].value * e[0].value + v[1].value * e[1].value + v[2].value * e[2].value;
}

/* No edge resists: the sense is that of the first off the face. By values first. */
static bool admit(face *f, const tp_edge_set *set) {
  bool turned = false, any = false;
  for (int k = 0; k < set->plan->edge_count; k++) {
    if (is_on(f, set, k)) continue;
    const double work = work_of(f->v, set->of[k]);
    if (!any) turned = work < 0;
    any = true;
    if (work == 0 || (work < 0) != turned) return false;
  }
  if (!any) return false;
  if (turned) tp_sparse_reverse(f->v);
  for (int k = 0; k < set->plan->edge_count; k++) {
    if (!is_on(f, set, k) && tp_near_sign(tp_sparse_dot(f->v, set->of[k])) <= 0) return false;
  }
  return true;
}

/* K, and which bear against it with all they have; false where the side of one is open. */
static bool find_held(face *f, const tp_edge_set *set) {
  const tp_filter_capacities *c = set->capacities;
  f->held = zero;
  f->full = (factors){{0}, {0}};
  f->idle = (choice){{false}, {false}};
  const bool turns = f->other >= 0 && tp_edges_meet(set, f->edge, f->other);
  const long site = set->plan->points[set->plan->edges[f->edge].point].site;
  for (int k = 0; k < c->count; k++) {
    const bool shears = acts(c->items[k].shear), pulls = acts(c->items[k].pull);
    f->idle.shear[k] = shears && turns && tp_capacity_meets(c, set->plan, k, site);
    if (shears && k != f->shear && !f->idle.shear[k]) {
      const tp_near work = tp_sparse_dot(f->v, c->items[k].shear);
      const int sign = tp_near_sign(work);
      if (sign == 0) return false;
      f->full.shear[k] = -sign;
      f->held = tp_near_plus(f->held, sign > 0 ? work : tp_near_neg(work));
    }
    if (pulls && k != f->pull) {
      const tp_near work = tp_sparse_dot(f->v, c->items[k].pull);
      const int sign = tp_near_sign(work);
      if (sign == 0) return false;
      if (sign > 0) continue;
      f->full.pull[k] = 1;
      f->held = tp_near_minus(f->held, work);
    }
  }
  return true;
}

static bool has_idle(const face *f, const tp_edge_set *set) {
  bool any = false;
  for (int k = 0; k < set->capacities->count; k++) any = any || f->idle.shear[k];
  return any;
}

/* The rest is a sum of the edge and of the capacity within its bounds. */
static bool bears_beside(const face *f, const tp_edge_set *set, const tp_near rest[3],
                         tp_near scale) {
  const tp_filter_capacity *c = set->capacities->items;
  const tp_near *of = f->shear >= 0 ? c[f->shear].shear : c[f->pull].pull;
  tp_near beyond[3], back[3], turned[3];
  for (int e = 0; e < 3; e++) {
    const tp_near most = tp_near_times(scale, of[e]);
    turned[e] = tp_near_neg(of[e]);
    beyond[e] = tp_near_minus(rest[e], most); /* less than all of it: what is left is against it */
    back[e] = f->shear >= 0 ? tp_near_plus(rest[e], most) : rest[e];
  }
  return tp_edges_press(set->of[f->edge], turned, beyond) &&
         tp_edges_press(set->of[f->edge], of, back);
}

static bool bears_face(const face *f, const tp_edge_set *set, tp_near tangent) {
  const tp_near scale = tp_tilt_secant(tangent);
  const int edges[2] = {f->edge, f->other};
  tp_near rest[3];
  factors of;
  tp_filter_loads_at(rest, set->loads, tangent);
  take_off(rest, set->capacities, &f->full, scale);
  if (f->other < 0) return bears_beside(f, set, rest, scale);
  if (tp_edges_press(set->of[f->edge], set->of[f->other], rest)) return true;
  if (!has_idle(f, set) || !propose(&of, set, edges, 2, &f->idle, rest, scale.value)) return false;
  take_off(rest, set->capacities, &of, scale);
  return tp_edges_press(set->of[f->edge], set->of[f->other], rest);
}

static bool is_limit(tp_near *tangent, face *f, const tp_edge_set *set) {
  tp_tilt_form power;
  tp_tilt_change change;
  if (!admit(f, set) || !find_held(f, set)) return false;
  tp_filter_loads_power(&power, set->loads, f->v);
  power.fixed = tp_near_plus(power.fixed, f->held);
  if (!tp_tilt_form_change(&change, &power) || change.level < 0 || change.upright > 0) return false;
  *tangent = change.tangent;
  return bears_face(f, set, *tangent);
}

/* Of two edges. */
static bool find_by_edges(tp_near *tangent, tp_mechanism *mechanism, const tp_edge_set *set) {
  const int count = set->plan->edge_count;
  for (int i = 0; i < count; i++) {
    for (int j = i + 1; j < count; j++) {
      face f = {.edge = i, .other = j, .shear = -1, .pull = -1};
      tp_edges_twist(f.v, set, i, j);
      if (!is_limit(tangent, &f, set)) continue;
      *mechanism = tp_edges_mechanism(set, i, j);
      return true;
    }
  }
  return false;
}

static bool try_capacity(tp_near *tangent, const tp_edge_set *set, int i, int k, bool pull) {
  const tp_filter_capacity *c = set->capacities->items + k;
  face f = {.edge = i, .other = -1, .shear = pull ? -1 : k, .pull = pull ? k : -1};
  if (!acts(pull ? c->pull : c->shear)) return false;
  tp_sparse_cross(f.v, set->of[i], pull ? c->pull : c->shear);
  return is_limit(tangent, &f, set);
}

/* Of an edge and a shear on a line that does not pass through its point, or a pull. */
static bool find_by_capacities(tp_near *tangent, const tp_edge_set *set) {
  for (int i = 0; i < set->plan->edge_count; i++) {
    const long site = set->plan->points[set->plan->edges[i].point].site;
    for (int k = 0; k < set->capacities->count; k++) {
      const bool meets = tp_capacity_meets(set->capacities, set->plan, k, site);
      if (!meets && try_capacity(tangent, set, i, k, false)) return true;
      if (try_capacity(tangent, set, i, k, true)) return true;
    }
  }
  return false;
}

bool tp_strong_limit_find(tp_near *tangent, tp_mechanism *mechanism, const tp_edge_set *set) {
  if (find_by_edges(tangent, mechanism, set)) return true;
  *mechanism = TP_SLIDES_AND_TOPPLES;
  return find_by_capacities(tangent, set);
}
