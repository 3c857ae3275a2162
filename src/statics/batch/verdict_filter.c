/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline is read as for its critical angle (batch/turning.c): a simple polygon, whose
 * underside runs one way and can be turned about at its end down-dip. Its moments are those of
 * batch/area.c; contact, limit, onset and factors are those of a case filter. */

#include "batch/verdict_filter.h"

#include "batch/area.h"
#include "case_filter/block_filter.h"
#include "number/near_angle.h"

#include <math.h>

/* As tp_solve_options has it: nine digits; a tenth of that is left to what it tells. */
static const double most_error = 1e-10;

static tp_near near_of(tp_bounded number) {
  return (tp_near){number.value, number.error};
}

/* Lengths and areas that no sum of products makes under- or overflow. */
static bool is_moderate(const tp_area_moments *m) {
  static const double least = 1e-12, most = 1e12;
  const double far = fmax(fabs(m->centroid_x.value), fabs(m->centroid_y.value));
  return m->area.value >= least && m->area.value <= most && far <= most;
}

/* In the order of the outline or against it. */
static void set_underside(tp_block_underside *u, double x[], double y[], tp_vertices vertices,
                          const tp_block_turning *turning) {
  const long count = (long)vertices.count;
  long at = turning->first;
  u->count = turning->edges + 1;
  for (int k = 0; k < u->count; k++) {
    x[k] = vertices.xy[2 * at];
    y[k] = vertices.xy[2 * at + 1];
    at = turning->counter_clockwise ? (at + 1 == count ? 0 : at + 1)
                                    : (at == 0 ? count - 1 : at - 1);
  }
  u->x = x;
  u->y = y;
}

static bool is_certain(tp_near number) {
  return number.error <= most_error * fabs(number.value);
}

static bool is_certain_factor(tp_fos_told fos) {
  return fos.state != TP_FOS_NUMBER || is_certain(fos.value);
}

static bool are_certain(const tp_block_told *told) {
  const tp_case_told *of = &told->of;
  if (of->never_topples || !is_certain(of->moments_deg) || !is_certain(of->limit_deg)) return false;
  if (!of->never && !is_certain(of->onset_deg)) return false;
  return !told->has_tilt ||
         (is_certain_factor(told->at.fos) && is_certain_factor(told->at.by_moments) &&
          is_certain_factor(told->at.by_shear));
}

/* Is it an angle that every scene takes? */
static bool is_taken(double degrees, double least) {
  static const double most = 89;
  return degrees >= least && degrees <= most;
}

static double tangent_of(double degrees) {
  tp_near sine, cosine;
  tp_near_sin_cos(&sine, &cosine, (tp_near){degrees, 0});
  return sine.value / cosine.value;
}

static bool tell(tp_block_told *told, tp_case_filter *filter, const tp_block_underside *underside,
                 tp_direction towards, double friction_deg, double tilt_deg) {
  static const double least = 1e-6;
  const tp_case_sample sample = {.friction_deg = {friction_deg, 0}};
  told->has_tilt = !isnan(tilt_deg);
  return is_taken(friction_deg, least) &&
         (!told->has_tilt || tilt_deg == 0 || is_taken(tilt_deg, least)) &&
         tp_block_filter_init(filter, underside, towards, tangent_of(friction_deg)) &&
         tp_case_filter_tell(&told->of, filter, &sample) &&
         (!told->has_tilt ||
          tp_case_filter_tell_at(&told->at, &told->of, (tp_near){tilt_deg, 0})) &&
         are_certain(told);
}

tp_status tp_verdict_filter(tp_block_told *told, tp_case_filter *filter, tp_workspace *workspace,
                            tp_vertices vertices, const tp_turning_task *task, double friction_deg,
                            double tilt_deg, tp_message *message) {
  enum { MOST = TP_REST_FACETS + 1 };
  double x[MOST], y[MOST];
  tp_block_turning turning;
  tp_area_moments moments;
  tp_area_centre centre;
  tp_block_underside underside;
  tp_status status = tp_turning_filter(&turning, workspace, vertices, task, message);
  if (status == TP_NO_ANSWER || (status == TP_OK && turning.edges >= MOST)) return TP_UNDECIDED;
  if (status == TP_OK)
    status = tp_area_filter(&moments, &centre, workspace, vertices, task->kernel, message);
  if (status != TP_OK) return status;
  set_underside(&underside, x, y, vertices, &turning);
  underside.origin_x = centre.origin_x;
  underside.origin_y = centre.origin_y;
  underside.centroid_x = near_of(centre.x);
  underside.centroid_y = near_of(centre.y);
  underside.gyration =
      tp_near_div(tp_near_add(near_of(moments.second_moment_xx), near_of(moments.second_moment_yy)),
                  near_of(moments.area));
  return is_moderate(&moments) &&
                 tell(told, filter, &underside, task->towards, friction_deg, tilt_deg)
             ? TP_OK
             : TP_UNDECIDED;
}
