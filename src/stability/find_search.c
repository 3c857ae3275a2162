/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/find_search.h"

#include "message.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 512, STEPS = 200 };

/* The result at a number: less the wanted value, with its bound. */
typedef struct sample {
  double x;
  bool known;
  tp_bounded gap;
} sample;

static bool target_value(tp_bounded *value, const tp_case *own, tp_find_target target) {
  const tp_pivot *pivot = own->has_governing ? own->pivots + own->governing : NULL;
  const bool slides = own->sliding.known && !own->sliding.never;
  switch (target) {
  case TP_FIND_CRITICAL_ANGLE:
    if (pivot != NULL) *value = pivot->critical_angle_deg;
    return pivot != NULL;
  case TP_FIND_FOS:
    if (pivot != NULL) *value = pivot->fos_resultant.value;
    return pivot != NULL && pivot->fos_resultant.state == TP_FOS_NUMBER;
  case TP_FIND_SLIDING_ANGLE:
    if (slides) *value = own->sliding.critical_angle_deg;
    return slides;
  case TP_FIND_SLIDING_FOS:
    if (slides) *value = own->sliding.fos.value;
    return slides && own->sliding.fos.state == TP_FOS_NUMBER;
  case TP_FIND_LIMIT_ANGLE:
    *value = own->limit.critical_angle_deg;
    return own->limit.kind == TP_LIMIT_AT_ANGLE;
  case TP_FIND_LIMIT_FOS:
    *value = own->limit.fos.value;
    return own->limit.fos.state == TP_FOS_NUMBER;
  }
  return false;
}

/* Solve the scene with the number replaced. */
static sample look(tp_search *s, double x) {
  sample at = {.x = x};
  tp_solution *solution = NULL;
  const tp_status status = tp_varied_solve(&solution, &s->scene, &x, &s->why);
  if (status == TP_OK && solution->case_count > 0) {
    at.known = target_value(&at.gap, solution->cases, s->options->target);
    at.gap.value -= s->options->value;
    /* the difference is rounded once */
    at.gap.error += fabs(at.gap.value) * 0x1p-52;
  }
  if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED) {
    s->status = tp_fail(s->message, status, (tp_place){0}, "%s", s->why.text);
  }
  tp_solution_free(solution);
  return at;
}

/* 1 above the wanted value, -1 below; 0 where that is not certain. */
static int side(const sample *at) {
  if (at->gap.value > at->gap.error) return 1;
  return at->gap.value < -at->gap.error ? -1 : 0;
}

/* The last point with an answer between one that has some and one that has none. */
static sample domain_edge(tp_search *s, sample inside, sample outside) {
  for (int k = 0; k < STEPS && s->status == TP_OK; k++) {
    const double x = inside.x + (outside.x - inside.x) / 2;
    if (x == inside.x || x == outside.x) break;
    if (fabs(outside.x - inside.x) < 1e-12 * (s->high - s->low)) break;
    const sample middle = look(s, x);
    if (middle.known) {
      inside = middle;
    } else {
      outside = middle;
    }
  }
  return inside;
}

/* A number between two to one of the lists of what is found. */
static tp_status add_number(const tp_search *s, tp_bounded **list, size_t *count, double low,
                            double high) {
  tp_bounded *all = realloc(*list, (*count + 1) * sizeof *all);
  if (all == NULL) return tp_fail_memory(s->message, "the solutions");
  *list = all;
  const double middle = low + (high - low) / 2;
  const double error = (high - low) / 2 + fabs(middle) * 0x1p-51; /* decimal text, and rounding */
  all[(*count)++] = (tp_bounded){.value = middle, .error = error};
  return TP_OK;
}

static tp_status add_solution(const tp_search *s, tp_found *found, double low, double high) {
  return add_number(s, &found->solutions, &found->count, low, high);
}

