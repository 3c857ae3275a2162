/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Forces of bolts as given, in kN; what they come to, per metre and on the block. */

#include "report/supports.h"

static void add_bolts(tp_page *p, const tp_support *own) {
  char n[2][TP_NUMBER_SIZE];
  const char *unit = p->solution->length_unit;
  tp_text_add(&p->text, "bolts of %s kN", tp_text_significant(n[0], own->force_kn, 5));
  if (own->rows > 1) tp_text_add(&p->text, " in %zu rows", own->rows);
  if (own->has_spacing) {
    tp_text_add(&p->text, " at a spacing of %s %s", tp_page_length(p, n[0], own->spacing_m, 5),
                unit);
  }
  if (own->has_capacity) {
    tp_text_add(&p->text, ",\n         capacity %s kN, utilisation %s",
                tp_text_significant(n[0], own->capacity_kn, 5),
                tp_text_fixed_up(n[1], own->utilisation, 3));
  }
  if (own->has_length) {
    tp_text_add(&p->text, ",\n         %s %s long, of which at least %s %s beyond the block",
                tp_page_length(p, n[0], own->length_m, 5), unit,
                tp_page_length(p, n[1], own->bond_length_m, 4), unit);
  }
}

void tp_page_add_supports(tp_page *p) {
  const tp_solution *s = p->solution;
  char n[2][TP_NUMBER_SIZE];
  for (size_t k = 0; k < s->support_count; k++) {
    const tp_support *own = s->supports + k;
    tp_text_add(&p->text, k == 0 ? "Support  " : "         ");
    if (own->is_pressure) {
      tp_text_add(&p->text, "pressure of a lining or a wall");
    } else {
      add_bolts(p, own);
    }
    tp_text_add(&p->text, ";\n         %s: %s kN per metre, %s kN on the block\n",
                own->passive ? "passive" : "active", tp_text_significant(n[0], own->force_kn_m, 5),
                tp_text_significant(n[1], own->total_kn, 5));
  }
}
