/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Profiles of a wanted JRC: it is put as the Z2 that has it by the regression of Tse and Cruden
 * (1979), JRC = 32.2 + 32.47 log10 Z2, for steps of 0.508 mm (1.27 mm on profiles enlarged 2.5
 * times); and profiles that stand in for the ten of Barton and Choubey (1977), of their length, 100
 * mm, and of their JRC as these were back-calculated from shear tests. */

#include "scene/rule_jrc.h"

#include "generate/generate.h"
#include "number/ball.h"
#include "number/ratio.h"

/* In tenths. */
static const long standard_jrc[] = {4, 28, 58, 67, 95, 108, 128, 145, 167, 187};
enum { STANDARDS = sizeof standard_jrc / sizeof standard_jrc[0], STEPS = 200 };

static void set_standard_jrc(fmpq_t jrc, long number) {
  fmpq_set_si(jrc, standard_jrc[number - 1], 10);
}

/* Z2 = 10^((JRC - 32.2) / 32.47), by a ball that is narrower than a double, to the nearest one. */
void tp_z2_of_jrc(fmpq_t z2, const fmpq_t jrc) {
  enum { BITS = 160 };
  fmpq_t number;
  arb_t power, ten;
  fmpq_init(number);
  arb_init(power);
  arb_init(ten);
  fmpq_set_si(number, 322, 10);
  fmpq_sub(z2, jrc, number);
  fmpq_set_si(number, 3247, 100);
  fmpq_div(z2, z2, number);
  arb_set_fmpq(power, z2, BITS);
  arb_set_ui(ten, 10);
  arb_pow(power, ten, power, BITS);
  arf_t nearest;
  arf_init(nearest);
  arf_set_round(nearest, arb_midref(power), 53, ARF_RND_NEAR);
  arf_get_fmpq(z2, nearest);
  arf_clear(nearest);
  fmpq_clear(number);
  arb_clear(power);
  arb_clear(ten);
}

static tp_status check_number(long *number, const tp_quantity *standard, tp_message *message) {
  const fmpq *value = standard->value;
  const bool is_short = fmpz_is_one(fmpq_denref(value)) && fmpz_bits(fmpq_numref(value)) < 8;
  const long own = is_short ? fmpz_get_si(fmpq_numref(value)) : 0;
  if (own >= 1 && own <= (long)STANDARDS) {
    *number = own;
    return TP_OK;
  }
  char text[80];
  tp_ratio_text(text, sizeof text, standard->value);
  return tp_refuse(message, TP_FAULT_RANGE, standard->place,
                   "jrc_profile is the number of a standard profile, 1 to %d; it is %s", STANDARDS,
                   text);
}

/* Self-affine with the exponent 0.8 that fracture surfaces of most rocks have, in steps of 0.5 mm;
 * its number is its seed. */
tp_status tp_rule_make_standard(tp_polyline *line, const tp_profile_rule *rule,
                                const fmpq_t metres_per_unit, tp_message *message) {
  long number = 1;
  bool no_wave = false;
  tp_status status = check_number(&number, &rule->standard, message);
  if (status != TP_OK) return status;
  tp_self_affine_options o;
  tp_self_affine_options_init(&o);
  o.steps = STEPS;
  fmpq_set_si(o.longest, 1, 10);
  fmpq_div(o.longest, o.longest, metres_per_unit);
  fmpq_div_fmpz(o.step, o.longest, (fmpz_t){STEPS});
  fmpq_mul_2exp(o.shortest, o.step, 1);
  o.hurst = 0.8;
  o.target = TP_TARGET_Z2;
  set_standard_jrc(o.size, number);
  tp_z2_of_jrc(o.size, o.size);
  o.seed = (uint64_t)number;
  if (!tp_generate_self_affine(line, &no_wave, &o)) {
    status = tp_fail_memory(message, "the profile");
  }
  tp_self_affine_options_clear(&o);
  return status;
}

/* ---- what is told of it ------------------------------------------------------------------------
 */

/* The JRC of a profile that was made, or scaled, holds by that regression. */
static tp_status note_jrc(tp_notes *notes, const tp_profile_rule *rule, const tp_quantity *jrc,
                          const fmpq_t metres_per_unit, tp_message *message) {
  fmpq_t number;
  fmpq_init(number);
  tp_z2_of_jrc(number, jrc->value);
  const double z2 = fmpq_get_d(number);
  fmpq_mul(number, rule->step.value, metres_per_unit);
  const double mm = 1000 * fmpq_get_d(number);
  fmpq_clear(number);
  if (jrc == rule->scaled + TP_ROUGHNESS_JRC) {
    return tp_notes_add(notes, message, TP_NOTE, jrc->place,
                        "the heights of the base are scaled to a Z2 of %.4g, which the JRC asked "
                        "for has by Tse and Cruden (1979), whose points were 0.508 mm apart",
                        z2);
  }
  return tp_notes_add(
      notes, message, TP_NOTE, jrc->place,
      "the base is generated, self-affine, and none of Barton's profiles: its Z2 of "
      "%.4g is what the JRC asked for has by Tse and Cruden (1979), whose points "
      "were 0.508 mm apart; these are %.4g mm apart",
      z2, mm);
}

static tp_status note_standard(tp_notes *notes, const tp_profile_rule *rule, tp_message *message) {
  long number = 1;
  const tp_status status = check_number(&number, &rule->standard, message);
  if (status != TP_OK) return status;
  fmpq_t jrc;
  fmpq_init(jrc);
  set_standard_jrc(jrc, number);
  const double value = fmpq_get_d(jrc);
  tp_z2_of_jrc(jrc, jrc);
  const double z2 = fmpq_get_d(jrc);
  fmpq_clear(jrc);
  return tp_notes_add(
      notes, message, TP_NOTE, rule->standard.place,
      "the base is generated, self-affine, and none of Barton's profiles: it stands "
      "in for the standard profile %ld by its length of 100 mm and its JRC of %.3g, "
      "as the Z2 of %.4g that this has by Tse and Cruden (1979); points are 0.5 mm "
      "apart",
      number, value, z2);
}

tp_status tp_profile_rule_notes(tp_notes *notes, const tp_profile_rule *rule,
                                const fmpq_t metres_per_unit, tp_message *message) {
  const tp_quantity *own = rule->roughness + TP_ROUGHNESS_JRC;
  const tp_quantity *scaled = rule->scaled + TP_ROUGHNESS_JRC;
  tp_status status = TP_OK;
  if (rule->made == TP_MADE_LIKE_STANDARD) status = note_standard(notes, rule, message);
  if (rule->made == TP_MADE_SELF_AFFINE && own->given) {
    status = note_jrc(notes, rule, own, metres_per_unit, message);
  }
  if (status != TP_OK || !scaled->given) return status;
  return note_jrc(notes, rule, scaled, metres_per_unit, message);
}
