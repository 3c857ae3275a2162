/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heights of facets and arms about their sides in doubles with bounds; passes in their order; sets
 * of facets that are joined, each with its lowest pose. */

#include "solid/persistence.h"

#include "solid/sides.h"
#include "solid/tilting.h"

#include <stdlib.h>

/* The way from a facet to another over the edge that they share. */
typedef struct pass {
  tp_near height;
  int one, other;
} pass;

typedef struct landscape {
  const tp_centre *centre;
  const tp_hull_facets *facets;
  const bool *is_pose;
  tp_near *heights; /* of facets */
  tp_near *arms;    /* about sides, above 0 where the foot lies within */
  pass *passes;
  long pass_count;
  double most_error;     /* of passes */
  int *leaders, *lowest; /* sets of facets, and the lowest pose of each at its leader; -1: none */
  bool is_undecided;     /* the level does not separate two heights */
  bool is_open;          /* a side has no twin: no closed surface, which a proven hull is */
} landscape;

static void set_plane(tp_rest_plane *plane, const landscape *l, long facet) {
  const tp_hull_side *sides = l->facets->sides + l->facets->starts[facet];
  const int corners[3] = {sides[0].from, sides[1].from, sides[2].from};
  tp_rest_plane_below(plane, l->centre->surface, corners);
}

static void measure_facet(landscape *l, long facet) {
  const tp_hull_side *sides = l->facets->sides;
  const long first = l->facets->starts[facet], past = l->facets->starts[facet + 1];
  tp_rest_plane plane;
  set_plane(&plane, l, facet);
  l->heights[facet] = tp_near_div(tp_centre_height(l->centre, &plane, tp_solid_accuracy),
                                  tp_near_norm(plane.near_up));
  if (!tp_near_tells(l->heights[facet], 100 * tp_solid_accuracy)) l->is_undecided = true;
  for (long k = first; k < past; k++) {
    tp_near outward[3]; /* seen from above the sides of a facet run the other way */
    tp_rest_plane_outward(outward, l->centre->surface, &plane, sides[k].to, sides[k].from);
    const tp_near arm = tp_centre_arm(l->centre, &plane, sides[k].to, sides[k].from, 0);
    l->arms[k] = tp_near_is_zero(arm) ? arm : tp_near_div(arm, tp_near_norm(outward));
  }
  tp_rest_plane_clear(&plane);
}

/* The same edge as a side of the neighbour; below 0: there is none. */
static long find_twin(const landscape *l, long side) {
  const tp_hull_side *sides = l->facets->sides;
  const int facet = sides[side].neighbour;
  for (long k = l->facets->starts[facet]; k < l->facets->starts[facet + 1]; k++) {
    if (sides[k].from == sides[side].to && sides[k].to == sides[side].from) return k;
  }
  return -1;
}

static void set_pass(landscape *l, long facet, long side) {
  const int other = l->facets->sides[side].neighbour;
  const long twin = find_twin(l, side);
  if (twin < 0) {
    l->is_open = true;
    return;
  }
  const tp_near own = l->arms[side], beyond = l->arms[twin];
  tp_near height = tp_near_larger(l->heights[facet], l->heights[other]);
  if (own.value > 0 && beyond.value > 0) {
    height = tp_near_larger(height, tp_near_length(l->heights[facet], own));
  }
  l->most_error = fmax(l->most_error, height.error);
  l->passes[l->pass_count++] = (pass){height, (int)facet, other};
}

static int compare_passes(const void *one, const void *other) {
  const pass *a = one, *b = other;
  if (a->height.value != b->height.value) return a->height.value < b->height.value ? -1 : 1;
  if (a->one != b->one) return a->one < b->one ? -1 : 1;
  return (a->other > b->other) - (a->other < b->other);
}

/* The first of two poses of the same height counts as the lower one. */
static bool is_lower_pose(landscape *l, int a, int b) {
  int order = tp_near_sign(tp_near_sub(l->heights[a], l->heights[b]));
  if (order == 0 && l->centre->level == TP_LEVEL_EXACT) {
    tp_rest_plane one, other;
    set_plane(&one, l, a);
    set_plane(&other, l, b);
    order = tp_centre_compare_heights(l->centre, &one, &other);
    tp_rest_plane_clear(&one);
    tp_rest_plane_clear(&other);
  } else if (order == 0) {
    l->is_undecided = true;
  }
  return order != 0 ? order < 0 : a < b;
}

static tp_near rise_to(const landscape *l, const pass *own, int facet) {
  const tp_near way = {own->height.value, l->most_error};
  const tp_near rise = tp_near_sub(way, l->heights[facet]);
  return (tp_near){fmax(rise.value, 0), rise.error + fmax(-rise.value, 0)};
}

static void join_facets(tp_persistence *persistences, landscape *l) {
  for (long k = 0; k < l->facets->count; k++) {
    l->leaders[k] = (int)k;
    l->lowest[k] = l->is_pose[k] ? (int)k : -1;
  }
  for (long k = 0; k < l->pass_count && !l->is_undecided; k++) {
    const pass *own = l->passes + k;
    const int one = tp_sides_leader(l->leaders, own->one);
    const int other = tp_sides_leader(l->leaders, own->other);
    if (one == other) continue;
    const int a = l->lowest[one], b = l->lowest[other];
    int left = a >= 0 ? a : b;
    if (a >= 0 && b >= 0) {
      left = is_lower_pose(l, a, b) ? a : b;
      const int ended = left == a ? b : a;
      persistences[ended] = (tp_persistence){true, rise_to(l, own, ended)};
    }
    tp_sides_join(l->leaders, one, other);
    l->lowest[tp_sides_leader(l->leaders, one)] = left;
  }
}

static bool make_landscape(landscape *l) {
  const size_t count = (size_t)l->facets->count, sides = (size_t)l->facets->starts[count];
  l->heights = malloc(count * sizeof *l->heights);
  l->arms = malloc(sides * sizeof *l->arms);
  l->passes = malloc(sides * sizeof *l->passes);
  l->leaders = malloc(count * sizeof *l->leaders);
  l->lowest = malloc(count * sizeof *l->lowest);
  return l->heights != NULL && l->arms != NULL && l->passes != NULL && l->leaders != NULL &&
         l->lowest != NULL;
}

tp_status tp_persistences_find(tp_persistence **persistences, const tp_centre *centre,
                               const tp_hull_facets *facets, const bool *is_pose, bool *told,
                               tp_message *message) {
  landscape l = {.centre = centre, .facets = facets, .is_pose = is_pose};
  tp_persistence *own = calloc((size_t)facets->count, sizeof *own);
  const bool done = make_landscape(&l) && own != NULL;
  for (long f = 0; f < facets->count && done && !l.is_undecided; f++) measure_facet(&l, f);
  for (long f = 0; f < facets->count && done && !l.is_undecided; f++) {
    for (long k = facets->starts[f]; k < facets->starts[f + 1]; k++) {
      if (facets->sides[k].neighbour > f) set_pass(&l, f, k);
    }
  }
  if (done && !l.is_open) {
    qsort(l.passes, (size_t)l.pass_count, sizeof *l.passes, compare_passes);
    join_facets(own, &l);
    *persistences = own;
    if (l.is_undecided) *told = false;
  } else {
    free(own);
  }
  free(l.heights);
  free(l.arms);
  free(l.passes);
  free(l.leaders);
  free(l.lowest);
  if (!done) return tp_fail_memory(message, "the poses of a solid");
  if (!l.is_open) return TP_OK;
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){centre->surface->mesh->file, 0, 0},
                 "facets of the convex hull of the solid do not close; please report this together "
                 "with the mesh");
}
