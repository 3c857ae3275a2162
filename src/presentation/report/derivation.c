/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A derivation as a page of text, as LaTeX, or as C functions, pivot by pivot with the elements
 * form, limit, onset and rounding (docs/derive.md). */

#include "common/host.h"
#include "output/encode.h"
#include "report/c_arguments.h"
#include "report/derived_limit.h"
#include "report/derived_onset.h"
#include "report/notes.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdlib.h>
#include <string.h>

typedef void (*encoder)(tp_text *text, const char *outside);

static void add_heading(tp_text *t, const tp_derivation *d, encoder encode) {
  encode(t, d->title != NULL ? d->title : "Formulas");
  tp_text_add(t, ": ");
  if (d->symbol_count == 0) tp_text_add(t, "no parameters, so numbers");
  for (size_t k = 0; k < d->symbol_count; k++) {
    tp_text_add(t, "%s", k == 0 ? "in " : ", ");
    tp_add_symbol(t, d->symbols[k], d->parameters[k]);
  }
}

/* "valley at (0, 0), towards the left, governs, 35.201 degrees at the scene's values" */
static void add_description(tp_text *t, const tp_derived_pivot *p) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "%s at (%s, %s), towards the %s, %s, %s degrees at the scene's values",
              tp_pivot_kind_name(p->kind), p->x.formula, p->y.formula,
              tp_direction_name(p->towards),
              p->governs      ? "governs"
              : p->admissible ? "admissible"
                              : "not admissible",
              tp_text_fixed(n, p->critical_angle_deg, 3));
}

/* The formula as a factor: in parentheses where it has a sum or a quotient. */
static void add_factor(tp_text *t, const char *formula) {
  const bool plain = strpbrk(formula, " /") == NULL;
  tp_text_add(t, plain ? "%s" : "(%s)", formula);
}

static void add_elements(tp_text *t, const tp_derivation *d, tp_direction towards) {
  if (d->elements[towards] == NULL) return;
  tp_text_add(t, "\nElements about the governing pivot, towards the %s\n",
              tp_direction_name(towards));
  for (size_t k = 0; k < d->element_count; k++) {
    const tp_derived_element *e = d->elements[towards] + k;
    tp_text_add(t, "  w%zu  %s, area %s\n      arms %s (%s), %s (%s)\n", k + 1,
                tp_element_kind_name(e->kind), e->area.formula, e->normal_arm.formula,
                e->normal_stabilises ? "stabilises" : "overturns", e->parallel_arm.formula,
                e->parallel_overturns ? "overturns" : "stabilises");
  }
}

static void add_text_pivot(tp_text *t, const tp_derived_pivot *p) {
  tp_text_add(t, "\nPivot: ");
  add_description(t, p);
  tp_text_add(t, "\n  tan(alpha_crit) = %s\n", p->tan_critical_angle.formula);
  if (!p->has_elements) return;
  tp_text_add(t, "  FoS by elements = ");
  if (p->splits) {
    add_factor(t, p->fos_cot.formula);
    tp_text_add(t, "*cot(alpha)");
    if (strcmp(p->fos_constant.formula, "0") != 0) {
      tp_text_add(t, " + %s", p->fos_constant.formula);
    }
    tp_text_add(t, "\n");
  } else {
    tp_text_add(
        t,
        "(A*cot(alpha) + B)/(C*cot(alpha) + D)\n    A = %s\n    B = %s\n    C = %s\n    D = %s\n",
        p->stabilising_cos.formula, p->stabilising_sin.formula, p->overturning_cos.formula,
        p->overturning_sin.formula);
  }
}

static void add_text_rounding(tp_text *t, const tp_derived_rounding *r, tp_direction towards) {
  if (!r->known) return;
  tp_text_add(
      t,
      "\nRounded corner: the axis moves from the governing %s, towards the %s, up-dip along\n"
      "its facet, of angle i, by r; the mass is kept\n  tan(alpha_crit) = %s\n"
      "  toppling at alpha: r = %s\n",
      tp_pivot_kind_name(r->kind), tp_direction_name(towards), r->tan_critical_angle.formula,
      r->rounding_length.formula);
  if (r->has_radius) tp_text_add(t, "  of radius r_c = %s\n", r->corner_radius.formula);
}

