/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The law of a wedge at the force of its scene, towards the azimuth of that or the worst, and
 * towards all. */

#include "solid_tilt/wedge_slide.h"

#include "number/ball.h"
#include "solid/surface.h"
#include "solid_tilt/solid_safety.h"
#include "solid_tilt/wedge_circle.h"
#include "solid_tilt/wedge_reach.h"
#include "solid_tilt/wedge_support.h"

#include <stdlib.h>

enum { BITS = TP_WEDGE_LAW_BITS, NEWTONS = 1000, HALF_TURN = 180 };

/* What has to be cleared together. */
enum { EAST, NORTH, DRIVING, STRENGTH, OWN, SECOND, NUMBERS };

typedef struct work {
  const tp_wedge_shape *shape;
  const tp_scene *scene;
  tp_solid_wedge *result;
  tp_wedge_forces forces;
  tp_wedge_law law;
  arb_struct values[TP_WEDGE_LINES]; /* at the scene's earthquake */
  arb_struct n[NUMBERS];
} work;

static bool is_shaken(const work *w) {
  return !fmpq_is_zero(w->scene->loads.horizontal.value);
}

static double degrees_of(double half_turns) {
  const double degrees = half_turns * HALF_TURN;
  return degrees < 0                  ? degrees + 2.0 * HALF_TURN
         : degrees >= 2.0 * HALF_TURN ? degrees - 2.0 * HALF_TURN
                                      : degrees;
}

/* ---- the least of all azimuths -----------------------------------------------------------------
 */

static void find_worst(work *w, tp_wedge_least *least) {
  tp_solid_wedge *own = w->result;
  if (!is_shaken(w)) return;
  tp_wedge_least_factor(least, &w->law, w->scene->loads.horizontal.value);
  own->has_worst = least->found;
  own->worst_fos = least->least;
  own->worst_azimuth_deg = degrees_of(least->half_turns);
  own->worst_slides_on = tp_wedge_way_name(least->way);
}

static void find_acceleration(work *w) {
  tp_solid_wedge *own = w->result;
  const tp_quantity *azimuth = &w->scene->loads.azimuth_deg;
  tp_wedge_least least = {.found = false};
  tp_wedge_way way = TP_WEDGE_UNKNOWN;
  tp_wedge_least_reach(&least, &w->law);
  own->has_acceleration = least.found;
  own->acceleration_g = least.least;
  own->acceleration_azimuth_deg = degrees_of(least.half_turns);
  own->acceleration_slides_on = tp_wedge_way_name(least.way);
  if (!azimuth->given) return;
  tp_ball_sin_cos_degrees(w->n + EAST, w->n + NORTH, azimuth->value, BITS);
  own->has_acceleration_ahead =
      tp_wedge_reach(w->n + OWN, &way, &w->law, w->n + EAST, w->n + NORTH);
  if (own->has_acceleration_ahead) own->acceleration_ahead_g = tp_ball_bounded(w->n + OWN);
}

/* ---- at the scene's earthquake -----------------------------------------------------------------
 */

/* Towards its azimuth, or the worst. */
static void set_force(work *w, const tp_wedge_least *worst) {
  const tp_scene *scene = w->scene;
  tp_solid_wedge *own = w->result;
  if (!is_shaken(w)) return;
  own->has_azimuth = true;
  if (scene->loads.azimuth_deg.given) {
    own->azimuth_deg = tp_surface_nearest(scene->loads.azimuth_deg.value);
    tp_ball_sin_cos_degrees(w->n + EAST, w->n + NORTH, scene->loads.azimuth_deg.value, BITS);
  } else {
    own->azimuth_deg = own->worst_azimuth_deg;
    tp_wedge_direction(w->n + EAST, w->n + NORTH, worst->half_turns);
  }
  arb_set_fmpq(w->n + OWN, scene->loads.horizontal.value, BITS);
  arb_mul(w->n + EAST, w->n + EAST, w->n + OWN, BITS);
  arb_mul(w->n + NORTH, w->n + NORTH, w->n + OWN, BITS);
}

static tp_bounded in_newtons(work *w, const arb_struct *kilonewtons) {
  arb_mul_ui(w->n + OWN, kilonewtons, NEWTONS, BITS);
  return tp_ball_bounded(w->n + OWN);
}

