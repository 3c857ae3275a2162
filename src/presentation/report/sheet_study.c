/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The sheet of a study: how probable each verdict is, and what that rests on. */

#include "report/sheet.h"

#include "output/encode.h"
#include "report/study_words.h"
#include "terms/names.h"

#include <math.h>

/* ---- probabilities -----------------------------------------------------------------------------
 */

static void add_answer(tp_document *d, const tp_study_result *r) {
  const tp_study_tilt *own = r->tilts;
  tp_text where = {0};
  if (r->samples == 0) {
    tp_document_add(d, TP_PASSAGE_CAUTION, "No sample was solved.");
    return;
  }
  if (own->as_it_lies) {
    tp_text_add(&where, "As it lies, of");
  } else if (!own->has_tilt) {
    tp_text_add(&where, "The scene has no tilt; as the table is tilted, of");
  } else if (own->tilt_varies) {
    tp_text_add(&where, "At the scene's tilt, which varies, of");
  } else {
    tp_text_add(&where, "At %.6g°, of", own->tilt_deg);
  }
  tp_text_add(&where,
              " %zu samples: certain to move %.2f %% (%.2f to %.2f %%), certain to stand %.2f %% "
              "(%.2f to %.2f %%).",
              r->samples, 100 * own->certain_to_move.share, 100 * own->certain_to_move.low,
              100 * own->certain_to_move.high, 100 * own->certain_to_stand.share,
              100 * own->certain_to_stand.low, 100 * own->certain_to_stand.high);
  tp_document_tell(d, TP_PASSAGE_ANSWER, 0, &where);
  if (r->has_required_fos) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH, "Below the factor required: %.2f %% (%.2f to %.2f %%).",
        100 * r->below_required.share, 100 * r->below_required.low, 100 * r->below_required.high);
    tp_document_add(d, TP_PASSAGE_PARAGRAPH, "Certain to be met: %.2f %%; open: %.2f %%.",
                    100 * r->meets_required.share, 100 * r->open_required.share);
  }
  if (r->samples < r->planned) {
    tp_document_add(d, TP_PASSAGE_CAUTION, "Of %zu samples planned %zu were solved (%s).",
                    r->planned, r->samples, tp_document_say(d, tp_study_end_name(r->end)));
  }
}

static void add_share(tp_document *d, const char *label, const tp_study_share *share) {
  tp_document_word(d, label);
  tp_document_cell(d, "%zu", share->samples);
  tp_document_cell(d, "%.4f", share->share);
  tp_document_cell(d, "%.4f", share->low);
  tp_document_cell(d, "%.4f", share->high);
}

static void add_outcomes(tp_document *d, const tp_study_result *r) {
  const tp_study_tilt *own = r->tilts;
  tp_document_heading(d, 2, "Outcomes");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0x1e,
                    own->as_it_lies ? "As it lies"
                    : own->has_tilt ? "At the scene's tilt"
                                    : "First motion");
  tp_document_cell(d, "Outcome");
  tp_document_cell(d, "Samples");
  tp_document_cell(d, "Share");
  tp_document_cell(d, "95 %% from");
  tp_document_cell(d, "95 %% to");
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    if (own->outcomes[k].samples == 0) continue;
    add_share(d, tp_study_outcome_name((tp_study_outcome)k), own->outcomes + k);
  }
  add_share(d, "certain to stand", &own->certain_to_stand);
  add_share(d, "certain to move", &own->certain_to_move);
  add_share(d, "open: neither is certain", &own->neither);
  if (r->has_required_fos) {
    add_share(d, "below the factor required", &r->below_required);
    add_share(d, "certain to meet the factor required", &r->meets_required);
    add_share(d, "open whether it is met", &r->open_required);
  }
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      "Outcomes that did not occur are omitted. Intervals are Wilson intervals of 95 %%, "
      "each taken separately; for the samples certain to move, with numbers:");
  const double n = (double)r->samples;
  tp_document_add(d, TP_PASSAGE_EQUATION,
                  "p = \\frac{n}{N} = \\frac{%zu}{%zu} = %.4f \\\\"
                  "p_{95} = \\frac{p + z^2 / (2 N) ± z (p (1 − p) / N + z^2 / (4 N^2))^{1/2}}"
                  "{1 + z^2 / N} , z = 1.959964 \\\\"
                  "p_{95} = \\frac{%.8f ± %.8f}{%.8f}",
                  own->certain_to_move.samples, r->samples, own->certain_to_move.share,
                  own->certain_to_move.share + 1.959964 * 1.959964 / (2 * n),
                  1.959964 *
                      sqrt(own->certain_to_move.share * (1 - own->certain_to_move.share) / n +
                           1.959964 * 1.959964 / (4 * n * n)),
                  1 + 1.959964 * 1.959964 / n);
}

