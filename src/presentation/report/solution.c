/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as a page for a terminal, 80 columns wide. Every printed digit is certain. */

#include "common/host.h"
#include "output/encode.h"
#include "report/contact.h"
#include "report/digits.h"
#include "report/friction.h"
#include "report/governing.h"
#include "report/limit.h"
#include "report/loads.h"
#include "report/notes.h"
#include "report/onset.h"
#include "report/pivots.h"
#include "report/poses.h"
#include "report/sliding.h"
#include "report/verdict.h"
#include "report/words.h"
#include "stability/severity.h"
#include "terms/names.h"

static void add_teeth(tp_page *p) {
  const tp_teeth_result *teeth = &p->solution->teeth;
  const char *unit = p->solution->length_unit;
  char n[7][TP_NUMBER_SIZE];
  if (!teeth->known) return;
  tp_text_add(&p->text, "Teeth    N = %zu, a = %s, b = %s, c = %s %s; left end %s, right end %s\n",
              teeth->count, tp_page_length(p, n[0], teeth->width_m, 6),
              tp_page_length(p, n[1], teeth->height_m, 6),
              tp_page_length(p, n[2], teeth->depth_m, 6), unit, tp_pivot_kind_name(teeth->left_end),
              tp_pivot_kind_name(teeth->right_end));
  tp_text_add(&p->text,
              "         width Δx = %s, mean height y = %s, amplitude A = %s,\n"
              "         wavelength λ = %s %s\n",
              tp_page_length(p, n[3], teeth->block_width_m, 6),
              tp_page_length(p, n[4], teeth->mean_height_m, 6),
              tp_page_length(p, n[5], teeth->amplitude_m, 6),
              tp_page_length(p, n[6], teeth->wavelength_m, 6), unit);
}

/* What the scene asks for: coordinates carry no unit of their own. */
static void add_units(tp_page *p) {
  const tp_result_units *own = &p->solution->result_units;
  const struct {
    const char *of;
    tp_result_unit unit;
  } all[] = {{"lengths and coordinates", own->length},
             {"forces", own->force},
             {"moments", own->moment},
             {"stresses", own->stress}};
  const char *before = "Units    ";
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
    if (all[k].unit.name == NULL) continue;
    tp_text_add(&p->text, "%s%s in %s", before, all[k].of, all[k].unit.name);
    before = k == 2 ? ",\n         " : ", ";
  }
  if (before[0] == ',') tp_text_add(&p->text, "\n");
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
    tp_page_add_force(p, b->weight_n);
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
  tp_text_add(&p->text, "\n%s", tp_text_stance(p->solution, c));
  if (p->solution->has_tilt_angle && !p->solution->frame.level) {
    tp_text_add(&p->text, p->solution->frame.world ? ", at %s°" : " by %s°",
                tp_page_degrees(n, p->solution->tilt_angle_deg));
  }
  tp_text_add(&p->text, "\n\n");
  tp_page_add_governing(p, c);
  tp_page_add_verdict(p, c);
  tp_page_add_motions(p, c);
  tp_text_add(&p->text, "\n");
  tp_page_add_pivots(p, c);
  tp_text_add(&p->text, "\n");
  add_rolling(p, c);
  tp_page_add_loads(p, c);
  tp_page_add_limit(p, c);
  tp_page_add_sliding(p, c);
}

void tp_page_add_input(tp_page *p) {
  add_units(p);
  add_teeth(p);
  add_block(p);
  tp_page_add_contact(p);
  tp_page_add_friction(p);
}

static double seconds(const tp_solution *s) {
  double sum = 0;
  for (size_t k = 0; k < s->effect_count; k++) sum += s->effects[k].seconds;
  return sum;
}

/* What the decisions rest on, and what is left of what ran: a line each. */
static void add_certainty(tp_page *p) {
  const tp_solution *s = p->solution;
  const double ms = 1e3 * seconds(s);
  tp_text_add(&p->text, "\n");
  if (s->zero_bits != 0) {
    tp_text_add(&p->text,
                "A decision above takes as zero what %ld bits cannot distinguish from zero.\n",
                s->zero_bits);
  }
  tp_text_add(&p->text, "Certain to every digit printed; %s, %.*f ms (--verbose: details).\n",
              tp_level_name(s->level), ms < 10 ? 2 : 0, ms);
}

tp_status tp_report_effects(char **text, const tp_solution *s) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, s);
  tp_text t = {0};
  tp_text_add(&t, "\nEffects computed\n");
  for (size_t k = 0; k < s->effect_count; k++) {
    tp_text_add(&t, "  %-9s %8.3f ms   for ", s->effects[k].name, 1e3 * s->effects[k].seconds);
    tp_encode_plain(&t, s->effects[k].called_for_by);
    tp_text_add(&t, "\n");
  }
  return tp_text_finish(&t, text);
}

/* Of two directions the one that is less safe, before the page of either. */
static void add_worst(tp_page *p) {
  const tp_solution *s = p->solution;
  const tp_case *worst = s->cases + tp_severity_worst(s);
  bool differ = false;
  for (size_t k = 0; k < s->case_count; k++) {
    differ =
        differ || tp_severity_compare(tp_severity_of(worst), tp_severity_of(s->cases + k)) != 0;
  }
  if (!differ || worst->governing_fos.fos.state == TP_FOS_NO_TILT) return;
  enum { MOST = 51 }; /* characters that fit behind the direction on a line of 80 */
  tp_text factor = {0};
  tp_text_factor(&factor, &worst->governing_fos);
  tp_text_add(&p->text, "Governs  towards the %s:%s", tp_direction_name(worst->towards),
              factor.length > MOST ? "\n         " : " ");
  tp_text_drop(&factor);
  tp_text_governing(&p->text, worst, "\n         ");
  tp_text_add(&p->text, "\n");
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
  tp_page_add_input(&p);
  tp_text_settings(&p.text, &solution->settings);
  tp_page_add_poses(&p);
  tp_text_notes(&p.text, &solution->notes);
  add_worst(&p);
  for (size_t k = 0; k < solution->case_count; k++) add_case(&p, solution->cases + k);
  tp_page_add_digits(&p);
  add_certainty(&p);
  return tp_text_finish(&p.text, text);
}
