/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that build a scene, drawn from bytes; and the file that says what the done ones said. */

#ifndef TP_TEST_BUILD_CALLS_H
#define TP_TEST_BUILD_CALLS_H

#include "fuzz.h"

enum { BUILD_NUMBERS = 6, BUILD_POINTS = 9 };

/* What of a scene a call sets, or adds to. */
typedef enum build_slot {
  SLOT_TITLE,
  SLOT_SHAPE,
  SLOT_HOLES,
  SLOT_PARTS,
  SLOT_ARCS,
  SLOT_MODEL,
  SLOT_CORNERS,
  SLOT_REPAIR,
  SLOT_THICKNESS,
  SLOT_UNIT_WEIGHT,
  SLOT_BASE,
  SLOT_BETWEEN,
  SLOT_BOUND, /* and two more: one for each choice */
  SLOT_BEYOND = SLOT_BOUND + 3,
  SLOT_FRICTION, /* that of a law is left open */
  SLOT_FACETS,
  SLOT_TOWARDS,
  SLOT_ANGLE,
  SLOT_FRAME,
  SLOT_HORIZONTAL,
  SLOT_VERTICAL,
  SLOT_WATER,
  SLOT_PRESSURES,
  SLOT_SURCHARGES,
  SLOT_SUPPORTS,
  SLOT_ANCHORS,
  SLOT_BOND,
  SLOT_COHESION,
  SLOTS
} build_slot;

typedef struct build_call build_call;

/* `file`: what a scene file says instead: $0 to $5 the numbers, $p the points, $c the count, $e the
 * name of the choice, $y and $z its two lowest bits as words. */
typedef struct build_kind {
  tp_status (*run)(tp_scene *scene, const build_call *call, tp_message *message);
  build_slot slot;
  const char *file;
  int choices; /* 0: the call makes none; numbers beyond are drawn where they are names */
  const char *names[4];
} build_kind;

struct build_call {
  const build_kind *kind;
  tp_exact numbers[BUILD_NUMBERS];
  long count; /* of teeth */
  int choice;
  tp_coordinates points; /* in the arrays below, or nowhere */
  double xy[2 * BUILD_POINTS];
  const char *texts[2 * BUILD_POINTS];
};

/* Any call; what it points to lies in the call itself, which is not to be moved. */
void build_draw(build_call *call, fuzz_bytes *bytes);

enum { BUILD_FIRST = 2 };
/* The calls that make a block that most others can be about: a simple outline, a unit weight. */
void build_draw_first(build_call calls[BUILD_FIRST], fuzz_bytes *bytes);

/* The scene file that says what the calls that are `done` said; the caller's to free. */
char *build_file(const char *length_unit, const build_call *calls, const bool *done, size_t count);

#endif
