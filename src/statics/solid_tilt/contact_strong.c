/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers of a section are good to 1e-12 of themselves, which each bound here leaves. */

#include "solid_tilt/contact_strong.h"

#include "number/near_angle.h"
#include "solid/tilting.h"
#include "solid_contacts/solid_section_onset.h"
#include "solid_tilt/contact_exclusion.h"
#include "solid_tilt/contact_plane.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- contacts as a plane -----------------------------------------------------------------------
 */

static bool is_parallel(const fmpq a[3], const fmpq b[3]) {
  fmpq_t entry, other;
  bool same = true;
  fmpq_init(entry);
  fmpq_init(other);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpq_mul(entry, a + i, b + j);
    fmpq_mul(other, a + j, b + i);
    same = same && fmpq_equal(entry, other);
  }
  fmpq_clear(entry);
  fmpq_clear(other);
  return same;
}

static bool faces_as(const fmpq a[3], const fmpq b[3]) {
  for (int k = 0; k < 3; k++) {
    if (fmpq_sgn(a + k) != fmpq_sgn(b + k)) return false;
  }
  return is_parallel(a, b);
}

/* Do the contacts lie on one line, or in one point? */
static bool is_on_line(const tp_friction_cones *cones) {
  fmpq way[3], entry[3];
  bool on_line = true, has_way = false;
  for (int k = 0; k < 3; k++) {
    fmpq_init(way + k);
    fmpq_init(entry + k);
  }
  for (long n = 1; n < cones->count; n++) {
    for (int k = 0; k < 3; k++) fmpq_sub(entry + k, cones->cones[n].at + k, cones->cones[0].at + k);
    on_line = on_line && (!has_way || is_parallel(way, entry));
    for (int k = 0; k < 3 && !has_way; k++) fmpq_set(way + k, entry + k);
    has_way = !(fmpq_is_zero(way) && fmpq_is_zero(way + 1) && fmpq_is_zero(way + 2));
  }
  for (int k = 0; k < 3; k++) {
    fmpq_clear(way + k);
    fmpq_clear(entry + k);
  }
  return on_line;
}

/* Is the way between two points of one normal so steep that each could press against the other? */
static bool is_steep(const tp_friction_cone *a, const tp_friction_cone *b) {
  double along = 0, square = 0;
  for (int k = 0; k < 3; k++) {
    const double way = b->near_at[k].value - a->near_at[k].value;
    along += way * a->unit[k];
    square += way * way;
  }
  static const double noise = 1e-9;
  const double across = sqrt(fmax(0, square - along * along));
  return fabs(along) * a->friction.value * (1 + noise) + noise * sqrt(square) > across &&
         fabs(along) > noise;
}

static bool is_plane(const tp_friction_cones *cones) {
  for (long n = 1; n < cones->count; n++) {
    const tp_friction_cone *entry = cones->cones + n;
    if (!faces_as(cones->cones[0].normal, entry->normal) ||
        entry->friction.value != cones->cones[0].friction.value) {
      return false;
    }
    for (long k = 0; k < n; k++) {
      if (is_steep(cones->cones + k, entry)) return false;
    }
  }
  return true;
}

/* ---- start -------------------------------------------------------------------------------------
 */

static bool init_smooth(tp_strong_side *strong, const tp_friction_cones *cones) {
  strong->smooth.cones = calloc((size_t)cones->count + 1, sizeof *strong->smooth.cones);
  if (strong->smooth.cones == NULL) return false;
  strong->smooth.count = cones->count;
  for (long n = 0; n < cones->count; n++) {
    strong->smooth.cones[n] = cones->cones[n];
    strong->smooth.cones[n].friction = (tp_near){0, 0};
  }
  return tp_hold_init(&strong->without, &strong->smooth, 1);
}

bool tp_contact_strong_init(tp_strong_side *strong, const tp_contact_work *w) {
  const tp_friction_cones *cones = &w->points.cones;
  const bool on_line = is_on_line(cones), one_normal = w->given->has_mean_normals;
  *strong = (tp_strong_side){.is_on_line = on_line,
                             .is_plane = !on_line && (one_normal || is_plane(cones))};
  if (strong->is_plane) return tp_contact_plane_find(&strong->is_proven_plane, w);
  const tp_solid_section_inertia inertia = tp_contacts_inertia(w);
  tp_hold_load load;
  tp_hold_load_init(&load);
  tp_hold_frame_scene(&load, &w->frame, w->given->scene);
  bool done =
      tp_solid_section_init(&strong->has_section, &strong->section, cones, &inertia, load.exact);
  tp_hold_load_clear(&load);
  return done && init_smooth(strong, cones);
}

