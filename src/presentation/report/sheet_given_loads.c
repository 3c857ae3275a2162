/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads of the scene with their sizes, as it gives them: without partial factors, which a row
 * of their own names. Of equal loads one stands for all. */

#include "report/sheet.h"

#include "evaluation/certainty.h"
#include "report/page.h"
#include "scene/anchor.h"

#include <string.h>

#define KILO 1e3

/* The cell that is being filled. */
typedef struct listing {
  tp_sheet *s;
  tp_text text;
  tp_text last; /* the load before, */
  size_t times; /* which stands so often */
} listing;

static void flush(listing *own) {
  if (own->times == 0) return;
  if (own->text.length > 0) tp_text_add(&own->text, "; ");
  if (own->times > 1) tp_text_add(&own->text, "%zu × ", own->times);
  tp_text_add(&own->text, "%s", own->last.data != NULL ? own->last.data : "");
  own->text.failed = own->text.failed || own->last.failed;
  tp_text_drop(&own->last);
  own->last = (tp_text){0};
  own->times = 0;
}

/* A load, which is taken over. */
static void add(listing *own, tp_text *load) {
  tp_document_set_decimals(&own->s->document, load);
  const bool same = own->times > 0 && !load->failed && own->last.data != NULL &&
                    load->data != NULL && strcmp(own->last.data, load->data) == 0;
  if (!same) flush(own);
  own->times++;
  if (same) {
    tp_text_drop(load);
  } else {
    own->last = *load;
  }
}

/* A phrase in the language of the sheet. */
#define SAY(own, phrase) tp_document_say(&(own)->s->document, phrase)

static const char *number(char out[TP_NUMBER_SIZE], const tp_quantity *of) {
  return tp_text_significant(out, tp_result_rational(of->value), 5);
}

/* A length of the scene in the unit that reports print in. */
static const char *length(char out[TP_NUMBER_SIZE], const listing *own, const tp_quantity *of) {
  const tp_page page = {.solution = own->s->solution};
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, of->value, own->s->scene->metres_per_unit);
  const tp_bounded bounded = tp_result_rational(metres);
  fmpq_clear(metres);
  return tp_page_length(&page, out, bounded, 6);
}

static const char *unit(const listing *own) {
  return own->s->solution->length_unit;
}

static tp_bounded times_kilo(const fmpq_t value) {
  fmpq_t own;
  fmpq_init(own);
  fmpq_set(own, value);
  fmpq_mul_si(own, own, (slong)KILO);
  const tp_bounded bounded = tp_result_rational(own);
  fmpq_clear(own);
  return bounded;
}

static const char *force(char out[TP_NUMBER_SIZE], const listing *own, const tp_quantity *kn) {
  return tp_text_significant(out, tp_sheet_force(own->s, times_kilo(kn->value)), 5);
}

static const char *stress(char out[TP_NUMBER_SIZE], const listing *own, const tp_quantity *kpa) {
  const tp_result_unit asked = own->s->solution->result_units.stress;
  const tp_bounded pascals = times_kilo(kpa->value);
  return tp_text_significant(
      out, asked.name != NULL ? tp_page_in(pascals, asked) : tp_text_over(pascals, KILO), 5);
}

static const char *stress_unit(const listing *own) {
  const char *name = own->s->solution->result_units.stress.name;
  return name != NULL ? name : "kPa";
}

/* ---- each kind of load -------------------------------------------------------------------------
 */

static bool is_some(const tp_quantity *q) {
  return q->given && !fmpq_is_zero(q->value);
}

static void add_strength(listing *own, const char *phrase, const tp_quantity *kpa) {
  char n[TP_NUMBER_SIZE];
  tp_text t = {0};
  if (!is_some(kpa)) return;
  tp_text_add(&t, SAY(own, phrase), stress(n, own, kpa), stress_unit(own));
  add(own, &t);
}

static void add_earthquake(listing *own, const tp_loads_description *l) {
  char n[2][TP_NUMBER_SIZE];
  tp_text t = {0};
  if (!is_some(&l->horizontal) && !is_some(&l->vertical)) return;
  tp_text_add(&t, SAY(own, "earthquake k_h = %s, k_v = %s"), number(n[0], &l->horizontal),
              number(n[1], &l->vertical));
  add(own, &t);
}

static void add_water_stand(listing *own, tp_text *t, const tp_water_description *w) {
  char n[TP_NUMBER_SIZE];
  if (w->level.given) {
    tp_text_add(t, SAY(own, "water to the level %s %s"), length(n, own, &w->level), unit(own));
  } else if (w->surface.count > 0) {
    tp_text_add(t, SAY(own, "water below a surface of %ld points"), w->surface.count);
  } else if (w->height.given) {
    tp_text_add(t, SAY(own, "water %s %s high behind the block"), length(n, own, &w->height),
                unit(own));
  }
}

