/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The first page of the sheet of many blocks: what was given, factors, verdict and what follows. */

#include "report/sheet_system.h"

#include "block_system/governing_case.h"
#include "report/system_words.h"
#include "terms/names.h"

#include <math.h>

/* ---- what was given ----------------------------------------------------------------------------
 */

static void add_weight(tp_system_sheet *s) {
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  tp_bounded sum = {0};
  bool weighed = true;
  for (size_t k = 0; k < own->block_count; k++) {
    const tp_system_block *block = own->blocks + k;
    if (block->ground) continue;
    weighed = weighed && block->has_weight;
    sum.value += block->weight_n_m.value;
    sum.error += block->weight_n_m.error;
  }
  tp_document_word(d, "Weight");
  if (weighed) {
    sum = tp_text_over(sum, 1e3);
    tp_document_cell(d, "W = %s kN/m in all", tp_text_significant(n, sum, 6));
  } else {
    tp_document_word(d, "not given: all blocks are of one material, and forces are not stated");
  }
}

/* A property of the contacts, from the least to the greatest. */
typedef tp_bounded property(const tp_system_contact *contact);

static tp_bounded friction(const tp_system_contact *contact) {
  return contact->friction_angle_deg;
}

static tp_bounded cohesion(const tp_system_contact *contact) {
  return contact->cohesion_kpa;
}

static tp_bounded tension(const tp_system_contact *contact) {
  return contact->tension_kpa;
}

static void add_property(tp_system_sheet *s, const char *word, property *of, const char *one,
                         const char *range, bool unless_zero) {
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  char n[2][TP_NUMBER_SIZE];
  if (own->contact_count == 0) return;
  tp_bounded least = of(own->contacts), most = least;
  for (size_t k = 1; k < own->contact_count; k++) {
    const tp_bounded value = of(own->contacts + k);
    if (value.value < least.value) least = value;
    if (value.value > most.value) most = value;
  }
  if (unless_zero && most.value == 0) return;
  tp_page_degrees(n[0], least);
  tp_page_degrees(n[1], most);
  tp_document_word(d, word);
  if (least.value < most.value) {
    tp_document_cell(d, range, n[0], n[1]);
  } else {
    tp_document_cell(d, one, n[0]);
  }
}

static void add_stance(tp_system_sheet *s) {
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  tp_text t = {0};
  tp_document_word(d, own->lies_in_place ? "As it lies" : "Tilt");
  tp_text_system_stance(&t, own, tp_system_governing(own));
  tp_document_told_cell(d, t.data != NULL ? t.data : "");
  d->failed = d->failed || t.failed;
  tp_text_drop(&t);
}

/* Loads are told as of one block, in the units of this sheet. */
static void add_loads(tp_system_sheet *s) {
  const tp_solution units = {.length_unit = s->system->length_unit,
                             .metres_per_unit = s->system->metres_per_unit};
  tp_sheet own = {.document = s->document, .scene = s->scene, .solution = &units};
  tp_sheet_add_given_loads(&own);
  s->document = own.document;
}

void tp_system_sheet_add_inputs(tp_system_sheet *s) {
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  size_t ground = 0;
  for (size_t k = 0; k < own->block_count; k++) ground += own->blocks[k].ground;
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Inputs");
  tp_document_word(d, "Blocks");
  tp_document_cell(d, "free: %zu, ground: %zu; contacts: %zu", own->block_count - ground, ground,
                   own->contact_count);
  add_weight(s);
  add_property(s, "Friction", friction, "φ = %s°", "φ from %s° to %s°", false);
  add_property(s, "Cohesion", cohesion, "c = %s kPa", "c from %s to %s kPa", true);
  add_property(s, "Tensile strength", tension, "σ = %s kPa", "σ from %s to %s kPa", true);
  add_stance(s);
  add_loads(s);
  tp_sheet_add_settings(d, &own->settings);
}

/* ---- what came out -----------------------------------------------------------------------------
 */

