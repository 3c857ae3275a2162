/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Visits every mode once: rays, sectors of faces between the twists about their contact points, and
 * the interior of the cone of twists (docs/mechanics.md section 6a). */

#include "motion/strata.h"

#include "motion/closed.h"

#include <stdlib.h>

/* What is visited. */
typedef struct visiting {
  tp_twists *twists;
  const tp_normals *n;
  bool bonded;
  tp_mode_visit visit;
  void *context;
  tp_closed closed;
  tp_cone_edge *chosen; /* of those that are closed */
} visiting;

/* The mode without the edges of `parted`, a bit for each of those that slip. */
static tp_motion_outcome visit_parted(visiting *v, const tp_mode *mode, const long *slipping,
                                      int count, unsigned parted) {
  tp_mode chosen = *mode;
  chosen.edge_count = 0;
  for (long k = 0; k < mode->edge_count; k++) {
    bool parts = false;
    for (int s = 0; s < count; s++) parts = parts || (slipping[s] == k && (parted >> s & 1) != 0);
    if (!parts) v->chosen[chosen.edge_count++] = mode->edges[k];
  }
  chosen.edges = v->chosen;
  return chosen.edge_count > 0 ? v->visit(v->context, &chosen) : TP_MOTION_PROVEN;
}

/* Cohesion acts along a contact that stays closed. As a block turns, one that slips touches its
 * facet to the first order alone: it may as well part, and holds nothing then. Without cohesion
 * forces of zero are that already. Where two contacts slip and no other is closed, the mode in
 * which one parts is the end of the face on which the other alone is closed. */