static void add_tilts(tp_document *d, const tp_study_result *r) {
  if (r->tilt_count == 1) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 7, 0x7f, "By tilt, with their intervals");
  static const char *const heads[] = {
      "Tilt", "Certain to stand", "from", "to", "Certain to move", "from", "to"};
  for (size_t k = 0; k < 7; k++) tp_document_word(d, heads[k]);
  for (size_t k = 1; k < r->tilt_count; k++) {
    const tp_study_tilt *own = r->tilts + k;
    const double shares[] = {own->certain_to_stand.share, own->certain_to_stand.low,
                             own->certain_to_stand.high,  own->certain_to_move.share,
                             own->certain_to_move.low,    own->certain_to_move.high};
    tp_document_cell(d, "%.4g°", own->tilt_deg);
    for (size_t j = 0; j < 6; j++) tp_document_cell(d, "%.4f", shares[j]);
  }
}

/* ---- numbers -----------------------------------------------------------------------------------
 */

static void add_number(tp_document *d, double value, tp_study_quantity quantity) {
  static const double kilo = 1e3;
  char n[TP_NUMBER_SIZE];
  if (quantity == TP_STUDY_SUPPORT_N_M && isfinite(value)) {
    tp_document_cell(d, "%.4g", value / kilo);
  } else if (quantity == TP_STUDY_SUPPORT_N_M) {
    tp_document_word(d, "no such force");
  } else if (isinf(value)) {
    tp_document_word(d, value > 0 ? "always" : "never");
  } else {
    tp_document_cell(d, "%s", tp_study_number(n, value, quantity));
  }
}

static void add_spreads(tp_document *d, const tp_study_result *r) {
  const tp_study_quantile *heads = NULL;
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    if (r->quantities[q].samples > 0) heads = r->quantities[q].quantiles;
  }
  if (heads == NULL) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 1 + TP_STUDY_QUANTILES, 0xfe,
                    "Quantiles (always: it stands at every tilt; never: at no tilt)");
  tp_document_cell(d, "Of");
  for (size_t k = 0; k < TP_STUDY_QUANTILES; k++) {
    tp_document_cell(d, "%.0f %%", 100 * heads[k].probability);
  }
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    const tp_study_spread *own = r->quantities + q;
    if (own->samples == 0) continue;
    tp_document_word(d, tp_study_quantity_words((tp_study_quantity)q));
    for (size_t k = 0; k < TP_STUDY_QUANTILES; k++) {
      add_number(d, own->quantiles[k].value, (tp_study_quantity)q);
    }
  }
}

/* What forces can hold is no more than that; a motion may begin before. */
static void add_upper_bounds(tp_document *d, const tp_study_result *r) {
  if (!r->of_many_blocks) return;
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      "Static limits and accelerations are upper bounds: up to them forces can hold the "
      "blocks.");
  if (r->open == 0) return;
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "The factor of safety of an open sample is an upper bound.");
}

