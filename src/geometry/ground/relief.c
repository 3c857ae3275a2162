/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two triangles at an edge lie in one plane where the third corner of one lies in that of the other
 * and beyond the edge; by doubles with bounds first, else in whole numbers. */

#include "ground/relief.h"

#include "solid/sides.h"

#include <stdlib.h>

/* ---- planes ------------------------------------------------------------------------------------
 */

void tp_relief_normal(tp_whole *normal, const tp_relief *r, long triangle) {
  const int *own = r->surface.triangles + 3 * triangle;
  tp_whole b, c;
  tp_whole_init(&b);
  tp_whole_init(&c);
  tp_whole_sub(&b, tp_relief_point(r, own[1]), tp_relief_point(r, own[0]));
  tp_whole_sub(&c, tp_relief_point(r, own[2]), tp_relief_point(r, own[0]));
  tp_whole_cross(normal, &b, &c);
  tp_whole_clear(&b);
  tp_whole_clear(&c);
}

static void near_way(tp_near way[3], const tp_surface *s, long from, const tp_surface *other,
                     long to) {
  for (int k = 0; k < 3; k++) {
    way[k] = tp_near_sub(tp_surface_near(other, to, k), tp_surface_near(s, from, k));
  }
}

static tp_near near_volume(const tp_near a[3], const tp_near b[3], const tp_near c[3]) {
  tp_near sum = {0, 0};
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const tp_near minor = tp_near_sub(tp_near_mul(a[i], b[j]), tp_near_mul(a[j], b[i]));
    sum = tp_near_add(sum, tp_near_mul(minor, c[k]));
  }
  return sum;
}

int tp_relief_side(const tp_relief *r, long triangle, const tp_relief *other, long vertex) {
  const int *own = r->surface.triangles + 3 * triangle;
  const tp_surface *s = &r->surface;
  tp_near near[3][3];
  near_way(near[0], s, own[0], s, own[1]);
  near_way(near[1], s, own[0], s, own[2]);
  near_way(near[2], s, own[0], &other->surface, vertex);
  int sign = tp_near_sign(near_volume(near[0], near[1], near[2]));
  if (sign != 0) return sign;
  tp_whole normal, way;
  fmpz_t height;
  tp_whole_init(&normal);
  tp_whole_init(&way);
  fmpz_init(height);
  tp_relief_normal(&normal, r, triangle);
  tp_whole_sub(&way, tp_relief_point(other, vertex), tp_relief_point(r, own[0]));
  tp_whole_dot(height, &normal, &way);
  sign = fmpz_sgn(height);
  tp_whole_clear(&normal);
  tp_whole_clear(&way);
  fmpz_clear(height);
  return sign;
}

static int normals_sign(const tp_relief *r, long one, long other) {
  tp_whole a, b;
  fmpz_t product;
  tp_whole_init(&a);
  tp_whole_init(&b);
  fmpz_init(product);
  tp_relief_normal(&a, r, one);
  tp_relief_normal(&b, r, other);
  tp_whole_dot(product, &a, &b);
  const int sign = fmpz_sgn(product);
  tp_whole_clear(&a);
  tp_whole_clear(&b);
  fmpz_clear(product);
  return sign;
}

/* ---- edges -------------------------------------------------------------------------------------
 */

static int third_corner(const tp_surface *s, long triangle, int one, int other) {
  const int *own = s->triangles + 3 * triangle;
  for (int k = 0; k < 2; k++) {
    if (own[k] != one && own[k] != other) return own[k];
  }
  return own[2];
}

static bool is_edge(const tp_relief *r, const tp_relief_edge *e) {
  if (e->triangles[1] < 0) return true;
  if (tp_relief_side(r, e->triangles[0], r, e->opposite[1]) != 0) return true;
  return normals_sign(r, e->triangles[0], e->triangles[1]) < 0;
}

static void number_side(tp_relief *r, long triangle, int one, int other, int edge) {
  const int *own = r->surface.triangles + 3 * triangle;
  for (int c = 0; c < 3; c++) {
    const int a = own[c], b = own[(c + 1) % 3];
    if ((a == one && b == other) || (a == other && b == one)) r->edge_of[3 * triangle + c] = edge;
  }
}

static void add_edge(tp_relief *r, int vertex, const tp_side *sides, long count) {
  tp_relief_edge *own = r->edges + r->edge_count;
  *own = (tp_relief_edge){
      .from = vertex, .to = sides->other, .triangles = {sides->triangle, -1}, .opposite = {-1, -1}};
  if (count > 1) own->triangles[1] = sides[1].triangle;
  for (long k = 0; k < count; k++) {
    own->opposite[k] = third_corner(&r->surface, own->triangles[k], own->from, own->to);
    number_side(r, own->triangles[k], own->from, own->to, (int)r->edge_count);
  }
  own->is_edge = is_edge(r, own);
  r->edge_count++;
}

