/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The convex hull of a solid is proven before it is used (solid/hull.h).
 *
 * A library once returned hulls with dents and flat facets for prisms with points on their edges,
 * and 82 of 120 were reported as certain. Here hulls are damaged in each way that a condition of
 * the proof is for, and each is refused by that condition; hulls of points of small grids, where
 * most planes hold many points, are compared with all planes through three of them in whole
 * numbers.
 */

#include "random_numbers.h"
#include "solid/hull.h"
#include "solid/hull_facets.h"
#include "suite.h"

#include <stdio.h>
#include <string.h>

enum { MOST = 60, MOST_PLANES = 400, TEXT = 16384 };

static tp_message message;

/* Points with a mesh and a surface of them; the triangles of the mesh do not matter. */
typedef struct cloud {
  int count;
  long points[MOST][3];
  tp_mesh mesh;
  tp_surface surface;
} cloud;

static void add(cloud *c, long x, long y, long z) {
  for (int k = 0; k < c->count; k++) {
    if (c->points[k][0] == x && c->points[k][1] == y && c->points[k][2] == z) return;
  }
  ck_assert_int_lt(c->count, MOST);
  memcpy(c->points[c->count++], (long[]){x, y, z}, sizeof c->points[0]);
}

/* Coordinates times 1, or times 10^20 + 1: then no double holds them. Vertex k of the surface is
 * point k. */
static void close_cloud(cloud *c, bool is_large) {
  static char text[TEXT];
  size_t length = 0;
  for (int k = 0; k < c->count; k++) {
    text[length++] = 'v';
    for (int i = 0; i < 3; i++) {
      const long at = c->points[k][i], size = labs(at);
      length += (size_t)snprintf(text + length, TEXT - length, is_large ? " %s%ld%020ld" : " %s%ld",
                                 at < 0 ? "-" : "", size, size);
    }
    text[length++] = '\n';
  }
  for (int k = 0; k + 2 < c->count; k++) {
    length += (size_t)snprintf(text + length, TEXT - length, "f %d %d %d\n", k + 1, k + 2, k + 3);
  }
  ck_assert_int_eq(tp_mesh_read_bytes(&c->mesh, TP_MESH_OBJ, text, length, "cloud.obj", &message),
                   TP_OK);
  ck_assert_int_eq(tp_surface_init(&c->surface, &c->mesh, -1, &message), TP_OK);
  ck_assert_int_eq(c->surface.vertex_count, c->count);
  ck_assert_int_eq(tp_surface_points(&c->surface).small, !is_large);
}

static void clear_cloud(cloud *c) {
  tp_surface_clear(&c->surface);
  tp_mesh_clear(&c->mesh);
  c->count = 0;
}

/* What the proof says of triangles. */
static tp_hull_fault judge(const cloud *c, const int *corners, long count) {
  int four[4];
  tp_hull hull = {.count = count, .corners = malloc(3 * (size_t)count * sizeof *corners)};
  ck_assert(tp_hull_span(four, &c->surface));
  memcpy(hull.corners, corners, 3 * (size_t)count * sizeof *corners);
  const tp_hull_fault fault = tp_hull_prove(&hull, &c->surface, four);
  tp_hull_clear(&hull);
  return fault;
}

/* ---- damaged hulls -----------------------------------------------------------------------------
 */

