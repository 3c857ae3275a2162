/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Onset and motions of slabs and toothed blocks (docs/mechanics.md sections 6a and 7) sampled over
 * the inverse slenderness, with changes of motion bisected to neighbouring doubles. */

#include "paper/mechanisms_rest.h"

#include "chart/mechanism_style.h"
#include "chart/motion_names.h"
#include "paper/teeth.h"

#include <math.h>
#include <stdio.h>

enum { SLABS = 120, BLOCKS_MAX = 60, FLANKS_MAX = 3000, BORDERS_MAX = 4 * SLABS, NAME_SIZE = 240 };

typedef struct border_list {
  size_t count;
  tp_toothed_border items[BORDERS_MAX];
} border_list;

static void begin_series(const tp_mechanisms_rest *r, tp_chart_style style, const char *series) {
  tp_chart_add_series(r->chart, style, (const char *const[]){r->panel, series, NULL});
}

static void begin_border(const tp_mechanisms_rest *r, tp_chart_style style, const char *toe,
                         unsigned below, unsigned above) {
  char border[TP_MOTIONS_BORDER_SIZE], name[NAME_SIZE];
  tp_motions_border_name(border, below, above);
  snprintf(name, sizeof name, "from rest%s: %s", toe, border);
  begin_series(r, style, name);
}

/* A series for each two motions. */
static void add_borders(const tp_mechanisms_rest *r, tp_chart_style style, const char *toe,
                        const border_list *list) {
  for (size_t k = 0; k < list->count; k++) {
    const tp_toothed_border *first = list->items + k;
    bool is_new = true;
    for (size_t j = 0; j < k; j++) {
      is_new &= list->items[j].below != first->below || list->items[j].above != first->above;
    }
    if (!is_new) continue;
    begin_border(r, style, toe, first->below, first->above);
    for (size_t j = k; j < list->count; j++) {
      const tp_toothed_border *own = list->items + j;
      if (own->below != first->below || own->above != first->above) continue;
      tp_chart_add_point(r->chart, tp_chart_exactly(own->inverse_slenderness), own->tilt_deg);
    }
  }
}

/* ---- planar base --------------------------------------------------------------------------------
 */

/* What a slab of some width begins with from rest. */
typedef struct first_motion {
  double width;
  tp_bounded onset_deg;
  tp_mechanism begins;
  unsigned upright; /* what can begin at 90 degrees */
} first_motion;

static tp_toothed_question slab(const tp_mechanisms_rest *r, double width) {
  return (tp_toothed_question){
      .block = {width, 0, 2}, .toe = TP_TOE_PLANAR, .friction_deg = r->options->friction_deg};
}

static tp_status sample(first_motion *first, const tp_mechanisms_rest *r, double width,
                        tp_message *message) {
  const tp_toothed_question question = slab(r, width);
  tp_solution *solution = NULL;
  const tp_status status = tp_toothed_solve(&solution, &question, message);
  if (status != TP_OK) return status;
  const tp_onset *onset = &solution->cases[0].onset;
  *first = (first_motion){
      .width = width,
      .onset_deg = onset->critical_angle_deg,
      .begins = onset->mechanism,
      .upright = onset->range_count > 0 ? onset->ranges[onset->range_count - 1].motions : 0};
  tp_solution_free(solution);
  return TP_OK;
}

/* Halve the widths from `low` to `high`, which begin with different motions, until no double lies
 * between them: a motion is no value that could be interpolated. */
static tp_status part(first_motion *low, first_motion *high, const tp_mechanisms_rest *r,
                      tp_message *message) {
  for (;;) {
    const double middle = low->width + (high->width - low->width) / 2;
    if (!(middle > low->width && middle < high->width)) return TP_OK;
    first_motion found = {0};
    const tp_status status = sample(&found, r, middle, message);
    if (status != TP_OK) return status;
    *(found.begins == low->begins ? low : high) = found;
  }
}

static double slenderest(const tp_mechanisms_rest *r) {
  return 1e-3 * r->x_most / SLABS; /* a block has a width */
}

/* From the slenderest slab to the one that begins with another motion. */
static tp_status add_curve(const tp_mechanisms_rest *r, double to, tp_message *message) {
  border_list list = {0};
  tp_status status = TP_OK;
  for (int k = 0; k <= SLABS && status == TP_OK; k++) {
    const tp_toothed_question question = slab(r, k > 0 ? to * k / SLABS : slenderest(r));
    status = tp_toothed_borders(list.items, &list.count, BORDERS_MAX, &question, message);
  }
  if (status == TP_OK) add_borders(r, tp_line_dynamic, "", &list);
  return status;
}