static void add_variables(tp_document *d, const tp_study_result *r) {
  tp_document_heading(d, 2, "Variables");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 6, 0x1c, "Variables and their samples");
  static const char *const heads[] = {
      "Key", "Distribution", "Least", "Greatest", "Rank correlation with the limit", "Unit"};
  for (size_t k = 0; k < 6; k++) tp_document_word(d, heads[k]);
  for (size_t k = 0; k < r->variable_count; k++) {
    const tp_study_variable *v = r->variables + k;
    const tp_study_rank *rank = v->rank_correlations + TP_STUDY_LIMIT_DEG;
    tp_text law = {0};
    tp_document_outside_cell(d, v->key);
    tp_text_add(&law, "%s: ", v->kind);
    tp_encode_plain(&law, v->law);
    tp_document_told_cell(d, law.data != NULL ? law.data : "");
    d->failed = d->failed || law.failed;
    tp_text_drop(&law);
    tp_document_cell(d, "%.6g", v->least);
    tp_document_cell(d, "%.6g", v->greatest);
    if (rank->known) {
      tp_document_cell(d, "%.3f", rank->value);
    } else {
      tp_document_cell(d, "–");
    }
    tp_document_cell(d, "%s", v->unit != NULL ? v->unit : "–");
  }
  for (size_t k = 0; k < r->correlation_count; k++) {
    const tp_study_correlation *own = r->correlations + k;
    tp_text text = {0};
    tp_text_add(&text, "Correlated: ");
    tp_encode_plain(&text, r->variables[own->one].key);
    tp_text_add(&text, " and ");
    tp_encode_plain(&text, r->variables[own->other].key);
    tp_text_add(&text, ", %.4g.", own->value);
    tp_document_tell(d, TP_PASSAGE_PARAGRAPH, 0, &text);
  }
}

static void add_price(tp_document *d, const tp_study_result *r) {
  tp_document_heading(d, 2, "Proof and computing cost");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "The verdict of each sample is proven; the probability is an estimate from the "
                  "samples, with its interval.");
  if (r->of_many_blocks) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "Limits and factors are certain to 1e-6 of themselves; by Goodman and Bray "
        "they have no bound. Blocks that forces can hold count as those that may move.");
  }
  if (r->of_wedge) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "A wedge stands or slides by the assumptions of Hoek and Bray: it does not turn, "
        "and friction and cohesion act against its sliding alone.");
  }
  if (r->open > 0) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    r->of_many_blocks
                        ? "Some samples have a limit or factor that is open, or only known to be "
                          "exceeded."
                        : "Some samples have a number certain to fewer than 9 digits.");
  }
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Samples, and the arithmetic that solved them");
  tp_document_cell(d, "Samples");
  tp_document_cell(d, "%zu of %zu, %s, seed %zu", r->samples, r->planned,
                   tp_document_say(d, r->method), r->seed);
  tp_document_cell(d, "Solved in doubles with bounds");
  tp_document_cell(d, "%zu", r->by_doubles);
  tp_document_cell(d, "Solved in higher precision");
  tp_document_cell(d, "%zu", r->samples - r->by_doubles);
  tp_document_cell(d, "Less certain than requested");
  tp_document_cell(d, "%zu", r->open);
  for (size_t k = 0; k < r->invalid_count; k++) {
    tp_text why = {0};
    tp_text_add(&why, "sample %zu, ", r->invalid[k].sample);
    tp_encode_plain(&why, r->invalid[k].settings);
    tp_text_add(&why, ": ");
    tp_encode_plain(&why, r->invalid[k].why);
    tp_document_cell(d, "Invalid");
    tp_document_outside_cell(d, why.data != NULL ? why.data : "");
    d->failed = d->failed || why.failed;
    tp_text_drop(&why);
  }
}

void tp_sheet_build_study(tp_document *document, const tp_study_result *result,
                          const tp_sheet_files *files, const tp_sheet_options *options,
                          tp_sheet_head *head, const tp_sheet_picture *charts, size_t count) {
  tp_document own = {.language = head->language, .comma = head->comma}, *d = &own;
  tp_sheet_set_letterhead(d, head);
  tp_sheet_add_title(d, result->title, "Probability that a rock block moves");
  tp_sheet_add_foot(d, files, options);
  tp_sheet_add_persons(d, head);
  tp_document_heading(d, 2, "Answer");
  add_answer(d, result);
  tp_sheet_add_charts(d, charts, count);
  if (result->samples > 0) {
    add_outcomes(d, result);
    add_tilts(d, result);
    add_spreads(d, result);
    add_upper_bounds(d, result);
    add_variables(d, result);
    tp_sheet_add_analyses(d, result);
    add_price(d, result);
  }
  tp_sheet_add_origin(d, files, options);
  tp_sheet_add_files(d, files, options);
  tp_sheet_add_signatures(d, head);
  *document = own;
}
