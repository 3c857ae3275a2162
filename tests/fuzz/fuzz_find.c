/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis and charts: drawn scenes, keys and numbers, wrong ones among them. */

#include "fuzz.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double draw_number(fuzz_bytes *b) {
  static const double odd[] = {0, -1, 90, 1e300, -1e300, 1e-300, NAN, INFINITY};
  const unsigned drawn = fuzz_pick(b, 256);
  return drawn >= 248 ? odd[drawn - 248] : drawn / 4.0;
}

static const char *draw_key(fuzz_bytes *b) {
  static const char *const keys[] = {"a",
                                     "block.slab.width",
                                     "block.slab.height",
                                     "block.teeth.count",
                                     "block.teeth.depth",
                                     "block.ellipse.flat",
                                     "block.outline.2.1",
                                     "block.rounded.corners.1.radius",
                                     "friction_angle_deg",
                                     "friction.jrc",
                                     "tilt.angle_deg",
                                     "tilt",
                                     "loads.water.height",
                                     "loads.seismic.horizontal",
                                     "base.beyond.left",
                                     "block",
                                     "length_unit",
                                     "block.outline.0.1",
                                     "..",
                                     ""};
  return keys[fuzz_pick(b, sizeof keys / sizeof keys[0])];
}

static void find(const tp_scene *scene, fuzz_bytes *b) {
  tp_found *found = NULL;
  char *text = NULL;
  tp_message message = {.text = ""};
  tp_find_options options = {.size = sizeof options,
                             .key = draw_key(b),
                             .target = (tp_find_target)fuzz_pick(b, TP_FIND_GOVERNING_FOS + 1),
                             .value = draw_number(b)};
  const unsigned ends = fuzz_pick(b, 4); /* none, both, the upper one, the lower one */
  options.has_low = ends % 2 != 0;
  options.has_high = ends == 1 || ends == 2;
  options.low = draw_number(b);
  options.high = draw_number(b);
  const tp_status status = tp_find(&found, scene, &options, &message);
  fuzz_judge(status, found, &message);
  if (status == TP_OK) {
    FUZZ_EXPECT(tp_report_found(&text, found, &options) == TP_OK);
    for (size_t k = 0; k < found->count; k++) FUZZ_EXPECT(found->solutions[k].error >= 0);
  }
  free(text);
  tp_found_free(found);
}

static void draw_list(tp_chart_list *list, double values[TP_CHART_LIST_MAX], fuzz_bytes *b) {
  *list = (tp_chart_list){fuzz_pick(b, TP_CHART_LIST_MAX + 1), values};
  for (size_t k = 0; k < list->count; k++) values[k] = draw_number(b);
}

static tp_status chart_fos(tp_chart **chart, fuzz_bytes *b, tp_message *message) {
  tp_chart_fos_options options = tp_chart_fos_options_default();
  double values[3][TP_CHART_LIST_MAX];
  if (fuzz_pick(b, 2) != 0) draw_list(&options.inverse_slenderness, values[0], b);
  if (fuzz_pick(b, 2) != 0) draw_list(&options.amplitude, values[1], b);
  if (fuzz_pick(b, 2) != 0) draw_list(&options.sub_blocks, values[2], b);
  if (fuzz_pick(b, 2) != 0) options.tilt_deg = (tp_chart_range){draw_number(b), draw_number(b)};
  return tp_chart_fos(chart, &options, message);
}

static tp_status chart_mechanisms(tp_chart **chart, fuzz_bytes *b, tp_message *message) {
  const tp_chart_mechanisms_options options = {.size = sizeof options,
                                               .friction_deg = draw_number(b),
                                               .roughness_angle_deg = draw_number(b),
                                               .amplitude = draw_number(b) / 100};
  return tp_chart_mechanisms(chart, &options, message);
}

/* Along one scalar against the tilt; with contours, which that has not, over two numbers: of these
 * friction is above zero in one or two rows of the grid alone, as all of it takes seconds. */
static tp_status chart_map(tp_chart **chart, const tp_scene *scene, fuzz_bytes *b,
                           tp_message *message) {
  tp_chart_map_options options = {.size = sizeof options, .scene = scene};
  double levels[TP_CHART_LIST_MAX];
  options.x = (tp_chart_axis){draw_key(b), {draw_number(b), draw_number(b)}};
  options.y = (tp_chart_axis){"tilt", {draw_number(b), draw_number(b)}};
  const unsigned drawn =
      fuzz_pick(b, 8); /* 0: none of what follows, as inputs that are at an end */
  options.any_tilt = drawn % 2 != 0;
  options.governing_fos = drawn / 2 % 2 != 0;
  if (drawn != 0) draw_list(&options.levels, levels, b);
  if (drawn >= 4) {
    const double most = draw_number(b);
    options.y = (tp_chart_axis){"friction_angle_deg", {-30 * most, most}};
  }
  return tp_chart_map(chart, &options, message);
}

static void report(const tp_chart *chart) {
  char *text = NULL;
  FUZZ_EXPECT(tp_report_chart_csv(&text, chart) == TP_OK);
  free(text);
  FUZZ_EXPECT(tp_report_chart_json(&text, chart) == TP_OK);
  free(text);
}

/* The scene with another number has that number, and may be varied, solved, and found in. */
static void vary(const tp_scene *scene, fuzz_bytes *b) {
  tp_scene *varied = NULL;
  tp_message message = {.text = ""};
  const char *const keys[2] = {draw_key(b), draw_key(b)};
  const tp_exact values[2] = {tp_exact_of(draw_number(b)), tp_exact_of(draw_number(b))};
  const size_t count = 1 + fuzz_pick(b, 2);
  const tp_status status = tp_scene_with_numbers(&varied, scene, keys, values, count, &message);
  fuzz_judge(status, varied, &message);
  for (size_t k = 0; k < 2 && k < count && status == TP_OK; k++) {
    tp_bounded number = {0};
    char *text = NULL;
    FUZZ_EXPECT(tp_scene_number(&number, varied, keys[k], &message) == TP_OK);
    FUZZ_EXPECT(number.value == values[k].value && number.error == 0);
    FUZZ_EXPECT(tp_scene_number_text(&text, varied, keys[k], &message) == TP_OK);
    free(text);
  }
  if (status == TP_OK) find(varied, b);
  tp_scene_free(varied);
}

static void call(unsigned which, const tp_scene *scene, fuzz_bytes *b) {
  tp_chart *chart = NULL;
  tp_message message = {.text = ""};
  if (which < 3) {
    find(scene, b);
  } else if (which == 3) {
    vary(scene, b);
  } else {
    const tp_status status = which == 4   ? chart_fos(&chart, b, &message)
                             : which == 5 ? chart_mechanisms(&chart, b, &message)
                                          : chart_map(&chart, scene, b, &message);
    fuzz_judge(status, chart, &message);
    if (status == TP_OK) report(chart);
  }
  tp_chart_free(chart);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  const unsigned which = fuzz_pick(&bytes, 8);
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  char *text = fuzz_scene(&bytes);
  const tp_status status = tp_scene_read_text(&scene, text, "scene", &message);
  fuzz_judge(status, scene, &message);
  if (status == TP_OK) call(which, scene, &bytes);
  tp_scene_free(scene);
  free(text);
  return 0;
}
