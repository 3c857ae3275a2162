/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks made an assemblage, with the friction of each contact. */

#ifndef TP_BLOCK_SYSTEM_BUILT_SYSTEM_H
#define TP_BLOCK_SYSTEM_BUILT_SYSTEM_H

#include "assemblage/load_bracket.h"

typedef struct tp_built_system {
  const tp_scene *scene;
  long count;
  tp_section *sections;
  tp_given_block *given;
  tp_assemblage assemblage;
  const tp_quantity **friction; /* by contact, degrees; borrowed from the scene */
  tp_near *tangents;            /* by contact: tan(phi) */
  tp_notes notes;               /* on what was made of the blocks */
} tp_built_system;

/* Each block is checked by itself first. On failure `system` is cleared. */
TP_MUST_USE tp_status tp_built_system_init(tp_built_system *system, const tp_scene *scene,
                                           tp_message *message);
void tp_built_system_clear(tp_built_system *system);

/* The program of forces towards a side with tan(phi) of all contacts over a number. */
TP_MUST_USE tp_status tp_built_system_program(tp_force_program *program,
                                              const tp_built_system *system, bool towards_left,
                                              double divisor, tp_message *message);

/* Its limit. */
TP_MUST_USE tp_status tp_built_system_bracket(tp_load_bracket *bracket,
                                              const tp_built_system *system, bool towards_left,
                                              double divisor, tp_message *message);

#endif
