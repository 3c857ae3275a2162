/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points put into families and normal lines, in one pass over their order. */

#include "motion/normals_order.h"

#include <stdlib.h>
#include <string.h>

void tp_normals_clear(tp_normals *n) {
  for (long k = 0; k < n->family_count; k++) {
    fmpz_clear(&n->families[k].tx);
    fmpz_clear(&n->families[k].ty);
  }
  free(n->items);
  free(n->families);
  free(n->order);
  free(n->same);
  free(n->family_of);
  free(n->normal_of);
  memset(n, 0, sizeof *n);
}

static bool is_new_family(const tp_normals_order *order, long k) {
  return k == 0 || !tp_normals_order_same_axis(order, k - 1, k) ||
         tp_normal_entry_is_against(order->entries + k) !=
             tp_normal_entry_is_against(order->entries + k - 1);
}

static int sense_of(const tp_cones *cones, long point) {
  return cones->senses == NULL ? 0 : cones->senses[point];
}

/* Of the entries before one on its line, with its site, the first with its friction; else its own
 * point. */
static long first_alike(const tp_normals *n, const tp_normals_order *order, long k) {
  const tp_cone_point *points = n->cones->points;
  const long own = tp_normal_entry_point(order->entries + k);
  for (long j = k - 1; j >= n->items[n->count - 1].first; j--) {
    const long other = tp_normal_entry_point(order->entries + j);
    if (points[other].site != points[own].site) break;
    if (tp_cones_own(n->cones, other) == tp_cones_own(n->cones, own) &&
        sense_of(n->cones, other) == sense_of(n->cones, own)) {
      return n->same[other];
    }
  }
  return own;
}

static tp_motion_outcome gather(tp_normals *n, const tp_normals_order *order) {
  for (long k = 0; k < order->count; k++) {
    const tp_normal_entry *e = order->entries + k, *before = k > 0 ? e - 1 : NULL;
    const long point = tp_normal_entry_point(e);
    const bool is_against = tp_normal_entry_is_against(e);
    n->order[k] = (int32_t)point;
    const bool same_axis = before != NULL && tp_normals_order_same_axis(order, k - 1, k);
    const bool same_family = same_axis && tp_normal_entry_is_against(before) == is_against;
    const int same_line = same_family ? tp_normals_order_same_line(order, k - 1, k, &n->judge) : 0;
    if (same_line == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (!same_family) {
      const long axis = n->family_count == 0 ? 0 : n->families[n->family_count - 1].axis;
      n->families[n->family_count++] =
          (tp_contact_family){.first = (int32_t)n->count,
                              .axis = (int32_t)(same_axis || before == NULL ? axis : axis + 1),
                              .sense = is_against ? -1 : 1};
      tp_contact_family *family = n->families + n->family_count - 1;
      tp_normals_order_direction(&family->tx, &family->ty, n->cones, point);
    }
    if (same_line) {
      n->items[n->count - 1].count++;
    } else {
      n->families[n->family_count - 1].count++;
      tp_normal *own = n->items + n->count++;
      *own = (tp_normal){.first = (int32_t)k, .count = 1, .family = (int32_t)n->family_count - 1};
      tp_normals_order_near(own->near, order, k, n->families + n->family_count - 1);
    }
    n->family_of[point] = (int32_t)n->family_count - 1;
    n->normal_of[point] = (int32_t)n->count - 1;
    n->same[point] = (int32_t)(same_line ? first_alike(n, order, k) : point);
  }
  return TP_MOTION_PROVEN;
}

static bool make_room(tp_normals *n, const tp_normals_order *order) {
  const size_t room = (size_t)order->count + 1;
  size_t families = 1;
  for (long k = 0; k < order->count; k++) families += is_new_family(order, k);
  n->order = calloc(room, sizeof *n->order);
  n->same = calloc(room, sizeof *n->same);
  n->normal_of = calloc(room, sizeof *n->normal_of);
  n->family_of = calloc(room, sizeof *n->family_of);
  n->items = calloc(room, sizeof *n->items);
  n->families = calloc(families, sizeof *n->families);
  return n->order != NULL && n->same != NULL && n->family_of != NULL && n->normal_of != NULL &&
         n->items != NULL && n->families != NULL;
}

tp_motion_outcome tp_normals_init(tp_normals *n, const tp_cones *cones, const tp_judge *judge) {
  memset(n, 0, sizeof *n);
  n->cones = cones;
  n->judge = *judge;
  n->judge.precision = tp_cones_places_are_exact(cones) ? ARF_PREC_EXACT : judge->bits;
  tp_motion_outcome outcome = TP_MOTION_OUT_OF_MEMORY;
  tp_normals_order order;
  if (tp_normals_order_init(&order, cones, n->judge.precision)) {
    if (make_room(n, &order)) outcome = gather(n, &order);
    tp_normals_order_clear(&order);
  }
  if (outcome != TP_MOTION_PROVEN) tp_normals_clear(n);
  return outcome;
}
