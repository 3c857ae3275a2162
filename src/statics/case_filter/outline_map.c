/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vertices read as affine functions from the scene's nodes, and the list of signs (differences,
 * turns, projections) that keep block, base and contact as they are in the scene at hand. */

#include "case_filter/outline_map.h"

#include "case_filter/outline_signs.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

/* ---- vertices ----------------------------------------------------------------------------------
 */

/* Of the base and of all else but the outline nothing may depend on what varies. */
static bool is_fixed_elsewhere(const tp_affine_scene *s) {
  for (const tp_node *part = s->scene->source->first; part != NULL; part = part->next) {
    const bool block = strcmp(part->key, "block") == 0, base = strcmp(part->key, "base") == 0;
    if (strcmp(part->key, "parameters") == 0) continue;
    if (!block && !base && tp_affine_depends(s, part)) return false;
    for (const tp_node *own = block || base ? part->first : NULL; own != NULL; own = own->next) {
      const bool mapped = block ? strcmp(own->key, "outline") == 0 || strcmp(own->key, "slab") == 0
                                : strcmp(own->key, "between") == 0;
      if (!mapped && tp_affine_depends(s, own)) return false;
    }
  }
  return true;
}

/* The k-th point of a list of points. */
static bool read_point(tp_affine *x, tp_affine *y, const tp_outline_mapping *m, const tp_node *list,
                       long k) {
  const tp_node *point = list != NULL && list->kind == TP_NODE_SEQUENCE ? list->first : NULL;
  for (; k > 0 && point != NULL; k--) point = point->next;
  if (point == NULL || point->kind != TP_NODE_SEQUENCE || point->count != 2) return false;
  return tp_affine_read(x, m->scene, point->first) && tp_affine_read(y, m->scene, point->last);
}

/* (0, 0), (w, 0), (w, h), (0, h). */
static bool read_slab(tp_outline_mapping *m, const tp_node *slab) {
  if (m->map->vertex_count != 4) return false;
  return tp_affine_read(m->x + 1, m->scene, tp_node_get(slab, "width")) &&
         tp_affine_read(m->x + 2, m->scene, tp_node_get(slab, "width")) &&
         tp_affine_read(m->y + 2, m->scene, tp_node_get(slab, "height")) &&
         tp_affine_read(m->y + 3, m->scene, tp_node_get(slab, "height"));
}

/* Those of the ring, which has them in its own order: what was read must have their values. */
static bool read_vertices(tp_outline_mapping *m) {
  const tp_scene *scene = m->problem->scene;
  const tp_polyline *ring = m->problem->section.rings;
  const tp_node *block = tp_node_get(scene->source, "block");
  bool done = true;
  if (scene->block.form == TP_OUTLINE_SLAB) {
    done = read_slab(m, tp_node_get(block, "slab"));
  } else {
    const tp_node *outline = tp_node_get(block, "outline");
    for (int k = 0; k < m->map->vertex_count && done; k++) {
      done = read_point(m->x + k, m->y + k, m, outline, tp_polyline_number(ring, k) - 1);
    }
  }
  for (int k = 0; k < m->map->vertex_count && done; k++) {
    tp_affine_value(m->own_x + k, m->x + k, m->variables);
    tp_affine_value(m->own_y + k, m->y + k, m->variables);
    done = fmpq_equal(m->own_x + k, ring->x + k) && fmpq_equal(m->own_y + k, ring->y + k);
  }
  return done;
}

/* Level ground past the vertex; -1 where there is none. */
static int add_end(tp_outline_mapping *m, long vertex, const fmpq_t beyond, bool left) {
  if (fmpq_is_zero(beyond)) return -1;
  const int k = m->map->point_count++;
  fmpq_t by;
  fmpq_init(by);
  if (left) {
    fmpq_neg(by, beyond);
  } else {
    fmpq_set(by, beyond);
  }
  for (int part = 0; part <= TP_AFFINE_VARIABLES; part++) {
    fmpq_set(m->x[k].of + part, m->x[vertex].of + part);
    fmpq_set(m->y[k].of + part, m->y[vertex].of + part);
  }
  fmpq_add(m->x[k].of, m->x[k].of, by);
  tp_affine_value(m->own_x + k, m->x + k, m->variables);
  tp_affine_value(m->own_y + k, m->y + k, m->variables);
  fmpq_clear(by);
  return k;
}