static void add_crack(listing *own, tp_text *t, const tp_water_description *w) {
  char n[TP_NUMBER_SIZE];
  if (!w->cracked) return;
  if (t->length > 0) tp_text_add(t, ", ");
  if (w->crack_level.given) {
    tp_text_add(t, SAY(own, "tension crack filled to the level %s %s"),
                length(n, own, &w->crack_level), unit(own));
  } else {
    tp_text_add(t, SAY(own, "tension crack filled %s %s high"), length(n, own, &w->crack_height),
                unit(own));
  }
}

static const char *uplift_words(const tp_water_description *w) {
  if (!w->uplift) return "no uplift";
  return w->shape == TP_WATER_UPLIFT_FULL ? "full uplift" : "triangular uplift";
}

static void add_water(listing *own, const tp_water_description *w) {
  char n[2][TP_NUMBER_SIZE];
  tp_text t = {0};
  if (!w->given) return;
  add_water_stand(own, &t, w);
  add_crack(own, &t, w);
  tp_text_add(&t, ", %s", SAY(own, uplift_words(w)));
  if (w->unit_weight_kn_m3.given) {
    tp_text_add(&t, ", ");
    tp_text_add(&t, SAY(own, "γ_w = %s kN/m³"), number(n[0], &w->unit_weight_kn_m3));
  }
  add(own, &t);
  if (!is_some(&w->ice_kpa)) return;
  t = (tp_text){0};
  tp_text_add(&t, SAY(own, "ice %s %s, %s %s thick"), stress(n[0], own, &w->ice_kpa),
              stress_unit(own), length(n[1], own, &w->ice_thickness), unit(own));
  add(own, &t);
}

static void add_lines(listing *own, const tp_line_load *loads, long count, const char *even,
                      const char *uneven) {
  for (long k = 0; k < count; k++) {
    const tp_line_load *l = loads + k;
    char n[2][TP_NUMBER_SIZE];
    tp_text t = {0};
    if (l->last_kpa.given && !fmpq_equal(l->first_kpa.value, l->last_kpa.value)) {
      tp_text_add(&t, SAY(own, uneven), stress(n[0], own, &l->first_kpa),
                  stress(n[1], own, &l->last_kpa), stress_unit(own));
    } else {
      tp_text_add(&t, SAY(own, even), stress(n[0], own, &l->first_kpa), stress_unit(own));
    }
    add(own, &t);
  }
}

static void add_bolts(listing *own, const tp_anchor_description *a) {
  char n[TP_NUMBER_SIZE];
  tp_text t = {0};
  const tp_quantity *kn = tp_anchor_bolt_force(a);
  tp_text_add(&t, a->passive ? SAY(own, "passive anchors of %s %s") : SAY(own, "anchors of %s %s"),
              force(n, own, kn), tp_sheet_force_unit(own->s));
  if (tp_anchor_rows(a) > 1) {
    tp_text_add(&t, ", ");
    tp_text_add(&t, SAY(own, "%ld rows"), tp_anchor_rows(a));
  }
  if (a->spacing.given) {
    tp_text_add(&t, ", ");
    tp_text_add(&t, SAY(own, "spaced %s %s"), length(n, own, &a->spacing), unit(own));
  }
  add(own, &t);
}

void tp_sheet_add_given_loads(tp_sheet *s) {
  const tp_loads_description *l = &s->scene->loads;
  tp_document *d = &s->document;
  listing own = {.s = s};
  add_water(&own, &l->water);
  add_earthquake(&own, l);
  add_lines(&own, l->surcharges, l->surcharge_count, "surcharge %s %s", "surcharge %s to %s %s");
  add_lines(&own, l->pressures, l->pressure_count, "pressure %s %s", "pressure %s to %s %s");
  add_lines(&own, l->supports, l->support_count, "support pressure %s %s",
            "support pressure %s to %s %s");
  for (long k = 0; k < l->anchor_count; k++) add_bolts(&own, l->anchors + k);
  add_strength(&own, "cohesion %s %s", &l->cohesion_kpa);
  add_strength(&own, "bond %s %s", &l->bond_kpa);
  flush(&own);
  if (own.text.length > 0) {
    tp_document_word(d, "Loads");
    tp_document_take_cell(d, &own.text);
  } else {
    d->failed = d->failed || own.text.failed;
    tp_text_drop(&own.text);
  }
  if (s->solution->partial_factors != NULL) {
    tp_document_word(d, "Partial factors");
    tp_document_told_cell(d, s->solution->partial_factors);
  }
}
