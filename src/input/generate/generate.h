/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Profiles made by rule: teeth, self-affine ones, noise on a profile, heights scaled, and wear of
 * asperities.
 *
 * The same options give the same exact coordinates on any machine that has the arithmetic of IEEE
 * 754 in doubles: random numbers are whole numbers of 64 bits (random.h), and what is computed in
 * doubles takes + - * / and square roots alone, which are correctly rounded, in one order. No sine,
 * power or logarithm of a mathematical library enters, as their last bits differ. What is not exact
 * already is rounded to decimals, of which each function says how many.
 *
 * Every function is pure: options in, a chain of points out. The caller has checked the ranges that
 * stand beside the options. False: memory is exhausted, and the chain is untouched. */

#ifndef TP_GENERATE_GENERATE_H
#define TP_GENERATE_GENERATE_H

#include "common/budget.h"
#include "plane/polyline.h"
#include "topple_generate.h"

#include <stdint.h>

/* Teeth: `count` facets, two a tooth, of a wavelength and an amplitude, both above zero. Rising
 * facets (to the right) take the share (1 + skew) / 2 of the wavelength. Each tooth has its own
 * wavelength and skew, each peak its own amplitude: those times 1 + scatter u, and skew + scatter
 * u, u evenly within (-1, 1). Scatter of the amplitude is in [0, 1], that of the wavelength in [0,
 * 0.9], and |skew| and its scatter are together at most 0.9.
 *
 * Exact where there is no scatter; x is rounded to a millionth of the wavelength where that or the
 * skew is scattered, y to a millionth of the amplitude where that is, to a power of ten. */
typedef struct tp_teeth_options {
  long count;
  fmpq_t wavelength, amplitude, skew;
  fmpq_t wavelength_scatter, amplitude_scatter, skew_scatter;
  fmpq_t x, y;          /* of the left end, y at the height of the valleys */
  bool left_end_valley; /* else it is a peak */
  uint64_t seed;
} tp_teeth_options;

void tp_teeth_options_init(tp_teeth_options *options);
void tp_teeth_options_clear(tp_teeth_options *options);
TP_MUST_USE bool tp_generate_teeth(tp_polyline *line, const tp_teeth_options *options);

/* What a self-affine profile is scaled to: its RMS height about its mean line, or its Z2. */
typedef enum tp_self_affine_target { TP_TARGET_RMS_HEIGHT, TP_TARGET_Z2 } tp_self_affine_target;

/* A self-affine profile: `steps` + 1 points, a step apart, 1 <= steps < TP_SELF_AFFINE_MOST, whose
 * one-sided power spectral density falls as frequency^-(2 hurst + 1) between 1 / longest and 1 /
 * shortest, and is zero beyond; 0 < hurst < 1, 2 step <= shortest < longest <= steps step. */
typedef struct tp_self_affine_options {
  long steps;
  fmpq_t step, shortest, longest;
  fmpq_t x, y; /* of the left end of the mean line */
  double hurst;
  tp_self_affine_target target;
  fmpq_t size; /* of the target, above zero */
  uint64_t seed;
} tp_self_affine_options;

enum { TP_SELF_AFFINE_LEAST = 8, TP_SELF_AFFINE_MOST = TP_BUDGET_PROFILE_POINTS };

void tp_self_affine_options_init(tp_self_affine_options *options);
void tp_self_affine_options_clear(tp_self_affine_options *options);
/* `no_wave`: no wave of the period lies between the cut-offs, and there is no profile. */
TP_MUST_USE bool tp_generate_self_affine(tp_polyline *line, bool *no_wave,
                                         const tp_self_affine_options *options);

/* Move every point along y by a random number of mean zero and standard deviation `deviation`,
 * above zero: the sum of twelve even ones, nearly normal and never beyond six deviations, rounded
 * to a millionth of a deviation or finer, to a power of ten. */
void tp_add_noise(tp_polyline *line, const fmpq_t deviation, uint64_t seed);

/* `line` becomes the worn profile; a corner is rounded by at most half of its edges. Coordinates
 * that are new are rounded to a millionth of the depth or finer, to a power of ten; an x is kept
 * between its neighbours. The depth is above zero, and less than the highest point stands above the
 * lowest (cut) or above the mean (abraded). */
TP_MUST_USE bool tp_wear_off(tp_polyline *line, tp_wear wear, const fmpq_t depth);

/* How rough a chain is. */
typedef struct tp_roughness {
  double size; /* the RMS height about its mean, between its points too, or Z2; 0: it is level */
  double mean_rise; /* of |dy| from point to point */
  long lowest;      /* the index of a lowest point */
} tp_roughness;

/* As topple profile has it. False: the chain steps upright or folds back, or is out of the range of
 * doubles. */
TP_MUST_USE bool tp_roughness_of(tp_roughness *roughness, const tp_polyline *line,
                                 tp_self_affine_target target);
/* Stretch the heights over the lowest point, which are as rough as `own`, until they are `size`,
 * above zero. Heights are rounded to a millionth of the mean rise or finer, to a power of ten. */
void tp_scale_heights(tp_polyline *line, const fmpq_t size, const tp_roughness *own);

/* By how much the highest point stands above the lowest, or above the mean of all. */
void tp_wear_most(fmpq_t most, const tp_polyline *line, tp_wear wear);

#endif