/* The ends of the contact, where the scene names them, are these vertices whatever varies. */
static bool keeps_between(const tp_outline_mapping *m, const long ends[2]) {
  const tp_scene *scene = m->problem->scene;
  if (scene->base.between.count == 0) return true;
  const tp_node *list = tp_node_get(tp_node_get(scene->source, "base"), "between");
  tp_affine x, y;
  tp_affine_init(&x);
  tp_affine_init(&y);
  bool same = scene->base.between.count == 2;
  for (int k = 0; k < 2 && same; k++) {
    same = read_point(&x, &y, m, list, k) && tp_affine_equal(&x, m->x + ends[k]) &&
           tp_affine_equal(&y, m->y + ends[k]);
  }
  tp_affine_clear(&x);
  tp_affine_clear(&y);
  return same;
}

static bool read_points(tp_outline_mapping *m) {
  const tp_scene *scene = m->problem->scene;
  const tp_base *base = &m->problem->base;
  const long count = m->problem->section.rings[0].count;
  const long ends[2] = {base->outline_first, (base->outline_first + base->mated_count) % count};
  if (!is_fixed_elsewhere(m->scene) || !read_vertices(m) || !keeps_between(m, ends)) return false;
  m->map->point_count = m->map->vertex_count;
  m->left_end = add_end(m, ends[0], scene->base.beyond_left.value, true);
  m->right_end = add_end(m, ends[1], scene->base.beyond_right.value, false);
  return true;
}

/* ---- the contact -------------------------------------------------------------------------------
 */

/* The point that a point of the lattice is, -1 for none. */
static int point_at(const tp_outline_mapping *m, long at) {
  const tp_lattice *l = &m->problem->lattice;
  const tp_base *base = &m->problem->base;
  if (at < l->start[1]) return (int)(at - l->start[0]);
  const long own = at - l->start[1] - base->mated_first;
  if (own >= 0 && own <= base->mated_count) {
    return (int)((base->outline_first + own) % m->map->vertex_count);
  }
  return own == -1 ? m->left_end : own == base->mated_count + 1 ? m->right_end : -1;
}

static bool take_point(tp_outline_mapping *m, int k) {
  const tp_plan_point *own = m->plan->points + k;
  const tp_facet *facet = m->problem->contact.facets + own->facet;
  const bool second = k > 0 && m->plan->points[k - 1].facet == own->facet;
  const int from = point_at(m, facet->t0), to = point_at(m, facet->t1);
  tp_mapped_point *p = m->map->points + k;
  *p = (tp_mapped_point){point_at(m, second ? facet->q1 : facet->q0), from, to, false};
  if (from < 0 || to < 0 || p->vertex < 0 || p->vertex >= m->map->vertex_count) return false;
  p->is_level = tp_affine_equal(m->y + from, m->y + to);
  if (from >= m->map->vertex_count || to >= m->map->vertex_count) p->from = -1; /* level ground */
  return true;
}

/* Is a difference of points the same whatever varies? */
static bool is_constant(const tp_outline_mapping *m, const tp_mapped_point *p) {
  tp_affine dx, dy;
  tp_affine_init(&dx);
  tp_affine_init(&dy);
  tp_affine_sub(&dx, m->x + p->to, m->x + p->from);
  tp_affine_sub(&dy, m->y + p->to, m->y + p->from);
  const bool constant = tp_affine_is_constant(&dx) && tp_affine_is_constant(&dy);
  tp_affine_clear(&dx);
  tp_affine_clear(&dy);
  return constant;
}

/* Facets that are parallel stay so: level ones, those that stay as they are, or one facet. */
static bool stay_parallel(const tp_outline_mapping *m) {
  for (int k = 0; k < m->plan->point_count; k++) {
    for (int j = 0; j < k; j++) {
      const tp_mapped_point *a = m->map->points + k, *b = m->map->points + j;
      if (m->plan->points[k].axis != m->plan->points[j].axis) continue;
      const bool same = a->from == b->from && a->to == b->to;
      if (same || (a->is_level && b->is_level)) continue;
      if (a->from < 0 || b->from < 0 || !is_constant(m, a) || !is_constant(m, b)) return false;
    }
  }
  return true;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static tp_near near_of(const fmpq_t value) {
  enum { BITS = 128 };
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, value, BITS);
  const tp_near near = fmpq_is_zero(value) ? (tp_near){0, 0} : tp_ball_near(ball);
  arb_clear(ball);
  return near;
}

static void round_affine(tp_near_affine *near, const tp_affine *own) {
  for (int part = 0; part <= TP_AFFINE_VARIABLES; part++) {
    near->of[part] = near_of(own->of + part);
  }
}

