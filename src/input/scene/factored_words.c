/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which partial factors act in a combination, and what it takes as favourable, in words. */

#include "scene/factored.h"

#include "number/ratio.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 900 };

static const char *name_of(const tp_scene *scene, tp_action_group group) {
  static const char *const names[] = {"weight", "water", "pressures", "surcharges"};
  if (group != TP_ACTION_PRESSURES || scene->loads.force_count == 0) return names[group];
  return scene->loads.pressure_count > 0 ? "pressures and forces" : "forces";
}

/* One more of a list, behind its head. */
static void add(char *text, size_t head, const char *format, ...) {
  const size_t used = strlen(text);
  va_list arguments;
  va_start(arguments, format);
  if (used > head) snprintf(text + used, SIZE - used, ", ");
  vsnprintf(text + strlen(text), SIZE - strlen(text), format, arguments);
  va_end(arguments);
}

static void add_factor(char *text, size_t head, const char *what, const char *how,
                       const fmpq_t value) {
  char number[64];
  tp_ratio_text(number, sizeof number, value);
  add(text, head, "%s %s %s", what, how, number);
}

static void add_actions(char *text, size_t head, const tp_scene *scene, unsigned combination) {
  const tp_partial_factors *own = scene->partial_factors;
  const tp_loads_description *loads = &scene->loads;
  bool active = false, passive = false;
  fmpq_t factor;
  fmpq_init(factor);
  for (int k = 0; k < TP_ACTION_GROUPS; k++) {
    const tp_action_group group = (tp_action_group)k;
    if (!tp_action_acts(scene, group)) continue;
    tp_action_factor(factor, scene, group, combination);
    add_factor(text, head, name_of(scene, group), "×", factor);
  }
  if (loads->seismic_place.file != NULL) {
    tp_action_factor_of(factor, own, TP_PARTIAL_EARTHQUAKE);
    add_factor(text, head, "earthquake", "×", factor);
  }
  for (long k = 0; k < loads->anchor_count; k++) {
    active = active || !loads->anchors[k].passive;
    passive = passive || loads->anchors[k].passive;
  }
  tp_action_factor_of(factor, own, TP_PARTIAL_PERMANENT_FAVOURABLE);
  if (active) add_factor(text, head, "active anchors", "×", factor);
  if (passive) add_factor(text, head, "passive anchors", "/", own->values + TP_PARTIAL_ANCHOR);
  fmpq_clear(factor);
}

static bool has_cohesion(const tp_scene *scene) {
  const tp_block_list *many = &scene->many;
  bool has = scene->loads.cohesion_kpa.given || scene->loads.bond_kpa.given ||
             many->slope.base.cohesion_kpa.given || many->slope.base.tension_kpa.given;
  for (long k = 0; k < many->joint_count && !has; k++) {
    has = many->joints[k].cohesion_kpa.given || many->joints[k].tension_kpa.given;
  }
  for (long k = 0; k < many->slope.set_count && !has; k++) {
    has = many->slope.sets[k].cohesion_kpa.given || many->slope.sets[k].tension_kpa.given;
  }
  return has;
}

static void add_worst(char *text, const tp_scene *scene, unsigned combination, unsigned solved) {
  add(text, SIZE, "; the worst of %u combinations: ", solved);
  const size_t head = strlen(text);
  for (int k = 0; k < TP_ACTION_GROUPS; k++) {
    if (!tp_action_has_two(scene, (tp_action_group)k)) continue;
    add(text, head, "%s %s", name_of(scene, (tp_action_group)k),
        combination >> k & 1 ? "favourable" : "unfavourable");
  }
}

char *tp_factored_text(const tp_scene *scene, unsigned combination, unsigned solved) {
  const tp_partial_factors *own = scene->partial_factors;
  char *text = calloc(1, SIZE);
  if (text == NULL) return NULL;
  add(text, 0, "%s: ", own->name != NULL ? own->name : "own");
  const size_t head = strlen(text);
  add_actions(text, head, scene, combination);
  if (scene->friction_angle_deg.given || scene->many.count > 0) {
    add_factor(text, head, "tan φ", "/", own->values + TP_PARTIAL_FRICTION);
  }
  if (has_cohesion(scene)) {
    add_factor(text, head, "cohesion and bond", "/", own->values + TP_PARTIAL_COHESION);
  }
  if (solved > 1) add_worst(text, scene, combination, solved);
  return text;
}

tp_status tp_factored_note(tp_notes *notes, const tp_scene *scene, const char *text,
                           tp_message *message) {
  if (text == NULL) return tp_fail_memory(message, "the partial factors");
  return tp_notes_add(notes, message, TP_NOTE, scene->partial_factors->place,
                      "with partial factors %s; numbers are of the factored scene", text);
}
