/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a sheet says of a case: verdict, factors of safety, the window of tilts, pivots. */

#include "report/sheet.h"

#include "report/first.h"
#include "report/governing.h"
#include "report/pivots.h"
#include "report/sliding.h"
#include "report/verdict.h"
#include "report/words.h"
#include "terms/names.h"

void tp_sheet_add_verdict(tp_sheet *s, const tp_case *c) {
  tp_text headline = {0};
  tp_page page = {.solution = s->solution};
  tp_text_governing(&headline, c, " ");
  if (headline.length > 0) {
    tp_text_add(&headline, ".");
    tp_document_tell(&s->document, TP_PASSAGE_ANSWER, 0, &headline);
  } else {
    tp_text_drop(&headline);
    tp_document_add(&s->document, TP_PASSAGE_ANSWER,
                    "No factor of safety: the scene gives no tilt.");
  }
  if (c->mechanism == TP_MAY_MOVE) {
    tp_document_add(
        &s->document, TP_PASSAGE_CAUTION,
        "Caution: a motion can begin at this tilt, regardless of the factor of safety.");
  }
  tp_page_add_verdict(&page, c);
  tp_sheet_prose(&s->document, TP_PASSAGE_ANSWER, &page.text);
}

/* ---- factors of safety -------------------------------------------------------------------------
 */

static const char *definition_words(const tp_factor *factor, bool loaded) {
  switch (factor->definition) {
  case TP_FOS_BY_MOMENTS:
    return "stabilising over overturning moments, about the pivot";
  case TP_FOS_BY_SHEAR:
    return loaded ? "shear strength over shear force along the facet that slides"
                  : "shear strength on the facet that slides: tan φ / tan(α − i)";
  case TP_FOS_BY_ROUGHNESS:
    return "shear strength on the mean plane: tan(φ + i) / tan α";
  case TP_FOS_BY_REDUCTION:
    return factor->raised
               ? "the factor by which all strength is multiplied until a "
                 "motion can just begin, or divided until none can"
               : "the factor by which all strength is divided until a motion can just begin";
  case TP_FOS_BY_DRIVING:
    return "the factor by which the driving loads are multiplied until a motion can just begin";
  }
  return "";
}

void tp_sheet_add_factors(tp_sheet *s, const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  tp_document *d = &s->document;
  if (g->fos.state == TP_FOS_NO_TILT || g->factor_count == 0) return;
  tp_document_heading(d, 3, "Factors of safety");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "The governing factor is the lesser of two: on driving loads and by strength "
                  "reduction, each up "
                  "to the first motion that can begin. It is below 1 exactly where a motion can "
                  "begin at the tilt. "
                  "Formulas of other motions are listed for comparison.");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 4, 2, "Factors of safety, the governing one marked");
  tp_document_cell(d, "Against");
  tp_document_cell(d, "FoS");
  tp_document_cell(d, "Definition");
  tp_document_cell(d, "Counts");
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *factor = g->factors + k;
    char n[TP_NUMBER_SIZE];
    tp_text against = {0};
    if (g->has_factor && k == g->factor) tp_document_mark_row(d);
    tp_text_against(&against, factor);
    tp_document_told_cell(d, against.failed ? "" : against.data);
    d->failed = d->failed || against.failed;
    tp_text_drop(&against);
    tp_document_told_cell(d, tp_page_fos(n, factor->fos));
    tp_document_word(d, definition_words(factor, s->solution->loaded));
    if (factor->counts) {
      tp_document_word(d, g->has_factor && k == g->factor ? "governs" : "yes");
    } else {
      tp_document_cell(d, "no: %s", tp_document_say(d, tp_text_standing(factor->standing)));
    }
  }
}

/* ---- the window of tilts -----------------------------------------------------------------------
 */

static void add_onset(tp_document *d, const tp_onset *o) {
  char n[TP_NUMBER_SIZE];
  tp_document_cell(d, "Certain to stand up to");
  switch (o->kind) {
  case TP_ONSET_AT_ANGLE:
    tp_document_cell(d, "α_s = %s°", tp_text_fixed(n, o->critical_angle_deg, 3));
    tp_document_cell(d, "Can begin there");
    tp_document_cell(d, "to %s", tp_document_say(d, tp_text_to_move(o->mechanism)));
    return;
  case TP_ONSET_NEVER:
    tp_document_cell(d, "every tilt up to 90°: no motion can begin");
    return;
  case TP_ONSET_NOWHERE:
    tp_document_cell(d, "no tilt");
    return;
  case TP_ONSET_NOT_ASKED:
    tp_document_cell(d, "not judged: the scene gives no friction angle");
    return;
  case TP_ONSET_UNDECIDED:
    tp_document_cell(d, "undecided at the precision allowed");
    return;
  }
}

