/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Every key of a scene in memory: the scene in which its number is another has, byte for byte, the
 * solution of one that is built anew with that number, and of the file that says the same, varied
 * by the same key and written anew. Not one key of the table is left out. */

#include "keyed_scenes.h"

#include "scene_varying/slot_table.h"
#include "scene_varying/slots.h"

#include <stdlib.h>
#include <string.h>

enum { TEXT_SIZE = 2000 };

static tp_scene *build(const keyed_scene *of, const double *numbers) {
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_tilt_towards(scene, true, false, &message));
  of->build(scene, numbers);
  return scene;
}

static tp_scene *read(const keyed_scene *of, const double *numbers) {
  char text[TEXT_SIZE];
  size_t length = 0;
  for (const char *at = of->text; *at != '\0'; at++) {
    if (*at == '@') {
      const double number = numbers[*++at - 'a'];
      length += (size_t)snprintf(text + length, sizeof text - length, "%.17g", number);
    } else {
      text[length++] = *at;
    }
  }
  text[length] = '\0';
  /* both say where it tilts to: one of them as part of the text */
  const char *tilt = strstr(text, "tilt: {");
  if (tilt == NULL) {
    strcat(text, "tilt: {towards: left}\n");
  } else {
    const size_t at = (size_t)(tilt - text) + strlen("tilt: {");
    memmove(text + at + strlen("towards: left, "), text + at, strlen(text + at) + 1);
    memcpy(text + at, "towards: left, ", strlen("towards: left, "));
  }
  tp_scene *scene = NULL;
  DO(tp_scene_read_text(&scene, text, "scene in memory", &message));
  return scene;
}

/* What the scene says: its report, or why there is none. */
static char *say(const tp_scene *scene) {
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  if (tp_scene_block_count(scene) > 0) return solve(scene, 9); /* all of these have an answer */
  if (tp_solve(&solution, scene, &options, &message) != TP_OK) return strdup(message.text);
  tp_solution_free(solution);
  return solve(scene, 9);
}

/* Of what is wrong, or of notes: the places, which a file and a call have each of their own. */
static void drop_places(char *said) {
  static const char name[] = "\"place\": \"";
  char *wrong = *said != '{' ? strstr(said, ": ") : NULL;
  if (wrong != NULL) memmove(said, wrong, strlen(wrong) + 1);
  for (char *at = strstr(said, name); at != NULL; at = strstr(at, name)) {
    at += strlen(name);
    memmove(at, at + strcspn(at, "\""), strlen(at + strcspn(at, "\"")) + 1);
  }
}

/* The number is there, exactly, and the scene says what the one written anew says. */
static void expect_varied(const tp_scene *scene, const char *key, double number, char *anew,
                          bool same_places) {
  tp_scene *varied = NULL;
  tp_bounded held = {0};
  char *before = say(scene);
  DO(tp_scene_with(&varied, scene, key, E(number), &message));
  DO(tp_scene_number(&held, varied, key, &message));
  ck_assert_msg(held.value == number && held.error == 0, "%s: %.17g", key, held.value);
  char *own = say(varied);
  tp_scene_free(varied);
  expect_equal(before, say(scene));
  if (!same_places) {
    drop_places(own);
    drop_places(anew);
  }
  size_t same = 0;
  while (own[same] != 0 && own[same] == anew[same]) same++;
  ck_assert_msg(own[same] == anew[same], "%s\nvaried: %.200s\nanew: %.200s", key,
                own + (same < 60 ? 0 : same - 60), anew + (same < 60 ? 0 : same - 60));
  free(own);
  free(anew);
}

enum {
  TEST_ROWS_AT = KEYED_ROWS + KEYED_BASE_ROWS,
  BLOCK_ROWS_AT = TEST_ROWS_AT + KEYED_TEST_ROWS,
  ALL_ROWS = BLOCK_ROWS_AT + KEYED_BLOCK_ROWS
};

static const keyed_row *row_of(size_t k) {
  if (k < KEYED_ROWS) return keyed_rows + k;
  if (k < TEST_ROWS_AT) return keyed_base_rows + (k - KEYED_ROWS);
  return k < BLOCK_ROWS_AT ? keyed_test_rows + (k - TEST_ROWS_AT)
                           : keyed_block_rows + (k - BLOCK_ROWS_AT);
}

START_TEST(every_key) {
  const keyed_row *row = row_of((size_t)_i);
  const keyed_scene *of = row->scene;
  const char *key = row->key;
  double numbers[MOST_NUMBERS];
  memcpy(numbers, of->numbers, sizeof numbers);
  numbers[row->letter - 'a'] = row->other;
  tp_scene *scene = build(of, of->numbers), *anew = build(of, numbers);
  tp_bounded held = {0};
  DO(tp_scene_number(&held, scene, key, &message));
  ck_assert_msg(held.value == of->numbers[row->letter - 'a'], "%s: %.17g", key, held.value);
  expect_varied(scene, key, row->other, say(anew), true);
  if (of->text != NULL) {
    tp_scene *file = read(of, of->numbers), *file_anew = read(of, numbers);
    expect_varied(file, key, row->other, say(file_anew), true);
    expect_varied(file, key, row->other, say(anew), false);
    tp_scene_free(file);
    tp_scene_free(file_anew);
  }
  tp_scene_free(scene);
  tp_scene_free(anew);
}
END_TEST

START_TEST(whole_table) {
  bool seen[200] = {false};
  ck_assert_uint_le(tp_slot_row_count, sizeof seen);
  for (size_t k = 0; k < ALL_ROWS; k++) {
    tp_scene *scene = build(row_of(k)->scene, row_of(k)->scene->numbers);
    tp_slot slot;
    DO(tp_slot_find(&slot, scene, row_of(k)->key, &message));
    seen[slot.row - tp_slot_rows] = true;
    tp_scene_free(scene);
  }
  for (size_t k = 0; k < tp_slot_row_count; k++) {
    ck_assert_msg(seen[k], "no test varies %s", tp_slot_rows[k].key);
  }
}
END_TEST

SUITE(vary_keys) {
  Suite *suite = suite_create("vary_keys");
  TCase *tests = tcase_create("keys");
  tcase_set_timeout(tests, 0);
  tcase_add_loop_test(tests, every_key, 0, ALL_ROWS);
  tcase_add_test(tests, whole_table);
  suite_add_tcase(suite, tests);
  return suite;
}