/* On both joints, or none, N of both and the way down their line. */
static void tell_forces(work *w, tp_wedge_way way) {
  tp_solid_wedge *own = w->result;
  for (int joint = 0; joint < 2; joint++) {
    const tp_wedge_way alone = joint == 0 ? TP_WEDGE_ON_A : TP_WEDGE_ON_B;
    const tp_wedge_way other = joint == 0 ? TP_WEDGE_ON_B : TP_WEDGE_ON_A;
    const int on = (way == alone ? TP_WEDGE_PRESS_A : TP_WEDGE_NORMAL_A) + joint;
    if (way != other) own->normal_n[joint] = in_newtons(w, w->values + on);
  }
  if (way == TP_WEDGE_ON_A || way == TP_WEDGE_ON_B) {
    own->driving_n = in_newtons(w, w->n + DRIVING);
  } else {
    arb_neg(w->n + SECOND, w->values + TP_WEDGE_ALONG);
    own->driving_n = in_newtons(w, w->n + SECOND);
  }
}

/* Up the line or down it: strength acts against either. */
static void tell_factor(work *w, tp_wedge_way way) {
  tp_solid_wedge *own = w->result;
  const arb_struct *driving = w->n + DRIVING, *strength = w->n + STRENGTH;
  if (way == TP_WEDGE_ON_NONE || way == TP_WEDGE_UNKNOWN) {
    own->has_fos = way == TP_WEDGE_ON_NONE; /* nothing holds it */
    own->verdict = own->has_fos ? TP_LEAVES_BASE : TP_MECHANISM_UNDECIDED;
    return;
  }
  own->verdict = arb_gt(strength, driving)   ? TP_STANDS
                 : arb_lt(strength, driving) ? TP_SLIDES
                                             : TP_MECHANISM_UNDECIDED;
  own->has_fos = arb_is_nonzero(driving);
  if (!own->has_fos) return;
  arb_div(w->n + OWN, strength, driving, BITS);
  own->fos = tp_ball_bounded(w->n + OWN);
}

/* Where the azimuth is the worst, by the bounds of all. */
static void tell_worst(tp_solid_wedge *own, const tp_wedge_least *worst) {
  const tp_bounded least = worst->least;
  own->has_fos = worst->found;
  own->fos = least;
  own->verdict = !worst->found                    ? TP_MECHANISM_UNDECIDED
                 : worst->way == TP_WEDGE_ON_NONE ? TP_LEAVES_BASE
                 : least.value - least.error > 1  ? TP_STANDS
                 : least.value + least.error < 1  ? TP_SLIDES
                                                  : TP_MECHANISM_UNDECIDED;
}

static void tell_way(work *w, const tp_wedge_least *worst) {
  tp_wedge_way way = TP_WEDGE_UNKNOWN;
  set_force(w, worst);
  tp_wedge_values(w->values, &w->law, w->n + EAST, w->n + NORTH, false);
  (void)tp_wedge_law_at(&way, w->n + DRIVING, w->n + STRENGTH, &w->law, w->n + EAST, w->n + NORTH);
  w->result->slides_on = tp_wedge_way_name(way);
  tell_forces(w, way);
  tell_factor(w, way);
  if (is_shaken(w) && !w->scene->loads.azimuth_deg.given) tell_worst(w->result, worst);
}

/* ---- its factor of safety ----------------------------------------------------------------------
 */

static tp_motion_verdict motion_verdict(tp_mechanism verdict) {
  return verdict == TP_STANDS                ? TP_VERDICT_STANDS
         : verdict == TP_MECHANISM_UNDECIDED ? TP_VERDICT_OPEN
                                             : TP_VERDICT_COLLAPSES;
}

/* As Hoek and Bray have it: strength over what drives. */
static void set_state(tp_state_ranges *state, const tp_solid_wedge *own) {
  state->verdict = motion_verdict(own->verdict);
  if (own->verdict == TP_LEAVES_BASE) {
    tp_state_ranges_add(state, TP_FOS_BY_REDUCTION, TP_LEAVES_BASE, 0, 0);
  } else if (own->has_fos) {
    tp_state_ranges_add_near(state, TP_FOS_BY_REDUCTION, TP_SLIDES,
                             (tp_near){own->fos.value, own->fos.error});
  } else if (own->verdict == TP_MECHANISM_UNDECIDED) {
    tp_state_ranges_add(state, TP_FOS_BY_REDUCTION, TP_SLIDES, 0, INFINITY);
  }
}

