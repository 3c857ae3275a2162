/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The first page of the sheet of a solid: factors, verdict and what follows. */

#include "report/sheet_solid.h"

#include "number/shortest.h"
#include "report/solid_page.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>

static void add_required_heads(tp_solid_sheet *s) {
  if (!s->solid->has_required_fos) return;
  tp_document_word(&s->document, "Required");
  tp_document_word(&s->document, "Requirement");
}

static void add_required(tp_solid_sheet *s, bool governs) {
  const tp_solid *own = s->solid;
  char n[TP_SHORTEST_SIZE];
  if (!own->has_required_fos) return;
  tp_document_cell(&s->document, "%s", tp_shortest(n, own->required_fos));
  tp_document_word(&s->document,
                   governs ? tp_sheet_met_words(tp_solid_meets(own, own->required_fos)) : "–");
}

/* The factor and what it is against; rounded to the safe side. */
static void add_factor(tp_document *d, const tp_solid_safety *own) {
  const bool has_fos = own != NULL && own->fos.state == TP_FOS_NUMBER;
  const bool bounded = own != NULL && own->fos.state == TP_FOS_UNDECIDED;
  char n[TP_NUMBER_SIZE];
  if (has_fos || !bounded) {
    tp_sheet_add_factor_if(d, has_fos, has_fos ? own->fos.value : (tp_bounded){0}, 6);
  } else if (own->most < HUGE_VAL) {
    tp_document_cell(d, "undecided, at most %s",
                     tp_text_significant_up(n, (tp_bounded){.value = own->most}, 5));
  } else {
    tp_document_word(d, "undecided");
  }
  const bool told = own != NULL && own->has_factor && (has_fos || bounded) &&
                    own->factor.mechanism != TP_MECHANISM_UNDECIDED;
  tp_document_word(d, told ? tp_text_motion(own->factor.mechanism) : "–");
}

static void add_band_row(tp_solid_sheet *s, size_t k) {
  const tp_solid_band *b = s->solid->bands + k;
  const tp_solid_stance *own = &b->stance;
  const bool governs = k == s->solid->governing;
  tp_document *d = &s->document;
  char n[TP_SHORTEST_SIZE];
  if (governs) tp_document_mark_row(d);
  tp_document_cell(d, "%s", tp_shortest(n, b->band));
  tp_sheet_add_number_if(d, b->stands, b->least.tilt_deg, 6);
  tp_sheet_add_number_if(d, b->stands, b->least.azimuth_deg, 6);
  add_factor(d, b->has_stance ? &own->safety : NULL);
  add_required(s, governs);
  tp_document_word(d, b->has_stance ? tp_mechanism_name(own->verdict) : "does not stand");
}

static void add_of_bands(tp_solid_sheet *s, unsigned required) {
  static const char *const heads[] = {"Least tilt (°)", "Towards (°)", "FoS", "Against"};
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 6 + required, 0xf,
                    own->has_below ? "Factors of safety on the section"
                                   : "Factors of safety, for each band");
  tp_document_cell(d, own->has_below ? "Below (%s)" : "Band (%s)", own->length_unit);
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  add_required_heads(s);
  tp_document_word(d, "Rock");
  for (size_t k = 0; k < own->band_count && k < TP_SOLID_SHEET_BANDS; k++) add_band_row(s, k);
  tp_sheet_add_rest(d, own->band_count, TP_SOLID_SHEET_BANDS);
}

static void add_of_contacts(tp_solid_sheet *s, unsigned required) {
  static const char *const heads[] = {"Held up to (°)", "Towards (°)", "FoS", "Against"};
  const tp_solid_contacts *own = &s->solid->contacts;
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5 + required, 0x7, "Factor of safety");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  add_required_heads(s);
  tp_document_word(d, "Rock");
  tp_sheet_add_number_if(d, own->has_critical, own->critical_deg, 6);
  tp_sheet_add_number_if(d, own->has_critical, own->critical_azimuth_deg, 6);
  add_factor(d, tp_solid_safety_of(s->solid));
  add_required(s, true);
  tp_document_word(d, tp_mechanism_name(own->verdict));
}

static void add_of_wedge(tp_solid_sheet *s, unsigned required) {
  static const char *const heads[] = {"Line plunges (°)", "Towards (°)", "FoS", "Slides"};
  const tp_solid_wedge *own = &s->solid->wedge;
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5 + required, 0x7, "Factor of safety");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  add_required_heads(s);
  tp_document_word(d, "Wedge");
  tp_sheet_add_number(d, own->plunge_deg, 6);
  tp_sheet_add_number(d, own->trend_deg, 6);
  tp_sheet_add_factor_if(d, own->has_fos, own->fos, 6);
  tp_document_word(d, tp_text_solid_wedge_way(own));
  add_required(s, true);
  tp_document_word(d, tp_mechanism_name(own->verdict));
}

void tp_solid_sheet_add_governing(tp_solid_sheet *s) {
  const unsigned required = s->solid->has_required_fos ? 2 : 0;
  if (s->solid->has_wedge) {
    add_of_wedge(s, required);
  } else if (s->solid->has_contacts) {
    add_of_contacts(s, required);
  } else {
    add_of_bands(s, required);
  }
}

/* ---- what follows ------------------------------------------------------------------------------
 */

static void add_verdict(tp_text *t, const tp_document *d, tp_mechanism verdict) {
  tp_text_add(t, tp_document_say(d, "Verdict: %s."),
              tp_document_say(d, tp_mechanism_name(verdict)));
}