/* A cube from -6 to 6, its triangles counter-clockwise seen from outside. */
static const int cube[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

static void add_cube(cloud *c, long half) {
  for (int k = 0; k < 8; k++) {
    add(c, k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half);
  }
}

static void copy_cube(int (*faces)[3]) {
  memcpy(faces, cube, sizeof cube);
}

/* Its upper side made of four triangles about point `apex`; 14 in all. */
static void copy_cube_with_apex(int faces[14][3], int apex) {
  static const int ring[5] = {4, 5, 7, 6, 4};
  copy_cube(faces);
  memcpy(faces[2], faces[12 - 1], sizeof faces[2]);
  memcpy(faces[3], faces[12 - 2], sizeof faces[3]);
  for (int k = 0; k < 4; k++)
    memcpy(faces[10 + k], (int[]){ring[k], ring[k + 1], apex}, sizeof faces[0]);
}

START_TEST(a_sound_hull_passes) {
  cloud c = {0};
  add_cube(&c, 6);
  add(&c, 0, 0, 6); /* in a face, and no corner */
  add(&c, 6, 6, 2); /* on an edge */
  add(&c, 0, 0, 3); /* within */
  add(&c, 0, 0, 9); /* over the upper face: only the last of these hulls may have it outside */
  close_cloud(&c, _i != 0);
  int faces[14][3];
  copy_cube_with_apex(faces, 11);
  ck_assert_int_eq(judge(&c, faces[0], 14), TP_HULL_PROVEN);
  copy_cube_with_apex(faces, 8);
  ck_assert_int_eq(judge(&c, faces[0], 14), TP_HULL_BEYOND);
  clear_cloud(&c);
  add_cube(&c, 6);
  add(&c, 0, 0, 6);
  close_cloud(&c, _i != 0);
  ck_assert_int_eq(judge(&c, cube[0], 12), TP_HULL_PROVEN);
  copy_cube_with_apex(faces, 8); /* the point in the face as a corner */
  ck_assert_int_eq(judge(&c, faces[0], 14), TP_HULL_PROVEN);
  clear_cloud(&c);
}
END_TEST

START_TEST(each_damage_is_refused) {
  cloud c = {0};
  add_cube(&c, 6);
  add_cube(&c, 4);
  add(&c, 0, 0, 3);
  close_cloud(&c, _i != 0);
  int faces[26][3];
  copy_cube(faces);
  faces[5][1] = -1; /* a corner that is no given point */
  ck_assert_int_eq(judge(&c, faces[0], 12), TP_HULL_NO_POINT);
  faces[5][1] = 17;
  ck_assert_int_eq(judge(&c, faces[0], 12), TP_HULL_NO_POINT);
  copy_cube(faces);
  ck_assert_int_eq(judge(&c, faces[0], 11), TP_HULL_OPEN); /* a triangle is missing */
  ck_assert_int_eq(judge(&c, faces[0], 0), TP_HULL_OPEN);
  faces[7][1] = 7; /* a triangle is flipped */
  faces[7][2] = 6;
  ck_assert_int_eq(judge(&c, faces[0], 12), TP_HULL_OPEN);
  copy_cube(faces);
  memcpy(faces[12], faces[3], sizeof faces[3]); /* a triangle is there twice */
  ck_assert_int_eq(judge(&c, faces[0], 13), TP_HULL_OPEN);
  copy_cube(faces);
  memcpy(faces[12], (int[]){0, 1, 5}, sizeof faces[12]); /* and a flat flap of two triangles */
  memcpy(faces[13], (int[]){0, 5, 1}, sizeof faces[13]);
  ck_assert_int_ne(judge(&c, faces[0], 14), TP_HULL_PROVEN);
  for (int k = 0; k < 12; k++) { /* all triangles are flipped */
    memcpy(faces[k], (int[]){cube[k][0], cube[k][2], cube[k][1]}, sizeof faces[k]);
  }
  ck_assert_int_eq(judge(&c, faces[0], 12), TP_HULL_TURNED);
  copy_cube_with_apex(faces, 16); /* a dent in the upper side */
  ck_assert_int_eq(judge(&c, faces[0], 14), TP_HULL_DENTED);
  for (int k = 0; k < 12; k++) { /* the smaller cube alone: the corners of the larger are outside */
    for (int i = 0; i < 3; i++) faces[k][i] = cube[k][i] + 8;
  }
  ck_assert_int_eq(judge(&c, faces[0], 12), TP_HULL_BEYOND);
  memcpy(faces[12], cube, sizeof cube); /* both cubes: two pieces, one in the other */
  ck_assert_int_eq(judge(&c, faces[0], 24), TP_HULL_WOUND);
  memcpy(faces[0], cube, sizeof cube); /* the same surface twice */
  ck_assert_int_eq(judge(&c, faces[0], 24), TP_HULL_OPEN);
  clear_cloud(&c);
}
END_TEST

/* A double pyramid over a star of five points, whose sides pass each other: closed, turned outwards
 * everywhere, of one piece with V - E + F = 2, and convex at each edge. It goes round twice. */
START_TEST(a_surface_wound_twice_is_refused) {
  static const long star[5][2] = {{100, 0}, {-81, 59}, {31, -95}, {31, 95}, {-81, -59}};
  cloud c = {0};
  int faces[10][3];
  for (int k = 0; k < 5; k++) add(&c, star[k][0], star[k][1], 0);
  add(&c, 0, 0, 50);
  add(&c, 0, 0, -50);
  close_cloud(&c, _i != 0);
  for (int k = 0; k < 5; k++) {
    memcpy(faces[2 * k], (int[]){k, (k + 1) % 5, 5}, sizeof faces[0]);
    memcpy(faces[2 * k + 1], (int[]){(k + 1) % 5, k, 6}, sizeof faces[0]);
  }
  ck_assert_int_eq(judge(&c, faces[0], 10), TP_HULL_WOUND);
  clear_cloud(&c);
}
END_TEST

START_TEST(two_pieces_apart_are_refused) {
  cloud c = {0};
  int faces[24][3];
  add_cube(&c, 6);
  for (int k = 0; k < 8; k++) add(&c, c.points[k][0] + 20, c.points[k][1], c.points[k][2]);
  close_cloud(&c, _i != 0);
  memcpy(faces[0], cube, sizeof cube);
  for (int k = 0; k < 12; k++) {
    for (int i = 0; i < 3; i++) faces[12 + k][i] = cube[k][i] + 8;
  }
  ck_assert_int_eq(judge(&c, faces[0], 24), TP_HULL_TURNED);
  clear_cloud(&c);
}
END_TEST

/* ---- searches that fail ------------------------------------------------------------------------
 */

static int calls, sound_from;

/* The hull with a triangle flipped, until call `sound_from`. */
static tp_geom_status search_damaged(tp_geom_hull *hull, const tp_geom_points *points, bool exact) {
  const tp_geom_status status = tp_geom_propose_hull(hull, points, exact);
  ck_assert_int_eq(exact, calls == 1);
  if (status == TP_GEOM_OK && calls < sound_from) {
    const int other = hull->triangles[1];
    hull->triangles[1] = hull->triangles[2];
    hull->triangles[2] = other;
  }
  calls++;
  return status;
}

static tp_geom_status search_in_vain(tp_geom_hull *hull, const tp_geom_points *points, bool exact) {
  (void)points;
  (void)exact;
  *hull = (tp_geom_hull){0, NULL};
  calls++;
  return TP_GEOM_FAILED;
}

static tp_geom_status search_without_memory(tp_geom_hull *hull, const tp_geom_points *points,
                                            bool exact) {
  (void)search_in_vain(hull, points, exact);
  return TP_GEOM_OUT_OF_MEMORY;
}

START_TEST(a_second_search_is_exact_and_a_third_is_none) {
  cloud c = {0};
  tp_hull hull;
  add_cube(&c, 6);
  close_cloud(&c, _i != 0);
  for (sound_from = 0; sound_from < 2; sound_from++) {
    calls = 0;
    ck_assert_int_eq(tp_hull_find_by(&hull, &c.surface, search_damaged, &message), TP_OK);
    ck_assert_int_eq(calls, 1 + sound_from);
    ck_assert_int_eq(hull.count, 12);
    tp_hull_clear(&hull);
  }
  calls = 0;
  ck_assert_int_eq(tp_hull_find_by(&hull, &c.surface, search_damaged, &message),
                   TP_DEPENDENCY_FAILED);
  ck_assert_int_eq(calls, 2);
  ck_assert(hull.count == 0 && hull.corners == NULL && hull.across == NULL && hull.level == NULL);
  ck_assert_msg(strstr(message.text, "failed its check: it is not closed") != NULL, "%s",
                message.text);
  ck_assert_int_eq(tp_hull_find_by(&hull, &c.surface, search_in_vain, &message),
                   TP_DEPENDENCY_FAILED);
  ck_assert_msg(strstr(message.text, "CGAL failed to find the convex hull") != NULL, "%s",
                message.text);
  ck_assert_int_eq(tp_hull_find_by(&hull, &c.surface, search_without_memory, &message),
                   TP_OUT_OF_MEMORY);
  clear_cloud(&c);
}
END_TEST

/* All points in one plane, which is bad input, and no failure of a library. */
START_TEST(flat_points_are_refused) {
  for (int k = 0; k < 3; k++) {
    cloud c = {0};
    tp_hull hull;
    int four[4];
    for (int i = 0; i < 9; i++) add(&c, i % 3, k == 0 ? i % 3 : i / 3, k == 2 ? 0 : 1 + i % 3);
    close_cloud(&c, _i != 0);
    ck_assert(!tp_hull_span(four, &c.surface));
    ck_assert_int_eq(tp_hull_find(&hull, &c.surface, &message), TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, "in one plane") != NULL, "%s", message.text);
    clear_cloud(&c);
  }
}
END_TEST

