/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outlines of figures as chains of straight and curved steps; arcs become cubic curves. */

#include "shape/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool add(tp_chain *chain, tp_chain_node node) {
  if (chain->count == chain->capacity) {
    const size_t capacity = chain->capacity == 0 ? 32 : 2 * chain->capacity;
    tp_chain_node *nodes = realloc(chain->nodes, capacity * sizeof *nodes);
    if (nodes == NULL) return false;
    chain->nodes = nodes;
    chain->capacity = capacity;
  }
  chain->nodes[chain->count++] = node;
  return true;
}

bool tp_chain_add(tp_chain *chain, tp_chain_step step, tp_spot at) {
  return add(chain, (tp_chain_node){step, at, {at, at}});
}

/* A cubic curve whose controls lie 4/3 tan(t / 4) half-axes along the tangents leaves an arc of t
 * radians by less than 5e-6 of its radius up to an eighth of a turn. */
bool tp_chain_add_arc(tp_chain *chain, tp_spot centre, double half_x, double half_y, double from,
                      double sweep) {
  const double eighth = atan(1);
  const int pieces = 1 + (int)fmin(fabs(sweep) / eighth, 8);
  const double piece = sweep / pieces, reach = 4.0 / 3 * tan(piece / 4);
  for (int k = 0; k < pieces; k++) {
    const double a = from + k * piece, b = a + piece;
    tp_chain_node node = {.step = TP_STEP_CURVE};
    node.at = (tp_spot){centre.x + half_x * cos(b), centre.y + half_y * sin(b)};
    node.control[0] = (tp_spot){centre.x + half_x * (cos(a) - reach * sin(a)),
                                centre.y + half_y * (sin(a) + reach * cos(a))};
    node.control[1] = (tp_spot){centre.x + half_x * (cos(b) + reach * sin(b)),
                                centre.y + half_y * (sin(b) - reach * cos(b))};
    if (!add(chain, node)) return false;
  }
  return true;
}

void tp_chain_clear(tp_chain *chain) {
  free(chain->nodes);
  memset(chain, 0, sizeof *chain);
}
