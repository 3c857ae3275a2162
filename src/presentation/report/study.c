/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The summary of a study as a page. A probability has four decimals, its interval beside it. */

#include "common/host.h"
#include "output/encode.h"
#include "report/study_words.h"

#include <math.h>
#include <string.h>

enum { LABEL = TP_STUDY_LABEL };

/* ---- probabilities -----------------------------------------------------------------------------
 */

static void add_share(tp_text *t, const char *label, const tp_study_share *share) {
  tp_text_add(t, "  %-*s %12zu   %.4f   %.4f to %.4f\n", LABEL, label, share->samples, share->share,
              share->low, share->high);
}

/* What did not happen is listed where one would look for it. */
static void add_own_tilt(tp_text *t, const tp_study_tilt *tilt, bool of_many) {
  if (tilt->as_it_lies) {
    tp_text_add(t, "\nAs it lies");
  } else if (tilt->tilt_varies) {
    tp_text_add(t, "\nAt the scene's tilt, which varies");
  } else if (tilt->has_tilt) {
    tp_text_add(t, "\nAt the scene's tilt, %.6g°", tilt->tilt_deg);
  } else {
    tp_text_add(t, "\nFirst motion as the table is tilted");
  }
  tp_text_add(t, "\n  %-*s %12s   %-8s %s\n", LABEL, "", "samples", "share", "95 %");
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    const bool always =
        k <= TP_STUDY_SLIDES_AND_TOPPLES || k == TP_STUDY_MAY_MOVE || k == TP_STUDY_UNDECIDED;
    if (!always && tilt->outcomes[k].samples == 0) continue;
    const char *label = k != TP_STUDY_MAY_MOVE ? tp_study_outcome_name((tp_study_outcome)k)
                        : of_many              ? "may move: forces can hold"
                                               : "may move: history dependent";
    add_share(t, label, tilt->outcomes + k);
  }
  add_share(t, "certain to stand", &tilt->certain_to_stand);
  add_share(t, "certain to move", &tilt->certain_to_move);
  add_share(t, "open: neither is certain", &tilt->neither);
}

static void add_tilts(tp_text *t, const tp_study_result *r) {
  add_own_tilt(t, r->tilts, r->of_many_blocks);
  if (r->has_required_fos) {
    add_share(t, "below the factor required", &r->below_required);
    add_share(t, "certain to meet it", &r->meets_required);
    add_share(t, "open: neither is certain", &r->open_required);
  }
  if (r->tilt_count == 1) return;
  tp_text_add(t, "\nBy tilt\n  %8s  %-25s %-25s %8s\n", "tilt", "certain to stand",
              "certain to move", "neither");
  for (size_t k = 1; k < r->tilt_count; k++) {
    const tp_study_tilt *tilt = r->tilts + k;
    const size_t neither =
        r->samples - tilt->certain_to_stand.samples - tilt->certain_to_move.samples;
    tp_text_add(t, "  %7.4g°  %.4f %.4f to %.4f   %.4f %.4f to %.4f %8zu\n", tilt->tilt_deg,
                tilt->certain_to_stand.share, tilt->certain_to_stand.low,
                tilt->certain_to_stand.high, tilt->certain_to_move.share, tilt->certain_to_move.low,
                tilt->certain_to_move.high, neither);
  }
}

/* ---- numbers -----------------------------------------------------------------------------------
 */

static void add_number(tp_text *t, double value, tp_study_quantity quantity) {
  enum { DIGITS = 4 };
  static const double kilo = 1e3;
  char own[TP_NUMBER_SIZE];
  if (quantity == TP_STUDY_SUPPORT_N_M && isfinite(value)) {
    tp_text_add(t, " %7.*g", DIGITS, value / kilo);
  } else if (quantity == TP_STUDY_SUPPORT_N_M) {
    tp_text_add(t, " %7s", "beyond");
  } else if (isinf(value)) {
    tp_text_add(t, " %7s", value > 0 ? "always" : "never");
  } else {
    tp_text_add(t, " %7s", tp_study_number(own, value, quantity));
  }
}

/* What forces can hold is no more than that; a motion may begin before. */
static void add_upper_bounds(tp_text *t, const tp_study_result *r) {
  tp_text_add(t, "Static limits and accelerations are upper bounds: up to them forces can hold the "
                 "blocks.\n");
  if (r->open > 0) {
    tp_text_add(t, "The factor of safety of an open sample is an upper bound.\n");
  }
}

