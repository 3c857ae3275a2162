/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Basins of initial positions (rest/basins.h) gathered by their final pose, widest first, as widths
 * and shares with bounds; each pose is solved by stability/pose_verdict.h. */

#include "stability/poses.h"

#include "common/host.h"
#include "common/message.h"
#include "evaluation/certainty.h"
#include "evaluation/rest_result.h"
#include "problem/effects.h"
#include "rest/basins.h"
#include "stability/pose_verdict.h"

#include <math.h>
#include <stdlib.h>

/* An ending that rests, with its basins. */
typedef struct pose_basins {
  long ending, first, widest, count;
  fmpq width, half; /* of all, and half of what their borders leave open */
} pose_basins;

typedef struct search {
  const tp_scene *scene;
  const tp_solve_options *options;
  tp_rested *rested;
  tp_basins basins;
  long pose_count;
  pose_basins *poses; /* the widest first; room for every ending */
  tp_poses_result *result;
} search;

/* Width of a basin, and half of what its borders leave open. */
static void measure(fmpq_t width, fmpq_t half, const tp_basins *b, long k) {
  fmpq_t middle, open;
  fmpq_init(middle);
  fmpq_init(open);
  tp_basins_border(width, half, b, k + 1);
  tp_basins_border(middle, open, b, k);
  fmpq_sub(width, width, middle);
  fmpq_add(half, half, open);
  fmpq_clear(middle);
  fmpq_clear(open);
}

static int compare_poses(const void *one, const void *other) {
  const pose_basins *a = one, *b = other;
  const int order = fmpq_cmp(&b->width, &a->width);
  return order != 0 ? order : a->first < b->first ? -1 : 1;
}

static void clear_poses(search *s) {
  for (long k = 0; k < s->pose_count; k++) {
    fmpq_clear(&s->poses[k].width);
    fmpq_clear(&s->poses[k].half);
  }
  free(s->poses);
}

/* The pose of an ending; as many as there are where it has none. */
static long pose_of(const search *s, long ending) {
  long k = 0;
  while (k < s->pose_count && s->poses[k].ending != ending) k++;
  return k;
}

/* Every basin of an ending adds to its pose. */
static void add_basin(pose_basins *own, search *s, long k) {
  fmpq_t width, half, widest;
  fmpq_init(width);
  fmpq_init(half);
  fmpq_init(widest);
  measure(width, half, &s->basins, k);
  fmpq_add(&own->width, &own->width, width);
  fmpq_add(&own->half, &own->half, half);
  if (own->count++ == 0) {
    own->first = own->widest = k;
  } else {
    measure(widest, half, &s->basins, own->widest);
    if (fmpq_cmp(width, widest) > 0) own->widest = k;
  }
  fmpq_clear(width);
  fmpq_clear(half);
  fmpq_clear(widest);
}

/* The poses that have a basin; what was seen in a single position alone has none. */
static void gather(search *s) {
  const tp_basins *b = &s->basins;
  for (long k = 0; k < b->count; k++) {
    const long ending = b->items[k].ending;
    if (b->endings.items[ending].how != TP_SETTLED_RESTS) continue;
    const long own = pose_of(s, ending);
    if (own == s->pose_count) {
      s->poses[own].ending = ending;
      fmpq_init(&s->poses[own].width);
      fmpq_init(&s->poses[own].half);
      s->pose_count++;
    }
    add_basin(s->poses + own, s, k);
  }
  qsort(s->poses, (size_t)s->pose_count, sizeof *s->poses, compare_poses);
}

static tp_bounded widened(tp_bounded number, const fmpq_t half) {
  if (!fmpq_is_zero(half)) {
    number.error = nextafter(number.error + nextafter(fmpq_get_d(half), INFINITY), INFINITY);
  }
  return number;
}

static tp_bounded border_m(const search *s, long before) {
  fmpq_t middle, half;
  fmpq_init(middle);
  fmpq_init(half);
  tp_basins_border(middle, half, &s->basins, before);
  fmpq_mul(half, half, s->scene->metres_per_unit);
  const tp_bounded border = widened(tp_rest_metres(s->rested, middle), half);
  fmpq_clear(middle);
  fmpq_clear(half);
  return border;
}

