/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Defaults of the options of a solid, and their doubles as the shortest decimals that name them;
 * and a scene. */

#include "solid_tilt/solid_given.h"

#include "common/options.h"
#include "number/ratio.h"
#include "solid/dipping.h"

#include <stdlib.h>

TP_OPTIONS_END(tp_solid_options, thin);

enum { AZIMUTHS = 72, OWN_BANDS = 4 };

void tp_solid_options_init(tp_solid_options *options, size_t size) {
  const tp_solid_options defaults = {.size = sizeof defaults,
                                     .friction_angle_deg = -1,
                                     .up = {0, 0, 1},
                                     .azimuths = AZIMUTHS,
                                     .below = -1};
  tp_options_fill(options, size, &defaults);
}

static tp_status refuse(tp_message *message, tp_fault fault, const char *what) {
  return tp_refuse(message, fault, (tp_place){0}, "%s", what);
}

static tp_status take_unit(tp_solid_given *given, const char *unit, tp_message *message) {
  given->has_unit = unit != NULL;
  given->length_unit = unit != NULL ? unit : "m";
  if (tp_unit_find(given->metres_per_unit, &given->length_unit)) return TP_OK;
  return refuse(message, TP_FAULT_UNIT,
                "the unit of a solid's lengths must be one of mm, cm, m, "
                "km, in, ft");
}

/* To whole numbers of the same direction. */
static void set_up(tp_solid_given *given, const fmpq parts[3]) {
  fmpz_t divisor;
  fmpz_init_set_ui(divisor, 1);
  for (int k = 0; k < 3; k++) fmpz_lcm(divisor, divisor, fmpq_denref(parts + k));
  for (int k = 0; k < 3; k++) {
    fmpz_divexact(given->up + k, divisor, fmpq_denref(parts + k));
    fmpz_mul(given->up + k, given->up + k, fmpq_numref(parts + k));
  }
  fmpz_clear(divisor);
}

static tp_status take_up(tp_solid_given *given, const double up[3], tp_message *message) {
  fmpq parts[3];
  bool done = true;
  for (int k = 0; k < 3; k++) {
    fmpq_init(parts + k);
    done = done && tp_ratio_read_double(parts + k, up[k]);
  }
  if (done) set_up(given, parts);
  for (int k = 0; k < 3; k++) fmpq_clear(parts + k);
  done = done &&
         !(fmpz_is_zero(given->up) && fmpz_is_zero(given->up + 1) && fmpz_is_zero(given->up + 2));
  return done ? TP_OK
              : refuse(message, TP_FAULT_RANGE,
                       "up must be three finite numbers, of which one at least is not 0");
}

static tp_status make_bands(tp_solid_given *given, size_t count, tp_message *message) {
  given->bands = calloc(count + 1, sizeof *given->bands);
  if (given->bands == NULL) return tp_fail_memory(message, "the bands of a solid");
  for (; given->band_count < count; given->band_count++) {
    fmpq_init(given->bands + given->band_count);
  }
  return TP_OK;
}

static tp_status take_bands(tp_solid_given *given, const tp_solid_options *o, tp_message *message) {
  if (o->bands == NULL) {
    return o->band_count == 0
               ? TP_OK
               : refuse(message, TP_FAULT_ARGUMENT, "a count of bands is given, but no bands");
  }
  if (o->band_count == 0 || o->band_count > TP_SOLID_BANDS) {
    return refuse(message, TP_FAULT_RANGE, "of bands there may be 1 to 100");
  }
  tp_status status = make_bands(given, o->band_count, message);
  for (size_t k = 0; k < given->band_count && status == TP_OK; k++) {
    if (tp_ratio_read_double(given->bands + k, o->bands[k]) && fmpq_sgn(given->bands + k) >= 0) {
      continue;
    }
    status = refuse(message, TP_FAULT_RANGE, "a band must be a finite length of 0 or more");
  }
  return status;
}

/* A rock that a plane cuts rests on all of the section and no more: its band is 0. */
static tp_status take_cut(tp_solid_given *given, tp_message *message) {
  given->has_below = true;
  return make_bands(given, 1, message);
}

static tp_status take_below(tp_solid_given *given, const tp_solid_options *o, tp_message *message) {
  if (o->below < 0) return take_bands(given, o, message);
  if (o->bands != NULL) {
    return refuse(message, TP_FAULT_ARGUMENT,
                  "a rock rests on what lies within its bands, or on the section of a plane that "
                  "cuts it so far over its lowest point: give one of both");
  }
  return tp_ratio_read_double(given->below, o->below)
             ? take_cut(given, message)
             : refuse(message, TP_FAULT_RANGE,
                      "the height of the plane that cuts the rock must be a finite length of 0 or "
                      "more");
}

static void start(tp_solid_given *given) {
  *given = (tp_solid_given){.length_unit = NULL};
  fmpq_init(given->metres_per_unit);
  fmpq_init(given->unit_weight);
  fmpq_init(given->band_lengths);
  fmpq_init(given->below);
  for (int k = 0; k < 3; k++) fmpz_init(given->up + k);
}

