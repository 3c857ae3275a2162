/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sections shifted to their places and checked; then contacts, and for each the friction of the
 * scene or of the joint between its two blocks. */

#include "block_system/built_system.h"

#include "block/arc_chords.h"
#include "block/check.h"
#include "common/notes.h"
#include "common/outside.h"
#include "evaluation/friction.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

static const double limit_share = 1e-6; /* of itself, to which a limit is proven */

void tp_built_system_clear(tp_built_system *s) {
  tp_assemblage_clear(&s->assemblage);
  for (long k = 0; k < s->count && s->sections != NULL; k++) tp_section_clear(s->sections + k);
  free(s->sections);
  free(s->given);
  free(s->friction);
  free(s->tangents);
  tp_notes_clear(&s->notes);
  memset(s, 0, sizeof *s);
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static tp_status shift(tp_section *section, const tp_listed_block *listed, tp_message *message) {
  if (!listed->at_x.given) return TP_OK;
  for (long r = 0; r < section->ring_count; r++) {
    tp_polyline *ring = section->rings + r;
    if (!tp_polyline_separate(ring)) return tp_fail_memory(message, "the blocks");
    for (long k = 0; k < ring->count; k++) {
      fmpq_add(ring->x + k, ring->x + k, listed->at_x.value);
      fmpq_add(ring->y + k, ring->y + k, listed->at_y.value);
    }
  }
  return TP_OK;
}

/* The block with chords for its arcs. */
static tp_status set_section(tp_section *section, const tp_listed_block *listed,
                             tp_message *message) {
  if (listed->shape.arc_count == 0) return tp_section_init(section, &listed->shape, message);
  tp_arc_chords chords;
  const tp_status status = tp_arc_chords_init(&chords, &listed->shape, message);
  if (status != TP_OK) return status;
  tp_block_description chorded = listed->shape;
  chorded.outline = chords.ring;
  chorded.arcs = NULL;
  chorded.arc_count = 0;
  const tp_status made = tp_section_init(section, &chorded, message);
  tp_arc_chords_clear(&chords);
  return made;
}

static tp_status check(const tp_section *section, const fmpq_t metres_per_unit,
                       tp_message *message) {
  const tp_polyline **chains = calloc((size_t)section->ring_count + 1, sizeof *chains);
  if (chains == NULL) return tp_fail_memory(message, "the blocks");
  for (long r = 0; r < section->ring_count; r++) chains[r] = section->rings + r;
  tp_lattice lattice;
  tp_status status =
      tp_lattice_init(&lattice, chains, section->ring_count, metres_per_unit, message);
  free(chains);
  if (status != TP_OK) return status;
  tp_geom_triangulation triangulation = {0};
  status = tp_check_section(&triangulation, section, &lattice, message);
  tp_geom_triangulation_clear(&triangulation);
  tp_lattice_clear(&lattice);
  return status;
}

static tp_status set_block(tp_built_system *s, const tp_listed_block *listed, tp_message *message) {
  tp_section *section = s->sections + s->count;
  tp_status status = set_section(section, listed, message);
  if (status != TP_OK) return status;
  s->given[s->count++] = (tp_given_block){
      .section = section, .name = listed->name, .place = listed->place, .fixed = listed->fixed};
  status = tp_notes_append(&s->notes, &section->notes, message);
  if (status == TP_OK) status = shift(section, listed, message);
  return status == TP_OK ? check(section, s->scene->metres_per_unit, message) : status;
}

/* ---- friction ----------------------------------------------------------------------------------
 */

/* Joints in the order of their pairs of blocks. */
static int compare_joints(const void *first, const void *second) {
  const tp_joint_description *a = *(const tp_joint_description *const *)first;
  const tp_joint_description *b = *(const tp_joint_description *const *)second;
  for (int greater = 0; greater < 2; greater++) {
    const long p = a->between[(a->between[0] < a->between[1]) == greater];
    const long q = b->between[(b->between[0] < b->between[1]) == greater];
    if (p != q) return p < q ? -1 : 1;
  }
  return 0;
}

/* Where the joint of a contact stands among those that are sorted; -1: it has none of its own. */
static long find_joint(const tp_joint_description **sorted, long count,
                       const tp_block_contact *contact) {
  const tp_joint_description key = {.between = {contact->block[0], contact->block[1]}};
  const tp_joint_description *own = &key;
  const tp_joint_description **found =
      bsearch(&own, sorted, (size_t)count, sizeof *sorted, compare_joints);
  return found != NULL ? found - sorted : -1;
}

static tp_status check_joints(tp_built_system *s, const tp_joint_description **sorted,
                              const bool *used, tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < s->scene->many.joint_count && status == TP_OK; k++) {
    if (k > 0 && compare_joints(sorted + k - 1, sorted + k) == 0) {
      return tp_refuse(message, TP_FAULT_KEY, sorted[k]->place,
                       "the joint between these two blocks is given twice, also in line %d",
                       sorted[k - 1]->place.line);
    }
    if (used[k]) continue;
    status =
        tp_notes_add(&s->notes, message, TP_CAUTION, sorted[k]->place,
                     "blocks '%s' and '%s' do not touch along an edge: this joint acts nowhere",
                     tp_quote_all(s->given[sorted[k]->between[0]].name).text,
                     tp_quote_all(s->given[sorted[k]->between[1]].name).text);
  }
  return status;
}

