/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results as JSON. What is printed stands in the tables of core/terms/results, of which the C is
 * made (make_results.py); here is what they call. */

#ifndef TP_REPORT_RESULTS_H
#define TP_REPORT_RESULTS_H

#include "block_system/governing_case.h"
#include "report/contact.h"
#include "report/derived_limit.h"
#include "report/derived_onset.h"
#include "report/onset.h"
#include "report/parts_json.h"
#include "report/poses.h"
#include "report/row.h"
#include "report/words.h"
#include "terms/names.h"

/* The exponent of a self-affine profile by one way, and the range over which it was fitted. */
typedef struct tp_hurst {
  const char *by;
  const tp_profile_estimate *estimate;
  double from, to;
} tp_hurst;

/* What a report is of, and where in it the writing is; tables call it x. */
typedef struct tp_json_subject {
  bool all;              /* of a profile, also each facet and ordinate */
  const tp_hurst *hurst; /* of a profile, by both ways */
  const tp_family *family;
  const tp_study_result *study;
  const tp_tilt_test *test;
  const tp_tilt_case *tilt_case;     /* of the test; */
  const tp_tilt_reaction *reactions; /* of the moment that is being written */
  size_t reaction_count;
  const tp_tilt_convergence_case *converge_case;
  const tp_block_system *system;
  const tp_system_case *system_case; /* of the system, that is being written */
  const tp_load_cases *load_cases;   /* NULL: the solution is of one scene */
  const tp_solution *s;
  tp_pivots_listed listed;
  const tp_case *c;  /* of the solution, that is being written: */
  size_t case_index; /* its number, */
  bool all_pivots;   /* and whether all its pivots are listed */
  size_t k;          /* the number of the item of a list */
} tp_json_subject;

/* The band of a solid that governs. */
const tp_solid_band *tp_solid_band_that_governs(const tp_solid *solid);
/* What it does, in a row: on a point or a line it topples. */
tp_mechanism tp_solid_row_verdict(const tp_solid *solid);

#include "results_json.h"

/* A profile's spectrum in bands, and its facets. */
void tp_json_profile_bands(tp_json *json, const char *key, const tp_profile *profile);
void tp_json_profile_facets(tp_json *json, const char *key, const tp_profile *profile);

/* How many quantities a study lists: of one block the first four. */
size_t tp_json_study_quantities(const tp_study_result *result);
/* Are quantiles of it upper bounds, as of what forces can hold, or where some samples are open? */
bool tp_study_is_upper_bound(const tp_study_result *result, tp_study_quantity quantity);

/* "c = 7.41, b = 100" as {"c": 7.41, "b": 100}. */
void tp_json_numbers_by_name(tp_json *json, const char *key, const char *text);

/* On to a case of a tilt test, and to the next of its moments; and the key of a setting. */
void tp_json_enter_tilt_case(tp_json_subject *x, const tp_tilt_case *own);
void tp_json_enter_moment(tp_json_subject *x);
const char *tp_json_key_of_setting(tp_converge_setting setting);

/* On to a case; and is a pivot of it listed? */
void tp_json_enter_load_case(tp_json_subject *x, const tp_load_case *own);
void tp_json_enter_case(tp_json_subject *x, const tp_case *own);
bool tp_json_lists_pivot(const tp_json_subject *x, size_t pivot);

/* Is the factor about a pivot printed? One below 0 is told of pivots alone about which the block is
 * free to turn. */
bool tp_pivot_has_fos(const tp_pivot *pivot, tp_fos fos);

/* Where no limit is reached as the table is tilted back: why. NULL where one is. */
const char *tp_text_holds_from_is(tp_limit_kind kind);

/* Why there is no margin, and why the block may not steepen by a certain angle; NULL where there is
 * one, and of a block that does not lie at its place. */
const char *tp_text_margin_is(const tp_solution *solution, const tp_case *own);
const char *tp_text_steepen_is(const tp_solution *solution, const tp_case *own);

/* By which formula the angle of sliding is found. */
const char *tp_text_sliding_method(const tp_solution *solution);

/* What a factor by strength reduction is that is no number above 0; else NULL. */
const char *tp_text_reduction(tp_fos fos);
/* The same of a factor on driving loads. */
const char *tp_text_driving(tp_fos fos);

/* Why there is no governing factor, where more is known of that than a factor tells, else NULL; and
 * what the factor is, which is no number above 0, else NULL. */
const char *tp_text_no_factor(const tp_governing_fos *governing);
const char *tp_text_factor_is(const tp_governing_fos *governing);

#endif
