/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Positions of the four blocks by the rules of the header, verdicts by sliding at phi + i and
 * toppling about valley, planar and peak toes, and the motions that begin from rest. */

#include "paper/table_7.h"
#include "paper/teeth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const printed[TP_TABLE_7_BLOCKS][2] = {{"slides", "stable"},
                                                          {"slides", "stable, topples if valley"},
                                                          {"slides", "topples, stable if peak"},
                                                          {"slides", "stable, topples if valley"}};

/* By sliding, and by how many of the axes valley, planar, peak it topples about. */
static const char *const verdicts[2][4] = {
    {"stable", "stable, topples if valley", "topples, stable if peak", "topples"},
    {"slides", "slides, topples too if valley", "slides and topples, slides if peak",
     "slides and topples"}};

tp_table_7_block tp_table_7_locate(int number, const tp_chart_mechanisms_options *o) {
  const double sliding = o->friction_deg + o->roughness_angle_deg;
  const bool steep = number == 2 || number == 3;
  tp_table_7_block block = {.number = number,
                            .tilt_deg = steep ? sliding - 1 : o->friction_deg + 1};
  const double along = tan(block.tilt_deg / tp_degrees_of_radian), a = o->amplitude;
  switch (number) {
  case 1:
    block.inverse_slenderness = 1.1 * tan(sliding / tp_degrees_of_radian);
    break;
  case 2:
    block.inverse_slenderness = 1.001 * tan(sliding / tp_degrees_of_radian);
    break;
  case 3:
    block.inverse_slenderness = along * (1 - (a + a * a / 12) / 2);
    break;
  default:
    block.inverse_slenderness = along * (1 + (a - a * a / 12) / 2);
  }
  return block;
}

/* What begins on the planar base at the block's tilt: the motions that can. */
static tp_status from_rest(char text[TP_MOTIONS_NAME_SIZE], const tp_table_7_block *block,
                           double friction_deg, tp_message *message) {
  const tp_toothed_question question = {.block = {block->inverse_slenderness, 0, 2},
                                        .toe = TP_TOE_PLANAR,
                                        .friction_deg = friction_deg,
                                        .tilt_deg = block->tilt_deg};
  tp_solution *solution = NULL;
  const tp_status status = tp_toothed_solve(&solution, &question, message);
  if (status != TP_OK) return status;
  const tp_onset *onset = &solution->cases[0].onset;
  unsigned motions = 0;
  for (size_t k = 0; k < onset->motion_count; k++) motions |= 1U << onset->motions[k].mechanism;
  tp_motions_name(text, motions);
  if (motions == 0) snprintf(text, TP_MOTIONS_NAME_SIZE, "stable");
  tp_solution_free(solution);
  return TP_OK;
}

tp_status tp_table_7_judge(tp_table_7_verdict *verdict, const tp_table_7_block *block,
                           const tp_chart_mechanisms_options *o, bool rough, tp_message *message) {
  static const tp_toe_kind rising[3] = {TP_TOE_VALLEY, TP_TOE_PLANAR, TP_TOE_PEAK};
  const tp_toothed toothed = {block->inverse_slenderness, rough ? o->amplitude : 0, 2};
  const double sliding = o->friction_deg + (rough ? o->roughness_angle_deg : 0);
  int topples = 0;
  for (int k = 0; k < 3; k++) {
    tp_bounded angle = {0};
    const tp_status status = tp_toothed_critical_angle(&angle, &toothed, rising[k], message);
    if (status != TP_OK) return status;
    topples += angle.value < block->tilt_deg;
  }
  verdict->program = verdicts[block->tilt_deg > sliding][topples];
  tp_status status = TP_OK;
  if (!rough) status = from_rest(verdict->from_rest, block, o->friction_deg, message);
  verdict->paper = printed[block->number - 1][rough];
  verdict->agrees = strcmp(verdict->paper, verdict->program) == 0 ||
                    (!rough && strcmp(verdict->paper, verdict->from_rest) == 0);
  return status;
}