/* The same wedge and bolts without the earthquake. */
static void find_static(tp_state_ranges *state, const work *w) {
  tp_wedge_way way = TP_WEDGE_UNKNOWN;
  tp_solid_wedge result = {.bolt_count = 0};
  tp_scene still = *w->scene; /* borrowed */
  fmpz one = 1;
  still.loads.horizontal.given = still.loads.vertical.given = false;
  *fmpq_numref(still.loads.horizontal.value) = *fmpq_numref(still.loads.vertical.value) = 0;
  *fmpq_denref(still.loads.horizontal.value) = *fmpq_denref(still.loads.vertical.value) = one;
  work own = {.shape = w->shape, .scene = &still, .result = &result};
  for (int k = 0; k < NUMBERS; k++) arb_init(own.n + k);
  tp_wedge_values_init(own.values);
  tp_wedge_forces_init(&own.forces, w->shape, &still);
  tp_wedge_law_init(&own.law, &own.forces, w->shape, &still);
  tp_wedge_values(own.values, &own.law, own.n + EAST, own.n + NORTH, false);
  (void)tp_wedge_law_at(&way, own.n + DRIVING, own.n + STRENGTH, &own.law, own.n + EAST,
                        own.n + NORTH);
  tell_factor(&own, way);
  set_state(state, &result);
  tp_wedge_law_clear(&own.law);
  tp_wedge_forces_clear(&own.forces);
  tp_wedge_values_clear(own.values);
  for (int k = 0; k < NUMBERS; k++) arb_clear(own.n + k);
}

static void tell_safety(work *w) {
  const tp_loads_description *loads = &w->scene->loads;
  tp_state_ranges state = {.is_static = false}, at_rest = {.is_static = true};
  set_state(&state, w->result);
  tp_solid_safety_add(&w->result->safety, &state);
  if (fmpq_is_zero(loads->horizontal.value) && fmpq_is_zero(loads->vertical.value)) return;
  find_static(&at_rest, w);
  tp_solid_safety_add(&w->result->safety, &at_rest);
}

/* ---- towards azimuths --------------------------------------------------------------------------
 */

static void tell_azimuth(work *w, tp_wedge_azimuth *own, size_t number, size_t count) {
  tp_wedge_way way = TP_WEDGE_UNKNOWN;
  fmpq_t azimuth;
  fmpq_init(azimuth);
  fmpq_set_ui(azimuth, 2 * HALF_TURN * number, count);
  own->azimuth_deg = tp_surface_nearest(azimuth);
  tp_ball_sin_cos_degrees(w->n + EAST, w->n + NORTH, azimuth, BITS);
  fmpq_clear(azimuth);
  own->has_acceleration = tp_wedge_reach(w->n + OWN, &way, &w->law, w->n + EAST, w->n + NORTH);
  own->acceleration_g = tp_ball_bounded(w->n + OWN);
  own->acceleration_slides_on = tp_wedge_way_name(way);
  own->slides_on = tp_wedge_way_name(TP_WEDGE_UNKNOWN);
  if (!is_shaken(w)) return;
  arb_set_fmpq(w->n + OWN, w->scene->loads.horizontal.value, BITS);
  arb_mul(w->n + EAST, w->n + EAST, w->n + OWN, BITS);
  arb_mul(w->n + NORTH, w->n + NORTH, w->n + OWN, BITS);
  const bool is_told =
      tp_wedge_law_at(&way, w->n + DRIVING, w->n + STRENGTH, &w->law, w->n + EAST, w->n + NORTH);
  own->slides_on = tp_wedge_way_name(way);
  own->has_fos = is_told && (way == TP_WEDGE_ON_NONE || arb_is_positive(w->n + DRIVING));
  if (!own->has_fos || way == TP_WEDGE_ON_NONE) return;
  arb_div(w->n + OWN, w->n + STRENGTH, w->n + DRIVING, BITS);
  own->fos = tp_ball_bounded(w->n + OWN);
}

static tp_status tell_azimuths(work *w, size_t count, tp_message *message) {
  tp_solid_wedge *own = w->result;
  own->azimuths = calloc(count + 1, sizeof *own->azimuths);
  if (own->azimuths == NULL) return tp_fail_memory(message, "the azimuths of a wedge");
  own->azimuth_count = count;
  for (size_t k = 0; k < count; k++) tell_azimuth(w, own->azimuths + k, k, count);
  return TP_OK;
}

/* ---- bolts -------------------------------------------------------------------------------------
 */

static tp_status tell_bolts(work *w, tp_message *message) {
  const tp_loads_description *loads = &w->scene->loads;
  tp_solid_wedge *own = w->result;
  own->bolts = calloc((size_t)loads->anchor_count + 1, sizeof *own->bolts);
  if (own->bolts == NULL) return tp_fail_memory(message, "the bolts of a wedge");
  own->bolt_count = (size_t)loads->anchor_count;
  for (size_t k = 0; k < own->bolt_count; k++) {
    const tp_anchor_description *given = loads->anchors + k;
    tp_wedge_bolt *bolt = own->bolts + k;
    bolt->azimuth_deg = tp_surface_nearest(given->azimuth_deg.value);
    bolt->dip_deg = tp_surface_nearest(given->dip_deg.value);
    arb_set_fmpq(w->n + SECOND, given->force_kn.value, BITS);
    bolt->force_n = in_newtons(w, w->n + SECOND);
    bolt->has_capacity = given->capacity_kn.given;
    if (!bolt->has_capacity) continue;
    bolt->capacity_kn = tp_surface_nearest(given->capacity_kn.value);
    arb_set_fmpq(w->n + OWN, given->capacity_kn.value, BITS);
    arb_div(w->n + OWN, w->n + SECOND, w->n + OWN, BITS);
    bolt->utilisation = tp_ball_bounded(w->n + OWN);
  }
  return TP_OK;
}

