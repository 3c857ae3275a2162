/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* No scene ends a program that calls the library. The story: a face that dips by 1e-12 degrees was
 * divided by zero in FLINT, which aborts. Each number of the scenes in tests/data/swept is changed
 * to extremes, in this one process, in which every call returns. Scenes in memory follow, by every
 * key that a number has. tests/program/swept_case.py changes the files likewise. */

#include "keyed_scenes.h"
#include "suite.h"

#include <ctype.h>
#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_SIZE = 4000 };

static const char *const extremes[] = {"0",      "1e-12",   "-1e-12",           "1e-30",
                                       "-1e-30", "1e-100",  "-1e-100",          "1e-300",
                                       "90",     "-1e-300", "89.9999999999999", "90.0000000000001",
                                       "1e300",  "-1e300"};
static const double doubles[] = {
    0,     1e-12,  -1e-12,           1e-30,           1e-300, -1e-300, 90,
    1e300, -1e300, 89.9999999999999, 90.0000000000001};

enum {
  EXTREMES = sizeof extremes / sizeof extremes[0],
  DOUBLES = sizeof doubles / sizeof doubles[0]
};

/* ---- solved ------------------------------------------------------------------------------------
 */

static bool has_map(const char *text, const char *key) {
  char line[40];
  snprintf(line, sizeof line, "\n%s:", key);
  return strstr(text, line) != NULL;
}

static tp_status solve_as(const tp_scene *scene, bool many, bool solid) {
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = TP_OK;
  if (many) {
    tp_block_system *system = NULL;
    status = tp_solve_block_system(&system, scene, &options, &message);
    tp_block_system_free(system);
  } else if (solid) {
    tp_solid *own = NULL;
    status = tp_solve_solid(&own, scene, &message);
    tp_solid_free(own);
  } else {
    tp_solution *solution = NULL;
    status = tp_solve(&solution, scene, &options, &message);
    tp_solution_free(solution);
  }
  return status;
}

/* Does it have an answer? A refusal has words. */
static bool ask_text(const char *text, const char *name) {
  tp_scene *scene = NULL;
  message.text[0] = '\0';
  tp_status status = tp_scene_read_text(&scene, text, name, &message);
  if (status == TP_OK) {
    status = solve_as(scene,
                      has_map(text, "blocks") || has_map(text, "columns") ||
                          has_map(text, "jointed_slope"),
                      has_map(text, "solid"));
    tp_scene_free(scene);
  }
  ck_assert_msg(status == TP_OK || message.text[0] != '\0', "%s", text);
  return status == TP_OK;
}

/* ---- files -------------------------------------------------------------------------------------
 */

/* Where a number stands in the text from `at` on, and its length; 0: none does. */
static size_t next_number(const char *text, size_t *at) {
  for (; text[*at] != '\0'; (*at)++) {
    const char before = *at > 0 ? text[*at - 1] : ' ';
    if (strchr(" [{:,", before) == NULL) continue;
    size_t length = text[*at] == '-' ? 1 : 0;
    if (!isdigit((unsigned char)text[*at + length])) continue;
    length += strspn(text + *at + length, "0123456789.");
    if (strchr(" ,]}\n", text[*at + length]) != NULL) return length;
  }
  return 0;
}

static void read_text(char *text, const char *path) {
  FILE *file = fopen(path, "rb");
  ck_assert_ptr_nonnull(file);
  const size_t length = fread(text, 1, TEXT_SIZE - 1, file);
  fclose(file);
  ck_assert_uint_lt(length, TEXT_SIZE - 1);
  text[length] = '\0';
}

/* Every `stride`-th change of the file, counted on from `*turn`. */
static void sweep_file(const char *path, long stride, long *turn, long *asked, long *answered) {
  char text[TEXT_SIZE], changed[TEXT_SIZE + 40];
  read_text(text, path);
  size_t at = (size_t)(strstr(text, "length_unit") - text), length = 0;
  for (; (length = next_number(text, &at)) > 0; at += length) {
    for (size_t k = 0; k < EXTREMES; k++) {
      if ((*turn)++ % stride != 0) continue;
      snprintf(changed, sizeof changed, "%.*s%s%s", (int)at, text, extremes[k], text + at + length);
      ++*asked;
      *answered += ask_text(changed, path);
    }
  }
}

START_TEST(files) {
  long turn = 0, asked = 0, answered = 0;
  struct dirent **names = NULL;
  const int count = scandir(TP_SWEPT, &names, NULL, alphasort);
  ck_assert_int_gt(count, 10);
  for (int k = 0; k < count; k++) {
    char path[4000];
    snprintf(path, sizeof path, "%s/%s", TP_SWEPT, names[k]->d_name);
    if (strstr(names[k]->d_name, ".yaml") != NULL) {
      sweep_file(path, rounds(41, 2), &turn, &asked, &answered);
    }
    free(names[k]);
  }
  free(names);
  ck_assert_int_gt(answered, asked / 10);
  ck_assert_int_lt(answered, asked);
}
END_TEST

/* ---- scenes in memory --------------------------------------------------------------------------
 */

static void sweep_rows(const keyed_row *rows, size_t count, long stride, long *turn) {
  for (size_t k = 0; k < count; k++) {
    tp_scene *scene = new_scene("m");
    DO(tp_scene_set_tilt_towards(scene, true, false, &message));
    rows[k].scene->build(scene, rows[k].scene->numbers);
    const bool many = tp_scene_block_count(scene) > 0;
    for (size_t n = 0; n < DOUBLES; n++) {
      tp_scene *varied = NULL;
      if ((*turn)++ % stride != 0) continue;
      if (tp_scene_with(&varied, scene, rows[k].key, E(doubles[n]), &message) != TP_OK) continue;
      (void)solve_as(varied, many, false);
      tp_scene_free(varied);
    }
    tp_scene_free(scene);
  }
}

START_TEST(scenes_in_memory) {
  const long stride = rounds(13, 1);
  long turn = 0;
  sweep_rows(keyed_rows, KEYED_ROWS, stride, &turn);
  sweep_rows(keyed_base_rows, KEYED_BASE_ROWS, stride, &turn);
  sweep_rows(keyed_test_rows, KEYED_TEST_ROWS, stride, &turn);
  sweep_rows(keyed_block_rows, KEYED_BLOCK_ROWS, stride, &turn);
}
END_TEST

SUITE(swept) {
  Suite *suite = suite_create("swept");
  TCase *tests = tcase_create("swept");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, files);
  tcase_add_test(tests, scenes_in_memory);
  suite_add_tcase(suite, tests);
  return suite;
}