/* Narrow a bracket whose ends lie on different sides. */
static void bisect(tp_search *s, tp_found *found, sample low, sample high) {
  for (int k = 0; k < STEPS && s->status == TP_OK; k++) {
    const double x = low.x + (high.x - low.x) / 2;
    if (high.x - low.x <= 1e-14 * fabs(x) || x <= low.x || x >= high.x) break;
    const sample middle = look(s, x);
    if (!middle.known || side(&middle) == 0) break;
    if (side(&middle) == side(&low)) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const double width = (high.x - low.x) / (fabs(high.x) + fabs(low.x));
  const double gap = fabs(high.gap.value - low.gap.value);
  if (s->status != TP_OK || (width < 1e-12 && gap > 1e-6)) return; /* it jumps there */
  s->status = add_solution(s, found, low.x, high.x);
}

/* A point that is not told apart from the wanted value: the nearest ones that are, on either side.
 * Where both lie on the same side the result comes up to the value, and may touch it. */
static void bracket_about(tp_search *s, tp_found *found, const sample *at, double step) {
  const double scale = at->x != 0 ? fabs(at->x) : step;
  for (double h = 1e-15 * scale; h < step && s->status == TP_OK; h *= 4) {
    const sample low = look(s, at->x - h), high = look(s, at->x + h);
    if (!low.known || !high.known) break;
    const int sides = side(&low) * side(&high);
    if (sides < 0) s->status = add_solution(s, found, low.x, high.x);
    if (sides > 0) {
      s->status = add_number(s, &found->touching, &found->touching_count, low.x, high.x);
    }
    if (sides != 0) return;
  }
}

/* Three points in a row on one side, the middle one nearest to the wanted value: by golden section
 * to the nearest between them, which may touch the value, or lie beyond it. */
static void descend(tp_search *s, tp_found *found, sample low, sample middle, sample high,
                    double step) {
  enum { MOST_LOOKS = 64 };
  static const double golden = 0.38196601125010515;
  const int own = side(&middle);
  for (int k = 0; k < MOST_LOOKS && s->status == TP_OK; k++) {
    const bool right = high.x - middle.x > middle.x - low.x;
    const double x = middle.x + golden * (right ? high.x - middle.x : low.x - middle.x);
    if (x <= low.x || x >= high.x || x == middle.x) return;
    const sample next = look(s, x);
    if (!next.known) return;
    if (side(&next) == 0) {
      bracket_about(s, found, &next, step);
      return;
    }
    if (side(&next) != own) { /* two solutions, closer than the points of the range */
      bisect(s, found, low, next);
      if (s->status == TP_OK) bisect(s, found, next, high);
      return;
    }
    if (fabs(next.gap.value) < fabs(middle.gap.value)) {
      *(right ? &low : &high) = middle;
      middle = next;
    } else {
      *(right ? &high : &low) = next;
    }
  }
}

static bool is_nearest(const sample *low, const sample *middle, const sample *high) {
  const double own = fabs(middle->gap.value);
  return side(middle) != 0 && side(low) == side(middle) && side(high) == side(middle) &&
         own <= fabs(low->gap.value) && own < fabs(high->gap.value);
}

/* From one point with an answer to the next. */
static void between(tp_search *s, tp_found *found, const sample *low, const sample *high,
                    double step) {
  if (side(high) == 0) {
    bracket_about(s, found, high, step);
  } else if (side(low) * side(high) < 0) {
    bisect(s, found, *low, *high);
  }
}

void tp_search_scan(tp_search *s, tp_found *found) {
  const double step = (found->high - found->low) / (POINTS - 1);
  s->low = found->low;
  s->high = found->high;
  sample last = {0}, before = {0};
  bool any = false;
  double first_known = 0, last_known = 0;
  for (int k = 0; k < POINTS && s->status == TP_OK; k++) {
    sample next = look(s, k == POINTS - 1 ? found->high : found->low + k * step);
    if (k > 0 && last.known && !next.known) { /* the domain ends between them */
      const sample edge = domain_edge(s, last, next);
      if (edge.x > last.x) between(s, found, &last, &edge, step);
      last_known = edge.x;
    } else if (next.known) {
      if (k > 0 && !last.known) last = domain_edge(s, next, last);
      if (!any) first_known = last.known ? last.x : next.x;
      if (k == 0 && side(&next) == 0) bracket_about(s, found, &next, step);
      if (last.known) between(s, found, &last, &next, step);
      if (before.known && last.known && is_nearest(&before, &last, &next)) {
        descend(s, found, before, last, next, step);
      }
      any = true;
      last_known = next.x;
    }
    before = last;
    last = next;
  }
  if (s->status != TP_OK) return;
  if (!any) {
    s->status = tp_fail(s->message, TP_NO_ANSWER, tp_node_place(s->scene.numbers[0], s->scene.path),
                        "nowhere from %g to %g the scene has a %s; %s", found->low, found->high,
                        tp_find_target_name(s->options->target),
                        s->why.text[0] != '\0' ? s->why.text : "nothing lets go there");
    return;
  }
  found->low = first_known;
  found->high = last_known;
}
