/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The result of a scene of many blocks: what the scene says, blocks and contacts; made and given
 * back. */

#include "block_system/system.h"

#include "block/ring_sums.h"
#include "common/notes.h"
#include "evaluation/certainty.h"
#include "evaluation/friction.h"
#include "number/ball.h"
#include "scene_varying/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 128 };
static const double newtons = 1000; /* in a kN */

size_t tp_scene_block_count(const tp_scene *scene) {
  return scene == NULL ? 0 : (size_t)scene->many.count;
}

tp_motions_sought tp_block_system_cheap_motions(const tp_scene *scene) {
  enum { FEW = 6 };
  long free_blocks = 0;
  for (long k = 0; k < scene->many.count; k++) free_blocks += !scene->many.blocks[k].fixed;
  return free_blocks <= FEW ? TP_MOTIONS_ALL : TP_MOTIONS_NONE;
}

static void clear_case(tp_system_case *own) {
  free(own->motions);
  free(own->forces);
  free(own->loads);
  free(own->start.motions);
  free(own->start.touches);
  free(own->goodman_bray.why_not);
  free(own->goodman_bray.columns);
}

void tp_block_system_free(tp_block_system *system) {
  if (system == NULL) return;
  for (size_t k = 0; k < system->block_count && system->blocks != NULL; k++) {
    free(system->blocks[k].name);
  }
  for (size_t k = 0; k < system->case_count && system->cases != NULL; k++) {
    clear_case(system->cases + k);
  }
  free(system->blocks);
  free(system->contacts);
  free(system->cases);
  free(system->title);
  free(system->scene);
  free(system->length_unit);
  free(system->partial_factors);
  tp_notes_clear(&system->notes);
  tp_settings_clear(&system->settings);
  free(system);
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static tp_bounded bounded(tp_near near) {
  return (tp_bounded){.value = near.value, .error = near.error};
}

/* A sum of a whole number and an arm, in metres. */
static tp_bounded coordinate(const tp_assemblage *a, const fmpz_t origin, const fmpz_t whole,
                             tp_near arm) {
  arb_t sum, metres;
  arb_init(sum);
  arb_init(metres);
  tp_ball_set_bounded(sum, arm.value, arm.error);
  arb_mul_2exp_si(sum, sum, a->length_exponent);
  arb_add_fmpz(sum, sum, whole, BITS);
  arb_add_fmpz(sum, sum, origin, BITS);
  arb_set_fmpq(metres, a->lattice.step_m, BITS);
  arb_mul(sum, sum, metres, BITS);
  const tp_bounded value = tp_ball_bounded(sum);
  arb_clear(sum);
  arb_clear(metres);
  return value;
}

/* Of the outline less its holes, which are the first chains of the block. */
static tp_bounded area_of(const tp_lattice *l, long chain, long hole_count) {
  fmpz sums[TP_AREA_SUM_COUNT];
  fmpq_t area;
  fmpq_init(area);
  for (int k = 0; k < TP_AREA_SUM_COUNT; k++) fmpz_init(sums + k);
  for (long r = chain; r <= chain + hole_count; r++) {
    const long first = l->start[r];
    tp_ring_sums_exact_first(sums, l->x + first, l->y + first, l->start[r + 1] - first,
                             TP_AREA_SUM_COUNT);
    if (r > chain) fmpz_neg(sums, sums);
    fmpz_add(fmpq_numref(area), fmpq_numref(area), sums);
  }
  fmpq_div_2exp(area, area, 1);
  fmpq_mul(area, area, l->step_m);
  fmpq_mul(area, area, l->step_m);
  const tp_bounded value = tp_result_rational(area);
  for (int k = 0; k < TP_AREA_SUM_COUNT; k++) fmpz_clear(sums + k);
  fmpq_clear(area);
  return value;
}

static bool set_block(tp_system_block *own, const tp_built_system *s, long k, long chain) {
  const tp_assemblage *a = &s->assemblage;
  const tp_rigid_block *block = a->blocks + k;
  const tp_listed_block *listed = s->scene->many.blocks + k;
  own->name = strdup(listed->name);
  own->ground = listed->fixed;
  own->area_m2 = area_of(&a->lattice, chain, s->sections[k].hole_count);
  own->centroid_x_m = coordinate(a, a->lattice.origin_x, block->x, block->arm_x);
  own->centroid_y_m = coordinate(a, a->lattice.origin_y, block->y, block->arm_y);
  own->has_weight = tp_listed_block_unit_weight(s->scene, listed)->given;
  own->weight_n_m =
      bounded(tp_near_mul(block->weight, (tp_near){ldexp(newtons, (int)a->weight_exponent), 0}));
  return own->name != NULL;
}

static tp_bounded property_of(const tp_built_system *s, long contact, tp_joint_property property) {
  return tp_result_rational(tp_built_system_property(s, contact, property)->value);
}

/* Of a factored scene that of the strength. */
static tp_bounded friction_of(const tp_built_system *s, long contact) {
  const tp_quantity *given = tp_built_system_property(s, contact, TP_JOINT_FRICTION);
  if (s->scene->friction_divisor == NULL) return tp_result_rational(given->value);
  arb_t degrees;
  arb_init(degrees);
  arb_set_fmpq(degrees, given->value, BITS);
  tp_friction_divide_angle(degrees, s->scene, BITS);
  const tp_bounded divided = tp_ball_bounded(degrees);
  arb_clear(degrees);
  return divided;
}

static void set_contact(tp_system_contact *own, const tp_built_system *s, long k) {
  const tp_assemblage *a = &s->assemblage;
  const tp_block_contact *contact = a->contacts + k;
  static const tp_near nothing = {0, 0};
  own->first = (size_t)contact->block[0];
  own->second = (size_t)contact->block[1];
  own->corner = contact->ends[0] == contact->ends[1];
  tp_bounded *const ends[2][2] = {{&own->from_x_m, &own->from_y_m}, {&own->to_x_m, &own->to_y_m}};
  for (int e = 0; e < 2; e++) {
    const long p = contact->ends[e];
    *ends[e][0] = coordinate(a, a->lattice.origin_x, a->lattice.x + p, nothing);
    *ends[e][1] = coordinate(a, a->lattice.origin_y, a->lattice.y + p, nothing);
  }
  own->friction_angle_deg = friction_of(s, k);
  own->cohesion_kpa = property_of(s, k, TP_JOINT_COHESION);
  own->tension_kpa = property_of(s, k, TP_JOINT_TENSION);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static bool set_lists(tp_block_system *own, const tp_built_system *s) {
  enum { CASES = 3 }; /* two directions, and one more while it is joined with another */
  const tp_assemblage *a = &s->assemblage;
  own->blocks = calloc((size_t)a->count, sizeof *own->blocks);
  own->contacts = calloc((size_t)a->contact_count + 1, sizeof *own->contacts);
  own->cases = calloc(CASES, sizeof *own->cases);
  bool done = own->blocks != NULL && own->contacts != NULL && own->cases != NULL;
  long chain = 0;
  for (long k = 0; k < a->count && done; k++) {
    done = set_block(own->blocks + k, s, k, chain);
    chain += s->sections[k].ring_count;
    own->block_count++;
  }
  for (long k = 0; k < a->contact_count && done; k++) set_contact(own->contacts + k, s, k);
  own->contact_count = (size_t)a->contact_count;
  return done;
}

/* With the case that the scene is of. */
static char *title_of(const tp_scene *scene) {
  const char *title = scene->title != NULL ? scene->title : "Blocks";
  static const char form[] = "%s, case %s";
  if (scene->load_case == NULL) return scene->title != NULL ? strdup(title) : NULL;
  const size_t size = sizeof form + strlen(title) + strlen(scene->load_case);
  char *own = malloc(size);
  if (own != NULL) snprintf(own, size, form, title, scene->load_case);
  return own;
}

tp_status tp_block_system_describe(tp_block_system **system, const tp_built_system *s,
                                   tp_message *message) {
  const tp_scene *scene = s->scene;
  tp_block_system *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the result");
  own->size = sizeof *own;
  own->title = title_of(scene);
  own->scene = strdup(scene->path);
  own->length_unit = strdup(scene->length_unit);
  own->metres_per_unit = fmpq_get_d(scene->metres_per_unit);
  own->lies_in_place = tp_scene_lies_in_place(scene);
  own->has_required_fos = scene->required_fos.given;
  if (own->has_required_fos) own->required_fos = tp_result_rational(scene->required_fos.value);
  const bool done = set_lists(own, s) && own->scene != NULL && own->length_unit != NULL &&
                    (own->title != NULL || (scene->title == NULL && scene->load_case == NULL));
  tp_status status = done ? TP_OK : tp_fail_memory(message, "the result");
  if (status == TP_OK) status = tp_scene_notes(&own->notes, scene, message);
  if (status == TP_OK) status = tp_notes_append(&own->notes, &s->notes, message);
  if (status == TP_OK) status = tp_scene_settings(&own->settings, scene, message);
  if (status == TP_OK) {
    *system = own;
  } else {
    tp_block_system_free(own);
  }
  return status;
}

bool tp_system_is_weighed(const tp_block_system *system) {
  for (size_t k = 0; k < system->block_count; k++) {
    if (!system->blocks[k].ground) return system->blocks[k].has_weight;
  }
  return false;
}

tp_status tp_system_case_add(tp_block_system *system, tp_system_case **added, tp_message *message) {
  tp_system_case *own = system->cases + system->case_count++;
  own->motions = calloc(system->block_count, sizeof *own->motions);
  own->forces = calloc(system->contact_count + 1, sizeof *own->forces);
  *added = own;
  return own->motions != NULL && own->forces != NULL ? TP_OK
                                                     : tp_fail_memory(message, "the result");
}

void tp_system_case_drop_last(tp_block_system *system) {
  tp_system_case *last = system->cases + --system->case_count;
  clear_case(last);
  *last = (tp_system_case){.motions = NULL};
}
