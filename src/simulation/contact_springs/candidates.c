/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bounding boxes sorted by their left side and swept; pairs whose normals can not face each other
 * before the next search are left out. */

#include "contact_springs/candidates.h"

#include "common/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the block's extent: how near pairs are that are looked at. */
static const double margin_share = 0.02;

/* A turn by the margin changes directions by less than this sine. */
static const double lean = 0.2;

void tp_near_pairs_clear(tp_near_pairs *c) {
  free(c->pairs);
  free(c->boxes);
  memset(c, 0, sizeof *c);
}

/* Of a feature at its place; of a disc the whole circle. */
static tp_box_of_feature box_of(const tp_feature *f, const tp_placing *placing) {
  if (f->kind != TP_FEATURE_STRAIGHT) {
    const tp_xy centre = tp_xy_plus(placing->moved, 1, tp_placing_turn(placing, f->centre));
    return (tp_box_of_feature){.left = centre.x - f->radius,
                               .right = centre.x + f->radius,
                               .low = centre.y - f->radius,
                               .high = centre.y + f->radius};
  }
  const tp_xy end = tp_xy_plus(f->from, f->length, f->tangent);
  const tp_xy p = tp_xy_plus(placing->moved, 1, tp_placing_turn(placing, f->from));
  const tp_xy q = tp_xy_plus(placing->moved, 1, tp_placing_turn(placing, end));
  return (tp_box_of_feature){.left = fmin(p.x, q.x),
                             .right = fmax(p.x, q.x),
                             .low = fmin(p.y, q.y),
                             .high = fmax(p.y, q.y)};
}

static int by_left_side(const void *left, const void *right) {
  const tp_box_of_feature *a = left, *b = right;
  if (a->left != b->left) return a->left < b->left ? -1 : 1;
  return a->feature < b->feature ? -1 : a->feature > b->feature;
}

bool tp_near_pairs_init(tp_near_pairs *c, const tp_features *of_base, double extent) {
  const tp_placing at_rest = {.cosine = 1};
  *c = (tp_near_pairs){
      .box_count = of_base->count, .margin = margin_share * extent, .extent = extent};
  c->boxes = calloc((size_t)of_base->count, sizeof *c->boxes);
  if (c->boxes == NULL) return false;
  for (long k = 0; k < of_base->count; k++) {
    c->boxes[k] = box_of(of_base->items + k, &at_rest);
    c->boxes[k].feature = k;
  }
  qsort(c->boxes, (size_t)c->box_count, sizeof *c->boxes, by_left_side);
  for (long k = 0; k < c->box_count; k++) {
    const double before = k > 0 ? c->boxes[k - 1].right_so_far : -INFINITY;
    c->boxes[k].right_so_far = fmax(before, c->boxes[k].right);
  }
  return true;
}

bool tp_near_pairs_are_old(const tp_near_pairs *c, const tp_body_state *state) {
  const tp_xy moved = tp_xy_minus(state->moved, c->found_at.moved);
  const double turned = fabs(state->turned - c->found_at.turned) * c->extent;
  return c->pairs == NULL || fabs(moved.x) + fabs(moved.y) + turned > c->margin;
}

/* Can the two face each other before the candidates are old? */
static bool may_face(const tp_feature *of_block, const tp_feature *of_base,
                     const tp_placing *placing) {
  const bool on_straight = of_base->kind == TP_FEATURE_STRAIGHT;
  if (!on_straight && of_block->kind != TP_FEATURE_STRAIGHT) return true;
  const tp_feature *disc = on_straight ? of_block : of_base;
  const tp_xy normal = on_straight ? tp_placing_turn_back(placing, of_base->normal)
                                   : tp_placing_turn(placing, of_block->normal);
  const tp_xy towards = {-normal.x, -normal.y};
  return tp_feature_reaches(disc, towards, lean + fmax(disc->slack_first, disc->slack_last));
}

static bool add_pair(tp_near_pairs *c, long of_block, long of_base) {
  tp_pair *pairs = tp_grow(c->pairs, c->count, &c->room, sizeof *pairs);
  if (pairs == NULL) return false;
  c->pairs = pairs;
  pairs[c->count++] = (tp_pair){of_block, of_base};
  return true;
}

/* The first box of the base that may reach as far as `left`. */
static long first_reaching(const tp_near_pairs *c, double left) {
  long low = 0, high = c->box_count;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    if (c->boxes[middle].right_so_far < left) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

static bool find_of(tp_near_pairs *c, long own, const tp_features *of_block,
                    const tp_features *of_base, const tp_placing *placing) {
  const tp_feature *feature = of_block->items + own;
  const tp_box_of_feature box = box_of(feature, placing);
  const double left = box.left - c->margin, right = box.right + c->margin;
  bool done = true;
  for (long k = first_reaching(c, left); k < c->box_count && c->boxes[k].left <= right && done;
       k++) {
    const tp_box_of_feature *other = c->boxes + k;
    const tp_feature *base = of_base->items + other->feature;
    const bool near_it = other->right >= left && other->low <= box.high + c->margin &&
                         other->high >= box.low - c->margin;
    if (near_it && tp_features_can_meet(feature, base) && may_face(feature, base, placing)) {
      done = add_pair(c, own, other->feature);
    }
  }
  return done;
}

static int by_features(const void *left, const void *right) {
  const tp_pair *a = left, *b = right;
  if (a->of_block != b->of_block) return a->of_block < b->of_block ? -1 : 1;
  return a->of_base < b->of_base ? -1 : a->of_base > b->of_base;
}

bool tp_near_pairs_find(tp_near_pairs *c, const tp_features *of_block, const tp_features *of_base,
                        const tp_body_state *state) {
  const tp_placing placing = tp_placing_of(state);
  bool done = c->pairs != NULL || (c->pairs = malloc(sizeof *c->pairs)) != NULL;
  if (c->room == 0) c->room = 1;
  c->count = 0;
  c->found_at = *state;
  for (long k = 0; k < of_block->count && done; k++) {
    done = find_of(c, k, of_block, of_base, &placing);
  }
  if (done) qsort(c->pairs, (size_t)c->count, sizeof *c->pairs, by_features);
  return done;
}