static void add_limit(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_limit *l = &c->limit;
  char n[TP_NUMBER_SIZE];
  tp_document_cell(d, "Certain to move beyond");
  switch (l->kind) {
  case TP_LIMIT_AT_ANGLE: {
    tp_page page = {.solution = s->solution};
    tp_document_cell(d, "α_w = %s°", tp_text_fixed(n, l->critical_angle_deg, 3));
    tp_page_add_limit_motion(&page, c, l);
    tp_document_cell(d, "By limit analysis it");
    tp_document_told_cell(d, page.text.data != NULL ? page.text.data : "");
    d->failed = d->failed || page.text.failed;
    tp_text_drop(&page.text);
    return;
  }
  case TP_LIMIT_INTERLOCKED:
    tp_document_cell(d, "no tilt up to 90°: some forces would hold it at each");
    return;
  case TP_LIMIT_NOWHERE:
    tp_document_cell(d, "any tilt: no forces hold it");
    return;
  case TP_LIMIT_NOT_ASKED:
    tp_document_cell(d, "not judged: the scene gives no friction angle");
    return;
  case TP_LIMIT_UNDECIDED:
    tp_document_cell(d, "undecided at the precision allowed");
    return;
  }
}

void tp_sheet_add_window(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  tp_document_heading(d, 3, "The window of tilts");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Below α_s no motion can begin by any forces that friction allows; beyond α_w no "
                  "such forces hold the block. Between these tilts the result depends on loading "
                  "history.");
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0,
                    "Tilts up to which it stands and beyond which it moves");
  if (s->solution->has_tilt_angle) {
    tp_document_cell(d, s->solution->frame.world ? "As it lies" : "Tilt of the scene");
    tp_document_cell(d, "α = %s°", tp_page_degrees(n, s->solution->tilt_angle_deg));
  }
  add_onset(d, &c->onset);
  add_limit(s, c);
  if (c->has_margin) {
    if (c->may_steepen) {
      tp_document_cell(d, "It may %s by", tp_document_say(d, tp_text_steepen(s->solution)));
    } else {
      tp_document_cell(d, "Margin to the lower of them");
    }
    tp_document_cell(d, "%s°", tp_text_fixed(n, c->margin_deg, 3));
  }
}

/* ---- pivots ------------------------------------------------------------------------------------
 */

static void add_pivot(tp_sheet *s, const tp_case *c, size_t k) {
  const tp_pivot *pivot = c->pivots + k;
  const tp_page page = {.solution = s->solution};
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  if (c->has_toppling_pivot && k == c->toppling_pivot) tp_document_mark_row(d);
  tp_document_cell(d, "%zu", pivot->index + 1);
  tp_document_word(d, tp_pivot_kind_name(pivot->kind));
  tp_document_cell(d, "%s", tp_page_coordinate(&page, n, pivot->x_m));
  tp_document_cell(d, "%s", tp_page_coordinate(&page, n, pivot->y_m));
  if (pivot->never || pivot->always) {
    tp_document_word(d, pivot->never ? "never" : "always");
  } else {
    tp_document_cell(d, "%s°", tp_text_fixed(n, pivot->critical_angle_deg, 3));
  }
  if (s->solution->has_tilt_angle) {
    tp_document_told_cell(d, tp_page_fos(n, pivot->fos));
    tp_document_told_cell(d, tp_page_fos(n, pivot->fos_elements));
  }
  tp_document_told_cell(d, tp_text_turning(c, k));
}

void tp_sheet_add_pivots(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const bool tilted = s->solution->has_tilt_angle;
  const char *unit = s->solution->length_unit;
  size_t left_out = c->candidate_count;
  if (c->pivot_count == 0) return;
  tp_document_heading(d, 3, "Pivots");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, tilted ? 8 : 6, tilted ? 0x7c : 0x1c,
                    "Points about which it might topple, the governing one marked");
  tp_document_cell(d, "Pivot");
  tp_document_cell(d, "Kind");
  tp_document_cell(d, "x (%s)", unit);
  tp_document_cell(d, "y (%s)", unit);
  tp_document_cell(d, "Topples at");
  if (tilted) {
    tp_document_cell(d, "FoS");
    tp_document_cell(d, "FoS by elements");
  }
  tp_document_cell(d, "Turning");
  for (size_t k = 0; k < c->pivot_count; k++) {
    if (!tp_pivot_has_row(c, k)) continue;
    add_pivot(s, c, k);
    left_out--;
  }
  if (left_out > 0) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH, "… and %zu more, all of them blocked.", left_out);
  }
  if (!c->has_toppling_pivot) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH, "Turning is blocked about every pivot.");
  }
  if (c->toppling_tie) {
    tp_page page = {.solution = s->solution};
    tp_text_add(&page.text, "Tie: another free pivot has the same critical angle");
    tp_page_add_tie(&page, c->toppling_tie_bits);
    tp_sheet_prose(d, TP_PASSAGE_PARAGRAPH, &page.text);
  }
}
