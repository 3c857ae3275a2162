/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Strips by counting the joints that a centroid lies behind, in doubles from the toe: whether it
 * lies on a joint is of no matter but for the name. */

#define _GNU_SOURCE /* qsort_r */
#include "jointing/names.h"

#include "number/between.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NAME = 100 };

/* The joints of a set as doubles: behind one is what has a normal * (x, y) above its offset. */
typedef struct strip_line {
  double x, y, offset;
} strip_line;

/* In the frame of the cuts, from the toe. */
static void find_centroid(double centroid[2], const tp_polyline *ring, const tp_cuts *cuts) {
  const double sign = cuts->slope->right ? -1 : 1;
  double twice = 0, sum[2] = {0, 0};
  for (long k = 1; k + 1 < ring->count; k++) {
    const double px = tp_ratio_apart(ring->x + k, ring->x),
                 py = tp_ratio_apart(ring->y + k, ring->y);
    const double qx = tp_ratio_apart(ring->x + k + 1, ring->x),
                 qy = tp_ratio_apart(ring->y + k + 1, ring->y);
    const double own = px * qy - py * qx;
    twice += own;
    sum[0] += own * (px + qx) / 3;
    sum[1] += own * (py + qy) / 3;
  }
  centroid[0] = sign * (tp_ratio_apart(ring->x, cuts->slope->toe_x.value) + sum[0] / twice);
  centroid[1] = tp_ratio_apart(ring->y, cuts->slope->toe_y.value) + sum[1] / twice;
}

static strip_line *make_lines(const tp_cuts *cuts, long set) {
  const tp_joint_traces *traces = cuts->traces + set;
  strip_line *lines = calloc((size_t)traces->count + 1, sizeof *lines);
  if (lines == NULL || traces->count == 0) return lines;
  for (long k = 0; k < traces->count; k++) {
    const tp_joint_trace *own = traces->lines + k;
    strip_line *line = lines + k;
    line->x = (own->left ? -1 : 1) * fmpq_get_d(own->along.y);
    line->y = (own->left ? 1 : -1) * fmpq_get_d(own->along.x);
    line->offset = line->x * tp_ratio_apart(own->foot.x, cuts->toe.x) +
                   line->y * tp_ratio_apart(own->foot.y, cuts->toe.y);
  }
  return lines;
}

static bool set_strips(tp_cut_blocks *blocks, const tp_cuts *cuts, const double *centroids,
                       long set) {
  strip_line *lines = make_lines(cuts, set);
  if (lines == NULL) return false;
  long least = -1;
  for (long b = 0; b < blocks->count; b++) {
    long behind = 0;
    for (long k = 0; k < cuts->traces[set].count; k++) {
      behind += lines[k].x * centroids[2 * b] + lines[k].y * centroids[2 * b + 1] > lines[k].offset;
    }
    blocks->blocks[b].strips[set] = behind;
    if (!blocks->blocks[b].ground && (least < 0 || behind < least)) least = behind;
  }
  for (long b = 0; b < blocks->count; b++) blocks->blocks[b].strips[set] += 1 - least;
  free(lines);
  return true;
}

/* ---- order -------------------------------------------------------------------------------------
 */

static int compare_strips(const tp_cut_block *a, const tp_cut_block *b, long set_count) {
  for (long s = 0; s < set_count; s++) {
    if (a->strips[s] != b->strips[s]) return a->strips[s] < b->strips[s] ? -1 : 1;
  }
  return 0;
}

typedef struct seated {
  tp_cut_block block;
  double x, y;
} seated;

static int compare_blocks(const void *first, const void *second, void *set_count) {
  const seated *a = first, *b = second;
  if (a->block.ground != b->block.ground) return a->block.ground ? -1 : 1;
  const int order =
      a->block.ground ? 0 : compare_strips(&a->block, &b->block, *(const long *)set_count);
  if (order != 0) return order;
  if (a->x != b->x) return a->x < b->x ? -1 : 1;
  return (a->y > b->y) - (a->y < b->y);
}

static bool sort(tp_cut_blocks *blocks, const double *centroids, long set_count) {
  seated *all = calloc((size_t)blocks->count + 1, sizeof *all);
  if (all == NULL) return false;
  for (long b = 0; b < blocks->count; b++) {
    all[b] = (seated){blocks->blocks[b], centroids[2 * b], centroids[2 * b + 1]};
  }
  qsort_r(all, (size_t)blocks->count, sizeof *all, compare_blocks, &set_count);
  for (long b = 0; b < blocks->count; b++) blocks->blocks[b] = all[b].block;
  free(all);
  return true;
}

/* ---- names -------------------------------------------------------------------------------------
 */

/* `same` how many before it have the same strips, or are ground too. */
static bool set_name(tp_cut_block *own, long set_count, long same) {
  char text[MOST_NAME] = "ground";
  int at = own->ground ? (int)strlen(text) : 0;
  for (long s = 0; s < set_count && !own->ground; s++) {
    at +=
        snprintf(text + at, sizeof text - (size_t)at, "%c%ld", s == 0 ? 'B' : '-', own->strips[s]);
  }
  if (same > 0) {
    snprintf(text + at, sizeof text - (size_t)at, "%s%ld", own->ground ? " " : ".", same + 1);
  }
  own->name = strdup(text);
  return own->name != NULL;
}

static bool set_names(tp_cut_blocks *blocks, long set_count) {
  long same = 0;
  bool done = true;
  for (long b = 0; b < blocks->count && done; b++) {
    tp_cut_block *own = blocks->blocks + b;
    const bool follows = b > 0 && own[-1].ground == own->ground &&
                         (own->ground || compare_strips(own - 1, own, set_count) == 0);
    same = follows ? same + 1 : 0;
    done = set_name(own, set_count, same);
  }
  return done;
}

tp_status tp_cut_blocks_name(tp_cut_blocks *blocks, const tp_cuts *cuts, tp_message *message) {
  const long set_count = cuts->slope->set_count;
  double *centroids = calloc(2 * (size_t)blocks->count + 1, sizeof *centroids);
  bool done = centroids != NULL;
  for (long b = 0; b < blocks->count && done; b++) {
    tp_cut_block *own = blocks->blocks + b;
    find_centroid(centroids + 2 * b, &own->outline, cuts);
    own->strips = calloc((size_t)set_count, sizeof *own->strips);
    done = own->strips != NULL;
  }
  for (long s = 0; s < set_count && done; s++) done = set_strips(blocks, cuts, centroids, s);
  done = done && sort(blocks, centroids, set_count) && set_names(blocks, set_count);
  free(centroids);
  return done ? TP_OK : tp_fail_memory(message, "the blocks of the slope");
}
