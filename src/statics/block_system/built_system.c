/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks, their contacts, and for each the friction of the scene, of the set that made it or of the
 * joint between its two blocks. */

#include "block_system/built_system.h"

#include "common/notes.h"
#include "common/outside.h"
#include "evaluation/friction.h"
#include "number/ball.h"
#include "scene/check.h"
#include "scene_varying/load_case.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 128 };

void tp_built_system_clear(tp_built_system *s) {
  tp_assemblage_clear(&s->assemblage);
  for (long k = 0; k < s->count && s->sections != NULL; k++) tp_section_clear(s->sections + k);
  free(s->sections);
  free(s->given);
  free(s->joints);
  free(s->strengths);
  free(s->pair_tangents);
  for (int left = 0; left < 2; left++) tp_block_loads_clear(s->loads + left);
  tp_notes_clear(&s->notes);
  memset(s, 0, sizeof *s);
}

/* ---- strength ----------------------------------------------------------------------------------
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

/* Where the joint of a contact stands among those that are sorted, that of its two blocks before
 * those of a block and a layer of the drawing, and these before that of two layers; -1: it has none
 * of its own. */
static long find_joint(const tp_built_system *s, const tp_joint_description **sorted,
                       const tp_block_contact *contact) {
  const tp_block_list *many = &s->scene->many;
  const long one = contact->block[0], other = contact->block[1];
  const long one_layer = -many->blocks[one].layer, other_layer = -many->blocks[other].layer;
  const tp_joint_description keys[] = {{.between = {one, other}},
                                       {.between = {one, other_layer}},
                                       {.between = {one_layer, other}},
                                       {.between = {one_layer, other_layer}}};
  const int count = one_layer < 0 ? 4 : 1; /* of a drawing all blocks have layers, else none */
  for (int k = 0; k < count; k++) {
    const tp_joint_description *own = keys + k;
    const tp_joint_description **found =
        bsearch(&own, sorted, (size_t)many->joint_count, sizeof *sorted, compare_joints);
    if (found != NULL) return found - sorted;
  }
  return -1;
}

static tp_status check_joints(tp_built_system *s, const tp_joint_description **sorted,
                              const bool *used, tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < s->scene->many.joint_count && status == TP_OK; k++) {
    if (k > 0 && compare_joints(sorted + k - 1, sorted + k) == 0) {
      return tp_refuse(message, TP_FAULT_KEY, sorted[k]->place,
                       "the joint between these two is given twice, also in line %d",
                       sorted[k - 1]->place.line);
    }
    if (used[k]) continue;
    if (sorted[k]->between[0] < 0 || sorted[k]->between[1] < 0) {
      status = tp_notes_add(&s->notes, message, TP_CAUTION, sorted[k]->place,
                            "of these two no blocks touch along an edge, or all that do have "
                            "joints of their own: this joint acts nowhere");
      continue;
    }
    status =
        tp_notes_add(&s->notes, message, TP_CAUTION, sorted[k]->place,
                     "blocks '%s' and '%s' do not touch along an edge: this joint acts nowhere",
                     tp_quote_all(s->given[sorted[k]->between[0]].name).text,
                     tp_quote_all(s->given[sorted[k]->between[1]].name).text);
  }
  return status;
}

/* The set that made the edges of a contact; NULL: none did. */
static const tp_joint_set *set_of(const tp_built_system *s, const tp_block_contact *own) {
  return tp_block_list_set(&s->scene->many, own->block[0],
                           own->from - s->assemblage.blocks[own->block[0]].outline);
}

/* Of a contact that may have a joint of its own. */
static const tp_quantity *property_of(const tp_built_system *s, const tp_block_contact *contact,
                                      const tp_joint_description *joint,
                                      tp_joint_property property) {
  const tp_scene *scene = s->scene;
  const tp_joint_set *set = set_of(s, contact);
  const tp_quantity *const of_scene[] = {[TP_JOINT_FRICTION] = &scene->friction_angle_deg,
                                         [TP_JOINT_COHESION] = &scene->loads.cohesion_kpa,
                                         [TP_JOINT_TENSION] = &scene->loads.bond_kpa};
  if (joint != NULL) {
    const tp_quantity *const own[] = {[TP_JOINT_FRICTION] = &joint->friction_angle_deg,
                                      [TP_JOINT_COHESION] = &joint->cohesion_kpa,
                                      [TP_JOINT_TENSION] = &joint->tension_kpa};
    if (own[property]->given) return own[property];
  }
  if (set == NULL) return of_scene[property];
  const tp_quantity *const own[] = {[TP_JOINT_FRICTION] = &set->friction_angle_deg,
                                    [TP_JOINT_COHESION] = &set->cohesion_kpa,
                                    [TP_JOINT_TENSION] = &set->tension_kpa};
  return own[property]->given ? own[property] : of_scene[property];
}

