/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tilts of balance, overtopping water and the moments of each load about the governing pivot
 * (docs/mechanics.md section 5), in text and JSON. */

#include "report/loads.h"
#include "terms/names.h"

/* The tilts in order: it begins to move at the first if it stands level, holds again at the next.
 */
static void add_limits(tp_page *p, const tp_case *c) {
  const tp_pivot *pivot = c->pivots + c->toppling_pivot;
  char n[TP_NUMBER_SIZE];
  if (pivot->limit_count < 2 && !(pivot->limit_count == 1 && pivot->critical_angle_deg.value < 0)) {
    return;
  }
  tp_text_add(&p->text, "  About that pivot its moments balance at");
  for (size_t k = 0; k < pivot->limit_count; k++) {
    tp_text_add(&p->text, "%s %s°", k > 0 ? " and" : "", tp_text_fixed(n, pivot->limits_deg[k], 3));
  }
  tp_text_add(&p->text, ": between these\n  tilts it fails or is held again.\n");
}

static bool is_beyond(tp_bounded angle, tp_bounded other) {
  return angle.value + angle.error > other.value - other.error;
}

/* Is anything said of tilts at which level water would run over the top of its face? */
static bool speaks_beyond_the_face(const tp_page *p, const tp_case *c) {
  const tp_bounded top = c->water_overtops_deg;
  if (p->solution->has_tilt_angle && is_beyond(p->solution->tilt_angle_deg, top)) return true;
  if (c->limit.kind != TP_LIMIT_AT_ANGLE || is_beyond(c->limit.critical_angle_deg, top))
    return true;
  const tp_sliding *s = &c->sliding;
  return s->known && !s->never && !s->always && is_beyond(s->critical_angle_deg, top);
}

static void add_overtopping(tp_page *p, const tp_case *c) {
  char n[TP_NUMBER_SIZE];
  if (!c->water_overtops || !speaks_beyond_the_face(p, c)) return;
  tp_text_add(&p->text,
              "  Caution: beyond %s° the level of the water is above the top of its face. There\n"
              "  its pressure is computed as if the face continued upwards: an upper bound.\n",
              tp_text_fixed(n, c->water_overtops_deg, 3));
  if (c->limit.kind == TP_LIMIT_INTERLOCKED || c->limit.kind == TP_LIMIT_NOWHERE) {
    tp_text_add(&p->text, "  It grows without bound towards 90°: contact forces are examined up to "
                          "89.9999°.\n");
  }
}

void tp_page_add_balance(tp_page *p, const tp_case *c) {
  if (!p->solution->loaded) return;
  add_overtopping(p, c);
  if (c->has_toppling_pivot) add_limits(p, c);
}

void tp_page_add_loads(tp_page *p, const tp_case *c) {
  tp_page_add_balance(p, c);
  if (!p->solution->loaded || !c->has_toppling_pivot || c->load_count == 0) return;
  const tp_result_unit unit = p->solution->result_units.moment;
  tp_text_add(&p->text, "  Moments about the governing pivot, overturning positive\n");
  for (size_t k = 0; k < c->load_count; k++) {
    const tp_load_result *l = c->loads + k;
    char n[TP_NUMBER_SIZE];
    tp_text_add(&p->text, "    %-17s %14s %s   %s\n", l->name,
                tp_text_significant(n, tp_page_in(l->moment_nm, unit), 6),
                unit.name != NULL ? unit.name : "N m", tp_load_side_name(l->side));
  }
  tp_text_add(&p->text, "\n");
}
