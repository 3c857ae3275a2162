/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as JSON: the contract of the program with other programs. */

#include "host.h"
#include "output/json.h"
#include "report/contact.h"
#include "report/governing.h"
#include "report/limit.h"
#include "report/loads.h"
#include "report/notes.h"
#include "report/onset.h"
#include "report/parts_json.h"
#include "report/pivots.h"
#include "report/words.h"

#include <math.h>
#include <string.h>

typedef struct named {
  const char *key;
  tp_bounded number;
} named;

/* Numbers, each followed by a comma and the separator. */
static void add_numbers(tp_text *t, const named *numbers, size_t count, const char *separator) {
  for (size_t k = 0; k < count; k++) {
    tp_json_number(t, numbers[k].key, numbers[k].number);
    tp_text_add(t, ",%s", separator);
  }
}

static void add_block(tp_text *t, const tp_block_result *b) {
  const named numbers[] = {{"area_m2", b->area_m2},
                           {"centroid_x_m", b->centroid_x_m},
                           {"centroid_y_m", b->centroid_y_m},
                           {"second_moment_xx_m4", b->second_moment_xx_m4},
                           {"second_moment_yy_m4", b->second_moment_yy_m4},
                           {"second_moment_xy_m4", b->second_moment_xy_m4},
                           {"thickness_m", b->thickness_m},
                           {"weight_n", b->weight_n}};
  const size_t all = sizeof numbers / sizeof numbers[0];
  tp_text_add(t, "      \"block\": {\n        ");
  add_numbers(t, numbers, b->has_weight ? all : all - 1, "\n        ");
  if (!b->has_weight) tp_text_add(t, "\"weight_n\": null,\n        ");
  tp_text_add(t,
              "\"vertices\": %zu, \"holes\": %zu, \"parts\": %zu, \"triangles\": %zu\n      },\n",
              b->vertices, b->holes, b->parts, b->triangles);
}

static void add_teeth(tp_text *t, const tp_teeth_result *teeth) {
  if (!teeth->known) return;
  const named lengths[] = {{"width_m", teeth->width_m},
                           {"height_m", teeth->height_m},
                           {"depth_m", teeth->depth_m},
                           {"block_width_m", teeth->block_width_m},
                           {"mean_height_m", teeth->mean_height_m},
                           {"amplitude_m", teeth->amplitude_m},
                           {"wavelength_m", teeth->wavelength_m}};
  tp_text_add(t, "      \"teeth\": {\n        \"count\": %zu,\n        ", teeth->count);
  add_numbers(t, lengths, sizeof lengths / sizeof lengths[0], "\n        ");
  tp_text_add(t, "\"left_end\": \"%s\", \"right_end\": \"%s\"\n      },\n",
              tp_text_pivot_kind(teeth->left_end), tp_text_pivot_kind(teeth->right_end));
}

static void add_toppling(tp_text *t, const tp_case *c) {
  if (!c->has_governing) {
    tp_text_add(t, "      \"toppling\": null,\n");
    return;
  }
  const tp_pivot *p = c->pivots + c->governing;
  tp_text_add(t, "      \"toppling\": {\"pivot\": %zu, \"tie\": %s", c->governing,
              tp_json_truth(c->governing_tie));
  tp_json_tie(t, c->governing_tie, c->governing_tie_bits);
  tp_text_add(t, ", ");
  tp_json_critical_angle(t, p);
  tp_text_add(t, ", ");
  tp_json_fos(t, "fos", p->fos_resultant);
  tp_text_add(t, ", ");
  tp_json_fos(t, "fos_elements", p->fos_elements);
  if (c->rolls != TP_ROLLS_NOT) {
    tp_text_add(t, ", \"beyond\": \"%s\"", c->rolls == TP_ROLLS_BACK ? "rolls back" : "topples");
    if (c->rests) {
      tp_text_add(t, ", ");
      tp_json_number(t, "rest_turn_deg", c->rest_turn_deg);
    }
  }
  tp_text_add(t, "},\n");
}

