/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each facet is judged by the signs of its arms; what it leads to is followed to the pose; shares
 * are added there. */

#include "solid/poses.h"

#include "number/near_angle.h"
#include "solid/persistence.h"
#include "solid/tilting.h"

#include <stdlib.h>

/* What is found of a facet. */
typedef struct place {
  tp_near share; /* its own, then with those that roll here */
  tp_near own;
  int next; /* the facet that the solid rolls to; its own number: it rests */
} place;

typedef struct search {
  const tp_centre *centre;
  const tp_hull_facets *facets;
  tp_hull_heights over;
  place *places;
  bool *is_pose; /* of each facet */
  tp_persistence *persistences;
  tp_support_edge *edges; /* of the facet at hand */
  bool open;              /* the level does not tell */
} search;

/* ---- where it rolls ----------------------------------------------------------------------------
 */

/* Seen from above the sides of a facet run the other way. */
static long set_edges(search *s, long facet) {
  const tp_hull_side *sides = s->facets->sides + s->facets->starts[facet];
  const long count = s->facets->starts[facet + 1] - s->facets->starts[facet];
  for (long k = 0; k < count; k++) s->edges[k] = (tp_support_edge){sides[k].to, sides[k].from};
  return count;
}

/* How far the foot lies beyond an edge, times |up|. */
static tp_near beyond(const search *s, const tp_rest_plane *plane, tp_support_edge edge,
                      double accuracy) {
  tp_near outward[3];
  tp_rest_plane_outward(outward, s->centre->surface, plane, edge.from, edge.to);
  const tp_near arm = tp_centre_arm(s->centre, plane, edge.from, edge.to, accuracy);
  return tp_near_is_zero(arm) ? arm : tp_near_neg(tp_near_div(arm, tp_near_norm(outward)));
}

/* The facet that it rolls to: what doubles leave open is decided in whole numbers, as edges of a
 * sliver can be told apart by less than their digits. Of equal ones the first is taken. */
static int roll(search *s, long facet) {
  const long count = set_edges(s, facet);
  tp_rest_plane plane;
  tp_hull_heights_plane(&plane, &s->over, facet);
  const bool is_exact = s->centre->level == TP_LEVEL_EXACT;
  const double accuracy = is_exact ? 1e-15 : 1e-9;
  tp_near most = {0, 0};
  long found = 0;
  for (long k = 0; k < count; k++) {
    const tp_near own = beyond(s, &plane, s->edges[k], accuracy);
    int order = k > 0 ? tp_near_sign(tp_near_sub(own, most)) : 1;
    if (order == 0 && is_exact) {
      const long from[2] = {s->edges[k].from, s->edges[found].from};
      const long to[2] = {s->edges[k].to, s->edges[found].to};
      order = tp_centre_compare_beyond(s->centre, &plane, from, to);
    } else if (order == 0) {
      s->open = true;
    }
    if (order <= 0) continue;
    most = own;
    found = k;
  }
  tp_rest_plane_clear(&plane);
  return s->facets->sides[s->facets->starts[facet] + found].neighbour;
}

static void judge(search *s, long facet) {
  const int side = tp_hull_heights_side(&s->over, facet);
  if (side == 2) s->open = true;
  s->places[facet].next = side == 1 || side == 2 ? (int)facet : roll(s, facet);
  s->is_pose[facet] = s->places[facet].next == facet;
}

/* ---- shares ------------------------------------------------------------------------------------
 */

static tp_near dot(const tp_near a[3], const tp_near b[3]) {
  return tp_near_add(tp_near_add(tp_near_mul(a[0], b[0]), tp_near_mul(a[1], b[1])),
                     tp_near_mul(a[2], b[2]));
}

/* The half of a solid angle, in degrees: the share of all is that over 360. */
static tp_near half_angle(const search *s, const int *corners) {
  tp_near at[3][3], length[3];
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < 3; k++) {
      at[c][k] =
          tp_near_sub(tp_surface_near(s->centre->surface, corners[c], k), s->centre->near[k]);
    }
    length[c] = tp_near_norm(at[c]);
  }
  tp_near turn[3];
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    turn[k] = tp_near_sub(tp_near_mul(at[1][i], at[2][j]), tp_near_mul(at[1][j], at[2][i]));
  }
  const tp_near across = dot(at[0], turn);
  tp_near along = tp_near_mul(tp_near_mul(length[0], length[1]), length[2]);
  for (int c = 0; c < 3; c++) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    along = tp_near_add(along, tp_near_mul(dot(at[c], at[i]), length[j]));
  }
  /* from 0 to 180 degrees, as across is above zero */
  if (fabs(along.value) < across.value) {
    return tp_near_sub((tp_near){90, 0}, tp_near_arctangent(tp_near_div(along, across)));
  }
  const tp_near angle = tp_near_arctangent(tp_near_div(across, along));
  return along.value > 0 ? angle : tp_near_add((tp_near){180, 0}, angle);
}

