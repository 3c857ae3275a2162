/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor by strength reduction: the strength at which a motion just begins at the tilt of the
 * scene, with F the factor
 *
 *     tan phi_F = tan phi / F,   c_F = c / F   (times F where more strength lets it begin),
 *
 * and, where it slides along a facet then, that what is left of the strength there is what drives:
 * phi_F + i = alpha of the weight alone, else (N - U) tan phi_F + c_F A + P = T. It is printed only
 * where it holds within the bounds of all its numbers. And the factor by the tilt. */

#include "report/sheet.h"

#include "evaluation/certainty.h"
#include "number/near_angle.h"
#include "report/words.h"
#include "scene/partial_factors.h"

#include <math.h>

static tp_near near_of(tp_bounded number) {
  return (tp_near){number.value, number.error};
}

static tp_bounded bounded_of(tp_near number) {
  return (tp_bounded){.value = number.value, .error = number.error};
}

static bool is_zero(tp_near number) {
  return fabs(number.value) <= number.error;
}

static const tp_factor *find(const tp_case *c, tp_fos_definition definition) {
  const tp_governing_fos *g = &c->governing_fos;
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *own = g->factors + k;
    const bool number =
        own->fos.state == TP_FOS_NUMBER && own->fos.value.value > own->fos.value.error;
    if (own->definition == definition && number) return own;
  }
  return NULL;
}

/* ---- by strength reduction ---------------------------------------------------------------------
 */

/* A strength divided by the factor, or times it. */
static tp_near reduced(const tp_factor *f, tp_near strength) {
  const tp_near factor = near_of(f->fos.value);
  if (tp_near_is_zero(strength)) return strength;
  return f->raised ? tp_near_mul(strength, factor) : tp_near_div(strength, factor);
}

static tp_near tangent(tp_bounded degrees) {
  tp_near sine, cosine;
  tp_near_sin_cos(&sine, &cosine, near_of(degrees));
  return tp_near_div(sine, cosine);
}

/* A strength of the scene by its partial factor; 1 where it has none. */
static tp_near design(const tp_sheet *s, tp_near strength, tp_partial_factor which) {
  const tp_partial_factors *factors = s->scene->partial_factors;
  if (factors == NULL || fmpq_is_one(factors->values + which)) return strength;
  return tp_near_div(strength, near_of(tp_result_rational(factors->values + which)));
}

static tp_near design_friction(const tp_sheet *s) {
  return design(s, tangent(s->solution->friction_angle_deg), TP_PARTIAL_FRICTION);
}

static tp_bounded angle_of(tp_near tangent_of) {
  return bounded_of(tp_near_arctangent(tangent_of));
}

/* "φ_d = arctan (tan 38° / 1.25) = 32.006°" */
static void add_design_friction(tp_sheet *s) {
  const tp_partial_factors *factors = s->scene->partial_factors;
  char n[TP_NUMBER_SIZE];
  if (factors == NULL || fmpq_is_one(factors->values + TP_PARTIAL_FRICTION)) return;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH, "Strength by its partial factors:");
  tp_document_add(
      &s->document, TP_PASSAGE_EQUATION,
      "φ_d = \\arctan \\frac{\\tan φ}{γ_φ} = \\arctan \\frac{\\tan %s}{%s} = %s",
      tp_sheet_angle(s->solution->friction_angle_deg).text,
      tp_text_significant(n, tp_result_rational(factors->values + TP_PARTIAL_FRICTION), 6),
      tp_sheet_angle(angle_of(design_friction(s))).text);
}

static void add_friction(tp_sheet *s, const tp_factor *f) {
  const bool factored = s->scene->partial_factors != NULL;
  const tp_near tan_phi = design_friction(s);
  const char *phi = factored ? "φ_d" : "φ";
  const tp_sheet_number angle = tp_sheet_angle(angle_of(tan_phi)),
                        fos = tp_sheet_factor(f->fos.value),
                        result = tp_sheet_angle(angle_of(reduced(f, tan_phi)));
  if (f->raised) {
    tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                    "φ_F = \\arctan (\\text{FoS} · \\tan %s) = \\arctan (%s · \\tan %s) = %s", phi,
                    fos.text, angle.text, result.text);
  } else {
    tp_document_add(
        &s->document, TP_PASSAGE_EQUATION,
        "φ_F = \\arctan \\frac{\\tan %s}{\\text{FoS}} = \\arctan \\frac{\\tan %s}{%s} = %s", phi,
        angle.text, fos.text, result.text);
  }
}

/* Of a strength in kPa, after its partial factor. */
static void add_stress(tp_sheet *s, const tp_factor *f, const char *symbol,
                       const tp_quantity *kpa) {
  char n[2][TP_NUMBER_SIZE];
  if (!kpa->given || fmpq_is_zero(kpa->value)) return;
  const tp_near own = design(s, near_of(tp_result_rational(kpa->value)), TP_PARTIAL_COHESION);
  const char *index = s->scene->partial_factors != NULL ? "_d" : "";
  const tp_sheet_number fos = tp_sheet_factor(f->fos.value);
  tp_text_significant(n[0], bounded_of(own), 6);
  tp_text_significant(n[1], bounded_of(reduced(f, own)), 6);
  if (f->raised) {
    tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                    "%s_F = \\text{FoS} · %s%s = %s · %s = %s \\text{ kPa}", symbol, symbol, index,
                    fos.text, n[0], n[1]);
  } else {
    tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                    "%s_F = \\frac{%s%s}{\\text{FoS}} = \\frac{%s}{%s} = %s \\text{ kPa}", symbol,
                    symbol, index, n[0], fos.text, n[1]);
  }
}

