/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "study/table_7.h"
#include "study/dynamic_border.h"
#include "study/teeth.h"

#include <math.h>
#include <string.h>

static const double degree = 57.29577951308232;
static const double rectangle_kappa = 0.25;

static const char *const printed[TP_TABLE_7_BLOCKS][2] = {{"slides", "stable"},
                                                          {"slides", "stable, topples if valley"},
                                                          {"slides", "topples, stable if peak"},
                                                          {"slides", "stable, topples if valley"}};

/* By sliding, and by how many of the axes valley, planar, peak it topples about. */
static const char *const verdicts[2][4] = {
    {"stable", "stable, topples if valley", "topples, stable if peak", "topples"},
    {"slides", "slides, topples too if valley", "slides and topples, slides if peak",
     "slides and topples"}};

tp_table_7_block tp_table_7_place(int number, const tp_chart_mechanisms_options *o) {
  const double sliding = o->friction_deg + o->roughness_angle_deg;
  const bool steep = number == 2 || number == 3;
  tp_table_7_block block = {.number = number,
                            .tilt_deg = steep ? sliding - 1 : o->friction_deg + 1};
  const double along = tan(block.tilt_deg / degree), a = o->amplitude;
  switch (number) {
  case 1:
    block.inverse_slenderness = 1.1 * tan(sliding / degree);
    break;
  case 2:
    block.inverse_slenderness = 1.001 * tan(sliding / degree);
    break;
  case 3:
    block.inverse_slenderness = along * (1 - (a + a * a / 12) / 2);
    break;
  default:
    block.inverse_slenderness = along * (1 + (a - a * a / 12) / 2);
  }
  return block;
}

static const char *from_rest(double delta, double friction, double tilt) {
  if (tilt <= fmin(delta, friction)) return "stable";
  if (friction <= delta) return "slides";
  return tilt <= tp_dynamic_border_deg(delta, rectangle_kappa, friction) ? "topples"
                                                                         : "slides and topples";
}

tp_status tp_table_7_judge(tp_table_7_verdict *verdict, const tp_table_7_block *block,
                           const tp_chart_mechanisms_options *o, bool rough, tp_message *message) {
  static const tp_toe_kind rising[3] = {TP_TOE_VALLEY, TP_TOE_PLANAR, TP_TOE_PEAK};
  const tp_toothed toothed = {block->inverse_slenderness, rough ? o->amplitude : 0, 2};
  const double sliding = o->friction_deg + (rough ? o->roughness_angle_deg : 0);
  double planar = 0;
  int topples = 0;
  for (int k = 0; k < 3; k++) {
    tp_bounded angle = {0};
    const tp_status status = tp_toothed_critical_angle(&angle, &toothed, rising[k], message);
    if (status != TP_OK) return status;
    if (rising[k] == TP_TOE_PLANAR) planar = angle.value;
    topples += angle.value < block->tilt_deg;
  }
  verdict->program = verdicts[block->tilt_deg > sliding][topples];
  verdict->from_rest = rough ? NULL : from_rest(planar, o->friction_deg, block->tilt_deg);
  verdict->paper = printed[block->number - 1][rough];
  verdict->agrees = strcmp(verdict->paper, verdict->program) == 0 ||
                    (!rough && strcmp(verdict->paper, verdict->from_rest) == 0);
  return TP_OK;
}