static void measure_shares(search *s) {
  const tp_near round = {360, 0};
  for (long f = 0; f < s->facets->count; f++) {
    const tp_hull_side *sides = s->facets->sides + s->facets->starts[f];
    const long count = s->facets->starts[f + 1] - s->facets->starts[f];
    place *own = s->places + f;
    for (long k = 1; k + 1 < count; k++) {
      const int corners[3] = {sides[0].from, sides[k].from, sides[k + 1].from};
      own->own = tp_near_plus(own->own, tp_near_div(half_angle(s, corners), round));
    }
  }
  for (long f = 0; f < s->facets->count; f++) {
    long at = f;
    for (int next = s->places[at].next; next != at; next = s->places[at].next) {
      s->places[at].next = s->places[next].next; /* half the way for those that come here later */
      at = next;
    }
    s->places[at].share = tp_near_plus(s->places[at].share, s->places[f].own);
  }
}

/* ---- poses -------------------------------------------------------------------------------------
 */

static void describe(tp_solid_pose *pose, search *s, long facet, double metres_per_step) {
  const long count = set_edges(s, facet);
  tp_rest_plane plane;
  tp_map_frame frame;
  tp_hull_heights_plane(&plane, &s->over, facet);
  bool told = true;
  const tp_near length = tp_near_norm(plane.near_up);
  const tp_near height =
      tp_near_div(tp_centre_height(s->centre, &plane, tp_solid_accuracy), length);
  const tp_near scale = {metres_per_step, fabs(metres_per_step) * DBL_EPSILON};
  for (int k = 0; k < 3; k++) pose->down[k] = 0 - plane.near_up[k].value / length.value;
  pose->corners = (size_t)count;
  pose->height_m = tp_near_bounded(tp_near_mul(height, scale));
  pose->facet_share = tp_near_bounded(s->places[facet].own);
  pose->share = tp_near_bounded(s->places[facet].share);
  tp_map_frame_init(&frame, plane.near_up);
  tp_tilt_least(&pose->least, s->centre, &plane, &frame, s->edges, count, &told);
  pose->has_persistence = s->persistences[facet].is_left;
  if (pose->has_persistence) {
    pose->persistence_m = tp_near_bounded(tp_near_mul(s->persistences[facet].rise, scale));
  }
  if (!told) s->open = true;
  tp_rest_plane_clear(&plane);
}

/* A pose, and the facet that comes first where shares are equal. */
typedef struct ranked {
  tp_solid_pose pose;
  long facet;
} ranked;

static int compare(const void *one, const void *other) {
  const ranked *a = one, *b = other;
  if (a->pose.share.value != b->pose.share.value) {
    return a->pose.share.value > b->pose.share.value ? -1 : 1;
  }
  return (a->facet > b->facet) - (a->facet < b->facet);
}

static tp_status collect(tp_solid_pose **poses, size_t *count, search *s, double metres_per_step,
                         tp_message *message) {
  size_t found = 0;
  for (long f = 0; f < s->facets->count; f++) found += s->places[f].next == f;
  ranked *all = calloc(found + 1, sizeof *all);
  tp_solid_pose *own = calloc(found + 1, sizeof *own);
  const tp_status status = all != NULL && own != NULL ? TP_OK : tp_fail_memory(message, "poses");
  size_t at = 0;
  for (long f = 0; f < s->facets->count && status == TP_OK; f++) {
    if (s->places[f].next != f) continue;
    all[at].facet = f;
    describe(&all[at++].pose, s, f, metres_per_step);
  }
  if (status == TP_OK) {
    qsort(all, found, sizeof *all, compare);
    for (size_t k = 0; k < found; k++) own[k] = all[k].pose;
    *poses = own;
    *count = found;
    own = NULL;
  }
  free(own);
  free(all);
  return status;
}

tp_status tp_solid_poses_find(tp_solid_pose **poses, size_t *count, const tp_centre *centre,
                              const tp_hull_facets *facets, double metres_per_step, bool *told,
                              tp_message *message) {
  long most = 0;
  for (long f = 0; f < facets->count; f++) {
    const long own = facets->starts[f + 1] - facets->starts[f];
    if (own > most) most = own;
  }
  search s = {.centre = centre, .facets = facets};
  s.places = calloc((size_t)facets->count + 1, sizeof *s.places);
  s.is_pose = calloc((size_t)facets->count + 1, sizeof *s.is_pose);
  s.edges = malloc((size_t)(most + 1) * sizeof *s.edges);
  tp_status status = s.places != NULL && s.is_pose != NULL && s.edges != NULL
                         ? TP_OK
                         : tp_fail_memory(message, "the poses of a solid");
  if (status == TP_OK) status = tp_hull_heights_init(&s.over, centre, facets, message);
  s.open = s.over.is_open;
  for (long f = 0; f < facets->count && status == TP_OK && !s.open; f++) judge(&s, f);
  if (status == TP_OK && !s.open) {
    bool decided = true;
    status = tp_persistences_find(&s.persistences, &s.over, s.is_pose, &decided, message);
    s.open = !decided;
  }
  if (status == TP_OK && !s.open) {
    measure_shares(&s);
    status = collect(poses, count, &s, metres_per_step, message);
  }
  if (status == TP_OK && s.open) {
    *told = false;
    free(*poses);
    *poses = NULL;
    *count = 0;
  }
  tp_hull_heights_clear(&s.over);
  free(s.persistences);
  free(s.places);
  free(s.is_pose);
  free(s.edges);
  return status;
}
