/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The view of blocks that begin to move: displaced as rigid bodies by a share of the size of all,
 * or by less where one would turn too far, and the box around them before and after. */

#include "report/system_moving.h"

#include <math.h>

/* Shares of the size of all, and the most that a block turns, radians. */
static const double moved_of_all = 0.08, most_turn = 0.35;

tp_spot tp_moving_turned(const tp_moving_view *m, tp_spot p) {
  return (tp_spot){m->cosine * p.x - m->sine * p.y, m->sine * p.x + m->cosine * p.y};
}

tp_spot tp_moving_on_page(const tp_moving_view *m, tp_spot p) {
  const tp_spot own = tp_moving_turned(m, p);
  return (tp_spot){m->left + TP_MOVING_MARGIN + TP_MOVING_SIZE * (own.x - m->box.x0),
                   TP_MOVING_HEAD + TP_MOVING_SIZE * (m->box.y1 - own.y)};
}

bool tp_moving_moves(const tp_moving_view *m, size_t block) {
  return !m->system->blocks[block].ground && m->motions[block].mechanism != TP_STANDS;
}

double tp_moving_turn(const tp_moving_view *m, size_t block) {
  return m->moved * m->motions[block].turn_per_m * m->shapes->unit_m;
}

/* At the end of its motion. */
static tp_spot displaced(const tp_moving_view *m, size_t block, tp_spot p) {
  if (!tp_moving_moves(m, block)) return p;
  const tp_system_motion *own = m->motions + block;
  const tp_spot c = m->shapes->blocks[block].centroid;
  const double sine = sin(tp_moving_turn(m, block)), cosine = cos(tp_moving_turn(m, block));
  return (tp_spot){c.x + m->moved * own->velocity_x + cosine * (p.x - c.x) - sine * (p.y - c.y),
                   c.y + m->moved * own->velocity_y + sine * (p.x - c.x) + cosine * (p.y - c.y)};
}

static void take_in_spot(tp_box *box, tp_spot p) {
  *box = (tp_box){fmin(box->x0, p.x), fmin(box->y0, p.y), fmax(box->x1, p.x), fmax(box->y1, p.y)};
}

static void turn_all(tp_moving_view *m) {
  const double degree = atan(1) / 45;
  const double tilt =
      (m->is_start ? m->own->start.tilt_angle_deg : m->own->tilt_angle_deg.value) * degree;
  const double turn = m->own->towards == TP_TOWARDS_LEFT ? tilt : -tilt;
  m->sine = sin(turn);
  m->cosine = cos(turn);
}

void tp_moving_set_up(tp_moving_view *m) {
  turn_all(m);
  m->moved = moved_of_all;
  for (size_t k = 0; k < m->shapes->count; k++) {
    const double own = fabs(m->motions[k].turn_per_m) * m->shapes->unit_m;
    if (m->moved * own > most_turn) m->moved = most_turn / own;
  }
  m->box = (tp_box){INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (size_t k = 0; k < m->shapes->count; k++) {
    const tp_chain *chain = &m->shapes->blocks[k].outline;
    for (size_t n = 0; n < chain->count && !m->system->blocks[k].ground; n++) {
      take_in_spot(&m->box, tp_moving_turned(m, chain->nodes[n].at));
      take_in_spot(&m->box, tp_moving_turned(m, displaced(m, k, chain->nodes[n].at)));
    }
  }
}

double tp_moving_width(const tp_moving_view *m) {
  return TP_MOVING_SIZE * (m->box.x1 - m->box.x0) + 2 * TP_MOVING_MARGIN;
}

double tp_moving_height(const tp_moving_view *m) {
  return TP_MOVING_HEAD + TP_MOVING_SIZE * (m->box.y1 - m->box.y0) + TP_MOVING_MARGIN;
}
