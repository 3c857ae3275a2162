/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The modes of the plan as functions of the share, over the weight and cos(tilt): w the loads at
 * the tilt, and e = N + s f T with f = tan(phi). Where no motion can begin, forces have to hold the
 * block too. */

#include "case_filter/strength_filter.h"

#include "case_filter/mode_capacities.h"
#include "motion/mode_shares.h"
#include "motion/strength_change.h"

static void set_edge(tp_share_line *own, const tp_contact_plan *plan, const tp_case_shape *shape,
                     tp_cone_edge edge, tp_near friction) {
  const tp_plan_point *at = plan->points + edge.point;
  const tp_shape_point *p = shape->points + edge.point;
  const tp_near along = edge.against ? friction : tp_near_neg(friction); /* turned round */
  for (int e = 0; e < 3; e++) {
    own->at[e] = tp_near_neg(p->normal[e]);
    own->rise[e] = tp_near_times(along, p->slip[e]);
  }
  own->balls = NULL;
  own->site = at->site + 1;
  own->parallel = 1 + 4 * at->axis + 2 * at->along + edge.against;
}

/* A force that is there whatever the share, or grows with it. */
static void add_line(tp_share_mode *mode, const tp_near of[3], tp_near times, bool grows,
                     long site) {
  const int place = mode->count + mode->free_count;
  tp_share_line *own = mode->own + place;
  mode->of[place] = own;
  *own = (tp_share_line){.site = site + 1};
  for (int e = 0; e < 3; e++) (grows ? own->rise : own->at)[e] = tp_near_times(times, of[e]);
  *(grows ? &mode->free_count : &mode->count) += 1;
}

/* Over the weight and cos(tilt), too. */
static void set_fixed(tp_share_mode *mode, const tp_near fixed[3], tp_near secant) {
  for (int e = 0; e < 3; e++) mode->loads.rise[e] = tp_near_times(secant, fixed[e]);
}

/* What cohesion and bonds do; false where that is open. */
static bool add_capacities(tp_share_mode *mode, const tp_filter_case *of, const tp_plan_mode *own,
                           tp_near tangent) {
  static const tp_near one = {1, 0};
  tp_mode_capacities held;
  if (!of->capacities->acts) return true;
  const tp_near secant = tp_tilt_secant(tangent);
  if (!tp_mode_capacities_find(&held, of, own)) return false;
  set_fixed(mode, held.fixed, secant);
  for (int k = 0; k < held.pull_count; k++) {
    add_line(mode, held.pulls[k], one, false, held.pull_site[k]);
  }
  for (int k = 0; k < held.free_count; k++) {
    add_line(mode, held.free[k], secant, true, held.free_site[k]);
  }
  return true;
}

/* Where all points open under the loads: no share changes that. */
static void set_interior(tp_share_mode *mode, const tp_filter_case *of) {
  mode->mechanism = TP_LEAVES_BASE;
  mode->interior = true;
  mode->ray_count = mode->count = 0;
  mode->planes = mode->own;
  mode->plane_count = of->plan->point_count;
  for (int k = 0; k < of->plan->point_count; k++) {
    mode->own[k] = (tp_share_line){.site = 0};
    tp_shape_response(mode->own[k].at, of->shape, k);
  }
}

/* The modes at a tilt, one after another; the last is that in which all points open. */
typedef struct modes {
  const tp_filter_case *of;
  tp_near tangent;
  tp_near loads[3];                       /* on the block, there */
  tp_share_line rays[TP_PLAN_RAYS];       /* M r of each */
  tp_share_line edges[TP_PLAN_POINTS][2]; /* turned round */
} modes;

static void begin(modes *m, const tp_filter_case *of, tp_near tangent) {
  m->of = of;
  m->tangent = tangent;
  tp_filter_loads_at(m->loads, of->loads, tangent);
  for (int e = 0; e < 3; e++) m->loads[e] = tp_near_neg(m->loads[e]);
  for (int k = 0; k < of->plan->ray_count; k++) {
    m->rays[k] = (tp_share_line){.site = 0};
    for (int e = 0; e < 3; e++) m->rays[k].at[e] = of->shape->inertia[k][e];
  }
  for (long k = 0; k < of->plan->point_count; k++) {
    set_edge(&m->edges[k][0], of->plan, of->shape, (tp_cone_edge){k, false}, of->friction);
    set_edge(&m->edges[k][1], of->plan, of->shape, (tp_cone_edge){k, true}, of->friction);
  }
}

static int count_of(const modes *m) {
  return m->of->plan->mode_count + (m->of->plan->opens_all ? 1 : 0);
}

