/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rays and faces of the cone of twists from the double description of its outermost normal lines;
 * each ray is identified as a turn about a contact point, a slide along an axis, or another
 * twist. */

#include "motion/twists.h"

#include "common/grow.h"
#include "motion/double_description.h"

#include <stdlib.h>
#include <string.h>

void tp_twists_clear(tp_twists *t) {
  for (long k = 0; k < t->ray_count; k++) tp_vector_clear(&t->rays[k].twist);
  free(t->rays);
  free(t->faces);
  free(t->lines);
  memset(t, 0, sizeof *t);
}

static tp_ray *next_ray(tp_twists *t) {
  tp_ray *more = tp_grow(t->rays, t->ray_count, &t->ray_room, sizeof *more);
  if (more == NULL) return NULL;
  t->rays = more;
  tp_ray *ray = t->rays + t->ray_count++;
  memset(ray, 0, sizeof *ray);
  tp_vector_init(&ray->twist);
  ray->site = ray->axis = -1;
  return ray;
}

/* (y, -x, 1) */
static void turn_about(tp_vector *twist, const tp_normals *n, long point, int sense) {
  const arb_struct x = tp_cones_x(n->cones, point), y = tp_cones_y(n->cones, point);
  tp_ball_turn(twist->of, &x, &y, n->judge.precision);
  if (sense < 0) tp_vector_neg(twist);
}

long tp_twists_add_turn(tp_twists *t, const tp_normals *n, long point, int sense) {
  tp_ray *ray = next_ray(t);
  if (ray == NULL) return -1;
  turn_about(&ray->twist, n, point, sense);
  ray->site = n->cones->points[point].site;
  tp_normals_near(ray->near, &ray->twist);
  return t->ray_count - 1;
}

static bool add_ray(tp_twists *t, const tp_vector *twist, bool back) {
  tp_ray *ray = next_ray(t);
  if (ray == NULL) return false;
  for (int k = 0; k < 3; k++) arb_set(ray->twist.of + k, twist->of + k);
  if (back) tp_vector_neg(&ray->twist);
  return true;
}

bool tp_twists_tell_line(tp_twists *t, long line) {
  long *more = tp_grow(t->lines, t->line_count, &t->line_room, sizeof *more);
  if (more == NULL) return false;
  t->lines = more;
  tp_ray *own = t->rays + t->ray_count - 1;
  if (own->line_count++ == 0) own->first_line = t->line_count;
  t->lines[t->line_count++] = line;
  return true;
}

static int by_number(const void *left, const void *right) {
  const long a = *(const long *)left, b = *(const long *)right;
  return (a > b) - (a < b);
}

/* All lines on a ray of a cone of three dimensions. */
static bool tell_lines(tp_twists *t, const tp_description *d, long ray) {
  const tp_described_ray *own = d->rays + ray;
  bool done = tp_twists_tell_line(t, d->rays[(ray + d->count - 1) % d->count].normal) &&
              tp_twists_tell_line(t, own->normal);
  for (long k = own->lines; k >= 0 && done; k = d->next[k]) done = tp_twists_tell_line(t, k);
  const tp_ray *made = t->rays + t->ray_count - 1;
  if (done) qsort(t->lines + made->first_line, (size_t)made->line_count, sizeof(long), by_number);
  return done;
}

static void add_face(tp_twists *t, long from, long to, long normal) {
  t->faces[t->face_count++] = (tp_twist_face){from, to, normal};
}

/* Of two normal lines on one ray: a site on both, through which they pass, is what it turns about,
 * as exactly as its coordinates. Those of one axis make it a slide. */