/* Where the earthquake may come from any azimuth, a force against one of them does not do. */
static void tell_support(work *w) {
  const tp_quantity *required = &w->scene->required_fos;
  if (!required->given || (is_shaken(w) && !w->scene->loads.azimuth_deg.given)) return;
  tp_wedge_support_find(w->result, &w->law, w->shape, w->values, required->value);
}

/* ---- its shape ---------------------------------------------------------------------------------
 */

static double number_of(const tp_quantity *quantity) {
  return quantity->given ? tp_surface_nearest(quantity->value) : 0;
}

static void tell_planes(work *w) {
  const tp_wedge_description *given = &w->scene->solid.wedge;
  for (int k = 0; k < TP_WEDGE_PLANES; k++) {
    tp_wedge_side *side = w->result->sides + k;
    side->dip_deg = number_of(&given->planes[k].dip_deg);
    side->dip_direction_deg = number_of(&given->planes[k].dip_direction_deg);
    if (k > TP_WEDGE_B) continue;
    side->friction_angle_deg = number_of(given->friction_deg + k);
    side->cohesion_kpa = number_of(given->cohesion_kpa + k);
  }
  for (int k = 0; k < TP_WEDGE_POINTS; k++) {
    double at[3];
    for (int i = 0; i < 3; i++) {
      arb_mul(w->n + OWN, w->shape->points[k] + i, &w->forces.metres, BITS);
      at[i] = tp_ball_bounded(w->n + OWN).value;
    }
    w->result->corners[k] = (tp_wedge_corner){at[0], at[1], at[2]};
  }
}

static void tell_shape(work *w) {
  tp_solid_wedge *own = w->result;
  const arb_struct *line = w->shape->line;
  tell_planes(w);
  own->has_crack = w->shape->has_crack;
  own->has_water = w->scene->solid.wedge.has_water;
  own->crack_area_m2 = tp_ball_bounded(w->forces.areas + 2);
  own->water_kpa = tp_ball_bounded(&w->forces.pressure);
  for (int joint = 0; joint < 2; joint++) {
    own->areas_m2[joint] = tp_ball_bounded(w->forces.areas + joint);
  }
  arb_hypot(w->n + OWN, line, line + 1, BITS);
  tp_ball_atan2_degrees(w->n + SECOND, line + 2, w->n + OWN, BITS);
  own->plunge_deg = tp_ball_bounded(w->n + SECOND);
  arb_neg(w->n + OWN, line);
  arb_neg(w->n + SECOND, line + 1);
  tp_ball_atan2_degrees(w->n + OWN, w->n + OWN, w->n + SECOND, BITS);
  if (arb_is_negative(w->n + OWN)) arb_add_ui(w->n + OWN, w->n + OWN, 2 * HALF_TURN, BITS);
  own->trend_deg = tp_ball_bounded(w->n + OWN);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

tp_status tp_wedge_slide(tp_solid_wedge *result, const tp_wedge_shape *shape, const tp_scene *scene,
                         size_t azimuths, tp_message *message) {
  work w = {.shape = shape, .scene = scene, .result = result};
  tp_wedge_least worst = {.found = false};
  for (int k = 0; k < NUMBERS; k++) arb_init(w.n + k);
  tp_wedge_values_init(w.values);
  tp_wedge_forces_init(&w.forces, shape, scene);
  tp_wedge_law_init(&w.law, &w.forces, shape, scene);
  result->worst_slides_on = tp_wedge_way_name(TP_WEDGE_UNKNOWN);
  tell_shape(&w);
  find_worst(&w, &worst);
  tell_way(&w, &worst);
  tell_safety(&w);
  find_acceleration(&w);
  tell_support(&w);
  tp_status status = tell_bolts(&w, message);
  if (status == TP_OK) status = tell_azimuths(&w, azimuths, message);
  tp_wedge_law_clear(&w.law);
  tp_wedge_forces_clear(&w.forces);
  tp_wedge_values_clear(w.values);
  for (int k = 0; k < NUMBERS; k++) arb_clear(w.n + k);
  return status;
}

void tp_solid_wedge_clear(tp_solid_wedge *wedge) {
  free(wedge->azimuths);
  free(wedge->bolts);
}