/* ---- small grids -------------------------------------------------------------------------------
 */

/* Sets of points, one bit each. */
typedef struct planes {
  int count;
  uint64_t on[MOST_PLANES];
} planes;

/* Of the plane through three points: those on it, where none is beyond on one of its sides. */
static uint64_t support(const cloud *c, int a, int b, int d) {
  long one[3], other[3], normal[3];
  for (int k = 0; k < 3; k++) {
    one[k] = c->points[b][k] - c->points[a][k];
    other[k] = c->points[d][k] - c->points[a][k];
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    normal[k] = one[i] * other[j] - one[j] * other[i];
  }
  if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0) return 0;
  uint64_t on = 0;
  bool above = false, below = false;
  for (int p = 0; p < c->count; p++) {
    long side = 0;
    for (int k = 0; k < 3; k++) side += normal[k] * (c->points[p][k] - c->points[a][k]);
    above = above || side > 0;
    below = below || side < 0;
    if (side == 0) on |= UINT64_C(1) << p;
  }
  return above && below ? 0 : on;
}

static void find_planes(planes *all, const cloud *c) {
  all->count = 0;
  for (int a = 0; a < c->count; a++) {
    for (int b = a + 1; b < c->count; b++) {
      for (int d = b + 1; d < c->count; d++) {
        const uint64_t on = support(c, a, b, d);
        int k = 0;
        while (k < all->count && all->on[k] != on) k++;
        ck_assert_int_lt(k, MOST_PLANES);
        if (on != 0 && k == all->count) all->on[all->count++] = on;
      }
    }
  }
}