/* Of the weight alone: what is left of the friction is what the facet asks for. */
static bool add_sliding_angle(tp_sheet *s, const tp_case *c, const tp_factor *f) {
  const tp_sliding *own = &c->sliding;
  if (s->solution->loaded || !own->known || own->never || own->always) return false;
  const tp_bounded phi = angle_of(reduced(f, tangent(own->friction_angle_deg)));
  const tp_bounded tilt = s->solution->tilt_angle_deg;
  const tp_near sum = tp_near_add(near_of(phi), near_of(own->facet_angle_deg));
  if (!is_zero(tp_near_sub(sum, near_of(tilt)))) return false;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "With that it just slides: φ_F and the inclination of the facet are the tilt.");
  tp_document_add(&s->document, TP_PASSAGE_EQUATION, "φ_F + i = %s + %s = %s",
                  tp_sheet_angle(phi).text, tp_sheet_angle(own->facet_angle_deg).text,
                  tp_sheet_angle(tilt).text);
  return true;
}

/* Under loads: it resists as much as drives it. */
static bool add_sliding_forces(tp_sheet *s, const tp_case *c, const tp_factor *f) {
  const tp_sliding *own = &c->sliding;
  char n[TP_NUMBER_SIZE];
  if (!s->solution->loaded || !own->known || !own->has_forces) return false;
  const tp_near tan_phi = reduced(f, near_of(own->friction_tangent)),
                cohesion = reduced(f, near_of(own->cohesion_n)),
                pressed = tp_near_sub(near_of(own->normal_n), near_of(own->uplift_n));
  const tp_near held =
      tp_near_add(tp_near_add(tp_near_mul(pressed, tan_phi), cohesion), near_of(own->held_n));
  if (!is_zero(tp_near_sub(held, near_of(own->driving_n)))) return false;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "With that it just slides: what resists along the facet is what drives.");
  tp_document_add(
      &s->document, TP_PASSAGE_EQUATION,
      "(N − U) \\tan φ_F + c_F A + P = (%s − %s) · %s + %s + %s = %s = T",
      tp_sheet_force_number(s, own->normal_n).text, tp_sheet_force_number(s, own->uplift_n).text,
      tp_text_significant(n, bounded_of(tan_phi), 6),
      tp_sheet_force_number(s, bounded_of(cohesion)).text,
      tp_sheet_force_number(s, own->held_n).text, tp_sheet_force_number(s, own->driving_n).text);
  return true;
}

static void add_reduction(tp_sheet *s, const tp_case *c) {
  const tp_factor *f = find(c, TP_FOS_BY_REDUCTION);
  tp_document *d = &s->document;
  if (f == NULL) return;
  if (f->raised) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "Factor of safety by strength: all strength is multiplied by it until at this "
                    "tilt a motion can just begin, or begin no more.");
  } else {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "Factor of safety by strength reduction: all strength is divided by it until "
                    "at this tilt a motion can just begin.");
  }
  if (s->solution->friction_is_residual || s->solution->friction_facet_count > 0) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "tan φ of each facet, as it is at its stress, is so divided or multiplied: "
                    "FoS = %s.",
                    tp_sheet_factor(f->fos.value).text);
    return;
  }
  add_design_friction(s);
  add_friction(s, f);
  add_stress(s, f, "c", &s->scene->loads.cohesion_kpa);
  add_stress(s, f, "σ", &s->scene->loads.bond_kpa);
  if (add_sliding_angle(s, c, f) || add_sliding_forces(s, c, f)) return;
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      "With that strength in the scene the tilt up to which it stands is this tilt "
      "(topple solve --set friction_angle_deg=%s repeats it).",
      tp_text_significant((char[TP_NUMBER_SIZE]){0}, angle_of(reduced(f, design_friction(s))), 12));
}

/* ---- on driving loads --------------------------------------------------------------------------
 */

static void add_driving(tp_sheet *s, const tp_case *c) {
  const tp_factor *f = find(c, TP_FOS_BY_DRIVING);
  if (f == NULL || f->fos.state != TP_FOS_NUMBER) return;
  if (!c->has_tilt_of_factor) {
    tp_document_add(
        &s->document, TP_PASSAGE_PARAGRAPH,
        "Factor of safety on driving loads: the first motion begins where the loads that "
        "drive the block are multiplied by FoS = %s, while those that rest on the base "
        "stay.",
        tp_sheet_factor(f->fos.value).text);
    return;
  }
  tp_document_add(
      &s->document, TP_PASSAGE_PARAGRAPH,
      "Factor of safety on driving loads: of the tilt α_s = %s at which the motion begins, "
      "and the tilt α.",
      tp_sheet_angle(c->tilt_of_factor_deg).text);
  tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                  "\\text{FoS} = \\frac{\\tan α_s}{\\tan α} = \\frac{\\tan %s}{\\tan %s} = %s",
                  tp_sheet_angle(c->tilt_of_factor_deg).text,
                  tp_sheet_angle(s->solution->tilt_angle_deg).text,
                  tp_sheet_factor(f->fos.value).text);
}

void tp_sheet_add_strength_formulas(tp_sheet *s, const tp_case *c) {
  if (!s->solution->has_tilt_angle) return;
  add_reduction(s, c);
  add_driving(s, c);
}
