/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Partial factors of a design check: on actions, on the strength of the contact, and on resistance
 * as a whole. Named sets stand in core/terms/partial_factors.csv, each value with its source.
 *
 * The self-weight drives and holds at once, and comes from a single source, so it has one factor,
 * the same for both (EN 1997-1:2004 2.4.2(9)P, note). Which one, and whether water, pressures and
 * surcharges count as favourable or unfavourable, is not decided beforehand: each combination is
 * solved, and the worst governs. A set that judges toppling alone compares moments, and there what
 * the weight drives with and what it holds with are apart (EN 1990:2002 6.4.3.1(4)):
 *
 *     0.9 M_holds >= 1.1 M_drives + 1.5 M_variable,
 *
 * which is the factor by moments with each action over 1.1, held against 1.1 / 0.9. */

#ifndef TP_SCENE_PARTIAL_FACTORS_H
#define TP_SCENE_PARTIAL_FACTORS_H

#include "scene/scene.h"

typedef enum tp_partial_factor {
  TP_PARTIAL_PERMANENT_UNFAVOURABLE, /* weight and pressures, times it */
  TP_PARTIAL_PERMANENT_FAVOURABLE,   /* the same where they help, and active anchors */
  TP_PARTIAL_WATER_UNFAVOURABLE,     /* water, its uplift too */
  TP_PARTIAL_WATER_FAVOURABLE,
  TP_PARTIAL_VARIABLE_UNFAVOURABLE, /* surcharges */
  TP_PARTIAL_VARIABLE_FAVOURABLE,
  TP_PARTIAL_EARTHQUAKE, /* the force of the earthquake on the unfactored weight */
  TP_PARTIAL_FRICTION,   /* tan(phi) over it */
  TP_PARTIAL_COHESION,   /* cohesion and bond over it */
  TP_PARTIAL_ANCHOR,     /* passive anchors over it */
  TP_PARTIAL_RESISTANCE, /* what the governing factor must reach */
  TP_PARTIAL_FACTORS
} tp_partial_factor;

struct tp_partial_factors {
  tp_place place;
  const char *name; /* of a named set; NULL: its own */
  bool toppling_alone;
  fmpq values[TP_PARTIAL_FACTORS];
};

/* The key of a factor in a scene. */
const char *tp_partial_factor_key(tp_partial_factor factor);

/* All 1, or those of a named set; NULL when memory is exhausted. */
tp_partial_factors *tp_partial_factors_new(tp_place place);
void tp_partial_factors_free(tp_partial_factors *factors);
/* False: there is no such set. */
bool tp_partial_factors_take_set(tp_partial_factors *factors, const char *name);
/* The names of all sets, NULL-terminated; and with a comma between. */
const char *const *tp_partial_factors_names(void);
void tp_partial_factors_list(char *list, size_t size);

/* A factor where it can be: of what is unfavourable and of strength no less than 1, of what is
 * favourable no more. */
TP_MUST_USE tp_status tp_partial_factor_check(tp_partial_factor factor, const fmpq_t value,
                                              tp_place place, tp_message *message);

/* Groups of actions whose factor may be the favourable or the unfavourable one: a combination has a
 * bit for each, set where it is favourable. */
enum { TP_COMBINATIONS = 16 };
/* Is a combination one that can differ from those before it? */
bool tp_combination_differs(const tp_scene *scene, unsigned combination);

/* The scene with its factors applied, which shares all else with it, and must not outlive it; to be
 * given back by tp_factored_clear. */
TP_MUST_USE tp_status tp_factored_init(tp_scene *factored, const tp_scene *scene,
                                       unsigned combination, tp_message *message);
void tp_factored_clear(tp_scene *factored);

/* "DA1-2: weight x 1, water x 1.35, ...; the worst of 2 combinations: water unfavourable" of the
 * factors that act in the combination that governs of those that were solved, to be freed; NULL
 * when memory is exhausted. */
char *tp_factored_text(const tp_scene *scene, unsigned combination, unsigned solved);
/* The note that tells this text, of NULL that memory is exhausted. */
TP_MUST_USE tp_status tp_factored_note(tp_notes *notes, const tp_scene *scene, const char *text,
                                       tp_message *message);

#endif
