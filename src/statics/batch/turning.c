/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical angle of a block on its mated base, decided in doubles with a proven bound.
 *
 * Underside: from the vertex with the least x + y to the one with the largest x - y, as
 * base/underside.c has it where no edge between the two runs back. Pivot: each vertex of it but one
 * end presses a facet down, so that end is the pivot, or none is (problem/admissible.c).
 * Angle (Eq. 2): with the pivot as origin the arms of the weight are X6 and Y6 over 3 A2
 * (block/ring_sums.h), so that the angle is the direction of (X6, Y6), and A2 gives their sign.
 *
 * Bound: the sums are within e_x and e_y of the truth. A vector of length r whose ends are known to
 * within d < r / 10 has its direction known to within asin(d / r) <= 1.01 d / r; here d <= e_x +
 * e_y, and r is at least the larger of its coordinates less d. To that comes the error of the
 * arctangent. What is not certain to 1e-9 of itself, or may lie on either side of 180 degrees, is
 * not decided here. */

#include "batch/turning.h"

#include "batch/simple.h"
#include "number/arctangent.h"

#include <math.h>

static const double most_error = 1e-9; /* as a share of the angle */

/* The direction of (cosine, sine), each within its error. */
static bool take_angle(tp_block_turning *turning, double sine, double cosine, double error) {
  const double up = fabs(sine), along = fabs(cosine), size = (up < along ? along : up) - error;
  if (!(error < 0.1 * size)) return false;
  if (cosine < 0 && !(up > error)) return false; /* 180 or -180 */
  turning->angle_deg = tp_arctangent_degrees(sine, cosine);
  turning->error_deg =
      57.9 * (error / size) + 1.01 * TP_ARCTANGENT_ERROR * fabs(turning->angle_deg);
  return turning->error_deg <= most_error * fabs(turning->angle_deg);
}

/* The underside as seen from the pivot, which is its left end (towards the left) or its right one,
 * in an outline that runs counter-clockwise, or not. */
static tp_scan_chain chain_of(const tp_scan *scan, bool left, bool counter_clockwise) {
  const long from = counter_clockwise ? scan->first : scan->last;
  const long to = counter_clockwise ? scan->last : scan->first;
  return (tp_scan_chain){.from = from,
                         .count = to - from + (to < from ? scan->count : 0),
                         .pivot = left ? scan->first : scan->last,
                         .forward = left == counter_clockwise,
                         .rightwards = left};
}

/* Of an outline that was read. */
static tp_status decide(tp_block_turning *turning, tp_scan *scan, const tp_turning_task *task) {
  const bool left = task->towards == TP_TOWARDS_LEFT;
  const long pivot = left ? scan->first : scan->last;
  const double scale = tp_scan_scale(scan);
  if (scale == 0 || scan->first < 0 || scan->last < 0 || scan->first == scan->last) {
    return TP_UNDECIDED;
  }
  tp_scan_shift(scan, scan->x[pivot], scan->y[pivot], scale, task->kernel);
  double sums[TP_AREA_SUM_COUNT], errors[TP_AREA_SUM_COUNT];
  tp_ring_sums_double_first(sums, errors, scan->u, scan->v, scan->count, false,
                            (tp_sums_plan){.sum_count = TP_AREA_SUM_COUNT, .threads = 1});
  if (!(fabs(sums[TP_A2]) > errors[TP_A2])) return TP_UNDECIDED;
  const bool counter_clockwise = sums[TP_A2] > 0;
  const tp_scan_answer turns =
      tp_scan_turn(scan, chain_of(scan, left, counter_clockwise), task->kernel);
  if (turns == TP_SCAN_OPEN) return TP_UNDECIDED;
  if (!task->simple && !tp_is_simple(scan->x, scan->y, scan->count)) return TP_UNDECIDED;
  if (turns == TP_SCAN_BLOCKED) return TP_NO_ANSWER;
  turning->pivot = pivot;
  turning->first = scan->first;
  turning->edges = (int)chain_of(scan, left, counter_clockwise).count;
  turning->counter_clockwise = counter_clockwise;
  const double sine = left == counter_clockwise ? sums[TP_X6] : -sums[TP_X6];
  const double cosine = counter_clockwise ? sums[TP_Y6] : -sums[TP_Y6];
  const bool certain = take_angle(turning, sine, cosine, errors[TP_X6] + errors[TP_Y6]);
  return certain ? TP_OK : TP_UNDECIDED;
}

tp_status tp_turning_filter(tp_block_turning *turning, tp_workspace *workspace,
                            tp_vertices vertices, const tp_turning_task *task,
                            tp_message *message) {
  *turning = (tp_block_turning){.angle_deg = NAN, .error_deg = NAN, .pivot = -1};
  if (vertices.count < 3) return TP_UNDECIDED;
  tp_scan scan;
  if (!tp_scan_read(&scan, workspace, vertices, task->kernel)) {
    return tp_fail_memory(message, "the vertices");
  }
  tp_block_turning own = *turning;
  const tp_status status = decide(&own, &scan, task);
  if (status == TP_OK) *turning = own;
  return status;
}
