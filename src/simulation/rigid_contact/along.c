/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Quintic Hermite polynomial of a step, gaps looked at eight times along it and where a cubic
 * through two looks is least, and root finding (number/root.h) for the share at which one closes.
 */

#include "rigid_contact/along.h"

#include "number/root.h"

#include <math.h>

enum { MOST_SAMPLES = 100 };

/* To which the share of a step is found at which a gap closes: the polynomial is no better. */
static const double near_share = 1e-7;

tp_motion_state tp_along_at(const tp_along *along, double share) {
  tp_motion_state state;
  const double s = share, h = along->step;
  for (int e = 0; e < 3; e++) {
    const double p = along->from[e], q = along->to[e];
    const double v = h * along->from[3 + e], w = h * along->to[3 + e];
    const double a = h * h * along->from_rates[3 + e], b = h * h * along->to_rates[3 + e];
    const double d = q - p;
    const double c3 = 10 * d - 6 * v - 4 * w - 1.5 * a + 0.5 * b;
    const double c4 = -15 * d + 8 * v + 7 * w + 1.5 * a - b;
    const double c5 = 6 * d - 3 * v - 3 * w - 0.5 * a + 0.5 * b;
    state.place[e] = p + s * (v + s * (a / 2 + s * (c3 + s * (c4 + s * c5))));
    state.speed[e] = (v + s * (a + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h;
  }
  return state;
}

void tp_along_look(tp_along *along) {
  for (int k = 0; k <= TP_LOOKS; k++) {
    along->looks[k] = tp_along_at(along, (double)k / TP_LOOKS);
    along->blocks[k] = tp_turned_block_at(along->looks + k);
  }
}

double tp_along_reach(const tp_along *along, int looks) {
  const double h = along->step / TP_LOOKS;
  double farthest = 0, bends = 0;
  for (int k = 1; k <= looks; k++) {
    double moved = 0;
    for (int e = 0; e < 3; e++) moved += fabs(along->looks[k].place[e] - along->from[e]);
    farthest = fmax(farthest, moved);
  }
  for (int e = 3; e < 6; e++) {
    bends += fmax(fabs(along->from_rates[e]), fabs(along->to_rates[e]));
  }
  return farthest + h * h / 4 * bends;
}

/* A gap, and how fast it changes from one look to the next. */
typedef struct gap_look {
  double width, speed;
} gap_look;

double tp_slack_gap_width(const tp_slack_gap *own, const tp_turned_block *block) {
  const tp_gap gap = tp_gap_moving(own->shapes, own->pair, block);
  return own->beyond ? fmax(gap.width, -gap.margin) : gap.width + own->slack;
}

static gap_look look_at(const tp_slack_gap *own, const tp_along *along,
                        const tp_motion_state *state, const tp_turned_block *block) {
  if (own->beyond) return (gap_look){tp_slack_gap_width(own, block), 0};
  const tp_gap gap = tp_gap_moving(own->shapes, own->pair, block);
  return (gap_look){gap.width + own->slack,
                    tp_gap_speed(gap.across, state->speed) * along->step / TP_LOOKS};
}

static double width_at(const tp_slack_gap *own, const tp_along *along, double share) {
  const tp_motion_state state = tp_along_at(along, share);
  const tp_turned_block block = tp_turned_block_at(&state);
  return tp_slack_gap_width(own, &block);
}

/* Where the cubic through two looks is least, as a share of the way from one to the other. */
static double least_between(gap_look a, gap_look b) {
  const double d = b.width - a.width;
  const double c2 = 3 * d - 2 * a.speed - b.speed, c3 = a.speed + b.speed - 2 * d;
  return -a.speed / (c2 + sqrt(fmax(c2 * c2 - 3 * c3 * a.speed, 0)));
}

bool tp_gap_span_find(tp_gap_span *found, const tp_along *along, const tp_slack_gap *gap,
                      double until) {
  gap_look last = look_at(gap, along, along->looks, along->blocks);
  for (int k = 1; k <= TP_LOOKS; k++) {
    found->sound = (double)(k - 1) / TP_LOOKS;
    found->below = (double)k / TP_LOOKS;
    if (found->sound >= until) return false;
    const gap_look now = look_at(gap, along, along->looks + k, along->blocks + k);
    if (now.width < 0) return true;
    if (last.speed < 0 && now.speed > 0 && last.width + last.speed < 0) {
      const double least = found->sound + least_between(last, now) / TP_LOOKS;
      if (least > found->sound && least < found->below && width_at(gap, along, least) < 0) {
        found->below = least;
        return true;
      }
    }
    last = now;
  }
  return false;
}

/* A gap along a step. */
typedef struct along_gap {
  const tp_slack_gap *gap;
  const tp_along *along;
} along_gap;

static bool sample(double *value, void *context, double share) {
  const along_gap *own = context;
  *value = width_at(own->gap, own->along, share);
  return true;
}

double tp_gap_span_share(const tp_gap_span *found, const tp_along *along, const tp_slack_gap *gap) {
  along_gap own = {gap, along};
  const tp_root_search search = {
      .value = sample, .context = &own, .width = near_share, .most = MOST_SAMPLES};
  const tp_root_end low = {found->sound, width_at(gap, along, found->sound)},
                    high = {found->below, width_at(gap, along, found->below)};
  tp_root root;
  return low.value > 0 && tp_root_find(&root, &search, low, high) ? root.high : found->sound;
}
