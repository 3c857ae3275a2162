/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks are let go from forces that are not there of themselves: by friction alone they could jam.
 * From a motion that is proven the modes of its contacts are tried at lesser numbers, by halving;
 * where they end the blocks are let go once more, from the forces that there were. */

#include "block_system/moving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 3000, MOST_MOTIONS = 12 };

void tp_moving_clear(tp_moving_search *m) {
  tp_blocks_at_clear(&m->at);
  tp_letting_go_clear(&m->letting_go);
  tp_rigid_groups_clear(&m->groups);
  free(m->modes);
  free(m->trial);
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
  m->x = INFINITY;
  m->modes = calloc((size_t)r->contact_count + 1, sizeof *m->modes);
  m->trial = calloc((size_t)r->contact_count + 1, sizeof *m->trial);
  m->proven = calloc((size_t)r->contact_count + 1, sizeof *m->proven);
  m->accelerations = calloc((size_t)r->rows + 1, sizeof *m->accelerations);
  m->tried = calloc((size_t)r->rows + 1, sizeof *m->tried);
  tp_status status = tp_letting_go_init(&m->letting_go, r, message);
  if (status == TP_OK) status = tp_rigid_groups_init(&m->groups, r, message);
  if (status == TP_OK && (!tp_blocks_at_init(&m->at, r) || m->modes == NULL || m->trial == NULL ||
                          m->proven == NULL || m->accelerations == NULL || m->tried == NULL)) {
    status = tp_fail_memory(message, "the motions");
  }
  if (status != TP_OK) tp_moving_clear(m);
  return status;
}

static tp_status prove_trial(tp_moving_search *m, double x, tp_message *message) {
  bool proven = false, exists = false;
  tp_status status = m->state(&exists, &m->at, m->context, x, message);
  if (status != TP_OK || !exists) return status;
  const tp_beginning_question q = {.groups = &m->groups,
                                   .friction = m->at.friction,
                                   .cohesion = m->at.cohesion,
                                   .bond = m->at.has_bond ? m->at.bond : NULL,
                                   .piece = m->at.piece,
                                   .loads = m->at.central,
                                   .normals = m->letting_go.normals,
                                   .shears = m->letting_go.shears};
  status = tp_beginning_prove(&proven, m->tried, m->trial, &q, message);
  if (status != TP_OK || !proven) return status;
  m->found = true;
  m->x = x;
  memcpy(m->proven, m->trial, (size_t)m->resting->contact_count * sizeof *m->trial);
  memcpy(m->accelerations, m->tried, (size_t)m->resting->rows * sizeof *m->tried);
  return TP_OK;
}

tp_status tp_moving_prove(tp_moving_search *m, double x, const tp_trial_mode *trial,
                          tp_message *message) {
  memcpy(m->trial, trial, (size_t)m->resting->contact_count * sizeof *m->trial);
  return prove_trial(m, x, message);
}

tp_status tp_moving_prove_modes(tp_moving_search *m, double x, const tp_mode_set *modes,
                                tp_message *message) {
  for (long k = 0; k < m->resting->contact_count; k++) {
    m->trial[k] = (tp_trial_mode){.mode = modes[k]};
  }
  return prove_trial(m, x, message);
}

/* From the forces that there are to those of the laws; a motion is to be proven. */
static tp_status let_go(tp_moving_search *m, double x, tp_message *message) {
  const tp_shear_strength strength = {m->at.friction, m->at.cohesion,
                                      m->at.has_bond ? m->at.bond : NULL};
  if (!tp_letting_go_find(&m->letting_go, &strength, m->at.loads, ROUNDS)) {
    return tp_fail_memory(message, "the motions");
  }
  if (!tp_letting_go_moves(&m->letting_go)) return TP_OK;
  tp_letting_go_modes(m->modes, &m->letting_go, &strength);
  return tp_moving_prove_modes(m, x, m->modes, message);
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

static bool has_pairs(const tp_moving_search *m) {
  return m->resting->pair_first < m->resting->contact_count;
}

/* From no forces in six ways, the last two for pairs of corners: each, or each other one. */
static tp_status try_ways(tp_moving_search *m, double x, int step, tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < (has_pairs(m) ? 6 : 4) && status == TP_OK && m->x > x; k += step) {
    m->letting_go.backwards = k < 4 && k % 2 == 1;
    m->letting_go.corners = k < 4    ? TP_CORNERS_AS_THEY_OPEN
                            : k == 4 ? TP_CORNERS_FIRST_SIDE
                                     : TP_CORNERS_SECOND_SIDE;
    status = let_go_from_nothing(m, x, k < 2 || k >= 4, message);
  }
  return status;
}

tp_status tp_moving_try(tp_moving_search *m, double x, bool from_nothing, tp_message *message) {
  bool exists = false;
  const tp_status status = m->state(&exists, &m->at, m->context, x, message);
  if (status != TP_OK || !exists) return status;
  return from_nothing ? try_ways(m, x, 1, message) : let_go(m, x, message);
}

tp_status tp_moving_try_few(tp_moving_search *m, double x, tp_message *message) {
  bool exists = false;
  const tp_status status = m->state(&exists, &m->at, m->context, x, message);
  return status == TP_OK && exists ? try_ways(m, x, 2, message) : status;
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

/* Past where two motions are told apart. How much a corner bears, and how much an end in its point,
 * makes motions of the same modes: nearer ones too where there are such. */
static tp_status go_over(tp_moving_search *m, double least, double width, tp_message *message) {
  static const double away = 1024, nearer = 64; /* widths */
  const double from = m->x;
  tp_status status = TP_OK;
  for (int k = 0; k < (has_pairs(m) ? 2 : 1) && status == TP_OK && m->x >= from; k++) {
    const double next = fmax(least, from - away * width / pow(nearer, k));
    status = tp_moving_try(m, next, false, message);
    if (status == TP_OK && m->x >= from) status = tp_moving_try(m, next, true, message);
  }
  return status;
}

/* Down along the motion that is found, and along those that it goes over into; `low`: it is not
 * proven there. */
static tp_status go_down(tp_moving_search *m, double *low, double least, double width,
                         tp_message *message) {
  static const double coarse = 256; /* widths */
  tp_status status = TP_OK;
  for (int k = 0; k < MOST_MOTIONS && status == TP_OK; k++) {
    *low = least;
    status = tp_moving_prove(m, least, m->proven, message);
    if (status != TP_OK || m->x <= least) return status;
    status = halve(m, low, coarse * width, message);
    const double from = m->x;
    if (status == TP_OK) status = go_over(m, least, width, message);
    if (m->x >= from) break;
  }
  return status;
}

/* Where a motion ends, another may begin farther down. What is proven stays so: the more is tried,
 * the less is the x at the end. */
tp_status tp_moving_follow(tp_moving_search *m, double least, double width, tp_message *message) {
  static const double leaps[] = {2e5, 1.4e5, 1e5, 7e4, 5e4, 3e4, 2e4, 1e4}; /* widths */
  enum { LEAPS = sizeof leaps / sizeof *leaps };
  double low = least;
  tp_status status = go_down(m, &low, least, width, message);
  for (int k = 0; k < LEAPS && status == TP_OK && m->x > least; k++) {
    const double from = m->x, to = fmax(least, from - leaps[k] * width);
    status = tp_moving_try(m, to, true, message);
    if (status != TP_OK || m->x >= from) continue;
    status = go_down(m, &low, least, width, message);
    k = -1;
  }
  return status == TP_OK ? halve(m, &low, width, message) : status;
}
