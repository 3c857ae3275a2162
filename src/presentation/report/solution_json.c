/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as JSON, key by key as docs/schema describes it for other programs. */

#include "report/solution_json.h"

#include "common/host.h"
#include "report/contact.h"
#include "report/earthquakes.h"
#include "report/friction.h"
#include "report/governing.h"
#include "report/joint.h"
#include "report/limit.h"
#include "report/loads.h"
#include "report/notes.h"
#include "report/onset.h"
#include "report/parts_json.h"
#include "report/pivots.h"
#include "report/poses.h"
#include "report/settings.h"
#include "report/words.h"

typedef struct named {
  const char *key;
  tp_bounded number;
} named;

static void add_numbers(tp_json *j, const named *numbers, size_t count) {
  for (size_t k = 0; k < count; k++) tp_json_bounded(j, numbers[k].key, numbers[k].number);
}

static void add_block(tp_json *j, const tp_block_result *b) {
  const named numbers[] = {{"area_m2", b->area_m2},
                           {"centroid_x_m", b->centroid_x_m},
                           {"centroid_y_m", b->centroid_y_m},
                           {"second_moment_xx_m4", b->second_moment_xx_m4},
                           {"second_moment_yy_m4", b->second_moment_yy_m4},
                           {"second_moment_xy_m4", b->second_moment_xy_m4},
                           {"thickness_m", b->thickness_m}};
  tp_json_object(j, "block", TP_JSON_BLOCK);
  add_numbers(j, numbers, sizeof numbers / sizeof numbers[0]);
  tp_json_known(j, "weight_n", b->has_weight, b->weight_n);
  tp_json_count(j, "vertices", b->vertices);
  tp_json_beside(j);
  tp_json_count(j, "holes", b->holes);
  tp_json_beside(j);
  tp_json_count(j, "parts", b->parts);
  tp_json_beside(j);
  tp_json_count(j, "triangles", b->triangles);
  tp_json_close(j);
}

static void add_teeth(tp_json *j, const tp_teeth_result *teeth) {
  if (!teeth->known) return;
  const named lengths[] = {{"width_m", teeth->width_m},
                           {"height_m", teeth->height_m},
                           {"depth_m", teeth->depth_m},
                           {"block_width_m", teeth->block_width_m},
                           {"mean_height_m", teeth->mean_height_m},
                           {"amplitude_m", teeth->amplitude_m},
                           {"wavelength_m", teeth->wavelength_m}};
  tp_json_object(j, "teeth", TP_JSON_BLOCK);
  tp_json_count(j, "count", teeth->count);
  add_numbers(j, lengths, sizeof lengths / sizeof lengths[0]);
  tp_json_string(j, "left_end", tp_text_pivot_kind(teeth->left_end));
  tp_json_beside(j);
  tp_json_string(j, "right_end", tp_text_pivot_kind(teeth->right_end));
  tp_json_close(j);
}

static void add_toppling(tp_json *j, const tp_case *c) {
  if (!c->has_governing) {
    tp_json_null(j, "toppling");
    return;
  }
  const tp_pivot *p = c->pivots + c->governing;
  tp_json_object(j, "toppling", TP_JSON_LINE);
  tp_json_count(j, "pivot", c->governing);
  tp_json_truth(j, "tie", c->governing_tie);
  tp_json_tie(j, c->governing_tie, c->governing_tie_bits);
  tp_json_critical_angle(j, p);
  tp_json_fos(j, "fos", p->fos_resultant);
  tp_json_fos(j, "fos_elements", p->fos_elements);
  if (c->rolls != TP_ROLLS_NOT) {
    tp_json_string(j, "beyond", c->rolls == TP_ROLLS_BACK ? "rolls back" : "topples");
    if (c->rests) tp_json_bounded(j, "rest_turn_deg", c->rest_turn_deg);
  }
  tp_json_close(j);
}

/* At which tilt it slides, and how far it is from that. */
static void add_sliding_answer(tp_json *j, const tp_sliding *s) {
  tp_json_known(j, "critical_angle_deg", !s->always, s->critical_angle_deg);
  if (s->always) tp_json_string(j, "critical_angle_is", "always");
  tp_json_fos(j, "fos", s->fos);
  tp_json_fos(j, "fos_strength", s->fos_strength);
  tp_json_break(j);
  tp_json_bounded(j, "friction_angle_deg", s->friction_angle_deg);
  tp_json_bounded(j, "facet_angle_deg", s->facet_angle_deg);
  tp_json_array(j, "facet", TP_JSON_LINE);
  tp_json_point(j, NULL, s->facet_x0_m, s->facet_y0_m);
  tp_json_point(j, NULL, s->facet_x1_m, s->facet_y1_m);
  tp_json_close(j);
}

static void add_sliding(tp_json *j, const tp_sliding *s, bool loaded, bool patton) {
  if (!s->known) return;
  tp_json_object(j, "sliding", TP_JSON_LINE);
  tp_json_string(j, "method",
                 loaded   ? "forces along and across the facet"
                 : patton ? "Patton, phi_b + i"
                          : "phi + i");
  if (s->never) {
    tp_json_null(j, "critical_angle_deg");
    tp_json_string(j, "critical_angle_is", "never");
    tp_json_no_fos(j, "fos", "unbounded: it never slides");
  } else {
    add_sliding_answer(j, s);
  }
  tp_json_close(j);
}

static void add_toe(tp_json *j, const tp_toe *toe) {
  if (!toe->known) return;
  tp_json_object(j, "toe", TP_JSON_LINE);
  tp_json_truth(j, "holds", toe->holds);
  tp_json_known(j, "limit_angle_deg", !toe->upright, toe->limit_angle_deg);
  tp_json_close(j);
}