void tp_contact_strong_clear(tp_strong_side *strong) {
  if (strong->is_plane) return;
  tp_solid_section_clear(&strong->section);
  tp_hold_clear(&strong->without);
  free(strong->smooth.cones);
}

/* ---- factors -----------------------------------------------------------------------------------
 */

static double upper_end(tp_near number) {
  const double end = number.value + number.error;
  return isfinite(end) ? nextafter(fmax(0, end), INFINITY) : INFINITY;
}

/* Up to where forces hold: multiples of what drives, divisors of friction. */
static double most_driving(const tp_weak_side *weak) {
  if (!weak->rests) return 0;
  return weak->limit.is_open || weak->limit.is_endless ? INFINITY : upper_end(weak->limit.t);
}

static double most_strength(const tp_weak_side *weak) {
  if (weak->kind == TP_HOLD_POWERLESS) return 0;
  return weak->kind == TP_HOLD_FACTOR ? upper_end(weak->factor) : INFINITY;
}

static tp_mechanism mechanism_of(const tp_contact_work *w, const double twist[TP_WRENCH]) {
  tp_solid_motion motion;
  bool any = false;
  for (int k = 0; k < TP_WRENCH; k++) any = any || twist[k] != 0;
  if (!any) return TP_MECHANISM_UNDECIDED;
  tp_contacts_motion(&motion, w, twist);
  return motion.mechanism;
}

/* On a plane what forces hold stays. */
static void take_flat(tp_state_ranges *state, const tp_contact_work *w, const tp_weak_side *weak) {
  state->verdict = weak->side == TP_HOLD_MOVES                      ? TP_VERDICT_COLLAPSES
                   : weak->side == TP_HOLD_HOLDS && weak->least > 0 ? TP_VERDICT_STANDS
                                                                    : TP_VERDICT_OPEN;
  if (!weak->rests) {
    tp_state_ranges_add(state, TP_FOS_BY_DRIVING, TP_MECHANISM_UNDECIDED, 0, 0);
  } else if (weak->limit.is_open) {
    tp_state_ranges_add(state, TP_FOS_BY_DRIVING, TP_MECHANISM_UNDECIDED, 0, INFINITY);
  } else if (!weak->limit.is_endless) {
    tp_state_ranges_add_near(state, TP_FOS_BY_DRIVING, mechanism_of(w, weak->limit.twist),
                             weak->limit.t);
  }
  if (weak->kind == TP_HOLD_FACTOR) {
    tp_state_ranges_add_near(state, TP_FOS_BY_REDUCTION, mechanism_of(w, weak->beyond),
                             weak->factor);
  } else if (weak->kind == TP_HOLD_FACTOR_OPEN) {
    tp_state_ranges_add(state, TP_FOS_BY_REDUCTION, TP_MECHANISM_UNDECIDED, 0, INFINITY);
  }
}

/* Also where forces no longer hold the load: loads between two that stay do. */
static bool stays_to_limit(const tp_contact_work *w, const tp_weak_side *weak) {
  tp_hold_load load;
  fmpq_t multiple;
  if (weak->limit.is_endless || !weak->drives) return true;
  if (weak->limit.is_open) return false;
  tp_hold_load_init(&load);
  fmpq_init(multiple);
  tp_hold_double(multiple, upper_end(weak->limit.t));
  for (int k = 0; k < 3; k++) {
    fmpq_set(load.exact + k, weak->rest.exact + k);
    fmpq_addmul(load.exact + k, weak->way.exact + k, multiple);
  }
  tp_hold_load_settle(&load);
  const bool stays = tp_contact_plane_stays(w, &load);
  fmpq_clear(multiple);
  tp_hold_load_clear(&load);
  return stays;
}

/* Where that is not proven of a plane, by exclusion. */
static bool take_plane(tp_state_ranges *state, const tp_strong_side *strong,
                       const tp_contact_work *w, const tp_weak_side *weak) {
  const bool is_given = w->given->has_mean_normals || weak->side != TP_HOLD_HOLDS;
  take_flat(state, w, weak);
  if (is_given) return true;
  const bool stands = strong->is_proven_plane && tp_contact_plane_stays(w, &weak->load);
  if (stands && stays_to_limit(w, weak)) return true;
  tp_contact_exclusion excluded;
  if (!tp_contact_exclusion_find(&excluded, w, weak)) return false;
  if (!stands && !excluded.stands) state->verdict = TP_VERDICT_OPEN;
  for (size_t k = 0; k < state->count; k++) {
    tp_factor_range *range = state->ranges + k;
    const bool drives = range->definition == TP_FOS_BY_DRIVING;
    const double least = !stands && !excluded.stands ? 0
                         : drives                    ? excluded.driving
                                                     : excluded.strength;
    if (drives || !stands) range->least = fmin(range->least, least);
  }
  return true;
}