/* Corners of the hull: points that are alone in the planes that have them. */
static uint64_t find_corners(const planes *all, const cloud *c) {
  uint64_t corners = 0;
  for (int p = 0; p < c->count; p++) {
    uint64_t common = ~UINT64_C(0);
    for (int k = 0; k < all->count; k++) {
      if (all->on[k] >> p & 1) common &= all->on[k];
    }
    if (common == UINT64_C(1) << p) corners |= common;
  }
  return corners;
}

static void check_facets(const cloud *c) {
  static planes all;
  tp_hull_facets facets;
  ck_assert_int_eq(tp_hull_facets_init(&facets, &c->surface, &message), TP_OK);
  find_planes(&all, c);
  const uint64_t corners = find_corners(&all, c);
  ck_assert_int_eq(facets.count, all.count);
  for (long f = 0; f < facets.count; f++) {
    uint64_t found = 0;
    for (long k = facets.starts[f]; k < facets.starts[f + 1]; k++) {
      found |= UINT64_C(1) << facets.sides[k].from;
    }
    int k = 0;
    while (k < all.count && (all.on[k] & corners) != found) k++;
    ck_assert_int_lt(k, all.count);
    all.on[k] = 0; /* each is met once */
  }
  tp_hull_facets_clear(&facets);
}

