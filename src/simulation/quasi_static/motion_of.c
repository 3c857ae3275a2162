/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mechanism of a steady drift: its velocity is compared with the contacts that are closed or slip,
 * and the block slides, turns about a contact that rests, or does both. */

#include "quasi_static/drift.h"

#include <math.h>

/* Speeds of contact points below this share of the block's are none: ten times what a steady drift
 * may still change. Where the weight moves the drift is never steady. */
static const double no_speed = 1e-6, no_speed_moving = 1e-2;

typedef struct moving {
  tp_three velocity; /* of the centroid, of a length of 1 in all */
  double none;       /* speeds below it are */
  long closed;       /* ends of facets that are */
  bool turns_about;  /* one of them, which rests: */
  tp_xy centre;
} moving;

/* Is an end in keeping with the motion? */
static bool add_end(moving *m, const tp_joint_facet *facet, tp_xy at, bool closed) {
  const tp_xy velocity =
      tp_xy_plus((tp_xy){m->velocity.of[0], m->velocity.of[1]}, m->velocity.of[2], tp_xy_left(at));
  const double normal = tp_xy_dot(velocity, facet->normal);
  if (!closed) return normal >= -m->none;
  m->closed++;
  if (fabs(tp_xy_dot(velocity, facet->tangent)) <= m->none) {
    m->turns_about = true;
    m->centre = at;
  }
  return fabs(normal) <= m->none;
}

bool tp_path_motion_of(tp_path_motion *motion, const tp_path_state *state,
                       const tp_path_model *model, const tp_three *velocity) {
  const double x = velocity->of[0], y = velocity->of[1], turning = velocity->of[2];
  const double size = sqrt(x * x + y * y + turning * turning);
  moving m = {.velocity = {{x / size, y / size, turning / size}},
              .none = model->moves > 0 ? no_speed_moving : no_speed};
  bool kept = true;
  for (long k = 0; k < model->count; k++) {
    const tp_joint_facet *facet = model->facets + k;
    const tp_facet_state *at = state->facets + k;
    if (!add_end(&m, facet, facet->from, at->from_closed)) kept = false;
    if (!facet->in_a_point && !add_end(&m, facet, facet->to, at->to_closed)) kept = false;
  }
  const bool turns = fabs(m.velocity.of[2]) > m.none;
  const double extent_m = model->body->extent_m;
  if (!m.turns_about && turns) m.centre = (tp_xy){-y / turning, x / turning};
  *motion = (tp_path_motion){.mechanism = m.closed == 0   ? TP_LEAVES_BASE
                                          : !turns        ? TP_SLIDES
                                          : m.turns_about ? TP_TOPPLES
                                                          : TP_SLIDES_AND_TOPPLES,
                             .direction = {m.velocity.of[0], m.velocity.of[1]},
                             .turning_m = m.velocity.of[2],
                             .has_centre = turns,
                             .centre = {m.centre.x * extent_m, m.centre.y * extent_m}};
  return kept;
}
