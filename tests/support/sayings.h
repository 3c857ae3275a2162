/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Everything that the library says of some scenes, as texts to be compared. Every public call is
 * among what is said (tests/program/test_calls.py holds to that). */

#ifndef TP_TEST_SAYINGS_H
#define TP_TEST_SAYINGS_H

#include "topple.h"

#include <stdbool.h>
#include <stddef.h>

enum { MOST_SAYINGS = 2000 };

typedef struct sayings {
  const char *folder; /* for files on the way */
  size_t count;
  char *texts[MOST_SAYINGS];
} sayings;

/* A part of it. All only add. There are no assertions and no arithmetic in doubles around the
 * calls, which the thread's settings may forbid, and no data but what is given. */
typedef struct saying {
  const char *name;
  void (*say)(sayings *s);
} saying;

extern const saying all_sayings[];
extern const size_t all_sayings_count;

void say_everything(sayings *s);
/* One scene, solved to so many digits, with the account by elements. */
void say_scene(sayings *s, const char *path, int digits);
void sayings_forget(sayings *s);

/* What they are made of: room for a text; a text for a status, for a number, or of a file that was
 * written; times made alike, which differ from run to run; all that is to be said of a scene, and
 * of a solution that has such times. */
char **next_saying(sayings *s);
void note_status(sayings *s, tp_status status, const tp_message *message);
void note_number(sayings *s, long number);
void say_file(sayings *s, const char *path);
void same_times(tp_solution *solution);
void say_solved(sayings *s, const tp_scene *scene, bool elements, int digits, bool figure);
void say_reports(sayings *s, const tp_solution *solution);

/* Scenes built in memory by every call that builds, right and wrong numbers among them. */
void say_built(sayings *s);
void say_built_shapes(sayings *s);
void say_built_loads(sayings *s);
void say_built_water(sayings *s);
void say_built_blocks(sayings *s);
void say_built_refused(sayings *s);
/* Many blocks in arrays. */
void say_blocks(sayings *s);
/* Scenes with other numbers. */
void say_varied(sayings *s);
/* Studies. */
void say_studies(sayings *s);
/* Simulated tilt tests. */
void say_tilts(sayings *s);
/* Roughness. */
void say_profiles(sayings *s);
void say_solids(sayings *s);
/* Names of enumerations, and calls on texts. */
void say_names(sayings *s);

#endif
