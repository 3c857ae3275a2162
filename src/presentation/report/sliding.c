/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding along the facet that governs, on the page. */

#include "report/sliding.h"

#include <string.h>

/* "along the facet from (30, 5) to (60, 0)" */
static void add_facet(tp_page *p, const tp_sliding *s) {
  char n[4][TP_NUMBER_SIZE];
  tp_page_coordinate(p, n[0], s->facet_x0_m);
  tp_page_coordinate(p, n[1], s->facet_y0_m);
  tp_page_coordinate(p, n[2], s->facet_x1_m);
  tp_page_coordinate(p, n[3], s->facet_y1_m);
  if (strcmp(n[0], n[2]) == 0 && strcmp(n[1], n[3]) == 0) {
    tp_text_add(&p->text, "against the contact in (%s, %s)", n[0], n[1]);
  } else {
    tp_text_add(&p->text, "along the facet from (%s, %s) to (%s, %s)", n[0], n[1], n[2], n[3]);
  }
}

static void add_loaded(tp_page *p, const tp_sliding *s) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(&p->text, "  Sliding under the loads: ");
  if (s->never || s->always) {
    tp_text_add(&p->text, "at %s tilt.\n", s->never ? "no" : "every");
    return;
  }
  tp_text_add(&p->text, "%s°, by the forces along and across the facet\n  ",
              tp_text_fixed(n, s->critical_angle_deg, 3));
  tp_text_add(&p->text, "that it slides on.\n");
}

void tp_page_add_sliding(tp_page *p, const tp_case *c) {
  const tp_solution *solution = p->solution;
  const tp_sliding *s = &c->sliding;
  char n[3][TP_NUMBER_SIZE];
  if (!solution->has_friction) {
    tp_text_add(&p->text, "  Sliding is not judged: the scene gives no friction_angle_deg.\n");
    return;
  }
  if (!s->known) return;
  if (solution->loaded) {
    add_loaded(p, s);
    return;
  }
  if (s->never) {
    tp_text_add(&p->text, "  Sliding: at no tilt, a facet stands too steep in the way.\n");
    return;
  }
  const bool climbs = s->facet_angle_deg.value >= 0;
  tp_bounded i = s->facet_angle_deg;
  if (!climbs) i.value = -i.value;
  tp_text_add(&p->text, "  Sliding ");
  add_facet(p, s);
  tp_text_add(&p->text, ":\n  φ %s i = %s° %s %s° = %s°%s.\n", climbs ? "+" : "−",
              tp_page_degrees(n[0], s->friction_angle_deg), climbs ? "+" : "−",
              tp_page_degrees(n[1], i), tp_text_fixed(n[2], s->critical_angle_deg, 3),
              solution->friction_is_patton ? ", φ by Patton's law (Eq. 6)" : "");
  if (solution->friction_facet_count > 0) {
    tp_text_add(&p->text, "  φ: the least of that facet and of all parallel to it.\n");
  }
}
