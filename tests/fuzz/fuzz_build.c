/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes built in memory by drawn calls, wrong ones among them, and solved. A call that fails
 * leaves the scene as it was: a second scene, built by those calls alone that were done, has the
 * same outcome. So has the scene file that says the same, but for what bears the name of a call. */

#include "build_calls.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_CALLS = 24 };

typedef struct outcome {
  tp_status status;
  tp_message message;
  char *json;
} outcome;

/* Empty the values of a key: a text, or a list, in which there is no bracket of a text. */
static void empty_values(char *json, const char *key) {
  char *at = json;
  while ((at = strstr(at, key)) != NULL) {
    at += strlen(key);
    int depth = 0;
    char *end = at;
    bool text = false;
    do {
      if (*end == '"' && (end == at || end[-1] != '\\')) text = !text;
      if (!text && *end == '[') depth++;
      if (!text && *end == ']') depth--;
      end++;
    } while (*end != '\0' && (text || depth > 0));
    memmove(at, end, strlen(end) + 1);
  }
}

static outcome solve(const tp_scene *scene, const tp_solve_options *options) {
  outcome own = {0};
  tp_solution *solution = NULL;
  own.status = tp_solve(&solution, scene, options, &own.message);
  fuzz_judge(own.status, solution, &own.message);
  if (own.status == TP_OK) {
    fuzz_report(solution);
    FUZZ_EXPECT(tp_report_json(&own.json, solution) == TP_OK);
    empty_values(own.json, "\"effects\": ");
    FUZZ_EXPECT(solution->case_count > 0);
  }
  tp_solution_free(solution);
  return own;
}

static void expect_equal(const outcome *one, const outcome *other) {
  FUZZ_EXPECT(one->status == other->status);
  if (one->status == TP_OK) FUZZ_EXPECT(strcmp(one->json, other->json) == 0);
}

/* What only one of the two says: where a note is of, what called for a load, the title. */
static void empty_places(outcome *own) {
  if (own->json == NULL) return;
  empty_values(own->json, "\"notes\": ");
  empty_values(own->json, "\"called_for_by\": ");
  empty_values(own->json, "\"title\": ");
}

static void compare_with_file(const char *text, outcome *built, const tp_solve_options *options) {
  tp_scene *read = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read_text(&read, text, "built.yaml", &message);
  fuzz_judge(status, read, &message);
  if (status == TP_OK) {
    outcome own = solve(read, options);
    empty_places(built);
    empty_places(&own);
    expect_equal(built, &own);
    free(own.json);
  } else {
    FUZZ_EXPECT(status == built->status);
  }
  tp_scene_free(read);
}

static tp_scene *new_scene(const char *unit) {
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_new(&scene, unit, &message);
  fuzz_judge(status, scene, &message);
  return scene;
}

static bool run_call(tp_scene *scene, const build_call *call) {
  tp_message message = {.text = ""};
  const tp_status status = call->kind->run(scene, call, &message);
  FUZZ_EXPECT(status == TP_OK || status == TP_BAD_INPUT);
  FUZZ_EXPECT((status == TP_OK) == (message.text[0] == '\0'));
  return status == TP_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const units[] = {"m", "mm", "ft", "yd", "in", "km"};
  static build_call calls[MOST_CALLS];
  bool done[MOST_CALLS] = {false};
  fuzz_bytes bytes = {data, data + size};
  const char *unit = units[fuzz_pick(&bytes, sizeof units / sizeof units[0])];
  tp_solve_options options = tp_solve_options_default();
  const unsigned asked = fuzz_pick(&bytes, 16);
  options.elements = (asked & 1) != 0;
  options.digits = (asked & 2) != 0 ? 30 : 9;
  const size_t first = asked < 12 ? BUILD_FIRST : 0;
  build_draw_first(calls, &bytes);
  tp_scene *scene = new_scene(unit), *other = new_scene(unit);
  if (scene == NULL) return 0;
  size_t count = 0, failed = 0;
  for (; count < first || (count < MOST_CALLS && bytes.at < bytes.end); count++) {
    if (count >= first) build_draw(calls + count, &bytes);
    done[count] = run_call(scene, calls + count);
    if (done[count]) FUZZ_EXPECT(run_call(other, calls + count));
    failed += !done[count];
  }
  outcome one = solve(scene, &options);
  if (failed > 0) {
    outcome two = solve(other, &options);
    expect_equal(&one, &two);
    FUZZ_EXPECT(strcmp(one.message.text, two.message.text) == 0);
    free(two.json);
  }
  char *text = build_file(unit, calls, done, count);
  compare_with_file(text, &one, &options);
  free(text);
  free(one.json);
  tp_scene_free(scene);
  tp_scene_free(other);
  return 0;
}