tp_status tp_mechanisms_rest_planar(const tp_mechanisms_rest *r, tp_message *message) {
  first_motion low = {0}, high = {0};
  tp_status status = sample(&low, r, slenderest(r), message);
  if (status == TP_OK) status = sample(&high, r, r->x_most, message);
  if (status != TP_OK || low.begins == high.begins) return status;
  status = part(&low, &high, r, message);
  if (status == TP_OK) status = add_curve(r, low.width, message);
  if (status != TP_OK) return status;
  const double half = (high.width - low.width) / 2;
  const tp_bounded root = {.value = low.width + half, .error = half + 0x1p-52 * high.width};
  begin_border(r, tp_line_dynamic, "", low.upright, high.upright);
  tp_chart_add_point(r->chart, root, low.onset_deg);
  tp_chart_add_point(r->chart, root, tp_chart_exactly(r->y_most));
  return TP_OK;
}

/* ---- rough base ---------------------------------------------------------------------------------
 */

/* Even numbers of flanks, `step` apart. */
static tp_toothed_question sawtooth(const tp_mechanisms_rest *r, tp_toe_kind toe, int flanks) {
  const double i = r->options->roughness_angle_deg / tp_degrees_of_radian,
               amplitude = r->options->amplitude;
  return (tp_toothed_question){.block = {flanks * amplitude / tan(i), amplitude, (size_t)flanks},
                               .toe = toe,
                               .friction_deg = r->options->friction_deg};
}

/* The most flanks of a block within the map, and how far apart to take them; 0 where there are no
 * teeth, or where they are too fine to be solved one by one. */
static int most_flanks(int *step, const tp_mechanisms_rest *r) {
  const tp_chart_mechanisms_options *o = r->options;
  *step = 2;
  if (!(o->amplitude > 0 && o->roughness_angle_deg > 0)) return 0;
  const double most = r->x_most * tan(o->roughness_angle_deg / tp_degrees_of_radian) / o->amplitude;
  if (most > FLANKS_MAX) return 0;
  *step = 2 * (int)fmax(1, ceil(most / (2 * BLOCKS_MAX)));
  return (int)most;
}

static tp_status add_toe(const tp_mechanisms_rest *r, tp_toe_kind toe, tp_chart_style style,
                         tp_message *message) {
  border_list list = {0};
  char name[40];
  int step = 0;
  const int most = most_flanks(&step, r);
  tp_status status = TP_OK;
  for (int n = step; n <= most && status == TP_OK; n += step) {
    const tp_toothed_question question = sawtooth(r, toe, n);
    status = tp_toothed_borders(list.items, &list.count, BORDERS_MAX, &question, message);
  }
  snprintf(name, sizeof name, " about the %s", tp_toe_names[toe]);
  if (status == TP_OK) add_borders(r, style, name, &list);
  return status;
}

/* About a valley a block of so many flanks may move below both formulas. */
static tp_status add_onset(const tp_mechanisms_rest *r, tp_message *message) {
  int step = 0;
  const int most = most_flanks(&step, r);
  if (most < step) return TP_OK;
  begin_series(r, tp_line_onset, "certain to stand, valley");
  for (int n = step; n <= most; n += step) {
    const tp_toothed_question question = sawtooth(r, TP_TOE_VALLEY, n);
    tp_solution *solution = NULL;
    const tp_status status = tp_toothed_solve(&solution, &question, message);
    if (status != TP_OK) return status;
    const tp_onset *onset = &solution->cases[0].onset;
    if (onset->kind == TP_ONSET_AT_ANGLE) {
      tp_chart_add_point(r->chart, tp_chart_exactly(question.block.inverse_slenderness),
                         onset->critical_angle_deg);
    }
    tp_solution_free(solution);
  }
  return TP_OK;
}

tp_status tp_mechanisms_rest_rough(const tp_mechanisms_rest *r, tp_message *message) {
  tp_status status = add_toe(r, TP_TOE_PEAK, tp_line_dynamic, message);
  if (status == TP_OK) status = add_toe(r, TP_TOE_VALLEY, tp_line_dynamic_valley, message);
  if (status == TP_OK) status = add_onset(r, message);
  return status;
}