static void add_edges(tp_relief *r, const tp_sides *sides) {
  for (int v = 0; v < r->surface.vertex_count; v++) {
    const tp_side *own = sides->items + sides->starts[v];
    const long count = sides->starts[v + 1] - sides->starts[v];
    for (long k = 0, next = 0; k < count; k = next) {
      while (next < count && own[next].other == own[k].other) next++;
      add_edge(r, v, own + k, next - k);
    }
  }
}

/* ---- corners -----------------------------------------------------------------------------------
 */

static void gather_triangles(tp_relief *r) {
  const tp_surface *s = &r->surface;
  for (long k = 0; k < 3 * s->triangle_count; k++) r->starts[s->triangles[k] + 1]++;
  for (long v = 0; v < s->vertex_count; v++) r->starts[v + 1] += r->starts[v];
  for (long k = 3 * s->triangle_count - 1; k >= 0; k--) {
    r->at[--r->starts[s->triangles[k] + 1]] = (int)(k / 3);
  }
  for (long v = 0; v < s->vertex_count; v++) r->starts[v] = r->starts[v + 1];
  r->starts[s->vertex_count] = 3 * s->triangle_count;
}

/* Do two edges at a vertex go opposite ways along one line? */
static bool is_straight(const tp_relief *r, int vertex, int one, int other) {
  tp_whole a, b, product;
  fmpz_t along;
  tp_whole_init(&a);
  tp_whole_init(&b);
  tp_whole_init(&product);
  fmpz_init(along);
  tp_whole_sub(&a, tp_relief_point(r, one), tp_relief_point(r, vertex));
  tp_whole_sub(&b, tp_relief_point(r, other), tp_relief_point(r, vertex));
  tp_whole_cross(&product, &a, &b);
  tp_whole_dot(along, &a, &b);
  const bool straight = tp_whole_is_zero(&product) && fmpz_sgn(along) < 0;
  tp_whole_clear(&a);
  tp_whole_clear(&b);
  tp_whole_clear(&product);
  fmpz_clear(along);
  return straight;
}

/* Of each vertex how many edges it has, and the ends of the first two of them. */
static bool find_corners(tp_relief *r) {
  const size_t count = (size_t)r->surface.vertex_count;
  int *edges = calloc(count, sizeof *edges);
  int *ends = r->along;
  const bool done = edges != NULL;
  for (long k = 0; done && k < r->edge_count; k++) {
    const tp_relief_edge *e = r->edges + k;
    for (int side = 0; side < 2 && e->is_edge; side++) {
      const int own = side == 0 ? e->from : e->to, other = side == 0 ? e->to : e->from;
      if (edges[own] < 2) ends[2L * own + edges[own]] = other;
      edges[own]++;
    }
  }
  for (int v = 0; done && v < (int)count; v++) {
    r->is_corner[v] = edges[v] > 2 || edges[v] == 1 ||
                      (edges[v] == 2 && !is_straight(r, v, ends[2L * v], ends[2L * v + 1]));
  }
  free(edges);
  return done;
}

int tp_relief_end(const tp_relief *r, int corner, int vertex) {
  for (int last = corner; !r->is_corner[vertex];) {
    const int *ends = r->along + 2L * vertex;
    const int next = ends[0] == last ? ends[1] : ends[0];
    last = vertex;
    vertex = next;
  }
  return vertex;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

bool tp_relief_init(tp_relief *r, const tp_surface *surface) {
  *r = (tp_relief){.surface = *surface};
  const size_t sides_count = 3 * (size_t)surface->triangle_count;
  const size_t vertices = (size_t)surface->vertex_count;
  tp_sides sides = {0};
  r->edges = malloc(sides_count * sizeof *r->edges);
  r->edge_of = malloc(sides_count * sizeof *r->edge_of);
  r->starts = calloc(vertices + 2, sizeof *r->starts);
  r->at = malloc(sides_count * sizeof *r->at);
  r->is_corner = calloc(vertices, sizeof *r->is_corner);
  r->along = malloc(2 * vertices * sizeof *r->along);
  bool done =
      r->along != NULL && r->edges != NULL && r->edge_of != NULL && r->starts != NULL &&
      r->at != NULL && r->is_corner != NULL &&
      tp_sides_init(&sides, surface->triangles, surface->triangle_count, surface->vertex_count);
  if (done) {
    add_edges(r, &sides);
    gather_triangles(r);
    done = find_corners(r) && tp_triangle_tree_init(&r->tree, &r->surface);
  }
  tp_sides_clear(&sides);
  return done;
}

void tp_relief_clear(tp_relief *r) {
  tp_triangle_tree_clear(&r->tree);
  free(r->edges);
  free(r->edge_of);
  free(r->starts);
  free(r->at);
  free(r->is_corner);
  free(r->along);
  *r = (tp_relief){.edges = NULL};
}
