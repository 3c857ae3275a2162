/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Incremental intersection of half-spaces with conflict lists (Clarkson and Shor 1989): each plane
 * replaces the run of rays below it by two new ones. */

#include "motion/solid_cone.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

void tp_solid_cone_clear(tp_solid_cone *c) {
  for (long k = 0; k < c->room; k++) tp_vector_clear(&c->rays[k].twist);
  for (int k = 0; k < 2; k++) tp_vector_clear(&c->h[k]);
  free(c->rays);
  free(c->next);
  free(c->below);
  memset(c, 0, sizeof *c);
}

static bool make_room(tp_solid_cone *c) {
  const long before = c->room;
  tp_solid_ray *more = tp_grow(c->rays, before, &c->room, sizeof *more);
  if (more == NULL) return false;
  for (long k = before; k < c->room; k++) {
    tp_vector_init(&more[k].twist);
    more[k].after = k + 1 < c->room ? k + 1 : c->unused;
  }
  c->unused = before;
  c->rays = more;
  return true;
}

/* The ray on two faces, the second next after the first; -1 when memory is exhausted. */
static long add_ray(tp_solid_cone *c, long first, long second) {
  if (c->unused < 0 && !make_room(c)) return -1;
  const long ray = c->unused;
  tp_solid_ray *own = c->rays + ray;
  c->unused = own->after;
  tp_normals_set_h(&c->h[0], c->n, first);
  tp_normals_set_h(&c->h[1], c->n, second);
  tp_vector_cross(&own->twist, &c->h[0], &c->h[1], c->n->judge.precision);
  tp_normals_near(own->near, &own->twist);
  own->face = second;
  own->lines = -1;
  c->count++;
  return ray;
}

static void link_rays(tp_solid_cone *c, long before, long after) {
  c->rays[before].after = after;
  c->rays[after].before = before;
}

static int sign_at(tp_solid_cone *c, long line, long ray) {
  const tp_solid_ray *own = c->rays + ray;
  c->checks++;
  return tp_normal_sign(c->n, c->n->items + line, &own->twist, own->near, -1);
}

static void hang(tp_solid_cone *c, long line, long ray) {
  c->next[line] = c->rays[ray].lines;
  c->rays[ray].lines = line;
}

/* A line to one of some rays: one that it cuts off, else one that it passes through, else none.
 * False where a sign is open. */
static bool locate(tp_solid_cone *c, long line, const long *rays, int count) {
  long through = -1;
  c->below[line] = -1;
  for (int k = 0; k < count; k++) {
    const int sign = sign_at(c, line, rays[k]);
    if (sign == TP_OPEN_SIGN) return false;
    if (sign < 0) {
      c->below[line] = rays[k];
      hang(c, line, rays[k]);
      return true;
    }
    if (sign == 0 && through < 0) through = rays[k];
  }
  if (through >= 0) hang(c, line, through);
  return true;
}

/* What a line cuts off: all rays between two that stay, which may be one. */
typedef struct gap {
  bool all;         /* none stays */
  long left, right; /* in the order of the circle the gap begins after one, ends before the other */
  int left_sign, right_sign;
} gap;

/* From a ray that the line cuts off. False where a sign is open. */
static bool find_gap(gap *g, tp_solid_cone *c, long line) {
  const long within = c->below[line];
  g->left_sign = g->right_sign = -1;
  for (g->left = c->rays[within].before; g->left != within; g->left = c->rays[g->left].before) {
    g->left_sign = sign_at(c, line, g->left);
    if (g->left_sign >= 0) break;
  }
  g->all = g->left == within;
  if (g->all) return true;
  for (g->right = c->rays[within].after; g->right_sign < 0; g->right = c->rays[g->right].after) {
    g->right_sign = g->right == g->left ? g->left_sign : sign_at(c, line, g->right);
    if (g->right_sign >= 0) break;
  }
  return g->left_sign != TP_OPEN_SIGN && g->right_sign != TP_OPEN_SIGN;
}

/* Is nothing above the line's plane? What lies in it is left, a ray or the face between two. */
static bool flattens(const gap *g, const tp_solid_cone *c) {
  if (g->all) return true;
  return g->left_sign == 0 && g->right_sign == 0 &&
         (g->left == g->right || c->rays[g->right].after == g->left);
}

static void flatten(tp_solid_cone *c, const gap *g) {
  c->flat = true;
  c->count = g->all ? 0 : g->left == g->right ? 1 : 2;
  if (!g->all) c->start = g->right;
}