static void describe_ray(tp_ray *ray, const tp_normals *n, long first, long second) {
  const tp_normal *a = n->items + first, *b = n->items + second;
  for (long k = a->first; k < a->first + a->count && ray->site < 0; k++) {
    const long point = n->order[k], site = n->cones->points[point].site;
    if (n->families[a->family].axis == n->families[b->family].axis) break;
    if (!tp_normal_has_site(n, b, site) || arb_contains_zero(ray->twist.of + 2)) continue;
    const int sense = arf_sgn(arb_midref(ray->twist.of + 2));
    turn_about(&ray->twist, n, point, sense);
    ray->site = site;
  }
}

/* A ray without turning: along the axis of a normal line that it lies on. */
static tp_motion_outcome finish_ray(tp_ray *ray, const tp_normals *n, long normal) {
  const int turns = ray->site >= 0 ? 1
                                   : tp_judge_sign(&n->judge, ray->twist.of + 2,
                                                   tp_vector_log2_size(&ray->twist));
  if (turns == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  if (turns == 0) {
    const long point = n->order[n->items[normal].first];
    arb_t side;
    arb_init(side);
    arb_mul_fmpz(side, ray->twist.of, tp_normals_tx(n, point), n->judge.precision);
    arb_addmul_fmpz(side, ray->twist.of + 1, tp_normals_ty(n, point), n->judge.precision);
    const bool back = arf_sgn(arb_midref(side)) < 0;
    const bool told = !arb_contains_zero(side);
    arb_set_fmpz(ray->twist.of, tp_normals_tx(n, point));
    arb_set_fmpz(ray->twist.of + 1, tp_normals_ty(n, point));
    arb_zero(ray->twist.of + 2);
    if (back) tp_vector_neg(&ray->twist);
    ray->axis = n->families[n->items[normal].family].axis;
    arb_clear(side);
    if (!told) return TP_MOTION_OPEN;
  }
  tp_normals_near(ray->near, &ray->twist);
  return TP_MOTION_PROVEN;
}

/* A pointed cone as it was cut out: ray k lies on the lines k - 1 and k, face k between rays k and
 * k + 1 on line k. */
static bool take_pointed(tp_twists *t, const tp_description *d) {
  for (long k = 0; k < d->count; k++) {
    if (!add_ray(t, &d->rays[k].twist, false)) return false;
    if (!d->flat && !tell_lines(t, d, k)) return false;
  }
  if (d->count == 2 && d->flat) {
    add_face(t, 0, 1, d->rays[0].normal);
  } else if (d->count > 2) {
    for (long k = 0; k < d->count; k++) add_face(t, k, (k + 1) % d->count, d->rays[k].normal);
  }
  t->has_interior = d->count > 2;
  return true;
}

/* A ray of K on a normal line, across the line within K: turning about the first point there, on
 * the side of what was cut out. Where that is no side, as it was cut out. */
static tp_motion_outcome add_across(tp_twists *t, const tp_normals *n, const tp_description *d,
                                    long k) {
  const tp_vector *across = &d->rays[k].twist;
  const long point = n->order[n->items[d->rays[k].normal].first];
  tp_vector turn;
  arb_t side;
  tp_vector_init(&turn);
  arb_init(side);
  turn_about(&turn, n, point, 1);
  tp_vector_dot(side, &turn, across, n->judge.precision);
  const int sign = tp_vector_judge(&n->judge, side, &turn, across);
  tp_vector_clear(&turn);
  arb_clear(side);
  if (sign == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  const bool done =
      sign == 0 ? add_ray(t, across, false) : tp_twists_add_turn(t, n, point, sign) >= 0;
  return done ? TP_MOTION_PROVEN : TP_MOTION_OUT_OF_MEMORY;
}

/* l, the rays of what is left across it, and -l. */
static tp_motion_outcome take_with_line(tp_twists *t, const tp_normals *n,
                                        const tp_description *d) {
  bool done = add_ray(t, &d->line, false);
  for (long k = 0; k < d->count && done; k++) {
    if (k == 1) done = add_ray(t, &d->line, true);
    const tp_motion_outcome added = done ? add_across(t, n, d, k) : TP_MOTION_OUT_OF_MEMORY;
    if (added != TP_MOTION_PROVEN) return added;
  }
  if (d->count < 2) done = done && add_ray(t, &d->line, true);
  if (!done) return TP_MOTION_OUT_OF_MEMORY;
  if (d->count == 0) return TP_MOTION_PROVEN;
  add_face(t, 0, 1, d->rays[0].normal);
  add_face(t, 1, 2, d->rays[0].normal);
  t->has_interior = d->count == 2;
  if (d->count == 2) {
    add_face(t, 2, 3, d->rays[1].normal);
    add_face(t, 3, 0, d->rays[1].normal);
  }
  return TP_MOTION_PROVEN;
}

/* One plane: u along the facet, v = h x u turning, and back. */
static bool take_plane(tp_twists *t, const tp_description *d, const tp_normals *n) {
  tp_vector h, u, v;
  tp_vector_init(&h);
  tp_vector_init(&u);
  tp_vector_init(&v);
  const long point = n->order[n->items[d->plane].first];
  tp_normals_set_h(&h, n, d->plane);
  arb_set_fmpz(u.of, tp_normals_tx(n, point));
  arb_set_fmpz(u.of + 1, tp_normals_ty(n, point));
  tp_vector_cross(&v, &h, &u, n->judge.precision);
  const bool done = add_ray(t, &u, false) && add_ray(t, &v, false) && add_ray(t, &u, true) &&
                    add_ray(t, &v, true);
  for (long k = 0; k < 4; k++) add_face(t, k, (k + 1) % 4, d->plane);
  t->has_interior = !d->flat;
  tp_vector_clear(&h);
  tp_vector_clear(&u);
  tp_vector_clear(&v);
  return done;
}

/* A normal line that the ray lies on. */
static long normal_of(const tp_twists *t, const tp_description *d, long ray) {
  for (long k = 0; k < t->face_count; k++) {
    if (t->faces[k].from == ray || t->faces[k].to == ray) return t->faces[k].normal;
  }
  return d->rank == 3 ? d->rays[ray].normal : d->plane;
}

static tp_motion_outcome finish_rays(tp_twists *t, const tp_normals *n, const tp_description *d) {
  const bool solid = d->rank == 3 && d->count > 2; /* ray k lies on faces k - 1 and k */
  for (long k = 0; k < t->ray_count; k++) {
    if (solid) {
      describe_ray(t->rays + k, n, d->rays[k].normal,
                   d->rays[(k + d->count - 1) % d->count].normal);
    }
    const long own = solid ? d->rays[k].normal : normal_of(t, d, k);
    const tp_motion_outcome outcome = finish_ray(t->rays + k, n, own);
    if (outcome != TP_MOTION_PROVEN) return outcome;
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome take(tp_twists *t, const tp_normals *n, const tp_description *d) {
  t->faces = calloc((size_t)d->count + 4, sizeof *t->faces);
  if (t->faces == NULL) return TP_MOTION_OUT_OF_MEMORY;
  t->everything = d->rank == 0;
  if (d->rank == 2) {
    const tp_motion_outcome outcome = take_with_line(t, n, d);
    if (outcome != TP_MOTION_PROVEN) return outcome;
  } else if ((d->rank == 3 && !take_pointed(t, d)) || (d->rank == 1 && !take_plane(t, d, n))) {
    return TP_MOTION_OUT_OF_MEMORY;
  }
  return finish_rays(t, n, d);
}

tp_motion_outcome tp_twists_init(tp_twists *t, const tp_normals *n, tp_work *work) {
  memset(t, 0, sizeof *t);
  tp_description d;
  tp_motion_outcome outcome = tp_description_init(&d, n, work);
  if (outcome != TP_MOTION_PROVEN) return outcome;
  outcome = take(t, n, &d);
  tp_description_clear(&d);
  if (outcome != TP_MOTION_PROVEN) tp_twists_clear(t);
  return outcome;
}
