/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each quantity is the least over the edges: a `least` keeps what is the least so far, and of which
 * kind. */

#include "solid_tilt/stance.h"

#include "number/near_angle.h"
#include "solid_tilt/shaken.h"
#include "solid_tilt/solid_safety.h"

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

/* 1 - g: what the earthquake lifts. */
static tp_near lightness(const tp_stance_loads *loads) {
  const bool lifts = loads->gravity.value != 1 || loads->gravity.error != 0;
  return lifts ? tp_near_minus(tp_unity, loads->gravity) : tp_nothing;
}

/* The resultant at an azimuth of the earthquake, c and w. */
static void set_resultant(tp_near *on, tp_near *lifts, tp_near pull[2], const tp_stance *x,
                          tp_near c, tp_near w) {
  const tp_near k = x->loads->horizontal, kc = tp_near_times(k, c);
  *lifts = tp_near_plus(tp_near_times(lightness(x->loads), x->loads->cosine),
                        tp_near_times(kc, x->loads->sine));
  *on = tp_near_minus(x->weight_on, tp_near_times(kc, x->loads->sine));
  pull[0] = tp_near_plus(x->weight_down, tp_near_times(kc, x->loads->cosine));
  pull[1] = tp_near_times(k, w);
}

/* What acts. */
typedef struct pulls {
  tp_near lifts;         /* cos d - N */
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
  set_resultant(&p->on, &p->lifts, pull, x, c, w);
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

/* P (cos d - N) + T . q at its worst: what of the driving loads turns it over an edge. */
static tp_near driving_about(const tp_stance *x, const pulls *p, const tp_stance_edge *edge) {
  if (!p->quake_to_any) {
    return tp_near_plus(tp_near_times(edge->arm, p->lifts), overturning(x, p, edge));
  }
  tp_near along, across;
  tp_stance_turn(&along, &across, x, edge->east, edge->north);
  const tp_near lifts =
      tp_near_times(edge->arm, tp_near_times(lightness(x->loads), x->loads->cosine));
  const tp_near reach = tp_near_plus(tp_near_times(edge->arm, x->loads->sine),
                                     tp_near_times(along, x->loads->cosine));
  return tp_near_plus(tp_near_plus(lifts, tp_near_times(along, x->weight_down)),
                      tp_near_times(x->loads->horizontal, tp_near_length(reach, across)));
}

/* On driving loads, of one edge; `least` falls to what the factor certainly is at least, where that
 * is all that is known. */
static void take_edge(tp_least *all, double *least, tp_near rests, tp_near over) {
  if (tp_near_sign(rests) < 0) { /* beyond the edge as it is */
    tp_least_take(all, tp_nothing, TP_TOPPLES);
  } else if (tp_near_sign(rests) > 0 && tp_near_sign(over) > 0) {
    tp_least_take(all, tp_near_div(rests, over), TP_TOPPLES);
  } else if (over.value + over.error > 0) {
    const double low = fmax(0, rests.value - rests.error) * (1 - 4 * DBL_EPSILON);
    *least = fmin(*least, low / (over.value + over.error));
  }
}

static void add_toppling(tp_state_ranges *state, tp_least *all, const tp_stance *x,
                         const pulls *p) {
  double least = INFINITY;
  for (size_t k = 0; k < x->count; k++) {
    const tp_near rests = tp_near_times(x->edges[k].arm, x->loads->cosine);
    take_edge(all, &least, rests, driving_about(x, p, x->edges + k));
  }
  if (all->found) {
    tp_state_ranges_add_near(state, TP_FOS_BY_DRIVING, TP_TOPPLES, all->value);
    state->ranges[state->count - 1].least = fmin(least, state->ranges[state->count - 1].least);
  } else if (isfinite(least)) {
    tp_state_ranges_add(state, TP_FOS_BY_DRIVING, TP_TOPPLES, least, INFINITY);
  }
}

/* On driving loads and by strength. Down a dip steeper than friction the worst azimuth of an
 * earthquake is not told: it slides without. */
static void add_sliding(tp_state_ranges *state, tp_near *strength, const tp_stance *x,
                        const pulls *p) {
  const tp_near cosine = x->loads->cosine;
  const tp_near rests = tp_near_times(x->friction, cosine);
  const tp_near drives = tp_near_plus(tp_near_times(x->friction, p->lifts), p->most);
  const bool told = !p->quake_to_any || tp_near_sign(tp_near_minus(rests, x->loads->sine)) >= 0;
  *strength = tp_near_div(tp_near_times(p->on, x->friction), p->most);
  if (tp_near_sign(drives) > 0) {
    tp_state_ranges_add_near(state, TP_FOS_BY_DRIVING, TP_SLIDES, tp_near_div(rests, drives));
    if (!told) state->ranges[state->count - 1].least = 0;
  } else if (!(tp_near_sign(drives) < 0)) {
    tp_state_ranges_add(state, TP_FOS_BY_DRIVING, TP_SLIDES, 0, INFINITY);
  }
  /* where it topples, no strength keeps it */
  const bool topples =
      state->count > 0 && state->ranges[0].mechanism == TP_TOPPLES && state->ranges[0].most < 1;
  if (!topples && !tp_near_is_zero(x->friction)) {
    tp_state_ranges_add_near(state, TP_FOS_BY_REDUCTION, TP_SLIDES, *strength);
  }
}

static tp_motion_verdict motion_verdict(tp_mechanism verdict) {
  return verdict == TP_STANDS                ? TP_VERDICT_STANDS
         : verdict == TP_MECHANISM_UNDECIDED ? TP_VERDICT_OPEN
                                             : TP_VERDICT_COLLAPSES;
}

static void set_factors(tp_solid_stance *own, tp_state_ranges *state, const tp_stance *x,
                        const pulls *p) {
  tp_least topples = {.found = false};
  state->verdict = motion_verdict(own->verdict);
  add_toppling(state, &topples, x, p);
  own->has_fos_toppling = topples.found;
  own->fos_toppling = tp_near_bounded(topples.value);
  own->has_fos_sliding = x->has_friction && tp_near_sign(p->most) > 0;
  if (!own->has_fos_sliding) return;
  tp_near slides;
  add_sliding(state, &slides, x, p);
  own->has_fos_sliding = tp_near_sign(p->on) > 0;
  own->fos_sliding = tp_near_bounded(slides);
}

/* The same without its earthquake: does it stand then? */
static bool find_static(tp_solid_stance *own, tp_state_ranges *state, const tp_stance *x) {
  const tp_stance_loads still = {.has_tilt = x->loads->has_tilt,
                                 .azimuth_deg = x->loads->azimuth_deg,
                                 .quake_deg = -1,
                                 .sine = x->loads->sine,
                                 .cosine = x->loads->cosine,
                                 .gravity = tp_unity};
  tp_stance alone = *x;
  pulls p;
  alone.loads = &still;
  alone.weight_down = still.sine;
  alone.weight_on = still.cosine;
  set_pulls(&p, &alone);
  set_verdict(own, &alone, &p);
  set_factors(own, state, &alone, &p);
  return own->verdict == TP_STANDS;
}

/* With its earthquake and without, and its factor of safety. */
static bool find_states(tp_solid_stance *own, const tp_stance *x) {
  const bool shaken = !tp_near_is_zero(x->loads->horizontal) || x->loads->gravity.value != 1;
  tp_state_ranges state = {.is_static = false}, at_rest = {.is_static = shaken};
  tp_solid_stance alone = {.has_fos = false};
  pulls p;
  const bool stands = find_static(&alone, &at_rest, x);
  set_pulls(&p, x);
  set_verdict(own, x, &p);
  set_factors(own, &state, x, &p);
  tp_solid_safety_add(&own->safety, &state);
  if (shaken) tp_solid_safety_add(&own->safety, &at_rest);
  own->has_fos = tp_solid_safety_number(&own->fos, &own->fos_mechanism, &own->safety);
  return stands;
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
  band->has_stance = true;
  const bool stands = find_states(&band->stance, &x);
  /* with the tilt towards any azimuth the least acceleration would be that of the worst */
  const bool open = loads->has_tilt && loads->azimuth_deg < 0;
  if (!open && stands) tp_stance_shake(band, &x);
}
