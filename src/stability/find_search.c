/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Between points: the domain ends at a yes or a no. The nearest value is looked for by golden
 * section, not by Brent's method with its parabolas: it lies, as a rule, in a kink, where one pivot
 * or mechanism takes over from another, and that method stops 10^-8 of the number before it. */

#include "stability/find_search.h"

#include "message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 512 };

static bool target_value(tp_bounded *value, const tp_case *own, tp_find_target target) {
  const tp_pivot *pivot = own->has_governing ? own->pivots + own->governing : NULL;
  const bool slides = own->sliding.known && !own->sliding.never;
  const bool has_angle = slides && !own->sliding.always;
  switch (target) {
  case TP_FIND_CRITICAL_ANGLE:
    if (pivot == NULL || pivot->never || pivot->always) return false;
    *value = pivot->critical_angle_deg;
    return true;
  case TP_FIND_FOS:
    if (pivot != NULL) *value = pivot->fos_resultant.value;
    return pivot != NULL && pivot->fos_resultant.state == TP_FOS_NUMBER;
  case TP_FIND_SLIDING_ANGLE:
    if (has_angle) *value = own->sliding.critical_angle_deg;
    return has_angle;
  case TP_FIND_SLIDING_FOS:
    if (slides) *value = own->sliding.fos.value;
    return slides && own->sliding.fos.state == TP_FOS_NUMBER;
  case TP_FIND_LIMIT_ANGLE:
    *value = own->limit.critical_angle_deg;
    return own->limit.kind == TP_LIMIT_AT_ANGLE;
  case TP_FIND_ONSET_ANGLE:
    *value = own->onset.critical_angle_deg;
    return own->onset.kind == TP_ONSET_AT_ANGLE;
  case TP_FIND_LIMIT_FOS:
    *value = own->limit.fos.value;
    return own->limit.fos.state == TP_FOS_NUMBER;
  }
  return false;
}

/* A number of digits as they are printed, or nothing. */
static void take_digits(char out[TP_SAMPLE_DIGITS], tp_bounded value) {
  out[0] = '\0';
  if (value.digits != NULL && strlen(value.digits) < TP_SAMPLE_DIGITS) strcpy(out, value.digits);
}

static void note_result(tp_found *found, tp_bounded value) {
  const bool first = found->least.value > found->greatest.value;
  if (first || value.value < found->least.value) found->least = value;
  if (first || value.value > found->greatest.value) found->greatest = value;
}

