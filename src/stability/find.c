/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis: the numbers of a scene for which a result has a wanted value.
 *
 * Method: the scene is solved with the number replaced, at 512 points of the range; where the scene
 * has no answer at one of two neighbours the edge of its domain is bisected. Between neighbours on
 * different sides of the wanted value the solution is bisected until the sides are no longer told
 * apart, or the bracket is narrower than 1e-14 of the number. Every side is certain: the result's
 * bound does not reach the wanted value. A bracket over which the result jumps is no solution. */

#include "scene/key.h"
#include "stability/varied.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 512, STEPS = 200 };

static const char *const targets[] = {"critical_angle", "fos",         "sliding_angle",
                                      "sliding_fos",    "limit_angle", "limit_fos"};
enum { TARGETS = sizeof targets / sizeof targets[0] };

bool tp_find_target_read(tp_find_target *target, const char *name) {
  for (int k = 0; k < TARGETS; k++) {
    if (strcmp(name, targets[k]) != 0) continue;
    *target = (tp_find_target)k;
    return true;
  }
  return false;
}

const char *tp_find_target_name(tp_find_target target) {
  return targets[target];
}

void tp_found_free(tp_found *found) {
  if (found == NULL) return;
  free(found->key);
  free(found->solutions);
  free(found);
}

typedef struct search {
  const tp_find_options *options;
  tp_varied scene;
  double low, high; /* the range */
  tp_message *message;
  tp_status status; /* of the system: memory; that a scene has no answer is none */
  tp_message why;   /* why the last scene had no answer */
} search;

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
static sample look(search *s, double x) {
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
static sample domain_edge(search *s, sample inside, sample outside) {
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

static tp_status add_solution(const search *s, tp_found *found, double low, double high) {
  tp_bounded *all = realloc(found->solutions, (found->count + 1) * sizeof *all);
  if (all == NULL) return tp_fail_memory(s->message, "the solutions");
  found->solutions = all;
  const double middle = low + (high - low) / 2;
  const double error = (high - low) / 2 + fabs(middle) * 0x1p-51; /* decimal text, and rounding */
  found->solutions[found->count++] = (tp_bounded){.value = middle, .error = error};
  return TP_OK;
}

/* Narrow a bracket whose ends lie on different sides. */
static void bisect(search *s, tp_found *found, sample low, sample high) {
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
 */
static void bracket_about(search *s, tp_found *found, const sample *at, double step) {
  const double scale = at->x != 0 ? fabs(at->x) : step;
  for (double h = 1e-15 * scale; h < step && s->status == TP_OK; h *= 4) {
    const sample low = look(s, at->x - h), high = look(s, at->x + h);
    if (!low.known || !high.known) break;
    if (side(&low) * side(&high) < 0) {
      s->status = add_solution(s, found, low.x, high.x);
      return;
    }
  }
}

/* From one point with an answer to the next. */
static void between(search *s, tp_found *found, const sample *low, const sample *high,
                    double step) {
  if (side(high) == 0) {
    bracket_about(s, found, high, step);
  } else if (side(low) * side(high) < 0) {
    bisect(s, found, *low, *high);
  }
}

static void scan(search *s, tp_found *found) {
  const double step = (found->high - found->low) / (POINTS - 1);
  s->low = found->low;
  s->high = found->high;
  sample last = {0};
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
      any = true;
      last_known = next.x;
    }
    last = next;
  }
  if (s->status != TP_OK) return;
  if (!any) {
    s->status = tp_fail(s->message, TP_NO_ANSWER, tp_node_place(s->scene.numbers[0], s->scene.path),
                        "nowhere from %g to %g the scene has a %s; %.600s", found->low, found->high,
                        targets[s->options->target],
                        s->why.text[0] != '\0' ? s->why.text : "nothing lets go there");
    return;
  }
  found->low = first_known;
  found->high = last_known;
}

/* The range to look in: as asked, or about the scene's own number. */
static tp_status set_range(const search *s, tp_found *found) {
  double own = 0;
  const tp_status status = tp_varied_check(&own, &s->scene, s->message);
  if (status != TP_OK) return status;
  found->low = s->options->has_range ? s->options->low : own < 0 ? 10 * own : 0;
  found->high = s->options->has_range ? s->options->high : own < 0 ? 0 : 10 * own;
  if (found->low < found->high) return TP_OK;
  tp_place place = tp_node_place(s->scene.numbers[0], s->scene.path);
  place.column += s->scene.numbers[0]->text_offset;
  return tp_fail(s->message, TP_BAD_INPUT, place,
                 "give the range to look in, as in --from 0 --to 10");
}

/* What the target cannot be without. */
static tp_status check_target(const search *s) {
  const tp_node *tilt = tp_node_get(s->scene.root, "tilt");
  const tp_find_target target = s->options->target;
  const bool has_tilt = tilt != NULL && tp_node_get(tilt, "angle_deg") != NULL;
  const tp_place place = {s->scene.path, 0, 0};
  if (target >= TP_FIND_SLIDING_ANGLE && !tp_varied_has_friction(&s->scene)) {
    return tp_fail(s->message, TP_BAD_INPUT, place,
                   "%s needs friction; give the scene its 'friction_angle_deg: …'",
                   targets[target]);
  }
  const bool needs_tilt =
      target == TP_FIND_FOS || target == TP_FIND_SLIDING_FOS || target == TP_FIND_LIMIT_FOS;
  if (!needs_tilt || has_tilt) return TP_OK;
  return tp_fail(s->message, TP_BAD_INPUT, place,
                 "%s needs a tilt; give the scene its 'tilt: {towards: left, angle_deg: …}'",
                 targets[target]);
}

tp_status tp_find(tp_found **found, const char *scene, const tp_find_options *options,
                  tp_message *message) {
  search s = {.options = options, .scene = {.path = scene, .count = 1}, .message = message};
  s.scene.options = tp_solve_options_default();
  s.scene.options.digits = 15;
  s.scene.options.strength_reduction = options->target == TP_FIND_LIMIT_FOS;
  s.scene.options.limit =
      options->target == TP_FIND_LIMIT_ANGLE || s.scene.options.strength_reduction;
  tp_found *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the solutions");
  own->key = strdup(options->key);
  s.status = own->key != NULL ? tp_node_read(&s.scene.root, scene, message)
                              : tp_fail_memory(message, "the solutions");
  if (s.status == TP_OK) {
    s.status = tp_key_find(s.scene.numbers, s.scene.root, options->key, scene, message);
    if (s.status == TP_OK) s.status = check_target(&s);
    if (s.status == TP_OK) s.status = set_range(&s, own);
    if (s.status == TP_OK) scan(&s, own);
    tp_node_free(s.scene.root);
  }
  if (s.status == TP_OK) {
    *found = own;
  } else {
    tp_found_free(own);
  }
  return s.status;
}