static void write_text(tp_text *t, const tp_derivation *d) {
  add_heading(t, d, tp_encode_plain);
  tp_text_add(t,
              "\n\nLengths in scene units; moments about its origin, weighted by relative density\n"
              "  area = %s\n  x moment = %s\n  y moment = %s\n\n"
              "FoS by the resultant weight = tan(alpha_crit)*cot(alpha)\n",
              d->area.formula, d->x_moment.formula, d->y_moment.formula);
  for (size_t k = 0; k < d->pivot_count; k++) add_text_pivot(t, d->pivots + k);
  add_elements(t, d, TP_TOWARDS_LEFT);
  add_elements(t, d, TP_TOWARDS_RIGHT);
  add_text_rounding(t, d->rounded + TP_TOWARDS_LEFT, TP_TOWARDS_LEFT);
  add_text_rounding(t, d->rounded + TP_TOWARDS_RIGHT, TP_TOWARDS_RIGHT);
  tp_text_derived_limit(t, d);
  tp_text_derived_onset(t, d);
  if (d->notes.count > 0) tp_text_add(t, "\n");
  tp_text_notes(t, &d->notes);
}

/* Notes as comments, one a line. */
static void add_comments(tp_text *t, const tp_derivation *d, const char *begin, const char *end,
                         encoder encode) {
  for (size_t k = 0; k < d->notes.count; k++) {
    const tp_note *note = d->notes.items + k;
    tp_text_add(t, "%s%s: ", begin, tp_note_kind_name(note->kind));
    encode(t, note->text);
    if (note->place[0] != '\0') {
      tp_text_add(t, " (");
      encode(t, note->place);
      tp_text_add(t, ")");
    }
    tp_text_add(t, "%s\n", end);
  }
}

static void add_latex_rounding(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_rounding *r = d->rounded + k;
    if (!r->known) continue;
    tp_text_add(t, "%% the corner at the governing %s, towards the %s, rounded\n",
                tp_pivot_kind_name(r->kind), tp_direction_name((tp_direction)k));
    tp_text_add(t, "\\[ \\tan\\alpha_{\\mathrm{crit}} = %s \\]\n\\[ r = %s \\]\n",
                r->tan_critical_angle.formula, r->rounding_length.formula);
    if (r->has_radius) tp_text_add(t, "\\[ r_c = %s \\]\n", r->corner_radius.formula);
  }
}

static void write_latex(tp_text *t, const tp_derivation *d) {
  tp_text_add(t, "%% ");
  add_heading(t, d, tp_encode_latex_comment);
  tp_text_add(t, "\n\\[ A = %s \\]\n\\[ S_x = %s \\]\n\\[ S_y = %s \\]\n", d->area.formula,
              d->x_moment.formula, d->y_moment.formula);
  for (size_t k = 0; k < d->pivot_count; k++) {
    const tp_derived_pivot *p = d->pivots + k;
    tp_text_add(t, "%% ");
    add_description(t, p);
    tp_text_add(t, "\n\\[ \\tan\\alpha_{\\mathrm{crit}} = %s \\]\n", p->tan_critical_angle.formula);
    if (!p->has_elements) continue;
    if (p->splits) {
      tp_text_add(t, "\\[ \\mathrm{FoS} = %s \\cot\\alpha + %s \\]\n", p->fos_cot.formula,
                  p->fos_constant.formula);
    } else {
      tp_text_add(t,
                  "\\[ \\mathrm{FoS} = \\frac{\\left(%s\\right) \\cot\\alpha + %s}"
                  "{\\left(%s\\right) \\cot\\alpha + %s} \\]\n",
                  p->stabilising_cos.formula, p->stabilising_sin.formula,
                  p->overturning_cos.formula, p->overturning_sin.formula);
    }
  }
  add_latex_rounding(t, d);
  tp_latex_derived_limit(t, d);
  tp_latex_derived_onset(t, d);
  add_comments(t, d, "% ", "", tp_encode_latex_comment);
}