static tp_near tangent_of(const tp_quantity *angle_deg) {
  enum { BITS = 128 };
  arb_t tangent;
  arb_init(tangent);
  arb_set_fmpq(tangent, angle_deg->value, BITS);
  tp_friction_tangent(tangent, tangent, BITS);
  const tp_near near = tp_ball_near(tangent);
  arb_clear(tangent);
  return near;
}

/* Contacts of a joint follow each other rarely: each takes a search. */
static void set_contacts(tp_built_system *s, const tp_joint_description **sorted, bool *used) {
  const tp_scene *scene = s->scene;
  const tp_near of_scene = tangent_of(&scene->friction_angle_deg);
  for (long k = 0; k < s->assemblage.contact_count; k++) {
    const long joint = find_joint(sorted, scene->many.joint_count, s->assemblage.contacts + k);
    s->friction[k] = joint >= 0 ? &sorted[joint]->friction_angle_deg : &scene->friction_angle_deg;
    s->tangents[k] = joint >= 0 ? tangent_of(s->friction[k]) : of_scene;
    if (joint >= 0) used[joint] = true;
  }
}

static tp_status set_friction(tp_built_system *s, tp_message *message) {
  const tp_block_list *many = &s->scene->many;
  const size_t contacts = (size_t)s->assemblage.contact_count + 1;
  const size_t joints = (size_t)many->joint_count + 1;
  const tp_joint_description **sorted = calloc(joints, sizeof *sorted);
  bool *used = calloc(joints, sizeof *used);
  s->friction = calloc(contacts, sizeof *s->friction);
  s->tangents = calloc(contacts, sizeof *s->tangents);
  tp_status status = TP_OK;
  if (sorted == NULL || used == NULL || s->friction == NULL || s->tangents == NULL) {
    status = tp_fail_memory(message, "the joints");
  } else {
    for (long k = 0; k < many->joint_count; k++) sorted[k] = many->joints + k;
    qsort(sorted, (size_t)many->joint_count, sizeof *sorted, compare_joints);
    set_contacts(s, sorted, used);
    status = check_joints(s, sorted, used, message);
  }
  free(sorted);
  free(used);
  return status;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status build(tp_built_system *s, tp_message *message) {
  const tp_block_list *many = &s->scene->many;
  s->sections = calloc((size_t)many->count, sizeof *s->sections);
  s->given = calloc((size_t)many->count, sizeof *s->given);
  if (s->sections == NULL || s->given == NULL) return tp_fail_memory(message, "the blocks");
  tp_status status = TP_OK;
  for (long k = 0; k < many->count && status == TP_OK; k++) {
    status = set_block(s, many->blocks + k, message);
  }
  if (status == TP_OK) {
    status =
        tp_assemblage_init(&s->assemblage, s->given, s->count, s->scene->metres_per_unit, message);
  }
  return status == TP_OK ? set_friction(s, message) : status;
}

tp_status tp_built_system_init(tp_built_system *s, const tp_scene *scene, tp_message *message) {
  memset(s, 0, sizeof *s);
  s->scene = scene;
  if (!scene->friction_angle_deg.given) {
    return tp_refuse(message, TP_FAULT_KEY, scene->many.place,
                     "the joints between blocks need a friction angle: 'friction_angle_deg: 30' in "
                     "the scene, and 'joints' where it differs");
  }
  const tp_status status = build(s, message);
  if (status != TP_OK) tp_built_system_clear(s);
  return status;
}

tp_status tp_built_system_program(tp_force_program *program, const tp_built_system *s,
                                  bool towards_left, double divisor, tp_message *message) {
  const long count = s->assemblage.contact_count;
  tp_near *tangents = calloc((size_t)count + 1, sizeof *tangents);
  if (tangents == NULL) return tp_fail_memory(message, "the joints");
  for (long k = 0; k < count; k++) {
    tangents[k] = tp_near_is_zero(s->tangents[k])
                      ? s->tangents[k]
                      : tp_near_div(s->tangents[k], (tp_near){divisor, 0});
  }
  const tp_status status =
      tp_force_program_tilted(program, &s->assemblage, tangents, towards_left, message);
  free(tangents);
  return status;
}

tp_status tp_built_system_bracket(tp_load_bracket *bracket, const tp_built_system *s,
                                  bool towards_left, double divisor, tp_message *message) {
  tp_force_program program;
  tp_status status = tp_built_system_program(&program, s, towards_left, divisor, message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(bracket, &program, limit_share, message);
  tp_force_program_clear(&program);
  return status;
}
