/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Passes in their order; sets of facets that are joined, each with its lowest pose. Two heights
 * that doubles do not separate, as those of like facets, are compared in whole numbers, at the
 * level double as well. */

#include "solid/persistence.h"

#include "solid/sides.h"
#include "solid/word_heights.h"

#include <stdlib.h>

/* The way from a facet to another over the edge that they share. */
typedef struct pass {
  tp_near height;
  int one, other;
} pass;

typedef struct landscape {
  const tp_centre *centre;
  const tp_hull_facets *facets;
  const tp_hull_heights *over;
  const bool *is_pose;
  pass *passes;
  long pass_count;
  double most_error;     /* of passes */
  int *leaders, *lowest; /* sets of facets, and the lowest pose of each at its leader; -1: none */
  bool is_undecided;     /* the level does not separate two heights */
  bool is_made;          /* what compares heights exactly, as one was needed: */
  bool has_words, has_made;
  tp_word_centre words;
  tp_centre made;
  bool is_open; /* a side has no twin: no closed surface, which a proven hull is */
} landscape;

/* An arm above 0 as a length. */
static tp_near length_of_arm(const landscape *l, long facet, long side) {
  const tp_hull_side *own = l->facets->sides + side;
  tp_rest_plane plane;
  tp_near outward[3]; /* seen from above the sides of a facet run the other way */
  tp_hull_heights_plane(&plane, l->over, facet);
  tp_rest_plane_outward(outward, l->centre->surface, &plane, own->to, own->from);
  tp_rest_plane_clear(&plane);
  return tp_near_div(l->over->arms[side], tp_near_norm(outward));
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
  const tp_near *heights = l->over->heights, *arms = l->over->arms;
  tp_near height = tp_near_larger(heights[facet], heights[other]);
  if (arms[side].value > 0 && arms[twin].value > 0) {
    const tp_near arm = length_of_arm(l, facet, side);
    height = tp_near_larger(height, tp_near_length(heights[facet], arm));
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

static void make_exact(landscape *l) {
  const tp_surface *summed = l->centre->summed;
  l->is_made = true;
  l->has_words = l->centre->level != TP_LEVEL_EXACT && summed != NULL &&
                 tp_surface_has_words(summed) && tp_surface_has_words(l->centre->surface);
  if (l->has_words) {
    tp_word_centre_init(&l->words, summed);
  } else if (l->centre->level != TP_LEVEL_EXACT) {
    l->has_made = tp_centre_exactly(&l->made, l->centre);
  }
}

/* The sign of one height less another in whole numbers. */
static int compare_exactly(landscape *l, int a, int b) {
  if (!l->is_made) make_exact(l);
  if (l->has_words) {
    int one[3], other[3];
    tp_hull_heights_corners(one, l->over, a);
    tp_hull_heights_corners(other, l->over, b);
    return tp_word_centre_compare(&l->words, l->centre->surface, one, other);
  }
  if (l->centre->level != TP_LEVEL_EXACT && !l->has_made) {
    l->is_undecided = true;
    return 0;
  }
  tp_rest_plane one, other;
  tp_hull_heights_plane(&one, l->over, a);
  tp_hull_heights_plane(&other, l->over, b);
  const int order = tp_centre_compare_heights(l->has_made ? &l->made : l->centre, &one, &other);
  tp_rest_plane_clear(&one);
  tp_rest_plane_clear(&other);
  return order;
}

/* The first of two poses of the same height counts as the lower one. */
static bool is_lower_pose(landscape *l, int a, int b) {
  const tp_near *heights = l->over->heights;
  int order = tp_near_sign(tp_near_sub(heights[a], heights[b]));
  if (order == 0) order = compare_exactly(l, a, b);
  return order != 0 ? order < 0 : a < b;
}

static tp_near rise_to(const landscape *l, const pass *own, int facet) {
  const tp_near way = {own->height.value, l->most_error};
  const tp_near rise = tp_near_sub(way, l->over->heights[facet]);
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
  l->passes = malloc(sides * sizeof *l->passes);
  l->leaders = malloc(count * sizeof *l->leaders);
  l->lowest = malloc(count * sizeof *l->lowest);
  return l->passes != NULL && l->leaders != NULL && l->lowest != NULL;
}

tp_status tp_persistences_find(tp_persistence **persistences, const tp_hull_heights *over,
                               const bool *is_pose, bool *told, tp_message *message) {
  const tp_hull_facets *facets = over->facets;
  landscape l = {.centre = over->centre, .facets = facets, .over = over, .is_pose = is_pose};
  tp_persistence *own = calloc((size_t)facets->count, sizeof *own);
  const bool done = make_landscape(&l) && own != NULL;
  for (long f = 0; f < facets->count && done; f++) {
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
  if (l.has_words) tp_word_centre_clear(&l.words);
  if (l.has_made) tp_centre_clear(&l.made);
  free(l.passes);
  free(l.leaders);
  free(l.lowest);
  if (!done) return tp_fail_memory(message, "the poses of a solid");
  if (!l.is_open) return TP_OK;
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){l.centre->surface->mesh->file, 0, 0},
                 "facets of the convex hull of the solid do not close; please report this together "
                 "with the mesh");
}