static void add_c_pivot(tp_text *t, const tp_derivation *d, size_t k) {
  const tp_derived_pivot *p = d->pivots + k;
  tp_text_add(t, "\n/* ");
  add_description(t, p);
  tp_text_add(t, " */\ndouble tan_critical_angle_%zu", k + 1);
  tp_c_arguments(t, d, "");
  const bool bounded = strcmp(p->tan_critical_angle.denominator, "0") != 0;
  tp_text_add(t, "  return %s;\n}\n", bounded ? p->tan_critical_angle.formula : "INFINITY");
  if (!p->has_elements) return;
  tp_text_add(t, "\ndouble fos_elements_%zu", k + 1);
  tp_c_arguments(t, d, "double alpha");
  tp_text_add(
      t,
      "  const double normal = cos(alpha), parallel = sin(alpha);\n"
      "  return (normal*(%s) + parallel*(%s))\n         / (normal*(%s) + parallel*(%s));\n}\n",
      p->stabilising_cos.formula, p->stabilising_sin.formula, p->overturning_cos.formula,
      p->overturning_sin.formula);
}

/* Angles in radians. */
static void add_c_rounding(tp_text *t, const tp_derivation *d) {
  for (int k = 0; k < 2; k++) {
    const tp_derived_rounding *r = d->rounded + k;
    const char *side = tp_direction_name((tp_direction)k);
    if (!r->known) continue;
    tp_text_add(
        t,
        "\n/* the corner at the governing %s, towards the %s, rounded by r along its facet of "
        "angle i */\ndouble tan_critical_angle_rounded_%s",
        tp_pivot_kind_name(r->kind), side, side);
    tp_c_arguments(t, d, "double r, double i");
    tp_text_add(t, "  (void)i; /* of a level facet it is 0 */\n  return %s;\n}\n",
                r->tan_critical_angle.formula);
    tp_text_add(t, "\ndouble rounding_length_%s", side);
    tp_c_arguments(t, d, "double alpha, double i");
    tp_text_add(t, "  (void)i;\n  return %s;\n}\n", r->rounding_length.formula);
    if (!r->has_radius) continue;
    tp_text_add(t, "\ndouble corner_radius_%s", side);
    tp_c_arguments(t, d, "double alpha, double i");
    tp_text_add(t, "  (void)i;\n  return %s;\n}\n", r->corner_radius.formula);
  }
}

static void write_c(tp_text *t, const tp_derivation *d) {
  tp_text_add(t, "/* ");
  add_heading(t, d, tp_encode_c_comment);
  tp_text_add(t, " */\n\n#include <math.h>\n\ndouble area");
  tp_c_arguments(t, d, "");
  tp_text_add(t, "  return %s;\n}\n", d->area.formula);
  for (size_t k = 0; k < d->pivot_count; k++) add_c_pivot(t, d, k);
  add_c_rounding(t, d);
  tp_c_derived_limit(t, d);
  tp_c_derived_onset(t, d);
  if (d->notes.count > 0) tp_text_add(t, "\n");
  add_comments(t, d, "/* ", " */", tp_encode_c_comment);
}

tp_status tp_report_derivation(char **text, const tp_derivation *derivation) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, derivation);
  tp_text t = {0};
  switch (derivation->notation) {
  case TP_NOTATION_TEXT:
    write_text(&t, derivation);
    break;
  case TP_NOTATION_LATEX:
    write_latex(&t, derivation);
    break;
  case TP_NOTATION_C:
    write_c(&t, derivation);
    break;
  }
  return tp_text_finish(&t, text);
}