static void add_element(tp_json *j, const tp_element *e) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "kind", e->kind == TP_ELEMENT_SLAB ? "slab" : "triangle");
  tp_json_count(j, "part", e->part);
  tp_json_bounded(j, "weight", e->weight);
  tp_json_bounded(j, "normal_arm_m", e->normal_arm_m);
  tp_json_bounded(j, "parallel_arm_m", e->parallel_arm_m);
  tp_json_bounded(j, "stabilising", e->stabilising);
  tp_json_bounded(j, "overturning", e->overturning);
  tp_json_bounded(j, "area_m2", e->area_m2);
  tp_json_bounded(j, "centroid_x_m", e->centroid_x_m);
  tp_json_bounded(j, "centroid_y_m", e->centroid_y_m);
  tp_json_close(j);
}

static void add_account(tp_json *j, const tp_account *a, bool has_weight) {
  if (a->count == 0) return;
  tp_json_object(j, "elements", TP_JSON_LINE);
  tp_json_string(j, "weight_unit", has_weight ? "N" : "weight of the block");
  tp_json_bounded(j, "angle_deg", a->angle_deg);
  tp_json_break(j);
  tp_json_bounded(j, "stabilising", a->stabilising);
  tp_json_bounded(j, "overturning", a->overturning);
  tp_json_break(j);
  tp_json_array(j, "account", TP_JSON_BLOCK);
  for (size_t k = 0; k < a->count; k++) add_element(j, a->elements + k);
  tp_json_close(j);
  tp_json_close(j);
}

static void add_mechanism(tp_json *j, const tp_case *c) {
  tp_json_string(j, "mechanism", tp_mechanism_name(c->mechanism));
  tp_json_beginnings(j, c);
  tp_json_object(j, "first", TP_JSON_LINE);
  tp_json_string(j, "mechanism", tp_mechanism_name(c->first));
  tp_json_known(j, "critical_angle_deg", c->has_first_angle, c->first_angle_deg);
  tp_json_known(j, "margin_deg", c->has_margin, c->margin_deg);
  tp_json_known(j, "margin_to_first_deg", c->has_margin_to_first, c->margin_to_first_deg);
  tp_json_close(j);
  tp_json_truth(j, "falls_backwards", c->falls_backwards);
}

static void add_effects(tp_json *j, const tp_solution *s) {
  tp_json_array(j, "effects", TP_JSON_BLOCK);
  for (size_t k = 0; k < s->effect_count; k++) {
    const tp_effect *e = s->effects + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_string(j, "name", e->name);
    tp_json_string(j, "called_for_by", e->called_for_by);
    tp_json_fixed(j, "seconds", e->seconds, 9);
    tp_json_string(j, "level", tp_level_name(e->level));
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_case(tp_json *j, const tp_solution *s, const tp_case *c, tp_pivots_listed shown) {
  if (shown == TP_PIVOTS_BY_COUNT) {
    shown = c->pivot_count > TP_PIVOTS_MANY ? TP_PIVOTS_GOVERNING : TP_PIVOTS_ALL;
  }
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "towards", tp_text_direction(c->towards));
  if (s->has_tilt_angle) tp_json_bounded(j, "tilt_angle_deg", s->tilt_angle_deg);
  if (s->has_friction) {
    tp_json_bounded(j,
                    s->friction_is_residual ? "residual_friction_angle_deg" : "friction_angle_deg",
                    s->friction_angle_deg);
  }
  tp_json_friction(j, s);
  add_block(j, &s->block);
  add_teeth(j, &s->teeth);
  tp_json_rest(j, &s->rest);
  tp_json_poses(j, &s->poses, (size_t)(c - s->cases));
  tp_json_joint(j, &s->joint);
  tp_json_within(j, &s->within);
  tp_json_frame(j, &s->frame);
  tp_json_contact(j, &s->contact, s->block.has_weight);
  tp_json_pivots(j, s, c, shown == TP_PIVOTS_ALL);
  add_toppling(j, c);
  add_sliding(j, &c->sliding, s->loaded, s->friction_is_patton);
  add_toe(j, &c->toe);
  tp_json_limit(j, c);
  tp_json_governing(j, c);
  tp_json_onset(j, c);
  add_account(j, &c->account, s->block.has_weight);
  tp_json_loads(j, c);
  add_mechanism(j, c);
  add_effects(j, s);
  tp_json_close(j);
}

void tp_json_solution(tp_json *j, const tp_solution *s, tp_pivots_listed listed) {
  if (s->title != NULL) tp_json_string(j, "title", s->title);
  tp_json_settings(j, &s->settings);
  tp_json_string(j, "level", tp_level_name(s->level));
  tp_json_beside(j);
  tp_json_integer(j, "bits", s->bits);
  if (s->zero_bits != 0) {
    tp_json_beside(j);
    tp_json_integer(j, "zero_bits", s->zero_bits);
  }
  tp_json_notes(j, &s->notes);
  tp_json_earthquakes(j, s);
  tp_json_array(j, "cases", TP_JSON_BLOCK);
  for (size_t k = 0; k < s->case_count; k++) add_case(j, s, s->cases + k, listed);
  tp_json_close(j);
}

tp_status tp_report_json(char **text, const tp_solution *solution) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  return tp_report_json_pivots(text, solution, TP_PIVOTS_BY_COUNT);
}

tp_status tp_report_json_pivots(char **text, const tp_solution *solution, tp_pivots_listed listed) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_solution(&j, solution, listed);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
