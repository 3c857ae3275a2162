/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heights of facets and arms about their sides in doubles with bounds; passes in their order; sets
 * of facets that are joined, each with its lowest. */

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
  tp_near *heights; /* of facets */
  tp_near *arms;    /* about sides, above 0 where the foot lies within */
  pass *passes;
  long pass_count;
  int *leaders, *lowest; /* sets of facets, and the lowest of each at its leader */
  bool is_open;          /* a side has no twin: no closed surface, which a proven hull is */
} landscape;

static void measure_facet(landscape *l, long facet) {
  const tp_hull_side *sides = l->facets->sides;
  const long first = l->facets->starts[facet], past = l->facets->starts[facet + 1];
  const int corners[3] = {sides[first].from, sides[first + 1].from, sides[first + 2].from};
  tp_rest_plane plane;
  tp_rest_plane_below(&plane, l->centre->surface, corners);
  l->heights[facet] = tp_near_div(tp_centre_height(l->centre, &plane, tp_solid_accuracy),
                                  tp_near_norm(plane.near_up));
  for (long k = first; k < past; k++) {
    tp_near outward[3]; /* seen from above the sides of a facet run the other way */
    tp_rest_plane_outward(outward, l->centre->surface, &plane, sides[k].to, sides[k].from);
    const tp_near arm = tp_centre_arm(l->centre, &plane, sides[k].to, sides[k].from, 0);
    l->arms[k] = tp_near_is_zero(arm) ? arm : tp_near_div(arm, tp_near_norm(outward));
  }
  tp_rest_plane_clear(&plane);
}

/* Of a side, the same edge as a side of its neighbour; below 0: there is none. */
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
  l->passes[l->pass_count++] = (pass){height, (int)facet, other};
}

static int compare_passes(const void *one, const void *other) {
  const pass *a = one, *b = other;
  if (a->height.value != b->height.value) return a->height.value < b->height.value ? -1 : 1;
  if (a->one != b->one) return a->one < b->one ? -1 : 1;
  return (a->other > b->other) - (a->other < b->other);
}

static bool is_lower_facet(const landscape *l, int a, int b) {
  const double one = l->heights[a].value, other = l->heights[b].value;
  return one != other ? one < other : a < b;
}

/* Which minimum ends here depends on the order of heights that bounds may not tell apart; what its
 * rise is off by for that is below their sum. */
static tp_near rise_to(const landscape *l, const pass *own, int facet) {
  const tp_near rise = tp_near_sub(own->height, l->heights[facet]);
  return (tp_near){fmax(rise.value, 0), 2 * rise.error + fmax(-rise.value, 0)};
}

static void join_facets(tp_persistence *persistences, landscape *l) {
  for (long k = 0; k < l->facets->count; k++) l->leaders[k] = l->lowest[k] = (int)k;
  for (long k = 0; k < l->pass_count; k++) {
    const pass *own = l->passes + k;
    const int one = tp_sides_leader(l->leaders, own->one);
    const int other = tp_sides_leader(l->leaders, own->other);
    if (one == other) continue;
    const int a = l->lowest[one], b = l->lowest[other];
    const int ended = is_lower_facet(l, a, b) ? b : a;
    persistences[ended] = (tp_persistence){true, rise_to(l, own, ended)};
    tp_sides_join(l->leaders, one, other);
    l->lowest[tp_sides_leader(l->leaders, one)] = ended == a ? b : a;
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
                               const tp_hull_facets *facets, tp_message *message) {
  landscape l = {.centre = centre, .facets = facets};
  tp_persistence *own = calloc((size_t)facets->count, sizeof *own);
  const bool done = make_landscape(&l) && own != NULL;
  for (long f = 0; f < facets->count && done; f++) measure_facet(&l, f);
  for (long f = 0; f < facets->count && done; f++) {
    for (long k = facets->starts[f]; k < facets->starts[f + 1]; k++) {
      if (facets->sides[k].neighbour > f) set_pass(&l, f, k);
    }
  }
  if (done && !l.is_open) {
    qsort(l.passes, (size_t)l.pass_count, sizeof *l.passes, compare_passes);
    join_facets(own, &l);
    *persistences = own;
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