static void set_mode(tp_share_mode *mode, const modes *m, const tp_plan_mode *own) {
  mode->mechanism = own->mechanism;
  mode->interior = false;
  mode->ray_count = own->ray_count;
  mode->count = own->ray_count + own->edge_count;
  for (int k = 0; k < own->ray_count; k++) mode->of[k] = m->rays + own->rays[k];
  for (int k = 0; k < own->edge_count; k++) {
    const tp_cone_edge *edge = own->edges + k;
    mode->of[own->ray_count + k] = &m->edges[edge->point][edge->against];
  }
}

static bool read_mode(tp_share_mode *mode, const modes *m, int k) {
  mode->sum = NULL;
  mode->bits = 0;
  mode->loads = (tp_share_line){.site = 0};
  for (int e = 0; e < 3; e++) mode->loads.at[e] = m->loads[e];
  mode->free_count = 0;
  if (k < m->of->plan->mode_count) {
    set_mode(mode, m, m->of->plan->modes + k);
    return add_capacities(mode, m->of, m->of->plan->modes + k, m->tangent);
  }
  set_interior(mode, m->of);
  if (!m->of->capacities->acts) return true;
  tp_near bonds[3];
  tp_bonds_of_all(bonds, m->of->capacities);
  set_fixed(mode, bonds, tp_tilt_secant(m->tangent));
  return true;
}

/* Can a motion begin with the share? 1, or -1: no, and forces hold it; 0 where that is open. */
static int side_of(const modes *m, double share) {
  tp_share_mode mode;
  int any = -1;
  for (int k = 0; k < count_of(m); k++) {
    const int side = read_mode(&mode, m, k) ? tp_share_mode_side(&mode, share) : 0;
    if (side > 0) return 1;
    if (side == 0) any = 0;
  }
  tp_edge_set edges;
  tp_filter_case reduced = *m->of;
  tp_filter_capacities capacities;
  if (reduced.capacities->acts) {
    tp_capacities_scale(&capacities, m->of->capacities, share);
    reduced.capacities = &capacities;
  }
  reduced.friction = tp_near_mul(reduced.friction, (tp_near){share, 0});
  tp_edge_set_init(&edges, &reduced);
  return any < 0 && tp_limit_filter_holds(&edges, m->tangent) ? -1 : 0;
}

/* From what doubles tell apart to a thousand millionth. */
static bool enclose(tp_near *share, const modes *m, double about) {
  static const double least = 0x1p-43, most = 0x1p-31, step = 16;
  bool proven = false;
  for (double width = least; width <= most && !proven; width *= step) {
    const int below = side_of(m, about * (1 - width));
    proven = below != 0 && below * side_of(m, about * (1 + width)) < 0;
    *share = tp_near_of(about, about * width);
  }
  return proven;
}

/* Where what can begin, or cannot, first changes, if its ratio is no larger; false where doubles do
 * not tell. */
static bool find_change(tp_share_change *change, const modes *m, bool moves, double ratio) {
  tp_share_mode mode;
  tp_share_spans spans = {.count = 0};
  bool done = true;
  for (int k = 0; k < count_of(m) && done; k++) {
    done = read_mode(&mode, m, k) && tp_share_spans_add_near(&spans, &mode, ratio);
  }
  *change = tp_share_spans_change(&spans, moves);
  tp_share_spans_clear(&spans);
  return done;
}

bool tp_strength_filter_find(tp_strength_told *told, const tp_filter_case *of, tp_near tangent,
                             bool moves, double most) {
  modes m;
  tp_share_change change;
  begin(&m, of, tangent);
  const bool done = find_change(&change, &m, moves, most);
  told->found = change.found;
  told->farther = most < INFINITY && (!change.found || fabs(log(change.share)) > log(most));
  if (!done || !change.found || told->farther) return done;
  told->mechanism = change.mechanism;
  return enclose(&told->share, &m, change.share);
}

bool tp_strength_filter_needs_some(const tp_filter_case *of, tp_near tangent) {
  static const double hardly_any = 16 * TP_LEAST_SHARE;
  modes m;
  tp_share_mode mode;
  bool begins = false;
  begin(&m, of, tangent);
  for (int k = 0; k < count_of(&m) && !begins; k++) {
    begins = read_mode(&mode, &m, k) && tp_share_mode_side(&mode, hardly_any) > 0;
  }
  return begins;
}

bool tp_strength_filter_moves_onset(const tp_filter_case *of, tp_near onset) {
  static const double beside = TP_BESIDE_END_DEG * M_PI / 180;
  const double t = onset.value;
  modes m;
  tp_share_change change;
  const double ratio = 1 + 2 * TP_LITTLE_STRENGTH;
  begin(&m, of, (tp_near){t + beside * (1 + t * t), 0});
  return find_change(&change, &m, true, ratio) && change.found &&
         fabs(log(change.share)) < TP_LITTLE_STRENGTH;
}
