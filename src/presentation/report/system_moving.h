/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where blocks that begin to move are seen: the view of a drawing that moves. On the page y is
 * down. */

#ifndef TP_REPORT_SYSTEM_MOVING_H
#define TP_REPORT_SYSTEM_MOVING_H

#include "shape/block_shapes.h"

/* Sizes in units of the drawing: of all free blocks, of the margins around them, of what is said
 * above. */
enum { TP_MOVING_SIZE = 420, TP_MOVING_MARGIN = 34, TP_MOVING_HEAD = 62 };

typedef struct tp_moving_view {
  const tp_block_system *system;
  const tp_system_case *own;
  const tp_block_shapes *shapes;
  const tp_system_motion *motions; /* by block */
  bool is_start;                   /* accelerations from rest; else velocities of the collapse */
  double moved;                    /* the way of the fastest corner, units of the shapes */
  double sine, cosine; /* of the turn of all, counter-clockwise, so that gravity points down */
  tp_box box;          /* around free blocks, turned, before and after */
  double left;         /* on the page */
} tp_moving_view;

/* Sets the way, the turn and the box. */
void tp_moving_set_up(tp_moving_view *view);
double tp_moving_width(const tp_moving_view *view);
double tp_moving_height(const tp_moving_view *view);

/* A vector turned as all is, and a spot of the blocks at rest on the page. */
tp_spot tp_moving_turned(const tp_moving_view *view, tp_spot vector);
tp_spot tp_moving_on_page(const tp_moving_view *view, tp_spot at);

/* Does a block move, and by how many radians is it turned at the end, counter-clockwise? */
bool tp_moving_moves(const tp_moving_view *view, size_t block);
double tp_moving_turn(const tp_moving_view *view, size_t block);

#endif