static void add_sliding(tp_text *t, const tp_sliding *s, bool loaded, bool patton) {
  if (!s->known) return;
  tp_text_add(t, "      \"sliding\": {\"method\": \"%s\", ",
              loaded   ? "forces along and across the facet"
              : patton ? "Patton, phi_b + i"
                       : "phi + i");
  if (s->never) {
    tp_text_add(t, "\"critical_angle_deg\": null, \"critical_angle_is\": \"never\", "
                   "\"fos\": null, \"fos_is\": \"unbounded: it never slides\"},\n");
    return;
  }
  if (s->always) {
    tp_text_add(t, "\"critical_angle_deg\": null, \"critical_angle_is\": \"always\"");
  } else {
    tp_json_number(t, "critical_angle_deg", s->critical_angle_deg);
  }
  tp_text_add(t, ", ");
  tp_json_fos(t, "fos", s->fos);
  tp_text_add(t, ", ");
  tp_json_fos(t, "fos_strength", s->fos_strength);
  tp_text_add(t, ",\n        ");
  tp_json_number(t, "friction_angle_deg", s->friction_angle_deg);
  tp_text_add(t, ", ");
  tp_json_number(t, "facet_angle_deg", s->facet_angle_deg);
  tp_text_add(t, ", \"facet\": [{");
  tp_json_number(t, "x_m", s->facet_x0_m);
  tp_text_add(t, ", ");
  tp_json_number(t, "y_m", s->facet_y0_m);
  tp_text_add(t, "}, {");
  tp_json_number(t, "x_m", s->facet_x1_m);
  tp_text_add(t, ", ");
  tp_json_number(t, "y_m", s->facet_y1_m);
  tp_text_add(t, "}]},\n");
}

static void add_toe(tp_text *t, const tp_toe *toe) {
  if (!toe->known) return;
  tp_text_add(t, "      \"toe\": {\"holds\": %s, ", tp_json_truth(toe->holds));
  if (toe->upright) {
    tp_text_add(t, "\"limit_angle_deg\": null},\n");
  } else {
    tp_json_number(t, "limit_angle_deg", toe->limit_angle_deg);
    tp_text_add(t, "},\n");
  }
}

static void add_account(tp_text *t, const tp_account *a, bool has_weight) {
  if (a->count == 0) return;
  tp_text_add(t, "      \"elements\": {\"weight_unit\": \"%s\", ",
              has_weight ? "N" : "weight of the block");
  tp_json_number(t, "angle_deg", a->angle_deg);
  tp_text_add(t, ",\n        ");
  tp_json_number(t, "stabilising", a->stabilising);
  tp_text_add(t, ", ");
  tp_json_number(t, "overturning", a->overturning);
  tp_text_add(t, ",\n        \"account\": [\n");
  for (size_t k = 0; k < a->count; k++) {
    const tp_element *e = a->elements + k;
    tp_text_add(t, "          {\"kind\": \"%s\", \"part\": %zu, ",
                e->kind == TP_ELEMENT_SLAB ? "slab" : "triangle", e->part);
    const named numbers[] = {{"weight", e->weight},
                             {"normal_arm_m", e->normal_arm_m},
                             {"parallel_arm_m", e->parallel_arm_m},
                             {"stabilising", e->stabilising}};
    add_numbers(t, numbers, sizeof numbers / sizeof numbers[0], " ");
    tp_json_number(t, "overturning", e->overturning);
    tp_text_add(t, "}%s\n", k + 1 < a->count ? "," : "");
  }
  tp_text_add(t, "        ]},\n");
}

static void add_known(tp_text *t, const char *key, bool known, tp_bounded number) {
  if (known) {
    tp_json_number(t, key, number);
  } else {
    tp_text_add(t, "\"%s\": null", key);
  }
}