/* A proven hull with one triangle changed, which is then no hull. */
static void check_damage(const cloud *c, random_numbers *state) {
  tp_hull hull;
  ck_assert_int_eq(tp_hull_find(&hull, &c->surface, &message), TP_OK);
  int *triangle = hull.corners + 3 * draw_below(state, hull.count);
  const int place = (int)draw_below(state, 3), was = triangle[place];
  triangle[place] = (int)((was + 1 + draw_below(state, c->count - 1)) % c->count);
  ck_assert_int_ne(judge(c, hull.corners, hull.count), TP_HULL_PROVEN);
  triangle[place] = was;
  for (int k = 0; k < 3; k++) { /* an edge turned to join the far corners of its two triangles */
    const long side = draw_below(state, 3 * hull.count), t = side / 3, other = hull.across[side];
    if (hull.level[side]) continue;
    int *one = hull.corners + 3 * t, *two = hull.corners + 3 * other;
    const int a = one[side % 3], b = one[(side + 1) % 3], far = one[(side + 2) % 3];
    const int beyond = two[0] != a && two[0] != b   ? two[0]
                       : two[1] != a && two[1] != b ? two[1]
                                                    : two[2];
    const int kept[6] = {one[0], one[1], one[2], two[0], two[1], two[2]};
    memcpy(one, (int[]){a, beyond, far}, 3 * sizeof *one);
    memcpy(two, (int[]){beyond, b, far}, 3 * sizeof *two);
    ck_assert_int_ne(judge(c, hull.corners, hull.count), TP_HULL_PROVEN);
    memcpy(one, kept, 3 * sizeof *one);
    memcpy(two, kept + 3, 3 * sizeof *two);
  }
  ck_assert_int_eq(judge(c, hull.corners, hull.count), TP_HULL_PROVEN);
  tp_hull_clear(&hull);
}

/* Random points of a grid of 2 to 6 to each side, and rows of points between two of them. */
START_TEST(facets_are_all_planes_through_three_points) {
  random_numbers state = random_numbers_from(59);
  const long count = rounds(300, 20000);
  for (long round = 0; round < count; round++) {
    cloud c = {0};
    int four[4];
    const long size = 2 + draw_below(&state, 5), wanted = 5 + draw_below(&state, 20);
    for (int k = 0; k < 3 * wanted && c.count < wanted; k++) {
      add(&c, 6 * draw_below(&state, size), 6 * draw_below(&state, size),
          6 * draw_below(&state, size));
    }
    for (int row = 0; row < 4; row++) {
      const long *a = c.points[draw_below(&state, c.count)],
                 *b = c.points[draw_below(&state, c.count)];
      const long parts = row < 2 ? 2 : 3;
      for (long k = 1; k < parts; k++) {
        add(&c, (a[0] * k + b[0] * (parts - k)) / parts, (a[1] * k + b[1] * (parts - k)) / parts,
            (a[2] * k + b[2] * (parts - k)) / parts);
      }
    }
    close_cloud(&c, draw_below(&state, 4) == 0);
    if (tp_hull_span(four, &c.surface)) {
      check_facets(&c);
      check_damage(&c, &state);
    }
    clear_cloud(&c);
  }
}
END_TEST

SUITE(solid_hull) {
  Suite *suite = suite_create("solid_hull");
  TCase *cases = tcase_create("solid_hull");
  tcase_set_timeout(cases, 3600);
  tcase_add_loop_test(cases, a_sound_hull_passes, 0, 2);
  tcase_add_loop_test(cases, each_damage_is_refused, 0, 2);
  tcase_add_loop_test(cases, a_surface_wound_twice_is_refused, 0, 2);
  tcase_add_loop_test(cases, two_pieces_apart_are_refused, 0, 2);
  tcase_add_loop_test(cases, a_second_search_is_exact_and_a_third_is_none, 0, 2);
  tcase_add_loop_test(cases, flat_points_are_refused, 0, 2);
  tcase_add_test(cases, facets_are_all_planes_through_three_points);
  suite_add_tcase(suite, cases);
  return suite;
}
