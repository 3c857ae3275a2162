/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fuzz_expect(bool condition, const char *what, const char *file, int line) {
  if (condition) return;
  fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, what);
  abort();
}

char *fuzz_text(const uint8_t *data, size_t size) {
  char *text = malloc(size + 1);
  FUZZ_EXPECT(text != NULL);
  if (size > 0) memcpy(text, data, size);
  text[size] = '\0';
  return text;
}

void fuzz_judge(tp_status status, const void *output, const tp_message *message) {
  FUZZ_EXPECT((status == TP_OK) == (output != NULL));
  FUZZ_EXPECT(status == TP_OK || message->text[0] != '\0');
  FUZZ_EXPECT(memchr(message->text, '\0', sizeof message->text) != NULL);
  /* a file that the input names is not there */
  FUZZ_EXPECT(status != TP_SYSTEM_FAILED || strstr(message->text, ": cannot be ") != NULL);
  FUZZ_EXPECT(status != TP_DEPENDENCY_FAILED);
}

/* A number is known to within its error, or out of range: a NaN is neither. */
static void check_bounded(tp_bounded number) {
  FUZZ_EXPECT(number.error >= 0);
  FUZZ_EXPECT(!isnan(number.value) || isinf(number.error));
}

static void check_fos(tp_fos fos) {
  if (fos.state == TP_FOS_NUMBER) check_bounded(fos.value);
}

static void check_limit(const tp_limit *limit) {
  if (limit->kind == TP_LIMIT_AT_ANGLE) check_bounded(limit->critical_angle_deg);
  check_fos(limit->fos);
}

static void check_case(const tp_case *c) {
  for (size_t k = 0; k < c->pivot_count; k++) {
    const tp_pivot *pivot = c->pivots + k;
    check_bounded(pivot->x_m);
    check_bounded(pivot->y_m);
    if (!pivot->never && !pivot->always) check_bounded(pivot->critical_angle_deg);
    check_fos(pivot->fos);
    check_fos(pivot->fos_elements);
  }
  FUZZ_EXPECT(!c->has_toppling_pivot || c->toppling_pivot < c->pivot_count);
  check_limit(&c->limit);
  check_limit(&c->limit_otherwise);
  if (c->has_margin) check_bounded(c->margin_deg);
}

/* JSON has no word for what is no number; within its texts a quote has a stroke before it. */
void fuzz_judge_json(const char *json) {
  static const char *const words[] = {"\": nan", "\": -nan", "\": inf", "\": -inf"};
  for (size_t k = 0; k < sizeof words / sizeof words[0]; k++) {
    for (const char *at = json; (at = strstr(at, words[k])) != NULL; at++) {
      FUZZ_EXPECT(at > json && at[-1] == '\\');
    }
  }
}

typedef tp_status (*solution_report)(char **text, const tp_solution *solution);

void fuzz_report(const tp_solution *solution) {
  static const solution_report reports[] = {tp_report_text, tp_report_elements, tp_report_json};
  char *text = NULL;
  check_bounded(solution->block.area_m2);
  check_bounded(solution->block.centroid_x_m);
  check_bounded(solution->block.centroid_y_m);
  for (size_t k = 0; k < solution->case_count; k++) check_case(solution->cases + k);
  for (size_t k = 0; k < sizeof reports / sizeof reports[0]; k++) {
    FUZZ_EXPECT(reports[k](&text, solution) == TP_OK);
    if (reports[k] == tp_report_json) fuzz_judge_json(text);
    free(text);
  }
  FUZZ_EXPECT(tp_report_table(&text, &solution, 1) == TP_OK);
  free(text);
}

void fuzz_report_derivation(const tp_derivation *derivation) {
  char *text = NULL;
  FUZZ_EXPECT(tp_report_derivation(&text, derivation) == TP_OK);
  free(text);
  FUZZ_EXPECT(tp_report_derivation_json(&text, derivation) == TP_OK);
  fuzz_judge_json(text);
  free(text);
}

unsigned fuzz_pick(fuzz_bytes *bytes, unsigned count) {
  return bytes->at < bytes->end ? *bytes->at++ % count : 0;
}