const tp_quantity *tp_built_system_property(const tp_built_system *s, long contact,
                                            tp_joint_property property) {
  return property_of(s, s->assemblage.contacts + contact, s->joints[contact], property);
}

/* Pressures in units of force over length of the assemblage. */
static void set_pressure(arb_t pressure, const tp_built_system *s, const tp_quantity *kpa) {
  arb_t step;
  arb_init(step);
  arb_set_fmpq(pressure, kpa->value, BITS);
  arb_set_fmpq(step, s->assemblage.lattice.step_m, BITS);
  arb_mul(pressure, pressure, step, BITS);
  arb_mul_2exp_si(pressure, pressure,
                  s->assemblage.length_exponent - s->assemblage.weight_exponent);
  arb_clear(step);
}

static tp_near tangent_of(const tp_built_system *s, const tp_quantity *angle_deg) {
  arb_t tangent;
  arb_init(tangent);
  arb_set_fmpq(tangent, angle_deg->value, BITS);
  tp_friction_tangent(tangent, tangent, BITS);
  tp_friction_divide_tangent(tangent, s->scene, BITS);
  const tp_near own = tp_ball_near_exact(tangent);
  arb_clear(tangent);
  return own;
}

static void set_strength(tp_built_system *s, long contact) {
  arb_t cohesion, tension;
  arb_init(cohesion);
  arb_init(tension);
  set_pressure(cohesion, s, tp_built_system_property(s, contact, TP_JOINT_COHESION));
  set_pressure(tension, s, tp_built_system_property(s, contact, TP_JOINT_TENSION));
  s->strengths[contact] =
      (tp_contact_strength){tangent_of(s, tp_built_system_property(s, contact, TP_JOINT_FRICTION)),
                            tp_ball_near_exact(cohesion), tp_ball_near_exact(tension)};
  s->has_cohesion = s->has_cohesion || !arb_is_zero(cohesion) || !arb_is_zero(tension);
  arb_clear(cohesion);
  arb_clear(tension);
}

/* Contacts of a joint follow each other rarely: each takes a search. Those of one set do. */
static void set_contacts(tp_built_system *s, const tp_joint_description **sorted, bool *used) {
  for (long k = 0; k < s->assemblage.contact_count; k++) {
    const tp_block_contact *own = s->assemblage.contacts + k;
    const long joint = find_joint(s, sorted, own);
    s->joints[k] = joint >= 0 ? sorted[joint] : NULL;
    if (joint >= 0) used[joint] = true;
    if (k > 0 && s->joints[k] == s->joints[k - 1] && set_of(s, own) == set_of(s, own - 1)) {
      s->strengths[k] = s->strengths[k - 1];
    } else {
      set_strength(s, k);
    }
  }
}

/* The greatest of all contacts where none is given: that leaves the most to a motion. */
static tp_near greatest_tangent(const tp_built_system *s) {
  tp_near most = {0, 0};
  for (long k = 0; k < s->assemblage.contact_count; k++) {
    most = tp_near_larger(most, s->strengths[k].tangent);
  }
  return most;
}

static void set_pairs(tp_built_system *s, const tp_joint_description **sorted, bool *used) {
  const tp_near most = s->assemblage.pair_count > 0 ? greatest_tangent(s) : (tp_near){0, 0};
  for (long k = 0; k < 2 * s->assemblage.pair_count; k++) {
    const tp_block_contact *own = s->assemblage.pairs[k / 2].side + k % 2;
    const long joint = find_joint(s, sorted, own);
    if (joint >= 0) used[joint] = true;
    const tp_quantity *angle =
        property_of(s, own, joint >= 0 ? sorted[joint] : NULL, TP_JOINT_FRICTION);
    s->pair_tangents[k] = angle->given ? tangent_of(s, angle) : most;
  }
}

