/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motion that is proven is followed down, and just below its end all motions are excluded. What
 * the exclusion leaves is tried as a motion, and followed in its turn. Following leaps: between its
 * end and where the blocks are there may be numbers at which no motion can begin. Of few blocks
 * those are looked for at intervals; the window ends above the highest. */

#include "block_system/onset_window.h"

#include "block_system/from_limit.h"
#include "common/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 8, INTERVALS = 32 };

/* A motion where it was first proven: its modes, and the forces that its proof began with. */
typedef struct first_motion {
  tp_trial_mode *modes;
  tp_letting_go forces;
} first_motion;

static tp_status first_init(first_motion *first, const tp_resting *r, tp_message *message) {
  *first = (first_motion){.modes = calloc((size_t)r->contact_count + 1, sizeof *first->modes)};
  if (first->modes == NULL) return tp_fail_memory(message, "the motions");
  const tp_status status = tp_letting_go_init(&first->forces, r, message);
  if (status != TP_OK) free(first->modes);
  return status;
}

static void first_clear(first_motion *first) {
  tp_letting_go_clear(&first->forces);
  free(first->modes);
}

static void first_keep(first_motion *first, const tp_moving_search *m) {
  memcpy(first->modes, m->proven, (size_t)m->resting->contact_count * sizeof *first->modes);
  tp_letting_go_copy(&first->forces, &m->letting_go);
}

static tp_status first_prove(tp_moving_search *m, double x, const first_motion *first,
                             tp_message *message) {
  tp_letting_go_copy(&m->letting_go, &first->forces);
  return tp_moving_prove(m, x, first->modes, message);
}

/* Just below the end of the motion, and farther. */
static tp_status exclude_below(tp_onset_window *w, tp_moving_search *m, tp_standing_search *s,
                               double least, tp_message *message) {
  static const double growth = 8, nearest = 4; /* widths */
  double away = nearest * w->width;
  tp_status status = TP_OK;
  w->has_stands = false;
  for (int k = 0; k < ROUNDS && status == TP_OK && m->x > least; k++) {
    const double at = fmax(least, m->x - away);
    bool proven = false;
    if (s->work > s->most_work) break;
    status = tp_standing_prove(&proven, s, at, at, message);
    if (status != TP_OK) break;
    if (proven) {
      w->has_stands = true;
      w->stands = at;
      break;
    }
    const double before = m->x;
    if (s->left[0] != 0) status = tp_moving_prove_modes(m, at, s->left, message);
    if (status == TP_OK && m->found && m->x < before) {
      status = tp_moving_follow(m, least, w->width, message);
    } else {
      away *= growth;
    }
  }
  return status;
}

/* Of few blocks proofs are cheap: the stretch between both is halved. */
static tp_status narrow(tp_onset_window *w, tp_moving_search *m, tp_standing_search *s,
                        tp_message *message) {
  enum { HALVINGS = 10 };
  tp_status status = TP_OK;
  for (int k = 0; k < HALVINGS && status == TP_OK && w->has_stands; k++) {
    const double middle = w->stands + (m->x - w->stands) / 2;
    bool stands = false;
    status = tp_standing_prove(&stands, s, middle, middle, message);
    if (stands) w->stands = middle;
    if (status != TP_OK || stands || !m->found) continue;
    status = tp_moving_prove(m, middle, m->proven, message);
    if (m->x > middle) break;
  }
  return status;
}

/* The greatest number of a row between two at which no motion can begin. */
static tp_status find_gap(bool *found, double *gap, const tp_onset_window *w, tp_standing_search *s,
                          double low, tp_message *message) {
  tp_status status = TP_OK;
  *found = false;
  for (int k = 1; k < INTERVALS && !*found && status == TP_OK; k++) {
    const double at = w->from - (w->from - low) * k / INTERVALS;
    if (w->from - at < w->width || s->work > s->most_work) break;
    status = tp_standing_prove(found, s, at, at, message);
    if (*found) *gap = at;
  }
  return status;
}

/* The highest gap ends the window: what is below it is another one. A motion was proven at `from`,
 * so the window reaches that, even where the proof does not succeed once more. */
static tp_status find_from(tp_onset_window *w, tp_moving_search *m, tp_standing_search *s,
                           const first_motion *first, tp_message *message) {
  double least = w->least;
  tp_status status = TP_OK;
  for (int k = 0; k < ROUNDS && status == TP_OK; k++) {
    bool has_gap = false;
    double gap = least;
    if (m->found) status = tp_moving_follow(m, least, w->width, message);
    if (status == TP_OK) status = exclude_below(w, m, s, least, message);
    if (status != TP_OK || !w->is_few) break;
    status = find_gap(&has_gap, &gap, w, s, m->x, message);
    if (status != TP_OK || !has_gap) break;
    least = gap;
    w->has_stands = true;
    w->stands = gap;
    m->x = w->collapses ? w->from : INFINITY;
    status = first_prove(m, w->from, first, message);
    if (status == TP_OK && m->x > w->from) {
      m->x = w->from;
      break;
    }
  }
  if (status == TP_OK && w->is_few) status = narrow(w, m, s, message);
  w->moves = fmin(m->x, w->from);
  w->reaches = m->x <= w->least;
  return status;
}

/* Beyond `from` there is one, though it may not be found: then all are excluded below it. */
static tp_status find_beyond(tp_onset_window *w, tp_moving_search *m, tp_message *message) {
  static const double steps = 1e3; /* widths */
  const tp_moving_range r = {.from = w->from,
                             .least = w->least,
                             .limit = w->from,
                             .width = w->width,
                             .step = steps * w->width};
  m->x = INFINITY;
  m->found = false;
  const tp_status status = tp_moving_from_limit(m, &r, w->least, message);
  m->x = fmin(m->x, w->from);
  return status;
}

static tp_status find_as_they_are(tp_onset_window *w, tp_moving_search *m,
                                  const first_motion *first, tp_message *message) {
  m->x = INFINITY;
  const tp_status status = first_prove(m, w->from, first, message);
  return status == TP_OK && m->x > w->from ? tp_moving_try(m, w->from, true, message) : status;
}

tp_status tp_onset_window_find(tp_onset_window *w, tp_moving_search *m, tp_standing_search *s,
                               tp_message *message) {
  first_motion first;
  tp_status status = first_init(&first, m->resting, message);
  if (status != TP_OK) return status;
  first_keep(&first, m);
  w->has_stands = w->reaches = false;
  status = w->collapses ? find_beyond(w, m, message) : find_as_they_are(w, m, &first, message);
  w->moves = w->from;
  if (status == TP_OK && m->x <= w->from) {
    first_keep(&first, m);
    status = find_from(w, m, s, &first, message);
  }
  first_clear(&first);
  return status;
}