static void conclude_bands(tp_text *t, const tp_document *d, const tp_solid *own) {
  const tp_solid_band *b = own->bands + own->governing;
  char n[2][TP_NUMBER_SIZE];
  tp_text_add(t,
              tp_document_say(d, own->has_below ? "A plane cuts it %s %s over its lowest point."
                                                : "The least band, %s %s, governs."),
              tp_shortest(n[0], b->band), own->length_unit);
  tp_text_add(t, " ");
  if (b->has_stance) {
    add_verdict(t, d, b->stance.verdict);
  } else {
    tp_text_add(t, "%s", tp_document_say(d, "It does not stand: a point or a line touches."));
  }
  if (b->stands) {
    tp_text_add(t, " ");
    tp_text_add(t, tp_document_say(d, "Tilted from level, it moves at %s° at the least: %s."),
                tp_text_fixed(n[0], b->critical_deg, 3),
                tp_document_say(d, tp_text_motion(b->mechanism)));
  }
  if (b->has_stance && b->stance.has_acceleration) {
    tp_text_add(t, " ");
    tp_text_add(
        t, tp_document_say(d, "Least horizontal acceleration that moves it: %s g towards %s°, %s."),
        tp_text_significant(n[0], b->stance.acceleration_g, 4),
        tp_text_fixed(n[1], b->stance.acceleration_azimuth_deg, 1),
        tp_document_say(d, tp_text_motion(b->stance.acceleration_mechanism)));
  }
}

static void conclude_contacts(tp_text *t, const tp_document *d, const tp_solid_contacts *own) {
  char n[2][TP_NUMBER_SIZE];
  add_verdict(t, d, own->verdict);
  if (own->verdict == TP_MAY_MOVE) {
    tp_text_add(t, " %s",
                tp_document_say(d, own->safety.states->motion == TP_SOLID_CAN_MOVE
                                       ? "Forces can hold it, but a motion can begin, proven: the "
                                         "result depends on the loading history."
                                       : "Forces can hold it; whether a motion can begin is not "
                                         "decided."));
  }
  if (own->has_certain) {
    const tp_bounded least = {.value = own->certain_to_stand_deg};
    tp_text_add(t, " ");
    tp_text_add(t,
                tp_document_say(d, "No motion can begin up to a tilt of %s°, and perhaps beyond."),
                tp_text_fixed_down(n[0], least, 3));
  }
  if (own->has_onset) {
    tp_text_add(t, " ");
    tp_text_add(t, tp_document_say(d, "A motion can begin from a tilt of %s° on."),
                tp_text_fixed(n[0], own->onset_deg, 3));
  }
  if (own->has_motion) {
    tp_text_add(t, " %s", tp_document_say(d, "No forces of the contacts hold it."));
  }
  if (own->has_critical) {
    tp_text_add(t, " ");
    tp_text_add(t,
                tp_document_say(d, "Forces hold it up to a tilt of %s° towards the azimuth %s°: "
                                   "there it moves, %s."),
                tp_text_fixed(n[0], own->critical_deg, 3),
                tp_text_fixed(n[1], own->critical_azimuth_deg, 1),
                tp_document_say(d, tp_text_motion(own->critical.mechanism)));
  }
  if (!own->has_acceleration || own->safety.motion == TP_SOLID_CAN_MOVE) return;
  tp_text_add(t, " ");
  tp_text_add(t,
              tp_document_say(d, "At its tilt they hold it up to a horizontal acceleration of %s "
                                 "g, the least of all azimuths, towards %s°: there it moves, %s."),
              tp_text_significant(n[0], own->acceleration_g, 4),
              tp_text_fixed(n[1], own->acceleration_azimuth_deg, 1),
              tp_document_say(d, tp_text_motion(own->acceleration.mechanism)));
}

static void conclude_wedge(tp_text *t, const tp_document *d, const tp_solid_wedge *own) {
  char n[2][TP_NUMBER_SIZE];
  add_verdict(t, d, own->verdict);
  tp_text_add(t, " ");
  tp_text_add(t, tp_document_say(d, "The line of both joints plunges %s° towards %s°."),
              tp_text_fixed(n[0], own->plunge_deg, 1), tp_text_fixed(n[1], own->trend_deg, 1));
  if (!own->has_acceleration) return;
  tp_text_add(t, " ");
  tp_text_add(
      t, tp_document_say(d, "Least horizontal acceleration that moves it: %s g towards %s°, %s."),
      tp_text_significant(n[0], own->acceleration_g, 4),
      tp_text_fixed(n[1], (tp_bounded){.value = own->acceleration_azimuth_deg}, 1),
      tp_document_say(d, tp_text_solid_wedge_on(own->acceleration_slides_on)));
}

void tp_solid_sheet_add_conclusion(tp_solid_sheet *s) {
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  tp_text t = {0};
  char n[TP_SHORTEST_SIZE];
  if (own->has_wedge) {
    conclude_wedge(&t, d, &own->wedge);
  } else if (own->has_contacts) {
    conclude_contacts(&t, d, &own->contacts);
  } else {
    conclude_bands(&t, d, own);
  }
  const tp_solid_safety *safety = tp_solid_safety_of(own);
  if (safety != NULL && safety->states[safety->governing].is_static) {
    tp_text_add(&t, " %s", tp_document_say(d, "The state without the earthquake governs."));
  }
  if (own->has_required_fos) {
    tp_text_add(&t, " ");
    tp_text_add(&t, tp_document_say(d, "Required factor of safety %s: %s."),
                tp_shortest(n, own->required_fos),
                tp_document_say(d, tp_sheet_met_words(tp_solid_meets(own, own->required_fos))));
  }
  tp_document_set_decimals(d, &t);
  tp_document_take(d, TP_PASSAGE_ANSWER, 0, &t);
}