static tp_bounded share_of(const search *s, const fmpq_t width, const fmpq_t half) {
  fmpq_t all, share, open;
  fmpq_init(all);
  fmpq_init(share);
  fmpq_init(open);
  fmpq_sub(all, s->basins.high, s->basins.low);
  fmpq_div(share, width, all);
  fmpq_div(open, half, all);
  const tp_bounded result = widened(tp_result_rational(share), open);
  fmpq_clear(all);
  fmpq_clear(share);
  fmpq_clear(open);
  return result;
}

static tp_settling_end end_of(const tp_ending *ending) {
  switch (ending->how) {
  case TP_SETTLED_RESTS:
    return TP_COMES_TO_REST;
  case TP_SETTLED_ROLLS_OFF:
  case TP_SETTLED_BESIDE:
    return ending->side < 0 ? TP_ROLLS_OFF_LEFT : TP_ROLLS_OFF_RIGHT;
  case TP_SETTLED_BALANCES:
    return TP_BALANCES;
  default:
    return TP_SETTLING_UNDECIDED;
  }
}

static tp_status turned_from(tp_bounded *turned_deg, const search *s, const fmpq_t shift,
                             tp_message *message) {
  const tp_status status = tp_settle_from(&s->rested->settling, shift, message);
  if (status == TP_OK) *turned_deg = tp_rest_turned_deg(s->rested);
  return status;
}

static tp_status describe_basin(search *s, long k, tp_message *message) {
  const tp_basin_found *found = s->basins.items + k;
  tp_basin *own = s->result->basins + k;
  fmpq_t width, half;
  fmpq_init(width);
  fmpq_init(half);
  measure(width, half, &s->basins, k);
  *own = (tp_basin){.end = end_of(s->basins.endings.items + found->ending),
                    .from_m = border_m(s, k),
                    .to_m = border_m(s, k + 1),
                    .share = share_of(s, width, half)};
  fmpq_clear(width);
  fmpq_clear(half);
  if (own->end != TP_COMES_TO_REST) return TP_OK;
  own->pose = (size_t)pose_of(s, found->ending);
  tp_status status = turned_from(&own->turned_from_deg, s, &found->first, message);
  if (status == TP_OK) status = turned_from(&own->turned_to_deg, s, &found->last, message);
  return status;
}

/* Set the block down as given, in the pose that it reaches from there: all other results are for
 * that position, and a contact that slides along a facet has its ends elsewhere from another one.
 * In any other pose, in the middle of its widest basin; at the basin's first position where the
 * middle belongs to another one, which is narrower than the spacing. */
static tp_status set_down(fmpq_t shift, search *s, const pose_basins *pose, tp_message *message) {
  const tp_basin_found *basin = s->basins.items + pose->widest;
  if (s->result->has_given && pose == s->poses + s->result->given) {
    fmpq_zero(shift);
    tp_status given = tp_settle_from(&s->rested->settling, shift, message);
    return given == TP_OK ? tp_rested_shift(s->rested, s->scene, shift, message) : given;
  }
  long ending = -1;
  fmpq_add(shift, &basin->first, &basin->last);
  fmpq_div_2exp(shift, shift, 1);
  tp_status status = tp_settle_from(&s->rested->settling, shift, message);
  if (status == TP_OK) {
    status = tp_endings_note(&ending, &s->basins.endings, &s->rested->settling, message);
  }
  if (status == TP_OK && ending != pose->ending) fmpq_set(shift, &basin->first);
  if (status == TP_OK) status = tp_rested_shift(s->rested, s->scene, shift, message);
  return status;
}

static void describe_contacts(tp_resting_pose *pose, const tp_rested *r) {
  const tp_bodies *b = &r->settling.bodies;
  const tp_touch *first = r->settling.touches.items, *last = first;
  for (long k = 1; k < r->settling.touches.count; k++) {
    const tp_touch *own = r->settling.touches.items + k;
    if (fmpq_cmp(tp_touch_x(b, own), tp_touch_x(b, first)) < 0) first = own;
    if (fmpq_cmp(tp_touch_x(b, own), tp_touch_x(b, last)) > 0) last = own;
  }
  pose->first_contact_x_m = tp_rest_metres(r, tp_touch_x(b, first));
  pose->first_contact_y_m = tp_rest_metres(r, tp_touch_y(b, first));
  pose->last_contact_x_m = tp_rest_metres(r, tp_touch_x(b, last));
  pose->last_contact_y_m = tp_rest_metres(r, tp_touch_y(b, last));
}

