/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bases made by rule, for scenes that are built in memory (docs/generate.md): the same rule gives
 * the same exact coordinates on any machine. Included by topple.h.
 *
 *     tp_base_self_affine_options rough = tp_base_self_affine_options_default();
 *     rough.length = tp_exact_of(100);
 *     rough.step = tp_exact_text("0.5");
 *     rough.hurst = tp_exact_text("0.8");
 *     rough.by = TP_ROUGHNESS_JRC;
 *     rough.roughness = tp_exact_of(8);
 *     rough.seed = 1;
 *     status = tp_scene_set_base_self_affine(scene, &rough, &message);
 *
 * A base is one of teeth, self-affine, a stand-in for a standard profile, and a list of points
 * (tp_scene_set_base_profile), which is then what a file calls `measured`. Noise, scaling and wear
 * change the profile that was set last; whatever order they come in, noise is added first, what
 * comes out is scaled, and that is worn. Another base drops them. The numbers have keys, those of a
 * file: tp_scene_with makes another scene with base.profile.self_affine.seed (topple_scene.h). */

#ifndef TOPPLE_GENERATE_H
#define TOPPLE_GENERATE_H

#include "topple_scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A base of teeth; lengths in the scene's unit. */
typedef struct tp_base_teeth_options {
  size_t size;          /* of this struct, as `…_default()` has it */
  long count;           /* facets, two a tooth: 1 to 10 million */
  tp_left_end left_end; /* with what it begins at its left */
  tp_exact wavelength;  /* of a tooth, above 0 */
  tp_exact amplitude;   /* from valley to peak, above 0 */
  tp_exact skew;        /* -0.9 to 0.9: facets that rise to the right take (1 + skew) / 2 */
  tp_exact wavelength_scatter, amplitude_scatter, skew_scatter; /* up to 0.9, 1 and 0.9 */
  tp_exact start_x, start_y; /* the left end, at the height of the valleys */
  long long seed;            /* of what is scattered, not below 0 */
} tp_base_teeth_options;

/* A valley at the origin, no skew, no scatter, seed 0; count, wavelength and amplitude are the
 * caller's to set. `size` is the caller's. */
void tp_base_teeth_options_init(tp_base_teeth_options *options, size_t size);
static inline tp_base_teeth_options tp_base_teeth_options_default(void) {
  tp_base_teeth_options options;
  tp_base_teeth_options_init(&options, sizeof options);
  return options;
}

/* The base is made of teeth. */
TP_MUST_USE tp_status tp_scene_set_base_teeth(tp_scene *scene, const tp_base_teeth_options *options,
                                              tp_message *message);

/* By which number it is said how rough a profile is: the root of the mean square of its heights, in
 * scene lengths; Z2, that of its slopes; or the JRC that Z2 has by Tse and Cruden (1979). */
typedef enum tp_roughness_by {
  TP_ROUGHNESS_RMS_HEIGHT,
  TP_ROUGHNESS_Z2,
  TP_ROUGHNESS_JRC
} tp_roughness_by;

/* A self-affine base; lengths in the scene's unit. */
typedef struct tp_base_self_affine_options {
  size_t size;                /* of this struct, as `…_default()` has it */
  tp_exact length, step;      /* of the profile, and between its points: 8 to 4 194 303 steps */
  tp_exact hurst;             /* the exponent, strictly between 0 and 1 */
  tp_roughness_by by;         /* what `roughness` is */
  tp_exact roughness;         /* above 0; Z2 1e-6 to 1000; JRC 0 to 20 */
  tp_exact shortest, longest; /* wavelengths that it holds; 0: two steps, and the length */
  tp_exact start_x, start_y;  /* the left end of its mean line */
  long long seed;             /* of its waves, not below 0 */
} tp_base_self_affine_options;

/* By its RMS height, all wavelengths, from the origin on, seed 0; length, step, hurst and roughness
 * are the caller's to set. `size` is the caller's. */
void tp_base_self_affine_options_init(tp_base_self_affine_options *options, size_t size);
static inline tp_base_self_affine_options tp_base_self_affine_options_default(void) {
  tp_base_self_affine_options options;
  tp_base_self_affine_options_init(&options, sizeof options);
  return options;
}

/* The base is self-affine. */
TP_MUST_USE tp_status tp_scene_set_base_self_affine(tp_scene *scene,
                                                    const tp_base_self_affine_options *options,
                                                    tp_message *message);

/* The base is a generated profile of the length, 100 mm, and the JRC of one of Barton's ten
 * standard profiles, by its `number` from 1 to 10. It stands in for that one, and is not it. */
TP_MUST_USE tp_status tp_scene_set_base_jrc_profile(tp_scene *scene, long number,
                                                    tp_message *message);

/* Move each point of the profile along y by a random number of the standard deviation `deviation`,
 * above 0; `seed` is not below 0. */
TP_MUST_USE tp_status tp_scene_set_base_noise(tp_scene *scene, tp_exact deviation, long long seed,
                                              tp_message *message);

/* Stretch its heights over the lowest point until it has that roughness, in the range of a
 * self-affine base, as tp_profile_of_scene measures it. It has one height at each x. */
TP_MUST_USE tp_status tp_scene_set_base_scaled(tp_scene *scene, tp_roughness_by by,
                                               tp_exact roughness, tp_message *message);

/* How asperities wear by a depth: what stands above the highest point less the depth is cut off;
 * corners that point upwards are rounded until they lie lower by it; or all heights above their
 * mean shrink in proportion, the highest by the depth. */
typedef enum tp_wear { TP_WEAR_CUT, TP_WEAR_ROUNDED, TP_WEAR_ABRADED } tp_wear;

/* Its asperities are worn by a `depth` above 0, and less than all of its roughness. */
TP_MUST_USE tp_status tp_scene_set_base_worn(tp_scene *scene, tp_wear wear, tp_exact depth,
                                             tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
