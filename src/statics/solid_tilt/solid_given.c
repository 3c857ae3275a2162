/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Defaults of the options of a solid, and their doubles as the shortest decimals that name them. */

#include "solid_tilt/solid_given.h"

#include "common/options.h"
#include "number/ratio.h"
#include "scene/scene.h"

#include <stdlib.h>

TP_OPTIONS_END(tp_solid_options, azimuths);

enum { AZIMUTHS = 72, OWN_BANDS = 4 };

void tp_solid_options_init(tp_solid_options *options, size_t size) {
  const tp_solid_options defaults = {
      .size = sizeof defaults, .friction_angle_deg = -1, .up = {0, 0, 1}, .azimuths = AZIMUTHS};
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
static tp_status take_up(tp_solid_given *given, const double up[3], tp_message *message) {
  fmpq parts[3];
  fmpz_t divisor;
  bool done = true;
  fmpz_init_set_ui(divisor, 1);
  for (int k = 0; k < 3; k++) {
    fmpq_init(parts + k);
    done = done && tp_ratio_read_double(parts + k, up[k]);
    fmpz_lcm(divisor, divisor, fmpq_denref(parts + k));
  }
  for (int k = 0; k < 3; k++) {
    fmpz_divexact(given->up + k, divisor, fmpq_denref(parts + k));
    fmpz_mul(given->up + k, given->up + k, fmpq_numref(parts + k));
    fmpq_clear(parts + k);
  }
  fmpz_clear(divisor);
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

tp_status tp_solid_given_init(tp_solid_given *given, const tp_solid_options *options,
                              tp_message *message) {
  *given = (tp_solid_given){.length_unit = NULL};
  fmpq_init(given->metres_per_unit);
  fmpq_init(given->unit_weight);
  for (int k = 0; k < 3; k++) fmpz_init(given->up + k);
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
  return status == TP_OK ? take_bands(given, options, message) : status;
}

void tp_solid_given_clear(tp_solid_given *given) {
  for (size_t k = 0; k < given->band_count; k++) fmpq_clear(given->bands + k);
  free(given->bands);
  for (int k = 0; k < 3; k++) fmpz_clear(given->up + k);
  fmpq_clear(given->metres_per_unit);
  fmpq_clear(given->unit_weight);
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
