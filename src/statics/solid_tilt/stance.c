/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each quantity is the least over the edges, and then that of sliding: a `least` keeps what is the
 * least so far, and of which kind. */

#include "solid_tilt/stance.h"

#include "number/near_angle.h"
#include "solid_tilt/shaken.h"

/* ---- loads -------------------------------------------------------------------------------------
 */

/* The double nearest to a rational, with a bound where it may not be the same. */
static tp_near near_of_rational(const fmpq_t number) {
  const double value = tp_surface_nearest(number);
  const bool exact =
      fmpz_is_one(fmpq_denref(number)) && fmpz_bits(fmpq_numref(number)) <= DBL_MANT_DIG;
  return (tp_near){value, exact ? 0 : fabs(value) * DBL_EPSILON};
}

static double azimuth_of(const tp_quantity *azimuth) {
  static const double round = 360;
  return azimuth->given ? fmod(tp_surface_nearest(azimuth->value), round) : -1;
}

void tp_stance_loads_of(tp_stance_loads *loads, const tp_scene *scene) {
  const bool dips = scene->solid.dip_deg.given;
  const tp_quantity *tilt = dips ? &scene->solid.dip_deg : &scene->tilt_angle_deg;
  const tp_near degrees = tilt->given ? near_of_rational(tilt->value) : tp_nothing;
  *loads = (tp_stance_loads){
      .has_tilt = !tp_near_is_zero(degrees),
      .azimuth_deg = azimuth_of(dips ? &scene->solid.dip_direction_deg : &scene->tilt_azimuth_deg),
      .quake_deg = azimuth_of(&scene->loads.azimuth_deg),
      .cosine = tp_unity,
      .horizontal = scene->loads.horizontal.given ? near_of_rational(scene->loads.horizontal.value)
                                                  : tp_nothing,
      .gravity = tp_unity};
  if (loads->has_tilt) tp_near_sin_cos(&loads->sine, &loads->cosine, degrees);
  if (loads->quake_deg < 0) loads->horizontal.value = fabs(loads->horizontal.value);
  if (scene->loads.vertical.given) {
    loads->gravity = tp_near_minus(tp_unity, near_of_rational(scene->loads.vertical.value));
  }
}

/* ---- one stance --------------------------------------------------------------------------------
 */

/* The resultant at an azimuth of the earthquake, c and w. */
static void set_resultant(tp_near *on, tp_near pull[2], const tp_stance *x, tp_near c, tp_near w) {
  const tp_near k = x->loads->horizontal, kc = tp_near_times(k, c);
  *on = tp_near_minus(x->weight_on, tp_near_times(kc, x->loads->sine));
  pull[0] = tp_near_plus(x->weight_down, tp_near_times(kc, x->loads->cosine));
  pull[1] = tp_near_times(k, w);
}

/* What acts. */
typedef struct pulls {
  tp_near on;            /* N, or the least of open azimuths, */
  tp_near most;          /* and the greatest |T| with it */
  bool to_any;           /* towards each edge; else */
  bool quake_to_any;     /* by an earthquake towards any azimuth; else */
  tp_near along, across; /* T */
} pulls;

static void set_pulls(pulls *p, const tp_stance *x) {
  const tp_stance_loads *l = x->loads;
  tp_near pull[2];
  tp_near c = tp_unity, w = tp_nothing;
  const bool shakes = !tp_near_is_zero(l->horizontal);
  const bool tilt_open = l->has_tilt && l->azimuth_deg < 0;
  *p = (pulls){.to_any = tilt_open || (!l->has_tilt && shakes && l->quake_deg < 0)};
  p->quake_to_any = shakes && l->quake_deg < 0 && !p->to_any;
  if (!p->to_any && !p->quake_to_any && shakes) {
    tp_near east, north;
    tp_azimuth_direction(&east, &north, l->quake_deg);
    tp_stance_turn(&c, &w, x, east, north);
  }
  set_resultant(&p->on, pull, x, c, w);
  p->along = pull[0];
  p->across = pull[1];
  p->most = tp_near_is_zero(pull[0]) && tp_near_is_zero(pull[1]) ? tp_nothing
                                                                 : tp_near_length(pull[0], pull[1]);
}

/* ---- factors of safety -------------------------------------------------------------------------
 */

/* The largest T . q, but for an earthquake towards any azimuth. */
static tp_near overturning(const tp_stance *x, const pulls *p, const tp_stance_edge *edge) {
  tp_near along, across;
  if (p->to_any) return tp_near_times(p->most, tp_near_length(edge->east, edge->north));
  tp_stance_turn(&along, &across, x, edge->east, edge->north);
  return tp_near_plus(tp_near_times(p->along, along), tp_near_times(p->across, across));
}

/* Of an earthquake towards any azimuth. */
static bool worst_factor(tp_near *factor, const tp_stance *x, const tp_stance_edge *edge) {
  const tp_stance_loads *l = x->loads;
  tp_near along, across;
  tp_stance_turn(&along, &across, x, edge->east, edge->north);
  const tp_near k2 = tp_near_times(l->horizontal, l->horizontal);
  const tp_near g2 = tp_near_times(l->gravity, l->gravity);
  const tp_near s2 = tp_near_times(l->sine, l->sine), c2 = tp_near_times(l->cosine, l->cosine);
  const tp_near a2 = tp_near_times(along, along), b2 = tp_near_times(across, across);
  const tp_near p2 = tp_near_times(edge->arm, edge->arm);
  const tp_near a = tp_near_minus(tp_near_times(g2, tp_near_times(s2, a2)),
                                  tp_near_times(k2, tp_near_plus(tp_near_times(c2, a2), b2)));
  const tp_near both = tp_near_times(tp_near_times(l->sine, l->cosine), along);
  const tp_near b = tp_near_times(tp_near_times(edge->arm, both), tp_near_plus(g2, k2));
  const tp_near c = tp_near_times(p2, tp_near_minus(tp_near_times(g2, c2), tp_near_times(k2, s2)));
  /* a f^2 - 2 b f + c, with c above 0 */
  return tp_least_root(factor, tp_near_neg(a), b, tp_near_neg(c));
}