static void add_factor(tp_document *d, const tp_fos *fos, bool is_least) {
  char n[TP_NUMBER_SIZE];
  if (fos->state == TP_FOS_NUMBER && is_least) {
    tp_document_cell(d, "above %s", tp_text_significant_down(n, fos->value, 4));
  } else if (fos->state == TP_FOS_NUMBER) {
    tp_document_cell(d, "%s", tp_text_fixed_down(n, fos->value, 5));
  } else {
    tp_document_word(d, fos->state == TP_FOS_NO_OVERTURNING ? "–"
                        : fos->state == TP_FOS_UNDEFINED    ? "none"
                                                            : "undecided");
  }
}

/* Rounded down; where proofs leave it open both bounds. */
static void add_safety(tp_document *d, const tp_system_safety *own) {
  static const double fourth = 1e4;
  const double least = floor(own->at_least * fourth) / fourth;
  const double most = ceil(own->at_most * fourth) / fourth;
  switch (own->fos.state) {
  case TP_FOS_NUMBER:
    tp_document_cell(d, "%.4f", least);
    break;
  case TP_FOS_NO_OVERTURNING:
    tp_document_word(d, "unbounded");
    break;
  case TP_FOS_UNDEFINED:
    tp_document_word(d, "none");
    break;
  default:
    if (isinf(most) && !(least > 0)) {
      tp_document_word(d, "undecided");
    } else if (isinf(most)) {
      tp_document_cell(d, "at least %.4f", least);
    } else if (!(least > 0)) {
      tp_document_cell(d, "at most %.4f (upper bound)", most);
    } else {
      tp_document_cell(d, "at least %.4f, at most %.4f", least, most);
    }
  }
}

static void add_goodman_bray(tp_document *d, const tp_goodman_bray *own) {
  if (!own->applies) {
    tp_document_word(d, "–");
  } else if (!own->has_fos) {
    tp_document_word(d, "none");
  } else {
    tp_system_sheet_add_goodman_bray(d, own);
  }
}

/* Rounded to the side on which it is proven. What no forces hold moves as it lies. */
static void add_beginning(tp_document *d, const tp_system_case *c) {
  static const double fifth = 1e5;
  if (c->verdict == TP_SYSTEM_COLLAPSES) {
    tp_document_word(d, "as they lie");
  } else if (c->has_moving_fos) {
    tp_document_cell(d, "%.5f", ceil(c->moving_fos * fifth) / fifth);
  } else {
    tp_document_word(d, tp_system_case_is_unexamined(c) ? "not examined" : "none proven");
  }
}

void tp_system_sheet_add_governing(tp_system_sheet *s) {
  const tp_block_system *own = s->system;
  const tp_system_case *governing = tp_system_governing(own);
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  tp_document_table(d, TP_TABLE_OF_COLUMNS, own->has_required_fos ? 9 : 7,
                    own->has_required_fos ? 0x7e : 0x3e, "Factors of safety");
  tp_document_word(d, "Direction");
  tp_document_word(d, "Factor of safety");
  tp_document_word(d, "Upper bound, strength reduction");
  tp_document_word(d, "Upper bound, driving loads");
  tp_document_word(d, "Goodman and Bray");
  tp_document_word(d, "A motion can begin at");
  if (own->has_required_fos) {
    tp_document_word(d, "Required");
    tp_document_word(d, "Requirement");
  }
  tp_document_word(d, "Blocks");
  for (size_t k = 0; k < own->case_count; k++) {
    const tp_system_case *c = own->cases + k;
    if (c == governing && own->case_count > 1) tp_document_mark_row(d);
    tp_document_word(d, tp_direction_name(c->towards));
    add_safety(d, &c->governing_fos);
    add_factor(d, &c->fos, c->fos_is_least);
    add_factor(d, &c->fos_driving, c->fos_driving_is_least);
    add_goodman_bray(d, &c->goodman_bray);
    add_beginning(d, c);
    if (own->has_required_fos) {
      tp_document_cell(d, "%s", tp_text_significant(n, own->required_fos, 6));
      tp_document_word(d, tp_sheet_met_words(c->meets_required));
    }
    tp_document_word(d, tp_system_verdict_name(c->verdict));
  }
}

