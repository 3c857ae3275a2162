/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as a page for a terminal, 80 columns wide. Every printed digit is certain. */

#include "host.h"
#include "report/encode.h"
#include "report/report_contact.h"
#include "report/report_digits.h"
#include "report/report_limit.h"
#include "report/report_loads.h"
#include "report/report_verdict.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ROWS_SHOWN = 16 };

static void add_teeth(tp_page *p) {
  const tp_teeth_result *teeth = &p->solution->teeth;
  const char *unit = p->solution->length_unit;
  char n[7][TP_NUMBER_SIZE];
  if (!teeth->known) return;
  tp_text_add(&p->text, "Teeth    N = %zu, a = %s, b = %s, c = %s %s; left end %s, right end %s\n",
              teeth->count, tp_page_length(p, n[0], teeth->width_m, 6),
              tp_page_length(p, n[1], teeth->height_m, 6),
              tp_page_length(p, n[2], teeth->depth_m, 6), unit, tp_text_pivot_kind(teeth->left_end),
              tp_text_pivot_kind(teeth->right_end));
  tp_text_add(&p->text,
              "         width Δx = %s, mean height y = %s, amplitude A = %s,\n"
              "         wavelength λ = %s %s\n",
              tp_page_length(p, n[3], teeth->block_width_m, 6),
              tp_page_length(p, n[4], teeth->mean_height_m, 6),
              tp_page_length(p, n[5], teeth->amplitude_m, 6),
              tp_page_length(p, n[6], teeth->wavelength_m, 6), unit);
}

static void add_block(tp_page *p) {
  const tp_solution *s = p->solution;
  const tp_block_result *b = &s->block;
  const char *unit = s->length_unit;
  char n[4][TP_NUMBER_SIZE];
  const tp_bounded area =
      tp_text_over(tp_text_over(b->area_m2, s->metres_per_unit), s->metres_per_unit);
  tp_text_add(&p->text, "Block    area %s %s², centroid (%s, %s) %s",
              tp_text_significant(n[0], area, 6), unit,
              tp_page_coordinate(p, n[1], b->centroid_x_m),
              tp_page_coordinate(p, n[2], b->centroid_y_m), unit);
  if (b->has_weight) {
    tp_text_add(&p->text, ", weight ");
    tp_page_add_quantity(p, b->weight_n, "N");
    tp_text_add(&p->text, "\n         over a thickness of %s %s",
                tp_page_length(p, n[3], b->thickness_m, 6), unit);
  } else {
    tp_text_add(&p->text, "\n         (no weight: the scene gives no unit_weight_kn_m3)");
  }
  if (b->vertices > 0) tp_text_add(&p->text, "; %zu vertices", b->vertices);
  if (b->vertices == 0) tp_text_add(&p->text, "; an ellipse on its flat");
  if (b->holes > 0) tp_text_add(&p->text, ", %zu hole%s", b->holes, b->holes == 1 ? "" : "s");
  if (b->parts > 0) {
    tp_text_add(&p->text, ", %zu part%s of other density", b->parts, b->parts == 1 ? "" : "s");
  }
  tp_text_add(&p->text, "\n");
}

static void add_pivot_row(tp_page *p, const tp_case *c, size_t k) {
  const tp_pivot *pivot = c->pivots + k;
  char n[5][TP_NUMBER_SIZE];
  const bool governs = c->has_governing && k == c->governing;
  tp_text_add(&p->text, "%s %-8s %10s %10s ", governs ? ">" : " ", tp_text_pivot_kind(pivot->kind),
              tp_page_coordinate(p, n[0], pivot->x_m), tp_page_coordinate(p, n[1], pivot->y_m));
  if (pivot->never || pivot->always) {
    tp_text_add(&p->text, "%14s", pivot->never ? "never" : "always");
  } else {
    tp_text_add(&p->text, "%13s°", tp_text_fixed(n[2], pivot->critical_angle_deg, 3));
  }
  if (p->solution->has_tilt_angle) {
    tp_text_add(&p->text, " %9s %9s", tp_page_fos(n[3], pivot->fos_resultant),
                tp_page_fos(n[4], pivot->fos_elements));
  }
  tp_text_add(&p->text, "  %s\n", governs ? "governs" : pivot->admissible ? "yes" : "no");
}

/* The admissible pivots, and of the others as many as fit, those nearest to the toe. */
static void add_pivots(tp_page *p, const tp_case *c) {
  char x[16], y[16];
  snprintf(x, sizeof x, "x (%s)", p->solution->length_unit);
  snprintf(y, sizeof y, "y (%s)", p->solution->length_unit);
  tp_text_add(&p->text, "  %-8s %10s %10s %14s", "Pivot", x, y, "critical angle");
  if (p->solution->has_tilt_angle) tp_text_add(&p->text, " %9s %9s", "FoS", "elements");
  tp_text_add(&p->text, "  admissible\n");
  size_t left_out = 0;
  for (size_t k = 0; k < c->pivot_count; k++) {
    const size_t from_toe = c->towards == TP_TOWARDS_LEFT ? k : c->pivot_count - 1 - k;
    if (c->pivots[k].admissible || from_toe < ROWS_SHOWN) {
      add_pivot_row(p, c, k);
    } else {
      left_out++;
    }
  }
  if (left_out > 0) {
    tp_text_add(&p->text, "  … and %zu more, none of them admissible (--json lists all)\n",
                left_out);
  }
}

/* One that is a number; "none" of one below zero. */
static void add_factor(tp_page *p, const char *name, tp_fos fos) {
  char n[TP_NUMBER_SIZE];
  if (fos.state == TP_FOS_NUMBER) tp_text_add(&p->text, "%s%s", name, tp_page_fos(n, fos));
}