static tp_status describe_pose(search *s, long k, tp_message *message) {
  const pose_basins *own = s->poses + k;
  tp_resting_pose *pose = s->result->poses + k;
  fmpq_t shift;
  fmpq_init(shift);
  tp_status status = set_down(shift, s, own, message);
  if (status == TP_OK) {
    const tp_rested *r = s->rested;
    *pose = (tp_resting_pose){.basins = (size_t)own->count,
                              .widest_basin = (size_t)own->widest,
                              .share = share_of(s, &own->width, &own->half),
                              .shift_m = tp_rest_metres(r, shift),
                              .rest = tp_rest_result_of(r),
                              .centroid_y_m = tp_rest_metres(r, &r->settling.bodies.centroid.y)};
    describe_contacts(pose, r);
    status = tp_pose_solve(pose, &r->scene, s->options, message);
  }
  fmpq_clear(shift);
  return status;
}

/* In which pose does the block of the scene come to rest? */
static tp_status find_given(search *s, tp_message *message) {
  fmpq_t none;
  long ending = -1;
  fmpq_init(none);
  tp_status status = tp_settle_from(&s->rested->settling, none, message);
  fmpq_clear(none);
  if (status == TP_OK) {
    status = tp_endings_note(&ending, &s->basins.endings, &s->rested->settling, message);
  }
  if (status != TP_OK) return status;
  s->result->given = (size_t)pose_of(s, ending);
  s->result->has_given = s->result->given < s->result->pose_count;
  if (!s->result->has_given) s->result->given = 0;
  return TP_OK;
}

static tp_status describe(search *s, tp_message *message) {
  const tp_basins *b = &s->basins;
  tp_poses_result *result = s->result;
  s->poses = calloc((size_t)b->endings.count, sizeof *s->poses);
  if (s->poses == NULL) return tp_fail_memory(message, "the resting poses");
  gather(s);
  result->known = true;
  result->from_m = tp_rest_metres(s->rested, b->low);
  result->to_m = tp_rest_metres(s->rested, b->high);
  result->spacing_m = tp_rest_metres(s->rested, b->spacing);
  result->border_m = tp_rest_metres(s->rested, b->narrow);
  result->settlings = (size_t)b->settlings;
  result->poses = calloc((size_t)s->pose_count + 1, sizeof *result->poses);
  result->basins = calloc((size_t)b->count + 1, sizeof *result->basins);
  if (result->poses == NULL || result->basins == NULL) {
    return tp_fail_memory(message, "the resting poses");
  }
  result->pose_count = (size_t)s->pose_count;
  result->basin_count = (size_t)b->count;
  tp_status status = find_given(s, message);
  for (long k = 0; k < b->count && status == TP_OK; k++) status = describe_basin(s, k, message);
  for (long k = 0; k < s->pose_count && status == TP_OK; k++) status = describe_pose(s, k, message);
  return status;
}

tp_status tp_poses_find(tp_solution *solution, const tp_scene *scene,
                        const tp_solve_options *options, tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  search s = {.scene = scene, .options = options, .result = &solution->poses};
  tp_status status = tp_rested_init(&s.rested, scene, message);
  if (status != TP_OK) return status;
  status = tp_basins_find(&s.basins, &s.rested->settling, message);
  if (status == TP_OK) {
    status = describe(&s, message);
    if (status == TP_OK) tp_poses_least(&solution->poses, solution->case_count);
    clear_poses(&s);
    tp_basins_clear(&s.basins);
  }
  tp_rested_free(s.rested);
  return tp_effects_entered(
      status, message,
      status != TP_OK || tp_effects_note(solution, "poses", scene->base.rests_place, "", began));
}
