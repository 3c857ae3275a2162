/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The geometry of a problem as chains of doubles, for drawing alone.
 *
 * Lengths are in units of the block's size (the larger of its width and height) from the local
 * origin of its lattice, which is subtracted exactly: a block far from the origin of its scene is
 * drawn as well as one near it. */

#ifndef TP_SHAPE_SHAPE_H
#define TP_SHAPE_SHAPE_H

#include "problem/problem.h"

typedef struct tp_spot {
  double x, y;
} tp_spot;

typedef struct tp_box {
  double x0, y0, x1, y1;
} tp_box;

/* How a chain gets to a node: by a jump that begins a new piece, straight, or by a cubic curve. */
typedef enum tp_chain_step { TP_STEP_JUMP, TP_STEP_LINE, TP_STEP_CURVE } tp_chain_step;

typedef struct tp_chain_node {
  tp_chain_step step;
  tp_spot at, control[2];
} tp_chain_node;

typedef struct tp_chain {
  bool closed; /* every piece of it */
  size_t count, capacity;
  tp_chain_node *nodes;
} tp_chain;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_chain_add(tp_chain *chain, tp_chain_step step, tp_spot at);

/* An arc of an ellipse with half-axes along x and y, from the parameter `from` on by `sweep`
 * radians, as cubic curves; the chain ends where the arc begins. */
TP_MUST_USE bool tp_chain_add_arc(tp_chain *chain, tp_spot centre, double half_x, double half_y,
                                  double from, double sweep);
void tp_chain_clear(tp_chain *chain);

typedef struct tp_shape {
  double unit_m, origin_x_m, origin_y_m;
  tp_spot drawn_origin_m, axis; /* among the results: the origin, and the direction of x */
  tp_chain outline;             /* the block with its holes */
  size_t part_count;
  tp_chain *parts;
  tp_chain base;     /* the profile from left to right */
  tp_chain contact;  /* facets of positive length */
  tp_chain elements; /* sides of the account's elements, where they were asked for */
  tp_box box;        /* around the block's vertices */
} tp_shape;

/* What is done with the shape of a solved scene, and doing it. */
typedef tp_status tp_shape_work(const tp_problem *problem, const tp_shape *shape, void *context,
                                tp_message *message);
TP_MUST_USE tp_status tp_shape_work_on(const tp_scene *scene, const tp_solution *solution,
                                       tp_shape_work *work, void *context, tp_message *message);

/* The double nearest to a number; fmpq_get_d cuts off. */
double tp_shape_nearest(const fmpq_t value);

/* A point of the lattice, one of the results in metres, and one given exactly in scene lengths. */
tp_spot tp_shape_of_point(const tp_shape *shape, const tp_lattice *lattice, long point);
tp_spot tp_shape_of_metres(const tp_shape *shape, tp_bounded x_m, tp_bounded y_m);
tp_spot tp_shape_of_scene(const tp_shape *shape, const tp_problem *problem, const fmpq_t x,
                          const fmpq_t y);

#endif
