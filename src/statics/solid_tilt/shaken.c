/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Least static accelerations that move a solid at its tilt, by the formulas of stance.h. */

#include "solid_tilt/shaken.h"

/* Of an edge: g (P cos d - q_t sin d), and the vector that it is divided by. */
static tp_near edge_strength(tp_near reach[2], const tp_stance *x, const tp_stance_edge *edge) {
  tp_near along;
  tp_stance_turn(&along, reach + 1, x, edge->east, edge->north);
  reach[0] = tp_near_plus(tp_near_times(edge->arm, x->loads->sine),
                          tp_near_times(along, x->loads->cosine));
  return tp_near_minus(tp_near_times(edge->arm, x->weight_on),
                       tp_near_times(along, x->weight_down));
}

/* Towards c and w. */
static void take_sliding(tp_least *l, const tp_stance *x, tp_near c, tp_near w) {
  const tp_stance_loads *own = x->loads;
  const tp_near mu2 = tp_near_times(x->friction, x->friction);
  const tp_near s2 = tp_near_times(own->sine, own->sine);
  const tp_near c2 = tp_near_times(own->cosine, own->cosine), cc = tp_near_times(c, c);
  const tp_near a = tp_near_minus(tp_near_plus(tp_near_times(cc, c2), tp_near_times(w, w)),
                                  tp_near_times(mu2, tp_near_times(cc, s2)));
  const tp_near b = tp_near_times(
      tp_near_times(c, own->gravity),
      tp_near_times(tp_near_times(own->sine, own->cosine), tp_near_plus(tp_unity, mu2)));
  const tp_near end = tp_near_times(tp_near_times(own->gravity, own->gravity),
                                    tp_near_minus(s2, tp_near_times(mu2, c2)));
  tp_near root;
  if (tp_least_root(&root, a, b, end)) tp_least_take(l, root, TP_SLIDES);
}

static void set_rose_acceleration(tp_solid_azimuth *own, const tp_stance *x) {
  tp_least all = {.found = false};
  tp_near east, north, c, w;
  tp_azimuth_direction(&east, &north, own->azimuth_deg);
  tp_stance_turn(&c, &w, x, east, north);
  for (size_t k = 0; k < x->count; k++) {
    tp_near reach[2];
    const tp_near top = edge_strength(reach, x, x->edges + k);
    const tp_near bottom = tp_near_plus(tp_near_times(c, reach[0]), tp_near_times(w, reach[1]));
    if (tp_near_sign(bottom) > 0) tp_least_take(&all, tp_near_div(top, bottom), TP_TOPPLES);
  }
  if (x->has_friction) take_sliding(&all, x, c, w);
  own->has_acceleration = all.found;
  own->acceleration_g = tp_near_bounded(all.value);
  own->acceleration_mechanism = all.mechanism;
}

/* tan(phi - d) = (mu cos d - sin d) / (cos d + mu sin d) */
static tp_near least_sliding(const tp_stance *x) {
  const tp_near s = x->loads->sine, c = x->loads->cosine;
  const tp_near top = tp_near_minus(tp_near_times(x->friction, c), s);
  const tp_near bottom = tp_near_plus(c, tp_near_times(x->friction, s));
  return tp_near_times(x->loads->gravity, tp_near_is_zero(top) ? top : tp_near_div(top, bottom));
}

static void set_least_acceleration(tp_solid_stance *own, const tp_stance *x) {
  tp_least all = {.found = false};
  for (size_t k = 0; k < x->count; k++) {
    tp_near reach[2];
    const tp_near top = edge_strength(reach, x, x->edges + k);
    if (!tp_least_take(&all, tp_near_div(top, tp_near_length(reach[0], reach[1])), TP_TOPPLES)) {
      continue;
    }
    /* back from t and s to east and north */
    all.east =
        tp_near_plus(tp_near_times(reach[0], x->down[0]), tp_near_times(reach[1], x->down[1]));
    all.north =
        tp_near_minus(tp_near_times(reach[0], x->down[1]), tp_near_times(reach[1], x->down[0]));
  }
  if (x->has_friction && tp_least_take(&all, least_sliding(x), TP_SLIDES)) {
    all.east = x->loads->has_tilt ? x->down[0] : tp_nothing;
    all.north = x->loads->has_tilt ? x->down[1] : tp_unity;
  }
  own->has_acceleration = all.found;
  own->acceleration_g = tp_near_bounded(all.value);
  own->acceleration_azimuth_deg = tp_azimuth_of(all.east, all.north);
  own->acceleration_mechanism = all.mechanism;
}

void tp_stance_shake(tp_solid_band *band, const tp_stance *x) {
  set_least_acceleration(&band->stance, x);
  for (size_t k = 0; k < band->rose_count; k++) set_rose_acceleration(band->rose + k, x);
}
