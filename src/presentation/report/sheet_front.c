/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The first page of a sheet: whose it is, the factor of each direction, and what follows. */

#include "report/sheet.h"

#include "report/governing.h"
#include "report/words.h"
#include "terms/names.h"

#include <string.h>

static bool is_given(const char *text) {
  return text != NULL && text[strspn(text, " ")] != '\0';
}

void tp_sheet_add_persons(tp_document *d, const tp_sheet_head *head) {
  static const char *const words[TP_LETTERHEAD_TEXTS] = {NULL,          "Project",    "Job",
                                                         "Prepared by", "Checked by", "Date"};
  size_t count = 0;
  for (int k = TP_LETTERHEAD_PROJECT; k < TP_LETTERHEAD_TEXTS; k++) {
    count += is_given(head->texts[k]);
  }
  if (count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, count, 0, "Project and persons");
  for (int k = TP_LETTERHEAD_PROJECT; k < TP_LETTERHEAD_TEXTS; k++) {
    if (is_given(head->texts[k])) tp_document_word(d, words[k]);
  }
  for (int k = TP_LETTERHEAD_PROJECT; k < TP_LETTERHEAD_TEXTS; k++) {
    if (is_given(head->texts[k])) tp_document_outside_cell(d, head->texts[k]);
  }
}

/* ---- what came out -----------------------------------------------------------------------------
 */

static const char *case_words(const tp_solution *own, const tp_case *c) {
  const bool left = c->towards == TP_TOWARDS_LEFT;
  if (own->frame.world) {
    return left ? "as it lies, towards the left" : "as it lies, towards the right";
  }
  return left ? "tilted towards the left" : "tilted towards the right";
}

static const char *state_words(tp_fos fos) {
  switch (fos.state) {
  case TP_FOS_NUMBER:
    return tp_text_fos(fos);
  case TP_FOS_NO_OVERTURNING:
    return "unbounded";
  case TP_FOS_UNDEFINED:
    return "none";
  case TP_FOS_UNDECIDED:
    return "undecided";
  case TP_FOS_NO_TILT:
    return "no tilt given";
  case TP_FOS_NOT_ASKED:
    break;
  }
  return "–";
}

void tp_sheet_add_fos(tp_sheet *s, tp_fos fos, bool at_most) {
  char n[TP_NUMBER_SIZE];
  if (state_words(fos) != NULL) {
    tp_document_word(&s->document, state_words(fos));
  } else {
    tp_document_cell(&s->document, at_most ? "at most %s" : "%s",
                     (at_most ? tp_text_fixed_up : tp_text_fixed_down)(n, fos.value, 3));
  }
}

const char *tp_sheet_met_words(tp_design design) {
  return design == TP_DESIGN_MET ? "met" : design == TP_DESIGN_NOT_MET ? "not met" : "undecided";
}

static void add_required(tp_sheet *s, tp_design design) {
  const tp_governing_fos *g = &s->solution->cases[0].governing_fos;
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  if (!g->has_required_fos) return;
  tp_document_cell(d, "%s", tp_text_significant(n, g->required_fos, 6));
  tp_document_word(d, tp_sheet_met_words(design));
}

static void add_case_row(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_governing_fos *g = &c->governing_fos;
  tp_document_word(d, case_words(s->solution, c));
  tp_sheet_add_fos(s, g->fos, g->sliding_judged && !g->complete);
  if (g->has_factor) {
    tp_sheet_add_against(s, g->factors + g->factor);
  } else {
    tp_document_word(d, "–");
  }
  add_required(s, g->meets_required);
  tp_document_word(d, tp_mechanism_name(c->mechanism));
}

static tp_design judge(const tp_earthquake *own, tp_bounded required) {
  const bool stands = own->mechanism == TP_STANDS || own->mechanism == TP_INTERLOCKED;
  if (own->mechanism == TP_MECHANISM_UNDECIDED) return TP_DESIGN_OPEN;
  if (!stands) return TP_DESIGN_NOT_MET;
  if (own->fos.state == TP_FOS_NO_OVERTURNING) return TP_DESIGN_MET;
  if (own->fos.state != TP_FOS_NUMBER) return TP_DESIGN_OPEN;
  const tp_bounded more = tp_text_less(own->fos.value, required);
  return more.value >= more.error   ? TP_DESIGN_MET
         : more.value < -more.error ? TP_DESIGN_NOT_MET
                                    : TP_DESIGN_OPEN;
}

static void add_earthquake_row(tp_sheet *s, const tp_earthquake *own, bool vertical) {
  tp_document *d = &s->document;
  const tp_case *c = s->solution->cases;
  const bool first = own == s->solution->earthquakes;
  if (first) tp_document_mark_row(d);
  tp_document_cell(
      d, "earthquake to the %s, %s%s", tp_document_say(d, tp_direction_name(own->towards)),
      tp_document_say(d, own->up_dip ? "up-dip" : "down-dip"),
      !vertical ? "" : tp_document_say(d, own->vertical ? ", with k_v" : ", without k_v"));
  tp_sheet_add_fos(s, own->fos,
                   first && c->governing_fos.sliding_judged && !c->governing_fos.complete);
  if (first && c->governing_fos.has_factor) {
    tp_sheet_add_against(s, c->governing_fos.factors + c->governing_fos.factor);
  } else {
    tp_document_word(d, "–");
  }
  add_required(s,
               first ? c->governing_fos.meets_required : judge(own, c->governing_fos.required_fos));
  tp_document_word(d, tp_mechanism_name(own->mechanism));
}

