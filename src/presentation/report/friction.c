/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facets with a friction angle that differs from the scene's, the first ten in text and all in
 * JSON. */

#include "report/friction.h"

#include "report/parts_json.h"

/* As many as are read; JSON has all. */
enum { LISTED = 10 };

static void add_facets(tp_page *p, const tp_facet_friction_result *f) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(&p->text, "         %s° on facet%s %zu", tp_page_degrees(n, f->angle_deg),
              f->first == f->last ? "" : "s", f->first);
  if (f->first != f->last) tp_text_add(&p->text, " to %zu", f->last);
  if (f->touching == 0) tp_text_add(&p->text, ", which the block does not touch");
  tp_text_add(&p->text, "\n");
}

void tp_page_add_friction(tp_page *p) {
  const tp_solution *s = p->solution;
  const size_t count = s->friction_facet_count;
  char n[TP_NUMBER_SIZE];
  if (count == 0) return;
  tp_text_add(&p->text, "Friction %s°, except on facets of the base, counted from the left:\n",
              tp_page_degrees(n, s->friction_angle_deg));
  for (size_t k = 0; k < count && k < LISTED; k++) add_facets(p, s->friction_facets + k);
  if (count > LISTED) tp_text_add(&p->text, "         and %zu more like these\n", count - LISTED);
}