/* From the first vertex, exactly: in doubles a difference would be as coarse as coordinates are far
 * from the origin. */
static void round_points(tp_outline_mapping *m) {
  tp_outline_map *map = m->map;
  tp_affine apart;
  tp_affine_init(&apart);
  round_affine(&map->first_x, m->x);
  round_affine(&map->first_y, m->y);
  for (int k = 0; k < map->point_count; k++) {
    map->x[k].varies = !tp_affine_is_constant(m->x + k);
    map->y[k].varies = !tp_affine_is_constant(m->y + k);
    tp_affine_sub(&apart, m->x + k, m->x);
    round_affine(map->x + k, &apart);
    tp_affine_sub(&apart, m->y + k, m->y);
    round_affine(map->y + k, &apart);
  }
  tp_affine_clear(&apart);
}

static void find(tp_outline_mapping *m, tp_direction towards) {
  m->fits = m->scene->parameters != NULL && read_points(m);
  for (int k = 0; k < m->plan->point_count && m->fits; k++) m->fits = take_point(m, k);
  m->fits = m->fits && stay_parallel(m);
  if (m->fits) tp_outline_mapping_add_signs(m, towards);
  if (m->fits) round_points(m);
}

/* An outline by its vertices, or a slab, on its mated base, where and as it is given. */
static bool is_plain(const tp_problem *problem) {
  const tp_scene *scene = problem->scene;
  const tp_world *world = problem->placement.world; /* a slope turns nothing */
  const tp_base_description *base = &scene->base;
  const bool form =
      scene->block.form == TP_OUTLINE_SLAB || scene->block.form == TP_OUTLINE_VERTICES;
  return form && scene->source != NULL && base->mated && problem->section.ring_count == 1 &&
         problem->section.rings[0].count <= TP_MAP_VERTICES && problem->placement.jointed == NULL &&
         problem->placement.rested == NULL && problem->placement.snapped == NULL &&
         (world == NULL || world->unturned) && !base->below.given && !base->left_of.given &&
         !base->right_of.given;
}

/* Allocates what is exact; false when memory is exhausted. */
static bool begin(tp_outline_mapping *m, const tp_scene_key *keys, size_t count) {
  const tp_scene *scene = m->problem->scene;
  m->variables = _fmpq_vec_init(TP_AFFINE_VARIABLES);
  m->own_x = _fmpq_vec_init(TP_MAP_POINTS);
  m->own_y = _fmpq_vec_init(TP_MAP_POINTS);
  for (int k = 0; k < TP_MAP_POINTS; k++) {
    tp_affine_init(m->x + k);
    tp_affine_init(m->y + k);
  }
  tp_message unused;
  bool known = true;
  for (size_t k = 0; k < count && known; k++) {
    known = tp_scene_key_value(m->variables + k, keys + k, scene, &unused) == TP_OK;
  }
  return known;
}

static void end(tp_outline_mapping *m) {
  _fmpq_vec_clear(m->variables, TP_AFFINE_VARIABLES);
  _fmpq_vec_clear(m->own_x, TP_MAP_POINTS);
  _fmpq_vec_clear(m->own_y, TP_MAP_POINTS);
  for (int k = 0; k < TP_MAP_POINTS; k++) {
    tp_affine_clear(m->x + k);
    tp_affine_clear(m->y + k);
  }
}

tp_status tp_outline_map_init(tp_outline_map *map, bool *fits, const tp_problem *problem,
                              tp_direction towards, const tp_contact_plan *plan,
                              const tp_scene_key *keys, size_t count, tp_message *message) {
  *map = (tp_outline_map){.variable_count = (int)count,
                          .vertex_count = (int)problem->section.rings[0].count,
                          .towards = towards,
                          .metres_per_unit = fmpq_get_d(problem->scene->metres_per_unit)};
  *fits = false;
  if (!is_plain(problem) || count > TP_AFFINE_VARIABLES) return TP_OK;
  tp_affine_scene scene;
  if (!tp_affine_scene_init(&scene, problem->scene, keys, count)) {
    return tp_fail_memory(message, "the scene");
  }
  tp_outline_mapping m = {.map = map, .problem = problem, .plan = plan, .scene = &scene};
  if (begin(&m, keys, count)) find(&m, towards);
  *fits = m.fits;
  end(&m);
  tp_affine_scene_clear(&scene);
  return TP_OK;
}