/* The rays of the gap, cut off already, are given back, and so is what waits at them. */
static bool empty_gap(tp_solid_cone *c, long first, long last, long line, const long ends[2]) {
  bool told = true;
  for (long ray = first, after = -1; told; ray = after) {
    after = c->rays[ray].after;
    for (long k = c->rays[ray].lines, then = -1; k >= 0 && told; k = then) {
      then = c->next[k];
      if (k != line) told = locate(c, k, ends, 2);
    }
    c->rays[ray].after = c->unused;
    c->unused = ray;
    c->count--;
    if (ray == last) break;
  }
  return told;
}

/* One line: its face between two rays, new ones but where it passes through those that stay. */
static tp_motion_outcome cut(tp_solid_cone *c, long line) {
  gap g;
  if (!find_gap(&g, c, line)) return TP_MOTION_OPEN;
  if (flattens(&g, c)) {
    flatten(c, &g);
    return TP_MOTION_PROVEN;
  }
  const long first = c->rays[g.left].after, last = c->rays[g.right].before;
  const long left_face = c->rays[g.left].face, right_face = c->rays[last].face;
  long ends[2] = {g.left, g.right};
  if (g.left_sign > 0) ends[0] = add_ray(c, left_face, line);
  if (g.right_sign > 0) ends[1] = add_ray(c, line, right_face);
  if (ends[0] < 0 || ends[1] < 0) return TP_MOTION_OUT_OF_MEMORY;
  if (g.left_sign > 0) link_rays(c, g.left, ends[0]);
  if (g.right_sign > 0) {
    link_rays(c, ends[1], g.right);
    c->rays[ends[1]].face = right_face;
  }
  link_rays(c, ends[0], ends[1]);
  c->rays[ends[0]].face = line;
  c->below[line] = -1;
  c->start = ends[0];
  if (g.left_sign == 0) hang(c, left_face, ends[0]);
  if (g.right_sign == 0) hang(c, right_face, ends[1]);
  return empty_gap(c, first, last, line, ends) ? TP_MOTION_PROVEN : TP_MOTION_OPEN;
}

/* Three half-spaces, and what of the other lines each of their rays has. */
static tp_motion_outcome begin(tp_solid_cone *c, const long *lines, long count) {
  long rays[3];
  for (int k = 0; k < 3; k++) { /* ray k lies on lines k - 1 and k */
    rays[k] = add_ray(c, lines[(k + 2) % 3], lines[k]);
    if (rays[k] < 0) return TP_MOTION_OUT_OF_MEMORY;
  }
  for (int k = 0; k < 3; k++) {
    link_rays(c, rays[k], rays[(k + 1) % 3]);
    c->below[lines[k]] = -1;
  }
  c->start = rays[0];
  for (long k = 3; k < count; k++) {
    if (!locate(c, lines[k], rays, 3)) return TP_MOTION_OPEN;
  }
  return TP_MOTION_PROVEN;
}

static bool pay(tp_solid_cone *c, tp_work *work) {
  static const double at_once = 1e6;   /* checks between two bills */
  static const double by_column = 0.1; /* a check of doubles, of the price of a column */
  if (c->checks < at_once) return true;
  const long columns = (long)(c->checks * by_column);
  c->checks = 0;
  return tp_work_spend(work, 1, columns, 1);
}

tp_motion_outcome tp_solid_cone_init(tp_solid_cone *c, const tp_normals *n, const long *lines,
                                     long count, tp_work *work) {
  *c = (tp_solid_cone){.n = n, .unused = -1};
  for (int k = 0; k < 2; k++) tp_vector_init(&c->h[k]);
  c->next = calloc((size_t)n->count, sizeof *c->next);
  c->below = calloc((size_t)n->count, sizeof *c->below);
  tp_motion_outcome done = TP_MOTION_OUT_OF_MEMORY;
  if (c->next != NULL && c->below != NULL) done = begin(c, lines, count);
  for (long k = 3; k < count && done == TP_MOTION_PROVEN && !c->flat; k++) {
    if (c->below[lines[k]] >= 0) done = cut(c, lines[k]);
    if (done == TP_MOTION_PROVEN && !pay(c, work)) done = TP_MOTION_TOO_DEAR;
  }
  if (done != TP_MOTION_PROVEN) tp_solid_cone_clear(c);
  return done;
}