/* A number of a section, with its bounds; of the weak side where this is less. */
static void take_onset(tp_state_ranges *state, tp_fos_definition definition, double share,
                       const tp_solid_section_onset *onset, const tp_contact_work *w,
                       const double weak_twist[TP_WRENCH]) {
  const tp_mechanism entry = mechanism_of(w, onset->twist);
  const double least = fmax(0, onset->x - share * (1 + onset->x));
  const double most = onset->x == 0 ? 0 : onset->x + share * (1 + onset->x);
  tp_state_ranges_add(state, definition,
                      entry != TP_MECHANISM_UNDECIDED ? entry : mechanism_of(w, weak_twist),
                      onset->is_endless ? INFINITY : least, onset->is_endless ? INFINITY : most);
}

static bool take_section(tp_state_ranges *state, const tp_strong_side *strong,
                         const tp_contact_work *w, const tp_weak_side *weak) {
  static const double linear = 1e-12, quadratic = 1e-9;
  tp_solid_section_onset driving = {.is_endless = true}, strength = {.is_endless = true};
  if (!tp_solid_section_driving(&driving, &strong->section, &weak->rest, &weak->way, 1,
                                most_driving(weak)) ||
      !tp_solid_section_strength(&strength, &strong->section, &weak->load, most_strength(weak))) {
    return false;
  }
  const bool moves = driving.moves_at_from || strength.moves_at_from;
  const bool near_one = (!driving.is_endless && fabs(driving.x - 1) <= 4 * linear) ||
                        (!strength.is_endless && fabs(strength.x - 1) <= 2 * quadratic);
  bool holds = weak->side == TP_HOLD_HOLDS;
  if (weak->side == TP_HOLD_OPEN &&
      !tp_solid_section_holds(&holds, &strong->section, &weak->load)) {
    return false;
  }
  const bool agree = !near_one && driving.moves_at_from == strength.moves_at_from;
  state->verdict = weak->side == TP_HOLD_MOVES ? TP_VERDICT_COLLAPSES
                   : agree && moves            ? TP_VERDICT_CAN_MOVE
                   : agree && holds            ? TP_VERDICT_STANDS
                                               : TP_VERDICT_OPEN;
  if (weak->drives) {
    take_onset(state, TP_FOS_BY_DRIVING, linear, &driving, w, weak->limit.twist);
  }
  /* where it moves however much strength there is, strength is no measure of it */
  if (!(strength.moves_at_from && strength.x == 0)) {
    take_onset(state, TP_FOS_BY_REDUCTION, quadratic, &strength, w, weak->beyond);
  }
  return true;
}

/* Without friction: from the load on, as far as that holds. Else by exclusion: as it is. */
static bool take_smooth(tp_state_ranges *state, tp_strong_side *strong, const tp_contact_work *w,
                        const tp_weak_side *weak) {
  tp_hold_side side = TP_HOLD_OPEN;
  tp_hold_limit limit = {.is_open = true};
  double twist[TP_WRENCH];
  if (!tp_hold_load_side(&side, twist, &strong->without, &weak->load)) return false;
  /* on a line, or with a contact that bears nothing, it is balanced at best */
  const bool stands = side == TP_HOLD_HOLDS && strong->without.found.t > 0 && !strong->is_on_line;
  if (stands && weak->drives &&
      !tp_hold_limit_find(&limit, &strong->without, &weak->load, &weak->way)) {
    return false;
  }
  tp_contact_exclusion excluded = {.stands = false};
  if (!stands && !strong->is_on_line && !tp_contact_exclusion_find(&excluded, w, weak)) {
    return false;
  }
  state->verdict = weak->side == TP_HOLD_MOVES ? TP_VERDICT_COLLAPSES
                   : stands || excluded.stands ? TP_VERDICT_STANDS
                                               : TP_VERDICT_OPEN;
  const double most = most_driving(weak);
  const double further = limit.is_open ? 0 : fmax(0, limit.t.value - limit.t.error);
  const bool endless = limit.is_endless || !weak->drives;
  if (weak->drives) {
    const double least = !stands   ? (excluded.stands ? excluded.driving : 0)
                         : endless ? INFINITY
                                   : nextafter(1 + further, 0);
    tp_state_ranges_add(state, TP_FOS_BY_DRIVING, mechanism_of(w, weak->limit.twist),
                        fmin(least, most), most);
  }
  if (!stands) {
    tp_state_ranges_add(state, TP_FOS_BY_REDUCTION, mechanism_of(w, weak->beyond),
                        excluded.stands ? excluded.strength : 0,
                        most_strength(weak) > 0 ? most_strength(weak) : INFINITY);
  }
  return true;
}