void tp_sheet_add_governing(tp_sheet *s) {
  const tp_solution *own = s->solution;
  tp_document *d = &s->document;
  const bool required = own->cases[0].governing_fos.has_required_fos;
  bool vertical = false;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, required ? 6 : 4, required ? 0xa : 2,
                    "Governing factors of safety");
  tp_document_word(d, "Case");
  tp_document_word(d, "FoS");
  tp_document_word(d, "Against");
  if (required) {
    tp_document_word(d, "Required");
    tp_document_word(d, "Requirement");
  }
  tp_document_word(d, "Block");
  for (size_t k = 0; k < own->earthquake_count; k++) vertical |= own->earthquakes[k].vertical;
  for (size_t k = 0; k < own->earthquake_count; k++) {
    add_earthquake_row(s, own->earthquakes + k, vertical);
  }
  for (size_t k = 0; k < own->case_count && own->earthquake_count == 0; k++) {
    add_case_row(s, own->cases + k);
  }
}

static const char *standing_words(tp_mechanism mechanism) {
  switch (mechanism) {
  case TP_STANDS:
    return "It stands.";
  case TP_SLIDES:
    return "It does not stand: it slides.";
  case TP_TOPPLES:
    return "It does not stand: it topples.";
  case TP_SLIDES_AND_TOPPLES:
    return "It does not stand: it slides and topples.";
  case TP_INTERLOCKED:
    return "It is interlocked: it neither slides nor topples at any tilt up to 90°.";
  case TP_MAY_MOVE:
    return "It may move or stand: the result depends on the loading history.";
  case TP_LEAVES_BASE:
    return "It does not stand: it leaves its base.";
  case TP_MECHANISM_UNDECIDED:
    break;
  }
  return "Whether it stands is undecided at the precision allowed.";
}

/* A sentence behind the others. */
static void add_sentence(tp_text *t, const char *sentence) {
  tp_text_add(t, "%s%s", t->length > 0 ? " " : "", sentence);
}

static void add_window(tp_text *t, const tp_sheet *s, const tp_case *c) {
  const tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  if (c->onset.kind == TP_ONSET_AT_ANGLE) {
    tp_text_add(t, " ");
    tp_text_add(t,
                tp_document_say(d, c->may_steepen
                                       ? "No motion can begin up to a dip of α_s = %s°."
                                       : "No motion can begin up to a tilt of α_s = %s°."),
                tp_text_fixed(n, c->onset.critical_angle_deg, 3));
  }
  if (c->limit.kind == TP_LIMIT_AT_ANGLE) {
    tp_text_add(t, " ");
    tp_text_add(t, tp_document_say(d, "Beyond α_w = %s° no forces of the base hold it."),
                tp_text_fixed(n, c->limit.critical_angle_deg, 3));
  }
  if (c->may_steepen) {
    tp_text_add(t, " ");
    tp_text_add(t, tp_document_say(d, "It may steepen by %s°."),
                tp_text_fixed(n, c->steepen_by_deg, 3));
  } else if (c->has_margin) {
    tp_text_add(t, " ");
    tp_text_add(t, tp_document_say(d, "Margin in tilt: %s°."), tp_text_fixed(n, c->margin_deg, 3));
  }
}

void tp_sheet_add_conclusion(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_governing_fos *g = &c->governing_fos;
  tp_text t = {0};
  char n[TP_NUMBER_SIZE];
  add_sentence(&t, tp_document_say(d, tp_text_stance(s->solution, c)));
  tp_text_add(&t, ":");
  if (s->solution->has_tilt_angle) {
    add_sentence(&t, tp_document_say(d, standing_words(c->mechanism)));
  } else {
    tp_text_add(&t, " ");
    tp_text_add(&t,
                tp_document_say(d, "The scene gives no tilt. First motion as it is tilted: %s."),
                tp_document_say(d, tp_text_motion(c->first)));
  }
  if (c->falls_backwards) add_sentence(&t, tp_document_say(d, "It fails up-dip already."));
  add_window(&t, s, c);
  if (g->has_required_fos) {
    tp_text_add(&t, " ");
    tp_text_add(&t, tp_document_say(d, "Required factor of safety %s: %s."),
                tp_text_significant(n, g->required_fos, 6),
                tp_document_say(d, tp_sheet_met_words(g->meets_required)));
  }
  if (!s->solution->has_friction) {
    add_sentence(&t, tp_document_say(d, "Sliding is not judged: no friction angle is given."));
  }
  tp_document_set_decimals(d, &t);
  tp_document_take(d, TP_PASSAGE_ANSWER, 0, &t);
}
