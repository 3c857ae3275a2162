/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks are let go from forces that are not there of themselves: by friction alone they could jam.
 * From a motion that is proven the modes of its contacts are tried at lesser numbers, by halving;
 * where they end the blocks are let go once more, from the forces that there were. */

#include "block_system/moving.h"

#include "contact_modes/beginning.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 3000, MOST_MOTIONS = 12 };

void tp_moving_clear(tp_moving_search *m) {
  tp_blocks_at_clear(&m->at);
  tp_letting_go_clear(&m->letting_go);
  free(m->modes);
  free(m->proven);
  free(m->accelerations);
  free(m->tried);
  memset(m, 0, sizeof *m);
}

tp_status tp_moving_init(tp_moving_search *m, const tp_resting *r, tp_moving_state *state,
                         const void *context, tp_message *message) {
  memset(m, 0, sizeof *m);
  m->resting = r;
  m->state = state;
  m->context = context;
  m->modes = calloc((size_t)r->contact_count + 1, sizeof *m->modes);
  m->proven = calloc((size_t)r->contact_count + 1, sizeof *m->proven);
  m->accelerations = calloc((size_t)r->rows + 1, sizeof *m->accelerations);
  m->tried = calloc((size_t)r->rows + 1, sizeof *m->tried);
  tp_status status = tp_letting_go_init(&m->letting_go, r, message);
  if (status == TP_OK && (!tp_blocks_at_init(&m->at, r) || m->modes == NULL || m->proven == NULL ||
                          m->accelerations == NULL || m->tried == NULL)) {
    status = tp_fail_memory(message, "the motions");
  }
  if (status != TP_OK) tp_moving_clear(m);
  return status;
}

tp_status tp_moving_prove(tp_moving_search *m, double x, const tp_mode_set *modes,
                          tp_message *message) {
  bool proven = false, exists = false;
  tp_status status = m->state(&exists, &m->at, m->context, x, message);
  if (status != TP_OK || !exists) return status;
  const tp_beginning_question q = {.resting = m->resting,
                                   .modes = modes,
                                   .friction = m->at.friction,
                                   .loads = m->at.central,
                                   .normals = m->letting_go.normals,
                                   .shears = m->letting_go.shears};
  status = tp_beginning_prove(&proven, m->tried, &q, message);
  if (status != TP_OK || !proven) return status;
  m->found = true;
  m->x = x;
  memmove(m->proven, modes, (size_t)m->resting->contact_count * sizeof *modes);
  memcpy(m->accelerations, m->tried, (size_t)m->resting->rows * sizeof *m->tried);
  return TP_OK;
}

/* From the forces that there are to those of the laws; a motion is to be proven. */
static tp_status let_go(tp_moving_search *m, double x, tp_message *message) {
  if (!tp_letting_go_find(&m->letting_go, m->at.friction, m->at.loads, ROUNDS)) {
    return tp_fail_memory(message, "the motions");
  }
  if (!tp_letting_go_moves(&m->letting_go)) return TP_OK;
  tp_letting_go_modes(m->modes, &m->letting_go, m->at.friction);
  return tp_moving_prove(m, x, m->modes, message);
}

/* From the forces of blocks without friction, or from none: friction then has nothing to jam by
 * that is not there. */
static tp_status let_go_from_nothing(tp_moving_search *m, double x, bool frictionless,
                                     tp_message *message) {
  tp_letting_go_release(&m->letting_go);
  if (frictionless && !tp_letting_go_find(&m->letting_go, NULL, m->at.loads, ROUNDS / 4)) {
    return tp_fail_memory(message, "the motions");
  }
  return let_go(m, x, message);
}

tp_status tp_moving_try(tp_moving_search *m, double x, bool from_nothing, tp_message *message) {
  bool exists = false;
  tp_status status = m->state(&exists, &m->at, m->context, x, message);
  if (status != TP_OK || !exists) return status;
  if (!from_nothing) return let_go(m, x, message);
  for (int k = 0; k < 4 && status == TP_OK && !m->found; k++) {
    m->letting_go.backwards = k % 2 == 1;
    status = let_go_from_nothing(m, x, k < 2, message);
  }
  return status;
}

/* The least x at which the motion that is found is still proven, to such a width; it is not at
 * `low`. */
static tp_status halve(tp_moving_search *m, double *low, double width, tp_message *message) {
  tp_status status = TP_OK;
  while (status == TP_OK && m->x - *low > width) {
    const double middle = *low + (m->x - *low) / 2;
    status = tp_moving_prove(m, middle, m->proven, message);
    if (m->x > middle) *low = middle;
  }
  return status;
}

tp_status tp_moving_follow(tp_moving_search *m, double least, double width, tp_message *message) {
  static const double coarse = 256, away = 1024; /* widths: past where two motions are told apart */
  tp_status status = TP_OK;
  double low = least;
  for (int k = 0; k < MOST_MOTIONS && status == TP_OK; k++) {
    status = tp_moving_prove(m, least, m->proven, message);
    if (status != TP_OK || m->x <= least) return status;
    low = least;
    status = halve(m, &low, coarse * width, message);
    const double from = m->x;
    if (status == TP_OK)
      status = tp_moving_try(m, fmax(least, from - away * width), false, message);
    if (m->x >= from) break;
  }
  return status == TP_OK ? halve(m, &low, width, message) : status;
}