/* Solve the scene with the number replaced. */
tp_sample tp_search_look(tp_search *s, double x) {
  tp_sample at = {.x = x};
  tp_solution *solution = NULL;
  const tp_status status = tp_varied_solve(&solution, &s->scene, &x, &s->why);
  if (status == TP_OK && solution->case_count > 0) {
    at.known = target_value(&at.gap, solution->cases, s->options->target);
    take_digits(at.digits, at.gap);
    at.gap.digits = NULL;
    if (at.known) note_result(s->found, at.gap);
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

int tp_search_side(const tp_sample *at) {
  if (at->gap.value > at->gap.error) return 1;
  return at->gap.value < -at->gap.error ? -1 : 0;
}

static tp_bounded between(double low, double high) {
  const double middle = low + (high - low) / 2;
  const double error = (high - low) / 2 + fabs(middle) * 0x1p-51; /* decimal text, and rounding */
  return (tp_bounded){.value = middle, .error = error};
}

/* A number between two to one of the lists of what is found. */
static void add_number(tp_search *s, tp_bounded **list, size_t *count, double low, double high) {
  tp_bounded *all = realloc(*list, (*count + 1) * sizeof *all);
  if (all == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  *list = all;
  all[(*count)++] = between(low, high);
}

void tp_search_add_solution(tp_search *s, double low, double high) {
  add_number(s, &s->found->solutions, &s->found->count, low, high);
}

void tp_search_add_touching(tp_search *s, double low, double high) {
  add_number(s, &s->found->touching, &s->found->touching_count, low, high);
}

void tp_search_add_interval(tp_search *s, const double from[2], const double to[2]) {
  tp_found *f = s->found;
  tp_found_interval *all = realloc(f->intervals, (f->interval_count + 1) * sizeof *all);
  if (all == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  f->intervals = all;
  all[f->interval_count++] =
      (tp_found_interval){.low = between(from[0], from[1]), .high = between(to[0], to[1])};
}

/* The last point with an answer between one that has some and one that has none. */
static tp_sample domain_edge(tp_search *s, tp_sample inside, tp_sample outside) {
  enum { STEPS = 200 };
  for (int k = 0; k < STEPS && s->status == TP_OK; k++) {
    const double x = inside.x + (outside.x - inside.x) / 2;
    if (x == inside.x || x == outside.x) break;
    if (fabs(outside.x - inside.x) < 1e-14 * fmax(fabs(x), fabs(s->own))) break;
    const tp_sample middle = tp_search_look(s, x);
    if (middle.known) {
      inside = middle;
    } else {
      outside = middle;
    }
  }
  return inside;
}

/* Three points in a row on one side, the middle one nearest to the wanted value: by golden section
 * to the nearest between them, which may touch the value, or lie beyond it. */
static void descend(tp_search *s, tp_sample low, tp_sample middle, tp_sample high) {
  enum { MOST_LOOKS = 64 };
  static const double golden = 0.38196601125010515;
  const int own = tp_search_side(&middle);
  for (int k = 0; k < MOST_LOOKS && s->status == TP_OK; k++) {
    const bool right = high.x - middle.x > middle.x - low.x;
    const double x = middle.x + golden * (right ? high.x - middle.x : low.x - middle.x);
    if (x <= low.x || x >= high.x || x == middle.x) return;
    const tp_sample next = tp_search_look(s, x);
    if (!next.known) return;
    if (tp_search_side(&next) == 0) {
      tp_search_level(s, &low, &next, &next, &high);
      return;
    }
    if (tp_search_side(&next) != own) { /* two solutions, closer than the points of the range */
      tp_search_cross(s, low, next);
      if (s->status == TP_OK) tp_search_cross(s, next, high);
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

static bool is_nearest(const tp_sample *low, const tp_sample *middle, const tp_sample *high) {
  const double own = fabs(middle->gap.value);
  const int side = tp_search_side(middle);
  return side != 0 && tp_search_side(low) == side && tp_search_side(high) == side &&
         own <= fabs(low->gap.value) && own < fabs(high->gap.value);
}

/* Points in a row with an answer, and what lies between them. */
static void search_row(tp_search *s, const tp_sample *row, size_t count) {
  for (size_t k = 0; k < count && s->status == TP_OK; k++) {
    if (tp_search_side(row + k) == 0) {
      const size_t first = k;
      while (k + 1 < count && tp_search_side(row + k + 1) == 0) k++;
      tp_search_level(s, first > 0 ? row + first - 1 : NULL, row + first, row + k,
                      k + 1 < count ? row + k + 1 : NULL);
    } else if (k + 1 < count && tp_search_side(row + k) * tp_search_side(row + k + 1) < 0) {
      tp_search_cross(s, row[k], row[k + 1]);
    } else if (k > 0 && k + 1 < count && is_nearest(row + k - 1, row + k, row + k + 1)) {
      descend(s, row[k - 1], row[k], row[k + 1]);
    }
  }
}

/* A row as it grows, and the ends of all rows. */
typedef struct rows {
  tp_sample row[POINTS + 2];
  size_t count;
  bool any;
  double first, last;
} rows;

static void end_row(tp_search *s, rows *r) {
  if (r->count == 0) return;
  if (!r->any) r->first = r->row[0].x;
  r->any = true;
  r->last = r->row[r->count - 1].x;
  search_row(s, r->row, r->count);
  r->count = 0;
}

static void look_at_all(tp_search *s, rows *r) {
  const tp_found *found = s->found;
  tp_sample last = {0};
  for (int k = 0; k < POINTS && s->status == TP_OK; k++) {
    const tp_sample next =
        tp_search_look(s, k == POINTS - 1 ? found->high : found->low + k * s->step);
    if (k > 0 && last.known && !next.known) { /* the domain ends between them */
      const tp_sample edge = domain_edge(s, last, next);
      if (edge.x > last.x) r->row[r->count++] = edge;
      end_row(s, r);
    } else if (next.known) {
      if (k > 0 && !last.known) {
        const tp_sample edge = domain_edge(s, next, last);
        if (edge.x < next.x) r->row[r->count++] = edge;
      }
      r->row[r->count++] = next;
    }
    last = next;
  }
  if (s->status == TP_OK) end_row(s, r);
}

/* Forget what was found. */
static void start_again(tp_search *s, rows *r) {
  tp_found *found = s->found;
  found->count = found->touching_count = found->interval_count = 0;
  found->low = r->first;
  found->high = r->last;
  *r = (rows){.count = 0};
}

void tp_search_scan(tp_search *s) {
  tp_found *found = s->found;
  const double width = found->high - found->low;
  rows *r = calloc(1, sizeof *r);
  if (r == NULL) {
    s->status = tp_fail_memory(s->message, "the points of the range");
    return;
  }
  s->step = width / (POINTS - 1);
  look_at_all(s, r);
  if (s->status == TP_OK && r->any && r->last > r->first && r->last - r->first < width / 2) {
    start_again(s, r); /* few of the points had an answer */
    s->step = (found->high - found->low) / (POINTS - 1);
    look_at_all(s, r);
  }
  if (s->status == TP_OK && !r->any) {
    s->status = tp_fail(s->message, TP_NO_ANSWER, tp_node_place(s->scene.numbers[0], s->scene.path),
                        "nowhere from %g to %g the scene has a %s; %s", found->low, found->high,
                        tp_find_target_name(s->options->target),
                        s->why.text[0] != '\0' ? s->why.text : "nothing lets go there");
  } else if (s->status == TP_OK) {
    found->low = r->first;
    found->high = r->last;
  }
  free(r);
}