static tp_status check_friction(const tp_built_system *s, tp_message *message) {
  for (long k = 0; k < s->assemblage.contact_count && !s->scene->friction_angle_deg.given; k++) {
    if (tp_built_system_property(s, k, TP_JOINT_FRICTION)->given) continue;
    const tp_block_contact *own = s->assemblage.contacts + k;
    return tp_refuse(message, TP_FAULT_KEY, s->scene->many.place,
                     "the joints between blocks need a friction angle, and that between '%s' and "
                     "'%s' has none: 'friction_angle_deg: 30' in the scene, and 'joints' where it "
                     "differs",
                     tp_quote_all(s->given[own->block[0]].name).text,
                     tp_quote_all(s->given[own->block[1]].name).text);
  }
  return TP_OK;
}

static tp_status set_strengths(tp_built_system *s, tp_message *message) {
  const tp_block_list *many = &s->scene->many;
  const size_t contacts = (size_t)s->assemblage.contact_count + 1;
  const size_t joints = (size_t)many->joint_count + 1;
  const tp_joint_description **sorted = calloc(joints, sizeof *sorted);
  bool *used = calloc(joints, sizeof *used);
  s->joints = calloc(contacts, sizeof *s->joints);
  s->strengths = calloc(contacts, sizeof *s->strengths);
  s->pair_tangents = calloc(2 * (size_t)s->assemblage.pair_count + 1, sizeof *s->pair_tangents);
  tp_status status = TP_OK;
  if (sorted == NULL || used == NULL || s->joints == NULL || s->strengths == NULL ||
      s->pair_tangents == NULL) {
    status = tp_fail_memory(message, "the joints");
  } else {
    for (long k = 0; k < many->joint_count; k++) sorted[k] = many->joints + k;
    qsort(sorted, (size_t)many->joint_count, sizeof *sorted, compare_joints);
    set_contacts(s, sorted, used);
    set_pairs(s, sorted, used);
    status = check_friction(s, message);
    if (status == TP_OK) status = check_joints(s, sorted, used, message);
  }
  free(sorted);
  free(used);
  return status;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status build(tp_built_system *s, tp_message *message) {
  tp_status status = tp_check_load_case(s->scene, message);
  if (status == TP_OK && s->scene->source == NULL) {
    status = tp_check_built_blocks(s->scene, message);
  }
  if (status == TP_OK) status = tp_built_system_set_blocks(s, message);
  if (status == TP_OK) {
    status =
        tp_assemblage_init(&s->assemblage, s->given, s->count, s->scene->metres_per_unit, message);
  }
  const bool is_cut = s->scene->many.slope.place.file != NULL;
  if (status == TP_OK && is_cut) status = tp_assemblage_straighten(&s->assemblage, message);
  if (status == TP_OK) status = tp_built_system_note_gaps(s, message);
  if (status == TP_OK) status = set_strengths(s, message);
  return status == TP_OK ? tp_built_system_set_loads(s, message) : status;
}

tp_status tp_built_system_init(tp_built_system *s, const tp_scene *scene, tp_message *message) {
  memset(s, 0, sizeof *s);
  s->scene = scene;
  const tp_status status = build(s, message);
  if (status != TP_OK) tp_built_system_clear(s);
  return status;
}

tp_near tp_built_system_over(tp_near number, double divisor) {
  return tp_near_is_zero(number) ? number : tp_near_div(number, (tp_near){divisor, 0});
}

tp_contact_strength tp_built_system_strength(const tp_built_system *s, long contact,
                                             double divisor) {
  const tp_contact_strength *own = s->strengths + contact;
  return (tp_contact_strength){tp_built_system_over(own->tangent, divisor),
                               tp_built_system_over(own->cohesion, divisor),
                               tp_built_system_over(own->tension, divisor)};
}

tp_contact_strength *tp_built_system_strengths(const tp_built_system *s, double divisor) {
  const long count = s->assemblage.contact_count;
  tp_contact_strength *strengths = calloc((size_t)count + 1, sizeof *strengths);
  for (long k = 0; k < count && strengths != NULL; k++) {
    strengths[k] = tp_built_system_strength(s, k, divisor);
  }
  return strengths;
}

tp_status tp_built_system_program(tp_force_program *program, const tp_built_system *s,
                                  const tp_weight_loads *loads, double divisor,
                                  tp_message *message) {
  tp_contact_strength *strengths = tp_built_system_strengths(s, divisor);
  if (strengths == NULL) return tp_fail_memory(message, "the joints");
  const tp_status status =
      tp_force_program_init(program, &s->assemblage, strengths, loads, message);
  free(strengths);
  return status;
}