static void add_mechanism(tp_text *t, const tp_case *c) {
  tp_text_add(t, "      \"mechanism\": \"%s\",\n", tp_text_mechanism(c->mechanism));
  tp_json_beginnings(t, c);
  tp_text_add(t, "      \"first\": {\"mechanism\": \"%s\", ", tp_text_mechanism(c->first));
  add_known(t, "critical_angle_deg", c->has_first_angle, c->first_angle_deg);
  tp_text_add(t, ", ");
  add_known(t, "margin_deg", c->has_margin, c->margin_deg);
  tp_text_add(t, ", ");
  add_known(t, "margin_to_first_deg", c->has_margin_to_first, c->margin_to_first_deg);
  tp_text_add(t, "},\n      \"falls_backwards\": %s,\n", tp_json_truth(c->falls_backwards));
}

static void add_effects(tp_text *t, const tp_solution *s) {
  tp_text_add(t, "      \"effects\": [");
  for (size_t k = 0; k < s->effect_count; k++) {
    const tp_effect *e = s->effects + k;
    tp_text_add(t, "%s\n        {\"name\": \"%s\", \"called_for_by\": ", k > 0 ? "," : "", e->name);
    tp_encode_json(t, e->called_for_by);
    tp_text_add(t, ", \"seconds\": %.9f, \"level\": \"%s\"}", e->seconds, tp_level_name(e->level));
  }
  tp_text_add(t, "\n      ]\n");
}

static void add_case(tp_text *t, const tp_solution *s, const tp_case *c, tp_pivots_listed shown) {
  enum { MOST_PIVOTS = 300 };
  if (shown == TP_PIVOTS_BY_COUNT) {
    shown = c->pivot_count > MOST_PIVOTS ? TP_PIVOTS_GOVERNING : TP_PIVOTS_ALL;
  }
  tp_text_add(t, "    {\n      \"towards\": \"%s\",\n", tp_text_direction(c->towards));
  if (s->has_tilt_angle) {
    tp_text_add(t, "      ");
    tp_json_number(t, "tilt_angle_deg", s->tilt_angle_deg);
    tp_text_add(t, ",\n");
  }
  if (s->has_friction) {
    tp_text_add(t, "      ");
    tp_json_number(t,
                   s->friction_is_residual ? "residual_friction_angle_deg" : "friction_angle_deg",
                   s->friction_angle_deg);
    tp_text_add(t, ",\n");
  }
  add_block(t, &s->block);
  add_teeth(t, &s->teeth);
  tp_json_frame(t, &s->frame);
  tp_json_contact(t, &s->contact, s->block.has_weight);
  tp_json_pivots(t, s, c, shown == TP_PIVOTS_ALL);
  add_toppling(t, c);
  add_sliding(t, &c->sliding, s->loaded, s->friction_is_patton);
  add_toe(t, &c->toe);
  tp_json_limit(t, c);
  tp_json_governing(t, c);
  tp_json_onset(t, c);
  add_account(t, &c->account, s->block.has_weight);
  tp_json_loads(t, c);
  add_mechanism(t, c);
  add_effects(t, s);
  tp_text_add(t, "    }");
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
  tp_text t = {0};
  tp_text_add(&t, "{\n  \"topple\": \"%s\",\n", TP_VERSION);
  if (solution->title != NULL) {
    tp_text_add(&t, "  \"title\": ");
    tp_encode_json(&t, solution->title);
    tp_text_add(&t, ",\n");
  }
  tp_text_add(&t, "  \"level\": \"%s\", \"bits\": %ld,\n", tp_level_name(solution->level),
              solution->bits);
  tp_json_notes(&t, &solution->notes);
  tp_text_add(&t, "  \"cases\": [\n");
  for (size_t k = 0; k < solution->case_count; k++) {
    add_case(&t, solution, solution->cases + k, listed);
    tp_text_add(&t, "%s\n", k + 1 < solution->case_count ? "," : "");
  }
  tp_text_add(&t, "  ]\n}\n");
  return tp_text_finish(&t, text);
}