static tp_motion_outcome visit_choices(visiting *v, const tp_mode *mode) {
  enum { MOST = 4 };
  tp_motion_outcome done = v->visit(v->context, mode);
  if (done != TP_MOTION_PROVEN || !v->bonded || tp_mode_slides(mode, v->twists)) return done;
  long slipping[MOST];
  int count = 0;
  for (long k = 0; k < mode->edge_count; k++) {
    const int slip = tp_closed_slip_in(v->n, v->twists, mode, mode->edges[k].point);
    if (slip == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (slip == 0) continue;
    if (count == MOST) return TP_MOTION_TOO_DEAR;
    slipping[count++] = k;
  }
  if (count == 0 || (count == mode->edge_count && count <= 2)) return done;
  v->chosen = malloc((size_t)mode->edge_count * sizeof *v->chosen);
  if (v->chosen == NULL) return TP_MOTION_OUT_OF_MEMORY;
  for (unsigned parted = 1; parted < 1U << count && done == TP_MOTION_PROVEN; parted++) {
    done = visit_parted(v, mode, slipping, count, parted);
  }
  free(v->chosen);
  return done;
}

static tp_motion_outcome visit_ray(visiting *v, long ray) {
  const tp_motion_outcome found = tp_closed_of_ray(&v->closed, v->twists, ray, v->n);
  if (found != TP_MOTION_PROVEN) return found;
  const tp_mode mode = {.mechanism = tp_closed_mechanism(&v->closed, v->twists->rays + ray),
                        .ray_count = 1,
                        .rays = {ray},
                        .edge_count = v->closed.edge_count,
                        .edges = v->closed.edges};
  return visit_choices(v, &mode);
}

static tp_motion_outcome visit_sector(visiting *v, long from, long to, long normal) {
  const tp_motion_outcome found =
      tp_closed_of_sector(&v->closed, v->twists->rays + from, v->twists->rays + to, normal, v->n);
  if (found != TP_MOTION_PROVEN) return found;
  const tp_mode mode = {.mechanism = TP_SLIDES_AND_TOPPLES,
                        .ray_count = 2,
                        .rays = {from, to},
                        .normal = normal,
                        .edge_count = v->closed.edge_count,
                        .edges = v->closed.edges};
  return visit_choices(v, &mode);
}

/* Of twists on a face, in their order from one end on: `cuts` has room for one more. A new one lies
 * before the first at which its point already slips as it does at the far end. */
static tp_motion_outcome insert_cut(long *cuts, long *count, const visiting *v, long point,
                                    long ray, int sign_at_end) {
  long at = *count;
  for (long k = 0; k < *count && at == *count; k++) {
    const tp_ray *cut = v->twists->rays + cuts[k];
    const int sign = tp_normals_slip(v->n, point, &cut->twist, cut->near);
    if (sign == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (sign == sign_at_end) at = k;
  }
  for (long k = *count; k > at; k--) cuts[k] = cuts[k - 1];
  cuts[at] = ray;
  (*count)++;
  return TP_MOTION_PROVEN;
}

/* The twist about the point as a ray between two others, where it slips in different senses:
 * |s_to| from + |s_from| to turns as it does. */
static tp_motion_outcome sense_between(int *sense, const visiting *v, const tp_twist_face *face,
                                       long point) {
  const tp_vector *from = &v->twists->rays[face->from].twist,
                  *to = &v->twists->rays[face->to].twist;
  const long bits = v->n->judge.precision;
  arb_t s_from, s_to, turn;
  arb_init(s_from);
  arb_init(s_to);
  arb_init(turn);
  tp_normals_slip_ball(s_from, v->n, point, from);
  tp_normals_slip_ball(s_to, v->n, point, to);
  arb_abs(s_from, s_from);
  arb_abs(s_to, s_to);
  arb_mul(turn, s_to, from->of + 2, bits);
  arb_addmul(turn, s_from, to->of + 2, bits);
  *sense = arf_sgn(arb_midref(turn));
  const bool told = !arb_contains_zero(turn);
  arb_clear(s_from);
  arb_clear(s_to);
  arb_clear(turn);
  return told ? TP_MOTION_PROVEN : TP_MOTION_OPEN;
}

static bool is_cut(const visiting *v, const long *cuts, long count, long point) {
  const long site = v->n->cones->points[point].site;
  for (long k = 0; k < count; k++) {
    if (v->twists->rays[cuts[k]].site == site) return true;
  }
  return false;
}

/* The twists on a face about a point that would stick, strictly within it; about one of several
 * frictions once. */
static tp_motion_outcome find_cuts(long *cuts, long *count, visiting *v,
                                   const tp_twist_face *face) {
  const tp_normal *own = v->n->items + face->normal;
  for (long k = own->first; k < own->first + own->count; k++) {
    const long point = v->n->order[k];
    if (v->n->same[point] != point || is_cut(v, cuts, *count, point)) continue;
    if (!v->bonded && arb_is_zero(tp_cones_friction(v->n->cones, point))) continue;
    const int from = tp_closed_slip(v->n, point, v->twists->rays + face->from);
    const int to = tp_closed_slip(v->n, point, v->twists->rays + face->to);
    if (from == TP_OPEN_SIGN || to == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (from * to >= 0) continue;
    int sense = 0;
    tp_motion_outcome done = sense_between(&sense, v, face, point);
    if (done != TP_MOTION_PROVEN) return done;
    const long ray = tp_twists_add_turn(v->twists, v->n, point, sense);
    if (ray < 0) return TP_MOTION_OUT_OF_MEMORY;
    if (v->twists->has_interior && !tp_twists_tell_line(v->twists, face->normal)) {
      return TP_MOTION_OUT_OF_MEMORY; /* no other line bounds K there */
    }
    done = insert_cut(cuts, count, v, point, ray, to);
    if (done != TP_MOTION_PROVEN) return done;
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome visit_face(visiting *v, const tp_twist_face *face) {
  const tp_normal *own = v->n->items + face->normal;
  long *cuts = calloc((size_t)own->count + 1, sizeof *cuts), count = 0;
  if (cuts == NULL) return TP_MOTION_OUT_OF_MEMORY;
  tp_motion_outcome done = find_cuts(cuts, &count, v, face);
  long from = face->from;
  for (long k = 0; k < count && done == TP_MOTION_PROVEN; k++) {
    done = visit_sector(v, from, cuts[k], face->normal);
    if (done == TP_MOTION_PROVEN) done = visit_ray(v, cuts[k]);
    from = cuts[k];
  }
  if (done == TP_MOTION_PROVEN) done = visit_sector(v, from, face->to, face->normal);
  free(cuts);
  return done;
}

tp_motion_outcome tp_strata_visit(tp_twists *twists, const tp_normals *normals, bool bonded,
                                  tp_mode_visit visit, void *context) {
  visiting v = {
      .twists = twists, .n = normals, .bonded = bonded, .visit = visit, .context = context};
  tp_motion_outcome done = TP_MOTION_PROVEN;
  if (twists->has_interior || twists->everything) {
    const tp_mode mode = {.mechanism = TP_LEAVES_BASE};
    done = visit(context, &mode);
  }
  const long rays = twists->ray_count; /* those that are added belong to faces */
  for (long k = 0; k < rays && done == TP_MOTION_PROVEN; k++) done = visit_ray(&v, k);
  for (long k = 0; k < twists->face_count && done == TP_MOTION_PROVEN; k++) {
    const tp_twist_face face = twists->faces[k];
    done = visit_face(&v, &face);
  }
  tp_closed_clear(&v.closed);
  return done;
}

tp_motion_outcome tp_strata_mechanism(tp_mechanism *mechanism, const tp_twists *twists,
                                      const tp_normals *normals, long ray) {
  tp_closed closed = {0};
  *mechanism = TP_SLIDES;
  if (twists->rays[ray].axis >= 0) return TP_MOTION_PROVEN;
  const tp_motion_outcome done = tp_closed_of_ray(&closed, twists, ray, normals);
  if (done == TP_MOTION_PROVEN) *mechanism = tp_closed_mechanism(&closed, twists->rays + ray);
  tp_closed_clear(&closed);
  return done;
}