static const char *verdict_words(tp_system_verdict verdict) {
  switch (verdict) {
  case TP_SYSTEM_STANDS:
    return "No motion can begin.";
  case TP_SYSTEM_CAN_HOLD:
    return "Forces within the strength of the joints hold all blocks as they lie. That no motion "
           "begins all the same is not excluded.";
  case TP_SYSTEM_MAY_MOVE:
    return "Forces within the strength of the joints can hold all blocks as they lie, but a motion "
           "can begin all the same.";
  case TP_SYSTEM_COLLAPSES:
    return "They collapse: no forces within the strength of the joints hold the blocks.";
  case TP_SYSTEM_UNDECIDED:
    break;
  }
  return "Whether forces hold the blocks is undecided.";
}

static void add_sentence(tp_text *t, const char *sentence) {
  tp_text_add(t, "%s%s", t->length > 0 ? " " : "", sentence);
}

static void add_acceleration(tp_text *t, const tp_document *d, const tp_system_case *c) {
  static const double fourth = 1e4;
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, " ");
  tp_text_add(t, tp_document_say(d, "Critical horizontal acceleration: %s g."),
              tp_text_significant(n, c->critical_acceleration_g, 4));
  if (tp_system_case_shakes_sooner(c)) {
    tp_text_add(t, " ");
    tp_text_add(t, tp_document_say(d, "A motion can begin from %.4f g."),
                ceil(c->moving_acceleration_g * fourth) / fourth);
  } else if (!c->has_standing_acceleration) {
    add_sentence(t, tp_document_say(d, "That a motion begins at less is not excluded."));
  }
}

static void add_limit(tp_text *t, const tp_system_sheet *s, const tp_system_case *c) {
  const tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  if (c->limit == TP_SYSTEM_LIMIT_NUMBER) {
    tp_text_add(t, " ");
    tp_text_add(t,
                tp_document_say(d, s->system->lies_in_place
                                       ? "Greatest dip that forces can hold: %s°."
                                       : "Greatest tilt that forces can hold: %s°."),
                tp_text_fixed(n, c->critical_angle_deg, 3));
    if (tp_system_case_is_held_farther(c)) {
      add_sentence(t, tp_document_say(d, "As they lie none hold the blocks."));
    }
  } else if (c->limit == TP_SYSTEM_INTERLOCKED) {
    add_sentence(t, tp_document_say(d, "Forces can hold the blocks at every tilt below 90°."));
  }
  if (tp_system_case_has_critical_acceleration(c)) add_acceleration(t, d, c);
}

static void add_unexamined(tp_text *t, const tp_system_sheet *s, const tp_system_case *c) {
  if (!tp_system_case_is_unexamined(c) || c->verdict != TP_SYSTEM_CAN_HOLD) return;
  tp_text_add(t, " ");
  tp_text_add(t,
              tp_document_say(&s->document, "Up to which factor no motion can begin was not "
                                            "examined: that is done for up to %d free blocks."),
              TP_MOST_MOVING_BLOCKS);
}

void tp_system_sheet_add_conclusion(tp_system_sheet *s, const tp_system_case *c) {
  tp_document *d = &s->document;
  const tp_mechanism collapse = tp_system_case_mechanism(c);
  char n[TP_NUMBER_SIZE];
  tp_text t = {0};
  if (s->system->case_count > 1) {
    tp_text_add(&t, tp_document_say(d, "Towards the %s:"),
                tp_document_say(d, tp_direction_name(c->towards)));
  }
  add_sentence(&t, tp_document_say(d, verdict_words(c->verdict)));
  if (tp_system_case_worst_verdict(c) != c->verdict) {
    add_sentence(&t, tp_document_say(d, "Without the earthquake:"));
    add_sentence(&t, tp_document_say(d, verdict_words(c->static_verdict)));
  }
  add_unexamined(&t, s, c);
  tp_system_sheet_add_estimate(&t, s, c);
  add_limit(&t, s, c);
  if (collapse != TP_STANDS) {
    tp_text_add(&t, " ");
    tp_text_add(&t, tp_document_say(d, "Collapse: %s."),
                tp_document_say(d, tp_mechanism_name(collapse)));
  }
  if (c->has_required_fos) {
    tp_text_add(&t, " ");
    tp_text_add(&t, tp_document_say(d, "Required factor of safety %s: %s."),
                tp_text_significant(n, s->system->required_fos, 6),
                tp_document_say(d, tp_sheet_met_words(c->meets_required)));
  }
  tp_document_set_decimals(d, &t);
  tp_document_take(d, TP_PASSAGE_ANSWER, 0, &t);
}