static void add_sliding(tp_page *p, const tp_case *c) {
  const tp_sliding *s = &c->sliding;
  char n[8][TP_NUMBER_SIZE];
  if (!p->solution->has_friction) {
    tp_text_add(&p->text, "  Sliding is not judged: the scene gives no friction_angle_deg.\n");
    return;
  }
  if (!s->known) return;
  if (p->solution->loaded && (s->never || s->always)) {
    tp_text_add(&p->text, "  Sliding under the loads: at %s tilt", s->never ? "no" : "every");
    if (s->always) add_factor(p, ", FoS ", s->fos);
    tp_text_add(&p->text, ".\n");
    return;
  }
  if (s->never) {
    tp_text_add(&p->text,
                "  Sliding by Patton's φ_b + i: never, a facet stands too steep in the way.\n");
    return;
  }
  if (p->solution->loaded) {
    tp_text_add(&p->text, "  Sliding under the loads: %s°",
                tp_text_fixed(n[0], s->critical_angle_deg, 3));
    add_factor(p, ", FoS ", s->fos);
    tp_text_add(&p->text, ",\n  by the forces along and across the facet\n");
    return;
  }
  const bool climbs = s->facet_angle_deg.value >= 0;
  tp_bounded i = s->facet_angle_deg;
  if (!climbs) i.value = -i.value;
  tp_text_add(&p->text, "  Sliding by Patton's φ_b %s i = %s° %s %s° = %s°", climbs ? "+" : "-",
              tp_page_degrees(n[0], s->friction_angle_deg), climbs ? "+" : "-",
              tp_page_degrees(n[1], i), tp_text_fixed(n[2], s->critical_angle_deg, 3));
  add_factor(p, ", FoS ", s->fos);
  if (s->fos_strength.state == TP_FOS_NUMBER) {
    tp_text_add(&p->text, ",\n  %s by strength reduction",
                tp_text_fixed(n[4], s->fos_strength.value, 3));
  }
  tp_page_coordinate(p, n[4], s->facet_x0_m);
  tp_page_coordinate(p, n[5], s->facet_y0_m);
  tp_page_coordinate(p, n[6], s->facet_x1_m);
  tp_page_coordinate(p, n[7], s->facet_y1_m);
  if (strcmp(n[4], n[6]) == 0 && strcmp(n[5], n[7]) == 0) {
    tp_text_add(&p->text, ",\n  against the contact in (%s, %s)", n[4], n[5]);
  } else {
    tp_text_add(&p->text, ",\n  on the facet from (%s, %s) to (%s, %s)", n[4], n[5], n[6], n[7]);
  }
  tp_text_add(&p->text, ".\n");
}

static void add_rolling(tp_page *p, const tp_case *c) {
  if (c->rolls == TP_ROLLS_NOT) return;
  if (c->rests) {
    char n[TP_NUMBER_SIZE];
    tp_text_add(&p->text, "  Its toe is rounded: it rolls on it to rest, turned by %s°.\n",
                tp_text_fixed(n, c->rest_turn_deg, 3));
    return;
  }
  tp_text_add(&p->text, "  Its toe is rounded: beyond its critical angle it %s.\n",
              c->rolls == TP_ROLLS_BACK ? "rolls on it to a new rest" : "goes over");
}

static void add_case(tp_page *p, const tp_case *c) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(&p->text, "\nTilted towards the %s", tp_text_direction(c->towards));
  if (p->solution->has_tilt_angle) {
    tp_text_add(&p->text, " by %s°", tp_page_degrees(n, p->solution->tilt_angle_deg));
  }
  tp_text_add(&p->text, "\n\n");
  add_pivots(p, c);
  if (!c->has_governing) tp_text_add(&p->text, "  No pivot is admissible: turning is blocked.\n");
  if (c->governing_tie) {
    tp_text_add(&p->text, "  Tie: another admissible pivot has exactly the same critical angle.\n");
  }
  tp_page_add_verdict(p, c);
  add_rolling(p, c);
  tp_page_add_loads(p, c);
  tp_page_add_limit(p, c);
  add_sliding(p, c);
}

static double seconds(const tp_solution *s) {
  double sum = 0;
  for (size_t k = 0; k < s->effect_count; k++) sum += s->effects[k].seconds;
  return sum;
}

static void add_effects(tp_page *p) {
  const tp_solution *s = p->solution;
  tp_text_add(&p->text,
              "\nCertain to every digit printed, by %s arithmetic, in %.2g ms. What ran:\n",
              tp_level_name(s->level), 1e3 * seconds(s));
  for (size_t k = 0; k < s->effect_count; k++) {
    tp_text_add(&p->text, "  %-9s %8.3f ms   for ", s->effects[k].name,
                1e3 * s->effects[k].seconds);
    tp_encode_plain(&p->text, s->effects[k].called_for_by);
    tp_text_add(&p->text, "\n");
  }
}

tp_status tp_report_text(char **text, const tp_solution *solution) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  tp_page p = {.solution = solution};
  if (solution->title != NULL) {
    tp_encode_plain(&p.text, solution->title);
    tp_text_add(&p.text, "\n\n");
  }
  add_teeth(&p);
  add_block(&p);
  tp_page_add_contact(&p);
  for (size_t k = 0; k < solution->case_count; k++) add_case(&p, solution->cases + k);
  tp_page_add_digits(&p);
  add_effects(&p);
  return tp_text_finish(&p.text, text);
}
