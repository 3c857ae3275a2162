/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks in contact, built corner by corner for tests of assemblages. */

#ifndef TP_TEST_BLOCK_PILE_H
#define TP_TEST_BLOCK_PILE_H

#include "assemblage/load_bracket.h"

enum { PILE_NAME = 24 };

typedef struct block_pile {
  long count, room;
  tp_block_description *descriptions;
  tp_section *sections;
  tp_given_block *given;
  char (*names)[PILE_NAME];
  tp_assemblage assemblage;
} block_pile;

/* Corners counter-clockwise, x and y in turn, each a whole number over `divisor`. */
void pile_add(block_pile *pile, const long *corners, long count, long divisor, bool fixed);
/* A rectangle. */
void pile_add_box(block_pile *pile, long left, long low, long right, long high, long divisor,
                  bool fixed);
/* Walls of Ferris and Tin-Loi (2001): courses of bricks 4 by 1.75, half bricks at the ends of each
 * other course, the lowest among them. */
void pile_add_wall(block_pile *pile, int courses, int bricks);
/* The status of its assemblage, in metres; of one that is to be had. */
tp_status pile_assemble(block_pile *pile, tp_message *message);
void pile_build(block_pile *pile);
void pile_clear(block_pile *pile);

/* By contact, to be freed: one tan(phi) for all. */
tp_contact_strength *pile_strengths(const block_pile *pile, double tangent);

/* With one tan(phi) for all contacts, tilted to a side. */
void pile_program(tp_force_program *program, const block_pile *pile, double tangent,
                  bool towards_left);

/* The greatest tan(tilt) to a side, or coefficient of acceleration, with one tan(phi) for all
 * contacts: between two proofs. */
tp_load_bracket pile_limit(const block_pile *pile, double tangent, bool towards_left, double share);

#endif