static void add_spreads(tp_text *t, const tp_study_result *r) {
  const tp_study_spread *heads = NULL;
  bool infinite = false, unsupported = false;
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    if (r->quantities[q].samples > 0) heads = r->quantities + q;
  }
  if (heads == NULL) return;
  tp_text_add(t, "\n%-22s", "Quantiles");
  for (size_t k = 0; k < TP_STUDY_QUANTILES; k++) {
    tp_text_add(t, " %5.0f %%", 100 * heads->quantiles[k].probability);
  }
  tp_text_add(t, "\n");
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    const tp_study_spread *spread = r->quantities + q;
    if (spread->samples == 0) continue;
    tp_text_add(t, "%-22s", tp_study_quantity_words((tp_study_quantity)q));
    for (size_t k = 0; k < TP_STUDY_QUANTILES; k++) {
      add_number(t, spread->quantiles[k].value, (tp_study_quantity)q);
      const bool own = isinf(spread->quantiles[k].value);
      *(q == TP_STUDY_SUPPORT_N_M ? &unsupported : &infinite) |= own;
    }
    tp_text_add(t, "\n");
  }
  if (infinite) {
    tp_text_add(
        t, "%s",
        r->of_solid ? "always: nothing moves it; never: it does not stand by itself, or not at its "
                      "tilt.\n"
        : r->of_many_blocks
            ? "always: forces hold the blocks at every tilt; never: no friction, or no\n"
              "acceleration, is enough or allowed.\n"
            : "always: stands at every tilt, or nothing overturns it; never: at no tilt.\n");
  }
  if (r->of_many_blocks) add_upper_bounds(t, r);
  if (unsupported) tp_text_add(t, "beyond: no such support holds the blocks.\n");
}

/* The factor of each definition by itself, where more than one governs. */
static void add_factors(tp_text *t, const tp_study_result *r) {
  enum { LABEL_OF_FACTORS = 29 };
  static const size_t shown[] = {1, 3, 5}; /* of the quantiles */
  const tp_study_quantile *heads = NULL;
  int governing = 0;
  for (int k = 0; k < TP_FOS_DEFINITIONS; k++) {
    governing += r->governing_factors[k].governs.samples > 0;
    if (r->governing_factors[k].spread.samples > 0)
      heads = r->governing_factors[k].spread.quantiles;
  }
  if (governing < 2 || heads == NULL) return;
  tp_text_add(t, "\n%-*s %10s %9s", LABEL_OF_FACTORS + 2, "Governing definition", "samples",
              "below 1");
  for (size_t j = 0; j < sizeof shown / sizeof shown[0]; j++) {
    tp_text_add(t, " %5.0f %%", 100 * heads[shown[j]].probability);
  }
  tp_text_add(t, "\n");
  for (int k = 0; k < TP_FOS_DEFINITIONS; k++) {
    const tp_study_factor *own = r->governing_factors + k;
    if (own->governs.samples == 0) continue;
    tp_text_add(t, "  %-*s %10zu %9zu", LABEL_OF_FACTORS, tp_fos_definition_name(own->definition),
                own->governs.samples, own->below_1);
    for (size_t j = 0; j < sizeof shown / sizeof shown[0] && own->spread.samples > 0; j++) {
      add_number(t, own->spread.quantiles[shown[j]].value, TP_STUDY_FOS);
    }
    tp_text_add(t, "\n");
  }
}

/* With which quantities: of one block, and of many. */
typedef struct ranked {
  size_t count;
  struct {
    tp_study_quantity quantity;
    const char *head;
  } columns[TP_STUDY_FOS + 2];
} ranked;

static const ranked ranked_of_block = {4,
                                       {{TP_STUDY_MOMENTS_DEG, "moments"},
                                        {TP_STUDY_ONSET_DEG, "onset"},
                                        {TP_STUDY_LIMIT_DEG, "limit"},
                                        {TP_STUDY_FOS, "factor"}}};
static const ranked ranked_of_many = {4,
                                      {{TP_STUDY_LIMIT_DEG, "limit"},
                                       {TP_STUDY_FOS, "factor"},
                                       {TP_STUDY_FOS_GOODMAN_BRAY, "FoS, G&B"},
                                       {TP_STUDY_ACCELERATION_G, "accel."},
                                       {TP_STUDY_SUPPORT_N_M, "support"}}};

static const ranked ranked_of_solid = {
    3,
    {{TP_STUDY_LIMIT_DEG, "limit"}, {TP_STUDY_FOS, "factor"}, {TP_STUDY_ACCELERATION_G, "accel."}}};

static void add_rank_row(tp_text *t, const tp_study_rank ranks[TP_STUDY_QUANTITIES],
                         const ranked *with) {
  for (size_t k = 0; k < with->count; k++) {
    const tp_study_rank *own = ranks + with->columns[k].quantity;
    if (own->known) {
      tp_text_add(t, " %10.3f", own->value);
    } else {
      tp_text_add(t, " %10s", "-");
    }
  }
  tp_text_add(t, "\n");
}

