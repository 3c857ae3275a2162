/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A family of formulas as text, LaTeX, C or JSON, with the reach of its proof in words. */

#include "common/host.h"
#include "output/encode.h"
#include "output/json.h"
#include "report/c_arguments.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

#include <string.h>

static void add_counts(tp_text *t, const long *counts, int number) {
  for (int k = 0; k < number; k++) tp_text_add(t, "%s%ld", k > 0 ? ", " : "", counts[k]);
}

static const char *parity(bool even) {
  return even ? "even" : "odd";
}

/* The reach of the proof. */
static void add_proof(tp_text *t, const tp_family *f, const char *indent) {
  tp_text_add(t,
              "%sFor every N of a parity: each sum over the underside is a polynomial in N of\n"
              "%sdegree 3 at most (terms of degree 2 in the number of the joint, by parity), so\n"
              "%sfour members fix it.",
              indent, indent, indent);
  for (int even = 0; even < 2; even++) {
    tp_text_add(t, "\n%s%s: fixed by N = ", indent, even == 1 ? "Even" : "Odd");
    add_counts(t, f->fixed_by[even], TP_FAMILY_FIXED);
    tp_text_add(t, "; found exact on N = ");
    add_counts(t, f->checked_on[even], TP_FAMILY_CHECKED);
  }
  tp_text_add(t, "\n");
}

/* What a formula calls the number of teeth, or would. */
static const char *name_of_count(const tp_family *f) {
  return f->count_is_symbol ? f->count : "N";
}

static void add_title(tp_text *t, const tp_family *f,
                      void (*encode)(tp_text *text, const char *outside)) {
  encode(t, f->title != NULL ? f->title : "Toothed block");
  tp_text_add(t, ", for every number %s of teeth", name_of_count(f));
}

static void write_text(tp_text *t, const tp_family *f) {
  add_title(t, f, tp_encode_plain);
  if (!f->count_is_symbol) tp_text_add(t, ": N = %s", f->count);
  tp_text_add(t, "\n");
  for (int k = 0; k < 4; k++) {
    const tp_family_formula *own = f->formulas + k;
    tp_text_add(t, "\nN %s, towards the %s, about the %s\n  tan(alpha_crit) = %s\n",
                parity(own->even), tp_direction_name(own->towards), tp_pivot_kind_name(own->kind),
                own->tan_critical_angle.formula);
  }
  tp_text_add(t, "\n");
  add_proof(t, f, "");
}

static void write_latex(tp_text *t, const tp_family *f) {
  tp_text_add(t, "%% ");
  add_title(t, f, tp_encode_latex_comment);
  if (!f->count_is_symbol) tp_text_add(t, "\n\\[ N = %s \\]", f->count);
  tp_text_add(t, "\n");
  for (int k = 0; k < 4; k++) {
    const tp_family_formula *own = f->formulas + k;
    tp_text_add(
        t, "%% N %s, towards the %s, about the %s\n\\[ \\tan\\alpha_{\\mathrm{crit}} = %s \\]\n",
        parity(own->even), tp_direction_name(own->towards), tp_pivot_kind_name(own->kind),
        own->tan_critical_angle.formula);
  }
  add_proof(t, f, "% ");
}

static void write_c(tp_text *t, const tp_family *f) {
  tp_text_add(t, "/* ");
  add_title(t, f, tp_encode_c_comment);
  tp_text_add(t, ": N is %s\n *\n", f->count);
  for (size_t s = 0; s < f->symbol_count; s++) {
    if (strcmp(f->symbols[s], f->parameters[s]) == 0) continue;
    tp_text_add(t, " * ");
    tp_add_symbol(t, f->symbols[s], f->parameters[s]);
    tp_text_add(t, "\n");
  }
  add_proof(t, f, " * ");
  tp_text_add(t, " */\n\n#include <math.h>\n");
  for (int k = 0; k < 4; k++) {
    const tp_family_formula *own = f->formulas + k;
    tp_text_add(t, "\n/* N %s, towards the %s, about the %s */\ndouble tan_critical_angle_%s_%s(",
                parity(own->even), tp_direction_name(own->towards), tp_pivot_kind_name(own->kind),
                parity(own->even), tp_direction_name(own->towards));
    if (f->count_is_symbol)
      tp_text_add(t, "double %s%s", f->count, f->symbol_count > 0 ? ", " : "");
    for (size_t s = 0; s < f->symbol_count; s++) {
      tp_text_add(t, "%sdouble ", s > 0 ? ", " : "");
      tp_encode_plain(t, f->symbols[s]);
    }
    const bool alone = !f->count_is_symbol && f->symbol_count == 0;
    tp_text_add(t, "%s) {\n  return %s;\n}\n", alone ? "void" : "",
                own->tan_critical_angle.formula);
  }
}

tp_status tp_report_family(char **text, const tp_family *family) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, family);
  tp_text t = {0};
  switch (family->notation) {
  case TP_NOTATION_TEXT:
    write_text(&t, family);
    break;
  case TP_NOTATION_LATEX:
    write_latex(&t, family);
    break;
  case TP_NOTATION_C:
    write_c(&t, family);
    break;
  }
  return tp_text_finish(&t, text);
}
