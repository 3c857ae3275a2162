/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a result reaches the wanted value: it passes it, jumps over it, touches it, or stays at it.
 *
 * A stretch on which it stays is told from one on which it is only near by digits: at points spread
 * over it the result is the same to 30 digits, and each end is bisected between a number at which
 * it is and one at which it is not. That it stays so between the points is not proven.
 *
 * What is bisected are certain sides, or sameness, not values: and how the gap shrinks from one
 * half to the next is what tells a crossing from a jump. */

#include "back_analysis/find_level.h"

#include <math.h>
#include <string.h>

/* Halvings of a range of doubles, of which 60 come to neighbours: the rest is for ranges about
 * zero. */
enum { STEPS = 200 };
enum { LEVEL_DIGITS = 30, LEAST_DIGITS = 20 }; /* asked of the result, and enough of them */

/* Shares of what a solution is bisected to: neighbours, a few doubles apart; and how far apart the
 * ends of a stretch have to be. */
static const double neighbours = 0.1, stretch = 10;

/* Two neighbours, as far as is worth telling. */
static bool is_narrow(const tp_search *s, double low, double high, double middle) {
  return !(middle > low && middle < high) || high - low <= neighbours * s->close * fabs(middle);
}

/* The width shrinks by 1000 between the two gaps, and that of what is continuous does likewise. */
static bool is_jump(const double *gaps, int count) {
  enum { APART = 10 };
  return count > APART && gaps[count - 1] > gaps[count - 1 - APART] / 8;
}

void tp_search_cross(tp_search *s, tp_sample low, tp_sample high) {
  double gaps[STEPS];
  int count = 0;
  while (count < STEPS && s->status == TP_OK) {
    const double x = low.x + (high.x - low.x) / 2;
    gaps[count++] = fabs(high.gap.value - low.gap.value);
    if (high.x - low.x <= s->close * fabs(x) || x <= low.x || x >= high.x) break;
    const tp_sample middle = tp_search_sample(s, x);
    if (!middle.known) break;
    if (tp_search_side(&middle) == 0) {
      tp_search_level(s, &low, &middle, &middle, &high);
      return;
    }
    if (tp_search_side(&middle) == tp_search_side(&low)) {
      low = middle;
    } else {
      high = middle;
    }
  }
  if (s->status == TP_OK && !is_jump(gaps, count)) tp_search_add_solution(s, low.x, high.x);
}

/* Narrow the stretch between a point that is told from the wanted value and one that is not. */
static void narrow(tp_search *s, tp_sample *told, tp_sample *level) {
  for (int k = 0; k < STEPS && s->status == TP_OK; k++) {
    const double x = told->x + (level->x - told->x) / 2;
    if (is_narrow(s, fmin(told->x, level->x), fmax(told->x, level->x), x)) return;
    const tp_sample middle = tp_search_sample(s, x);
    if (!middle.known) return;
    *(tp_search_side(&middle) == 0 ? level : told) = middle;
  }
}

/* Beyond an end of the range the nearest point that is told from the wanted value. */
static bool sample_beyond(tp_search *s, tp_sample *told, const tp_sample *end, int way) {
  const double scale = end->x != 0 ? fabs(end->x) : s->step;
  for (double h = neighbours * s->close * scale; h < s->step && s->status == TP_OK; h *= 4) {
    *told = tp_search_sample(s, end->x + way * h);
    if (!told->known) return false;
    if (tp_search_side(told) != 0) return true;
  }
  return false;
}

/* With more digits. */
static tp_sample sample_closely(tp_search *s, double x) {
  const int digits = s->varied.options.digits;
  s->varied.options.digits = LEVEL_DIGITS;
  const tp_sample at = tp_search_sample(s, x);
  s->varied.options.digits = digits;
  return at;
}

/* All digits that both have; of two that are exact these may be few. */
static bool is_same(const tp_sample *a, const tp_sample *b) {
  if (!a->known || !b->known || a->digits[0] == '\0') return false;
  if (strcmp(a->digits, b->digits) == 0) return true;
  const size_t one = strlen(a->digits), other = strlen(b->digits);
  const size_t count = one < other ? one : other;
  return count >= LEAST_DIGITS && strncmp(a->digits, b->digits, count) == 0;
}

/* Does the result stay the same from low to high? `middle` is one of the points. */
static bool stays(tp_search *s, double low, double high, tp_sample *middle) {
  enum { PIECES = 10 };
  const double x = low + (high - low) / 2;
  if (is_narrow(s, low, high, x) || high - low <= stretch * s->close * fabs(x)) return false;
  *middle = sample_closely(s, x);
  for (int k = 1; k < PIECES && s->status == TP_OK; k++) {
    const tp_sample own = sample_closely(s, low + (high - low) * k / PIECES);
    if (!is_same(&own, middle)) return false;
  }
  return s->status == TP_OK;
}

/* Bisect where it leaves what it is in the middle, on the way to `end`; two numbers, ascending. */
static void find_end(tp_search *s, double ends[2], const tp_sample *middle, double end) {
  tp_sample own = sample_closely(s, end);
  double inside = middle->x, outside = end;
  if (is_same(&own, middle)) inside = end;
  while (s->status == TP_OK && inside != end) {
    const double x = inside + (outside - inside) / 2;
    if (is_narrow(s, fmin(inside, outside), fmax(inside, outside), x)) break;
    own = sample_closely(s, x);
    *(is_same(&own, middle) ? &inside : &outside) = x;
  }
  ends[0] = fmin(inside, outside);
  ends[1] = fmax(inside, outside);
}

void tp_search_level(tp_search *s, const tp_sample *before, const tp_sample *first,
                     const tp_sample *last, const tp_sample *after) {
  tp_sample low = *first, high = *last, under = *first, over = *last, middle;
  bool has_under = before != NULL, has_over = after != NULL;
  if (has_under) under = *before;
  if (has_over) over = *after;
  if (has_under) narrow(s, &under, &low);
  if (has_over) narrow(s, &over, &high);
  if (s->status == TP_OK && stays(s, low.x, high.x, &middle)) {
    double from[2], to[2];
    find_end(s, from, &middle, under.x);
    find_end(s, to, &middle, over.x);
    if (s->status == TP_OK) tp_search_add_interval(s, from, to);
    return;
  }
  if (!has_under) has_under = sample_beyond(s, &under, first, -1);
  if (!has_over) has_over = sample_beyond(s, &over, last, 1);
  if (s->status != TP_OK) return;
  if (!has_under) under = low;
  if (!has_over) over = high;
  if (has_under && has_over && tp_search_side(&under) != tp_search_side(&over)) {
    tp_search_add_solution(s, under.x, over.x);
  } else {
    tp_search_add_touching(s, under.x, over.x);
  }
}
