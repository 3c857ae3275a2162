/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mode can begin where its loads, with what is fixed of cohesion and bonds, are a sum of its
 * generators with factors that are not negative, and of what is free with factors from -1 to 1: by
 * Caratheodory of three of these, all that is free besides at a bound (motion/share_mode.h). Such
 * tilts are an interval where each plane that bounds them is passed once from level to upright; as
 * it may be any plane of two, at any bounds of the rest, that is asked of all. */

#include "case_filter/strong_modes.h"

enum { GENERATORS = 2 + TP_PLAN_EDGES + TP_MODE_PULLS + TP_MODE_FREE };

/* The plane of two generators: its normal, and on that the loads less what is fixed, and what is
 * free. */
typedef struct plane {
  tp_near h[3];
  tp_tilt_form power;
  tp_near free[TP_MODE_FREE];
} plane;

typedef struct strong_mode {
  int ray_count, count,
      all; /* rays come first, and then edges and pulls; behind `count` what is free */
  tp_near of[GENERATORS][3];
  long site[GENERATORS], parallel[GENERATORS]; /* of forces, from 1 on; 0 of others */
  tp_near across[3];                           /* to both rays */
  const tp_filter_loads *loads;
  tp_near staying[3];         /* of them, less what is fixed */
  unsigned known[GENERATORS]; /* bit j of the i-th: their plane is there, i < j */
  plane planes[GENERATORS][GENERATORS];
} strong_mode;

static void add(strong_mode *m, const tp_near of[3], bool turned, long site, long parallel) {
  for (int e = 0; e < 3; e++) m->of[m->all][e] = turned ? tp_near_neg(of[e]) : of[e];
  m->site[m->all] = site;
  m->parallel[m->all++] = parallel;
}

static bool set_mode(strong_mode *m, const tp_plan_mode *mode, const tp_filter_case *of) {
  const tp_contact_plan *plan = of->plan;
  tp_mode_capacities held;
  m->all = 0;
  m->ray_count = mode->ray_count;
  m->loads = of->loads;
  if (!tp_mode_capacities_find(&held, of, mode)) return false;
  for (int k = 0; k < mode->ray_count; k++) add(m, of->shape->inertia[mode->rays[k]], false, 0, 0);
  for (int k = 0; k < mode->edge_count; k++) {
    const tp_cone_edge *edge = mode->edges + k;
    const tp_plan_point *at = plan->points + edge->point;
    tp_near force[3];
    tp_shape_edge(force, of->shape, *edge, of->friction);
    add(m, force, true, at->site + 1, 1 + 4 * at->axis + 2 * at->along + edge->against);
  }
  for (int k = 0; k < held.pull_count; k++) add(m, held.pulls[k], false, held.pull_site[k] + 1, -1);
  m->count = m->all;
  for (int k = 0; k < held.free_count; k++) add(m, held.free[k], false, held.free_site[k] + 1, 0);
  for (int e = 0; e < 3; e++) {
    m->staying[e] = tp_near_minus(of->loads->sum.fixed[e], held.fixed[e]);
  }
  for (int k = 0; k < m->all; k++) m->known[k] = 0;
  if (mode->ray_count == 2) tp_shape_response(m->across, of->shape, mode->line);
  return true;
}

/* Three of the generators and of what is free, the rest of that at its bounds: the bit k of what is
 * free tells its side. */
typedef struct choice {
  int of[3];
  const plane *across[3]; /* of the other two, */
  tp_near whole[3];       /* and each on that */
  unsigned bounds;
} choice;

static bool is_free(const strong_mode *m, int k) {
  return k >= m->count;
}

/* Do three forces have a point or a direction in common? */
static bool is_flat(const strong_mode *m, const int of[3]) {
  const int a = of[0], b = of[1], c = of[2];
  const bool site = m->site[a] != 0 && m->site[a] == m->site[b] && m->site[a] == m->site[c];
  return site || (m->parallel[a] != 0 && m->parallel[a] == m->parallel[b] &&
                  m->parallel[a] == m->parallel[c]);
}

static const plane *plane_of(strong_mode *m, int i, int j) {
  plane *own = &m->planes[i][j];
  if ((m->known[i] & 1U << j) != 0) return own;
  m->known[i] |= 1U << j;
  if (m->ray_count == 2 && i + j == 1) {
    for (int e = 0; e < 3; e++) own->h[e] = m->across[e];
  } else {
    tp_sparse_cross(own->h, m->of[i], m->of[j]);
  }
  tp_filter_loads_power(&own->power, m->loads, own->h);
  own->power.fixed = tp_sparse_dot(own->h, m->staying);
  for (int k = m->count; k < m->all; k++) {
    own->free[k - m->count] = tp_sparse_dot(own->h, m->of[k]);
  }
  return own;
}

/* The factor of the k-th of a choice, (h . w) / (h . g): above zero, and what is free within its
 * bounds. */