/* Of what varies, and of what is measured but for the two bounds. */
static void add_ranks(tp_text *t, const tp_study_result *r) {
  bool any = false;
  for (size_t k = 0; k < r->variable_count; k++) {
    for (int q = 0; q < TP_STUDY_QUANTITIES; q++)
      any = any || r->variables[k].rank_correlations[q].known;
  }
  if (!any) return;
  ranked shown = r->of_solid         ? ranked_of_solid
                 : r->of_many_blocks ? ranked_of_many
                                     : ranked_of_block;
  const ranked *with = &shown;
  shown.count += r->quantities[TP_STUDY_SUPPORT_N_M].samples > 0; /* where one is asked for */
  tp_text_add(t, "\n%-*s", LABEL + 2, "Rank correlation with");
  for (size_t k = 0; k < with->count; k++) tp_text_add(t, " %10s", with->columns[k].head);
  tp_text_add(t, "\n");
  for (size_t k = 0; k < r->variable_count; k++) {
    const tp_study_variable *v = r->variables + k;
    tp_text_add(t, "  ");
    tp_encode_column(t, v->key, LABEL);
    add_rank_row(t, v->rank_correlations, with);
  }
  for (size_t k = 0; k + 2 < r->roughness_count; k++) {
    tp_text_add(t, "  %-*s", LABEL, r->roughness[k].name);
    add_rank_row(t, r->roughness[k].rank_correlations, with);
  }
}

static void add_steps(tp_text *t, const tp_study_result *r) {
  if (r->convergence_count < 2) return;
  tp_text_add(t, "\nCertain to move, as the number of samples grew\n");
  for (size_t k = 0; k < r->convergence_count; k++) {
    const tp_study_step *step = r->convergence + k;
    tp_text_add(t, "  %12zu   %.4f   %.4f to %.4f\n", step->of_samples, step->certain_to_move.share,
                step->certain_to_move.low, step->certain_to_move.high);
  }
}

/* ---- what to look at ---------------------------------------------------------------------------
 */

static void add_bad(tp_text *t, const tp_study_result *r) {
  for (size_t k = 0; k < r->invalid_count; k++) {
    tp_text_add(t, "%sInvalid sample %zu", k == 0 ? "\n" : "", r->invalid[k].sample);
    tp_study_add_lines(t, r->invalid[k].settings);
    tp_study_add_lines(t, r->invalid[k].why);
    tp_text_add(t, "\n");
  }
}

/* What accuracy costs, in bulk. */
static void add_tellers(tp_text *t, const tp_study_result *r) {
  if (r->of_many_blocks) {
    tp_text_add(t,
                "Limits and factors are certain to 1e-6 of themselves, but for open factors: upper "
                "bounds.\n");
  }
  if (r->of_solid) {
    tp_text_add(t, "Solved in doubles with proven bounds, or in whole numbers where these do not "
                   "tell.\n");
  }
  if (r->of_wedge) {
    tp_text_add(
        t, "A wedge stands or slides by the assumptions of Hoek and Bray: it does not turn, and "
           "friction and\ncohesion act against its sliding alone.\n");
  }
  if (r->by_doubles == 0) return;
  tp_text_add(t, "%zu samples solved in doubles with proven bounds, %zu in higher precision.\n",
              r->by_doubles, r->samples - r->by_doubles);
}

static void add_foot(tp_text *t, const tp_study_result *r) {
  tp_text_add(t, "\nIntervals of probabilities: Wilson, 95 %%, each taken separately.\n");
  if (r->open > 0) {
    tp_text_add(t, "%zu samples have a %s.\n", r->open,
                r->of_many_blocks ? "limit or factor that is open, or only known to be exceeded"
                                  : "number certain to fewer than 9 digits");
  }
  add_tellers(t, r);
  if (r->kept < r->samples) {
    tp_text_add(t, "Ranges, quantiles and ranks are of the first %zu samples.\n", r->kept);
  }
}

tp_status tp_report_study(char **text, const tp_study_result *result) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, result);
  tp_text t = {0};
  tp_study_add_head(&t, result);
  if (result->samples > 0) {
    add_tilts(&t, result);
    add_spreads(&t, result);
    add_factors(&t, result);
    add_ranks(&t, result);
    tp_study_add_analyses(&t, result);
    add_steps(&t, result);
    add_bad(&t, result);
    add_foot(&t, result);
  }
  return tp_text_finish(&t, text);
}