/* What is to be done to the mesh. */
static tp_status check_repair(const tp_solid_options *options, tp_message *message) {
  const double within = options->repair_merge_within, below = options->repair_drop_below;
  if (!options->repair && (within != 0 || below != 0)) {
    return refuse(message, TP_FAULT_KEY,
                  "points are merged and pieces dropped by a repair: ask for it too");
  }
  if (!(isfinite(options->thin) && options->thin >= 0)) {
    return refuse(message, TP_FAULT_RANGE,
                  "a mesh is thinned by a finite length above 0, or 0 where it is not");
  }
  return isfinite(within) && within >= 0 && below >= 0 && below < 1
             ? TP_OK
             : refuse(message, TP_FAULT_RANGE,
                      "a repair merges points within a length of 0 or more, and drops pieces below "
                      "a share of the area from 0 to below 1");
}

tp_status tp_solid_given_init(tp_solid_given *given, const tp_solid_options *options,
                              tp_message *message) {
  start(given);
  fmpq_one(given->band_lengths);
  given->has_friction = options->friction_angle_deg >= 0;
  given->friction_angle_deg = options->friction_angle_deg;
  given->azimuths = options->azimuths;
  tp_status status = take_unit(given, options->length_unit, message);
  if (status == TP_OK) status = take_up(given, options->up, message);
  if (status == TP_OK && !(tp_ratio_read_double(given->unit_weight, options->unit_weight_kn_m3) &&
                           fmpq_sgn(given->unit_weight) >= 0)) {
    status = refuse(message, TP_FAULT_RANGE,
                    "the unit weight must be a finite number above 0, or 0 where it is not known");
  }
  if (status == TP_OK && !(options->friction_angle_deg < 90)) {
    status = refuse(message, TP_FAULT_RANGE, "the friction angle must lie between 0 and below 90");
  }
  if (status == TP_OK && (options->azimuths == 0 || options->azimuths > TP_SOLID_AZIMUTHS)) {
    status = refuse(message, TP_FAULT_RANGE, "a rose has 1 to 36000 azimuths");
  }
  if (status == TP_OK) status = check_repair(options, message);
  return status == TP_OK ? take_below(given, options, message) : status;
}

/* ---- a scene -----------------------------------------------------------------------------------
 */

/* From the vertical to across the base. */
static void lay_on_slope(tp_solid_given *given, const tp_solid_description *own) {
  fmpz normal[3];
  for (int k = 0; k < 3; k++) fmpz_init(normal + k);
  tp_dipping_base_set(normal, &given->frame, given->up, own->dip_deg.value,
                      own->dip_direction_deg.value);
  for (int k = 0; k < 3; k++) {
    fmpz_swap(given->up + k, normal + k);
    fmpz_clear(normal + k);
  }
  given->is_on_slope = true;
}

/* Its bands are over the ground, not over a plane. */
static void take_ground(tp_solid_given *given) {
  given->ground_bands = given->bands;
  given->ground_band_count = given->band_count;
  given->bands = NULL;
  given->band_count = 0;
}

tp_status tp_solid_given_of_scene(tp_solid_given *given, const tp_scene *scene,
                                  tp_message *message) {
  const tp_solid_description *own = &scene->solid;
  start(given);
  given->scene = scene;
  given->length_unit = scene->length_unit;
  given->has_unit = true;
  fmpq_set(given->metres_per_unit, own->metres_per_unit);
  fmpq_div(given->band_lengths, scene->metres_per_unit, own->metres_per_unit);
  if (own->unit_weight_kn_m3.given) fmpq_set(given->unit_weight, own->unit_weight_kn_m3.value);
  given->has_friction = scene->friction_angle_deg.given;
  if (given->has_friction) {
    given->friction_angle_deg = tp_surface_nearest(scene->friction_angle_deg.value);
  }
  given->azimuths =
      own->azimuths.given ? (size_t)fmpz_get_ui(fmpq_numref(own->azimuths.value)) : AZIMUTHS;
  set_up(given, own->up);
  if (own->dip_deg.given) lay_on_slope(given, own);
  if (own->below.given) {
    fmpq_mul(given->below, own->below.value, given->band_lengths);
    return take_cut(given, message);
  }
  const tp_status status = make_bands(given, (size_t)own->band_count, message);
  for (size_t k = 0; k < given->band_count; k++) {
    fmpq_mul(given->bands + k, own->bands + k, given->band_lengths);
  }
  given->contacts = own->contacts;
  given->contact_count = own->contact_count;
  if (status == TP_OK && own->ground.place.file != NULL) take_ground(given);
  return status;
}

void tp_solid_given_clear(tp_solid_given *given) {
  for (size_t k = 0; k < given->band_count; k++) fmpq_clear(given->bands + k);
  free(given->bands);
  for (size_t k = 0; k < given->ground_band_count; k++) fmpq_clear(given->ground_bands + k);
  free(given->ground_bands);
  for (int k = 0; k < 3; k++) fmpz_clear(given->up + k);
  fmpq_clear(given->metres_per_unit);
  fmpq_clear(given->unit_weight);
  fmpq_clear(given->band_lengths);
  fmpq_clear(given->below);
}

tp_status tp_solid_given_bands(tp_solid_given *given, double height, tp_message *message) {
  const tp_status status = make_bands(given, OWN_BANDS, message);
  if (status != TP_OK) return status;
  const double hundredth = height / 100;
  long power = (long)floor(log10(hundredth));
  for (int k = OWN_BANDS - 1; k > 0; k--, power--) {
    fmpq_set_si(given->bands + k, 10, 1);
    fmpq_pow_si(given->bands + k, given->bands + k, power);
  }
  return TP_OK;
}