static bool keep_factor(tp_near_interval *own, const strong_mode *m, const choice *c, int k) {
  const tp_near whole = c->whole[k];
  const int sign = tp_near_sign(whole);
  tp_tilt_form power = c->across[k]->power;
  for (int at = m->count; at < m->all; at++) { /* what the base bears besides */
    const tp_near free = c->across[k]->free[at - m->count];
    if (c->of[0] == at || c->of[1] == at || c->of[2] == at) continue;
    const bool up = (c->bounds >> (at - m->count) & 1U) != 0;
    power.fixed = up ? tp_near_minus(power.fixed, free) : tp_near_plus(power.fixed, free);
  }
  if (sign == 0) return false;
  if (!is_free(m, c->of[k])) return tp_near_interval_keep(own, &power, sign, true);
  tp_tilt_form other = power;
  other.fixed = tp_near_plus(power.fixed, whole); /* -1 and 1 of it are borne */
  power.fixed = tp_near_minus(power.fixed, whole);
  return tp_near_interval_keep(own, &power, sign, true) &&
         tp_near_interval_keep(own, &other, -sign, true);
}

static bool span(tp_near_interval *own, const strong_mode *m, const choice *c) {
  bool told = true;
  *own = (tp_near_interval){.empty = false};
  for (int k = 0; k < 3 && told; k++) told = keep_factor(own, m, c, k);
  tp_near_interval_settle(own);
  return told;
}

/* What a mode's choices leave, one after another: with all rays and no pull its motion certainly
 * takes part; with pulls it may need more than the bond has. */
typedef struct gathering {
  tp_mode_interval *own;
  tp_near_interval perhaps, perhaps_with_rays, pulled;
} gathering;

static void take(gathering *g, const strong_mode *m, const choice *c, tp_near_interval *span) {
  bool pulls = false;
  for (int k = 0; k < 3; k++) pulls = pulls || m->parallel[c->of[k]] == -1;
  const bool all_rays = c->of[0] == 0 && (m->ray_count < 2 || c->of[1] == 1);
  tp_near_interval_unite(span->perhaps ? &g->perhaps : &g->own->all, span);
  if (!all_rays) return;
  if (pulls) {
    tp_near_interval_unite(&g->pulled, span);
  } else {
    tp_near_interval_unite(span->perhaps ? &g->perhaps_with_rays : &g->own->with_rays, span);
  }
}

static bool take_choices(gathering *g, strong_mode *m, choice *c) {
  unsigned among = 0; /* of what is free */
  for (int k = 0; k < 3; k++) {
    c->across[k] = plane_of(m, c->of[k == 0 ? 1 : 0], c->of[k == 2 ? 1 : 2]);
    c->whole[k] = tp_near_dot(c->across[k]->h, m->of[c->of[k]]);
    if (is_free(m, c->of[k])) among |= 1U << (c->of[k] - m->count);
  }
  for (c->bounds = 0; c->bounds < 1U << (m->all - m->count); c->bounds++) {
    tp_near_interval own;
    if ((c->bounds & among) != 0) continue;
    if (!span(&own, m, c)) return false;
    take(g, m, c, &own);
  }
  return true;
}

bool tp_strong_mode_find(tp_mode_interval *own, const tp_plan_mode *mode,
                         const tp_filter_case *of) {
  const tp_near_interval none = {.empty = true};
  gathering g = {own, none, none, none};
  strong_mode m;
  choice c;
  *own = (tp_mode_interval){none, none, none};
  if (!set_mode(&m, mode, of)) return false;
  for (c.of[0] = 0; c.of[0] < m.all; c.of[0]++) {
    for (c.of[1] = c.of[0] + 1; c.of[1] < m.all; c.of[1]++) {
      for (c.of[2] = c.of[1] + 1; c.of[2] < m.all; c.of[2]++) {
        if (!is_flat(&m, c.of) && !take_choices(&g, &m, &c)) return false;
      }
    }
  }
  tp_near_interval_add_perhaps(&own->all, &g.perhaps);
  tp_near_interval_add_perhaps(&own->with_rays, &g.perhaps_with_rays);
  own->pulled = g.pulled;
  return true;
}

bool tp_strong_leaving_find(tp_near_interval *own, const tp_filter_case *of) {
  const tp_contact_plan *plan = of->plan;
  tp_near bonds[3];
  tp_bonds_of_all(bonds, of->capacities);
  *own = (tp_near_interval){.empty = !plan->opens_all};
  for (int k = 0; k < plan->point_count && !own->empty; k++) {
    tp_near response[3];
    tp_tilt_form power;
    tp_shape_response(response, of->shape, k);
    tp_filter_loads_power(&power, of->loads, response);
    power.fixed = tp_near_minus(power.fixed, tp_sparse_dot(response, bonds));
    if (!tp_near_interval_keep(own, &power, 1, true)) return false;
  }
  tp_near_interval_settle(own);
  return true;
}
