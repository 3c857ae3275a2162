/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes that have a number for every key which a scene in memory can have. */

#ifndef TP_TEST_KEYED_SCENES_H
#define TP_TEST_KEYED_SCENES_H

#include "built_scene.h"

enum {
  MOST_NUMBERS = 26,
  KEYED_ROWS = 110,
  KEYED_BASE_ROWS = 33,
  KEYED_TEST_ROWS = 23,
  KEYED_BLOCK_ROWS = 13
};

/* A scene of numbers: built, and as text, in which @a is the first of them; or NULL. */
typedef struct keyed_scene {
  void (*build)(tp_scene *scene, const double *n);
  const char *text;
  double numbers[MOST_NUMBERS];
} keyed_scene;

/* A key of such a scene, the letter of its number, and another one. */
typedef struct keyed_row {
  const keyed_scene *scene;
  const char *key;
  char letter;
  double other;
} keyed_row;

extern const keyed_row keyed_rows[KEYED_ROWS];
/* Of bases that are made by rule. */
extern const keyed_row keyed_base_rows[KEYED_BASE_ROWS];
/* Of simulated tilt tests. */
extern const keyed_row keyed_test_rows[KEYED_TEST_ROWS];
/* Of many blocks. */
extern const keyed_row keyed_block_rows[KEYED_BLOCK_ROWS];

#endif
