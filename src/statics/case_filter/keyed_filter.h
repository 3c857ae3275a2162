/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The case filter of a scene in which the numbers at some keys vary: friction, tilt or the dip of a
 * slope (not of the world's frame), numbers of its loads, its unit weight and thickness, and
 * vertices as functions of numbers.
 */

#ifndef TP_CASE_FILTER_KEYED_FILTER_H
#define TP_CASE_FILTER_KEYED_FILTER_H

#include "case_filter/case_filter.h"

typedef struct tp_keyed_filter {
  tp_case_filter *of;
  size_t count;
  int *parts; /* what each number is */
  bool has_tilt, lies_in_place;
  tp_near friction_deg, tilt_deg; /* of the scene, where they do not vary; with its dip */
} tp_keyed_filter;

/* `*filter` stays NULL where scenes with these numbers are none for it, or where at `further_tilts`
 * than the scene's own its loads are others. */
TP_MUST_USE tp_status tp_keyed_filter_new(tp_keyed_filter **filter, const tp_scene *scene,
                                          const tp_scene_key *keys, size_t count,
                                          bool further_tilts, tp_message *message);
void tp_keyed_filter_free(tp_keyed_filter *filter);

/* The case with the values of the numbers, each a decimal that names the double, and its tilt;
 * false where doubles do not tell. */
TP_MUST_USE bool tp_keyed_filter_tell(tp_case_told *told, tp_near *tilt_deg,
                                      const tp_keyed_filter *filter, const double *values);

/* A double that stands for the decimal that names it. */
tp_near tp_keyed_number(double number);

#endif