bool tp_contact_strong_find(tp_state_ranges *state, tp_strong_side *strong,
                            const tp_contact_work *w, const tp_weak_side *weak) {
  strong->is_held = weak->side == TP_HOLD_HOLDS;
  if (strong->is_plane) {
    return take_plane(state, strong, w, weak);
  }
  const bool in_section = strong->has_section &&
                          tp_solid_section_has_load(&strong->section, &weak->load) &&
                          tp_solid_section_has_load(&strong->section, &weak->rest);
  if (!state->is_static) w->results->is_in_section = in_section;
  return in_section ? take_section(state, strong, w, weak) : take_smooth(state, strong, w, weak);
}

/* ---- onsets ------------------------------------------------------------------------------------
 */

static bool has_section(const tp_strong_side *strong, const tp_hold_load *load,
                        const tp_hold_load *way) {
  return strong->has_section && tp_solid_section_has_load(&strong->section, load) &&
         tp_solid_section_has_load(&strong->section, way);
}

static bool find_from_level(tp_solid_section_onset *onset, const tp_strong_side *strong,
                            const tp_hold_load *load, const tp_hold_load *way) {
  *onset = (tp_solid_section_onset){.is_endless = true};
  if (!has_section(strong, load, way)) return true;
  return tp_solid_section_driving(onset, &strong->section, load, way, 0, INFINITY);
}

static tp_near near_of(const tp_solid_section_onset *onset) {
  static const double share = 1e-12;
  return (tp_near){onset->x, share * (1 + onset->x)};
}

/* Where no section has them: up to which t all motions are excluded; not of tables of many. */
static bool find_excluded(double *reached, const tp_strong_side *strong, tp_contact_work *w,
                          const tp_level_loads *loads, const tp_hold_load *way) {
  tp_hold_limit limit;
  tp_hold_side side = TP_HOLD_OPEN;
  double twist[TP_WRENCH];
  *reached = 0;
  if (strong->is_on_line || w->given->azimuths == 0) return true;
  if (!tp_hold_load_side(&side, twist, &w->hold, &loads->load)) return false;
  if (side != TP_HOLD_HOLDS) return true;
  if (!tp_hold_limit_find(&limit, &w->hold, &loads->load, way)) return false;
  const double most = limit.is_open      ? 0
                      : limit.is_endless ? INFINITY
                                         : limit.t.value - limit.t.error;
  return tp_contact_exclusion_from(reached, w, &loads->load, way, most);
}

/* Towards the azimuth of its tilt. */
static bool find_tilt(const tp_strong_side *strong, tp_contact_work *w) {
  const tp_quantity *azimuth = &w->given->scene->tilt_azimuth_deg;
  tp_solid_contacts *entry = w->results;
  tp_solid_section_onset onset = {.is_endless = true};
  double reached = 0;
  if (!azimuth->given) return true;
  tp_hold_load way;
  tp_hold_load_init(&way);
  tp_hold_frame_way(&way, &w->frame, azimuth->value);
  const bool in_section = has_section(strong, &w->level.load, &way);
  const bool done = in_section ? find_from_level(&onset, strong, &w->level.load, &way)
                               : find_excluded(&reached, strong, w, &w->level, &way);
  entry->has_onset = done && !onset.is_endless;
  if (entry->has_onset) entry->onset_deg = tp_near_bounded(tp_near_arctangent(near_of(&onset)));
  entry->has_certain = done && reached > 0;
  if (entry->has_certain) {
    const tp_near degrees = tp_near_arctangent((tp_near){reached, 0});
    entry->certain_to_stand_deg = nextafter(degrees.value - degrees.error, 0);
  }
  tp_hold_load_clear(&way);
  return done;
}

/* Towards the azimuth of its earthquake, or of its tilt. */
static bool find_acceleration(const tp_strong_side *strong, const tp_contact_work *w) {
  const tp_scene *scene = w->given->scene;
  const tp_quantity *azimuth =
      scene->loads.azimuth_deg.given ? &scene->loads.azimuth_deg : &scene->tilt_azimuth_deg;
  tp_solid_contacts *entry = w->results;
  tp_solid_section_onset onset;
  if (!azimuth->given) return true;
  tp_hold_load way;
  tp_hold_load_init(&way);
  tp_hold_frame_shake(&way, &w->frame, scene, azimuth->value);
  const bool done = find_from_level(&onset, strong, &w->tilted.load, &way);
  entry->has_onset_acceleration = done && !onset.is_endless && !onset.moves_at_from;
  if (entry->has_onset_acceleration) entry->onset_acceleration_g = tp_near_bounded(near_of(&onset));
  tp_hold_load_clear(&way);
  return done;
}

bool tp_contact_strong_onsets(const tp_strong_side *strong, tp_contact_work *w) {
  return strong->is_plane || (find_tilt(strong, w) && find_acceleration(strong, w));
}
