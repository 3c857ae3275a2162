/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks made an assemblage, with the friction of each contact. */

#ifndef TP_BLOCK_SYSTEM_BUILT_SYSTEM_H
#define TP_BLOCK_SYSTEM_BUILT_SYSTEM_H

#include "assemblage/load_bracket.h"
#include "block_system/block_loads.h"

typedef struct tp_built_system {
  const tp_scene *scene;
  long count;
  tp_section *sections;
  tp_given_block *given;
  tp_assemblage assemblage;
  const tp_joint_description **joints; /* by contact; NULL: the scene's strength */
  tp_contact_strength *strengths;      /* by contact */
  tp_near *pair_tangents;              /* tan(phi) by pair of corners, two each: of its sides */
  bool has_cohesion;                   /* some of them has cohesion or tension */
  bool is_measured; /* that, or loads that are no weights: a common factor on all weights changes
                       something */
  tp_block_loads loads[2]; /* to the right, and to the left */
  tp_notes notes;          /* on what was made of the blocks */
} tp_built_system;

/* Each block is checked by itself first. On failure `system` is cleared. */
TP_MUST_USE tp_status tp_built_system_init(tp_built_system *system, const tp_scene *scene,
                                           tp_message *message);
/* Its blocks, at their places, with the gaps closed that the scene asks for; and a caution where
 * blocks all but touch (block_system/built_blocks.c). */
TP_MUST_USE tp_status tp_built_system_set_blocks(tp_built_system *system, tp_message *message);
TP_MUST_USE tp_status tp_built_system_note_gaps(tp_built_system *system, tp_message *message);
/* Its loads besides weights (block_system/built_loads.c), which need all else. */
TP_MUST_USE tp_status tp_built_system_set_loads(tp_built_system *system, tp_message *message);
void tp_built_system_clear(tp_built_system *system);

/* The friction angle, in degrees, and cohesion and tension, in kPa, of a contact: its joint's where
 * that gives them, else the scene's. */
typedef enum tp_joint_property {
  TP_JOINT_FRICTION,
  TP_JOINT_COHESION,
  TP_JOINT_TENSION
} tp_joint_property;
const tp_quantity *tp_built_system_property(const tp_built_system *system, long contact,
                                            tp_joint_property property);

/* The strength of a contact over a number, as its program has it. */
tp_contact_strength tp_built_system_strength(const tp_built_system *system, long contact,
                                             double divisor);

/* Of all contacts, to be freed; NULL when memory is exhausted. */
tp_contact_strength *tp_built_system_strengths(const tp_built_system *system, double divisor);

/* What is exactly nothing stays so. */
tp_near tp_built_system_over(tp_near strength, double divisor);

/* The program of forces with the strength of all contacts over a number. */
TP_MUST_USE tp_status tp_built_system_program(tp_force_program *program,
                                              const tp_built_system *system,
                                              const tp_weight_loads *loads, double divisor,
                                              tp_message *message);

#endif
