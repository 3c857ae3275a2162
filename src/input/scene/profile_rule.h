/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a base profile is made by: the numbers of its rule, each with the place that gave it, read
 * from a file or set by calls. Whatever holds of them is checked in one place, where the profile is
 * made of them (generate/generate.h). */

#ifndef TP_SCENE_PROFILE_RULE_H
#define TP_SCENE_PROFILE_RULE_H

#include "plane/polyline.h"
#include "scene/quantity.h"
#include "topple_generate.h"

typedef enum tp_made_of {
  TP_MADE_OF_POINTS, /* as they were given: there is no rule */
  TP_MADE_OF_TEETH,
  TP_MADE_SELF_AFFINE,
  TP_MADE_LIKE_STANDARD, /* in place of one of Barton's ten */
  TP_MADE_OF_MEASURED
} tp_made_of;

enum { TP_ROUGHNESS_KINDS = 3, TP_WEAR_KINDS = 3 };

typedef struct tp_profile_rule {
  tp_made_of made;
  tp_place place;       /* of the rule */
  tp_place first_place; /* of what it begins with */
  bool left_end_valley;
  tp_quantity count, wavelength, amplitude, skew;
  tp_quantity scatter[3]; /* of wavelength, amplitude, skew */
  tp_quantity length, step, hurst, shortest, longest;
  tp_quantity roughness[TP_ROUGHNESS_KINDS]; /* one of them is given, by tp_roughness_by */
  tp_quantity start_x, start_y, seed;
  tp_quantity standard; /* the number of the profile */
  tp_polyline measured; /* shared with other scenes */
  tp_quantity deviation, noise_seed;
  tp_quantity scaled[TP_ROUGHNESS_KINDS]; /* one at most is given */
  tp_quantity worn[TP_WEAR_KINDS];        /* likewise, by tp_wear: its depth */
} tp_profile_rule;

/* Keys of files, which messages name. */
extern const char *const tp_roughness_keys[TP_ROUGHNESS_KINDS + 1];
extern const char *const tp_wear_keys[TP_WEAR_KINDS + 1];
extern const char *const tp_scatter_keys[4];

/* No rule any more. */
void tp_profile_rule_drop(tp_profile_rule *rule);

/* Of several quantities the one that is given; -1: none is. */
int tp_given_of(const tp_quantity *quantities, int count);

#endif