/* The margin a N - H T . n at its least: above 0 where it does not topple about the edge. */
static tp_near margin(const tp_stance *x, const pulls *p, const tp_stance_edge *edge) {
  if (!p->quake_to_any) {
    return tp_near_minus(tp_near_times(edge->arm, p->on), overturning(x, p, edge));
  }
  tp_near along, across;
  tp_stance_turn(&along, &across, x, edge->east, edge->north);
  const tp_near still =
      tp_near_minus(tp_near_times(edge->arm, x->weight_on), tp_near_times(along, x->weight_down));
  const tp_near reach = tp_near_plus(tp_near_times(edge->arm, x->loads->sine),
                                     tp_near_times(along, x->loads->cosine));
  return tp_near_minus(still, tp_near_times(x->loads->horizontal, tp_near_length(reach, across)));
}

static void take_factor(tp_least *all, const tp_stance *x, const pulls *p,
                        const tp_stance_edge *edge) {
  tp_near factor;
  if (p->quake_to_any) {
    if (tp_near_sign(edge->arm) > 0 && worst_factor(&factor, x, edge)) {
      tp_least_take(all, factor, TP_TOPPLES);
    }
    return;
  }
  const tp_near over = overturning(x, p, edge);
  if (tp_near_sign(over) <= 0) return;
  tp_least_take(all, tp_near_div(tp_near_times(edge->arm, p->on), over), TP_TOPPLES);
}

static void set_factors(tp_solid_stance *own, const tp_stance *x, const pulls *p) {
  tp_least topples = {.found = false}, all = topples;
  if (tp_near_sign(p->on) <= 0) return; /* nothing presses on the base */
  for (size_t k = 0; k < x->count; k++) take_factor(&topples, x, p, x->edges + k);
  own->has_fos_toppling = topples.found;
  own->fos_toppling = tp_near_bounded(topples.value);
  own->has_fos_sliding = x->has_friction && tp_near_sign(p->most) > 0;
  if (topples.found) tp_least_take(&all, topples.value, TP_TOPPLES);
  if (own->has_fos_sliding) {
    const tp_near slides = tp_near_div(tp_near_times(p->on, x->friction), p->most);
    own->fos_sliding = tp_near_bounded(slides);
    tp_least_take(&all, slides, TP_SLIDES);
  }
  own->has_fos = all.found;
  own->fos = tp_near_bounded(all.value);
  own->fos_mechanism = all.mechanism;
}

static void set_verdict(tp_solid_stance *own, const tp_stance *x, const pulls *p) {
  int topples = -1, slides = -1; /* the greater of the signs of what moves it */
  for (size_t k = 0; k < x->count; k++) {
    const int side = -tp_near_sign(margin(x, p, x->edges + k));
    if (side > topples) topples = side;
  }
  if (x->has_friction && !tp_near_is_zero(p->most)) {
    slides = tp_near_sign(tp_near_minus(p->most, tp_near_times(p->on, x->friction)));
  }
  own->verdict = tp_near_sign(p->on) < 0       ? TP_LEAVES_BASE
                 : topples > 0 && slides > 0   ? TP_SLIDES_AND_TOPPLES
                 : topples > 0                 ? TP_TOPPLES
                 : slides > 0                  ? TP_SLIDES
                 : topples == 0 || slides == 0 ? TP_MECHANISM_UNDECIDED
                                               : TP_STANDS;
}

/* Does it stand at its tilt under its weight alone? */
static bool stands_still(const tp_stance *x) {
  const tp_stance_loads still = {.has_tilt = x->loads->has_tilt,
                                 .azimuth_deg = x->loads->azimuth_deg,
                                 .quake_deg = -1,
                                 .sine = x->loads->sine,
                                 .cosine = x->loads->cosine,
                                 .gravity = x->loads->gravity};
  tp_stance own = *x;
  pulls p;
  tp_solid_stance told;
  own.loads = &still;
  set_pulls(&p, &own);
  set_verdict(&told, &own, &p);
  return told.verdict == TP_STANDS;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

void tp_stance_find(tp_solid_band *band, const tp_stance_loads *loads, const tp_stance_edge *edges,
                    size_t count, bool has_friction, double friction_angle_deg) {
  tp_stance x = {.loads = loads,
                 .edges = edges,
                 .count = count,
                 .has_friction = has_friction,
                 .down = {tp_nothing, tp_unity}};
  if (loads->azimuth_deg >= 0) {
    tp_azimuth_direction(x.down, x.down + 1, loads->azimuth_deg);
  }
  x.weight_down = tp_near_times(loads->gravity, loads->sine);
  x.weight_on = tp_near_times(loads->gravity, loads->cosine);
  if (has_friction && friction_angle_deg > 0) {
    const tp_near angle = {friction_angle_deg, friction_angle_deg * DBL_EPSILON / 2};
    tp_near sine, cosine;
    tp_near_sin_cos(&sine, &cosine, angle);
    x.friction = tp_near_div(sine, cosine);
  }
  pulls p;
  set_pulls(&p, &x);
  band->has_stance = true;
  set_verdict(&band->stance, &x, &p);
  set_factors(&band->stance, &x, &p);
  /* with the tilt towards any azimuth the least acceleration would be that of the worst */
  const bool open = loads->has_tilt && loads->azimuth_deg < 0;
  if (!open && stands_still(&x)) tp_stance_shake(band, &x);
}
