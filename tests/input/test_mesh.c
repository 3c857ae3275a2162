/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sections of solids in whole numbers, exactly: planes through two vertices each, so that vertices
 * and edges lie on them. All chains must close, and the area of all must be what the faces give one
 * by one as vectors, which are not joined; equal as rationals. */

#include "format/mesh_cut.h"
#include "random_numbers.h"
#include "suite.h"

#include <arb.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 400, VERTICES = 18, FACES = 32 };

static random_numbers state;

/* An octahedron with halved edges, its middles pushed out: convex, faces outwards. */
static const long corners[VERTICES][3] = {
    {10, 0, 0}, {-10, 0, 0}, {0, 10, 0}, {0, -10, 0}, {0, 0, 10},  {0, 0, -10},
    {7, 7, 0},  {0, 7, 7},   {7, 0, 7},  {-7, 7, 0},  {-7, 0, 7},  {-7, -7, 0},
    {0, -7, 7}, {7, -7, 0},  {0, 7, -7}, {7, 0, -7},  {-7, 0, -7}, {0, -7, -7},
};
static const int eighths[8][6] = {
    {0, 6, 2, 7, 4, 8},   {2, 9, 1, 10, 4, 7},  {1, 11, 3, 12, 4, 10}, {3, 13, 0, 8, 4, 12},
    {2, 6, 0, 15, 5, 14}, {1, 9, 2, 14, 5, 16}, {3, 11, 1, 16, 5, 17}, {0, 13, 3, 17, 5, 15}};

typedef struct solid {
  long points[VERTICES][3];
  int faces[FACES][3];
} solid;

/* Drawn out along its axes and sheared; now and then far off. */
static void draw_solid(solid *own) {
  const long a = 1 + draw_below(&state, 9), b = 1 + draw_below(&state, 9);
  const long shear = draw_below(&state, 5) - 2, off = draw_below(&state, 3) == 0 ? 123456789 : 3;
  for (int k = 0; k < VERTICES; k++) {
    own->points[k][0] = a * corners[k][0] + shear * corners[k][2] + off;
    own->points[k][1] = b * corners[k][1] + shear * corners[k][0] - off;
    own->points[k][2] = corners[k][2] + off;
  }
  for (int e = 0; e < 8; e++) {
    static const int parts[4][3] = {{0, 1, 5}, {1, 2, 3}, {5, 3, 4}, {1, 3, 5}};
    for (int p = 0; p < 4; p++) {
      for (int c = 0; c < 3; c++) own->faces[4 * e + p][c] = eighths[e][parts[p][c]];
    }
  }
}

static void read_solid(tp_mesh *mesh, const solid *own) {
  char text[8192];
  size_t length = 0;
  tp_message message;
  for (int k = 0; k < VERTICES; k++) {
    length += (size_t)snprintf(text + length, sizeof text - length, "v %ld %ld %ld\n",
                               own->points[k][0], own->points[k][1], own->points[k][2]);
  }
  for (int k = 0; k < FACES; k++) {
    length +=
        (size_t)snprintf(text + length, sizeof text - length, "f %d/1 %d//2 %d\n",
                         own->faces[k][0] + 1, own->faces[k][1] + 1, own->faces[k][2] - VERTICES);
  }
  ck_assert_int_eq(tp_mesh_read_bytes(mesh, TP_MESH_OBJ, text, length, "solid", &message), TP_OK);
  ck_assert_int_eq(mesh->vertex_count, VERTICES);
  ck_assert_int_eq(mesh->face_count, FACES);
}

/* Moment of the step from one point to another about the origin: s1 h2 - s2 h1. */
static void add_moment(fmpq_t sum, const fmpq *s1, const fmpq *h1, const fmpq *s2, const fmpq *h2) {
  fmpq_addmul(sum, s1, h2);
  fmpq_submul(sum, s2, h1);
}

/* Twice the area of the section, by the vectors of its faces, which need no order. The plane goes
 * through p along (dx, dy); s is not scaled. */
static void sum_vectors(fmpq_t sum, const solid *own, const long p[3], long dx, long dy) {
  fmpq end[2][2];
  fmpq_t t;
  fmpq_init(t);
  for (int k = 0; k < 4; k++) fmpq_init(&end[k / 2][k % 2]);
  fmpq_zero(sum);
  for (int f = 0; f < FACES; f++) {
    int found = 0;
    for (int c = 0; c < 3; c++) {
      const long *a = own->points[own->faces[f][c]], *b = own->points[own->faces[f][(c + 1) % 3]];
      const long u = dx * (a[1] - p[1]) - dy * (a[0] - p[0]);
      const long v = dx * (b[1] - p[1]) - dy * (b[0] - p[0]);
      if ((u < 0) == (v < 0)) continue;
      const long from = dx * (a[0] - p[0]) + dy * (a[1] - p[1]);
      const long to = dx * (b[0] - p[0]) + dy * (b[1] - p[1]);
      fmpq *at = end[v < 0];
      fmpq_set_si(t, u, 1);
      fmpq_set_si(at, u - v, 1);
      fmpq_div(t, t, at);
      fmpq_set_si(at, to - from, 1);
      fmpq_mul(at, at, t);
      fmpq_add_si(at, at, from);
      fmpq_set_si(at + 1, b[2] - a[2], 1);
      fmpq_mul(at + 1, at + 1, t);
      fmpq_add_si(at + 1, at + 1, a[2]);
      found++;
    }
    ck_assert(found == 0 || found == 2);
    if (found == 2) add_moment(sum, end[1], end[1] + 1, end[0], end[0] + 1);
  }
  fmpq_abs(sum, sum);
  for (int k = 0; k < 4; k++) fmpq_clear(&end[k / 2][k % 2]);
  fmpq_clear(t);
}

static void sum_chains(fmpq_t sum, const tp_mesh_section *section) {
  fmpq_zero(sum);
  for (long k = 0; k < section->count; k++) {
    const tp_polyline *line = &section->chains[k].points;
    ck_assert(section->chains[k].closed);
    ck_assert_int_ge(line->count, 3);
    for (long q = 0, r = line->count - 1; q < line->count; r = q++) {
      add_moment(sum, line->x + r, line->y + r, line->x + q, line->y + q);
    }
  }
  fmpq_abs(sum, sum);
}

/* False where the plane holds a face, or passes by. */
static bool cut(tp_mesh_section *section, const tp_mesh *mesh, const long p[3], const long q[3],
                fmpq_t scale) {
  tp_section_plane plane;
  tp_message message = {.text = ""};
  fmpq x[4];
  const long values[] = {p[0], p[1], q[0], q[1]};
  for (int k = 0; k < 4; k++) {
    fmpq_init(x + k);
    fmpq_set_si(x + k, values[k], 1);
  }
  tp_section_plane_init(&plane);
  ck_assert(tp_section_plane_through(&plane, x, x + 1, x + 2, x + 3));
  const tp_status status = tp_mesh_cut(section, mesh, -1, &plane, &message);
  fmpq_set(scale, &plane.scale);
  if (status != TP_OK) ck_assert_ptr_nonnull(strstr(message.text, "lies in the plane"));
  tp_section_plane_clear(&plane);
  for (int k = 0; k < 4; k++) fmpq_clear(x + k);
  return status == TP_OK && section->count > 0;
}

START_TEST(planes_through_vertices) {
  int cuts = 0;
  fmpq_t area, wanted, scale;
  fmpq_init(area);
  fmpq_init(wanted);
  fmpq_init(scale);
  for (int round = 0; round < ROUNDS; round++) {
    solid own;
    tp_mesh mesh;
    tp_mesh_section section;
    draw_solid(&own);
    read_solid(&mesh, &own);
    const long *p = own.points[draw_below(&state, VERTICES)];
    const long *q = own.points[draw_below(&state, VERTICES)];
    if (p[0] == q[0] && p[1] == q[1]) {
      tp_mesh_clear(&mesh);
      continue;
    }
    if (cut(&section, &mesh, p, q, scale)) {
      sum_chains(area, &section);
      sum_vectors(wanted, &own, p, q[0] - p[0], q[1] - p[1]);
      fmpq_mul(wanted, wanted, scale);
      ck_assert(fmpq_equal(area, wanted));
      ck_assert_int_eq(section.flipped, 0);
      cuts++;
      tp_mesh_section_clear(&section);
    }
    tp_mesh_clear(&mesh);
  }
  ck_assert_int_gt(cuts, ROUNDS / 3);
  fmpq_clear(area);
  fmpq_clear(wanted);
  fmpq_clear(scale);
}
END_TEST

/* One face that is no convex polygon, cut in two pieces: a comb of two teeth, upright. */
START_TEST(face_with_two_pieces) {
  static const char comb[] = "v 0 -1 0\nv 5 -1 0\nv 5 2 0\nv 4 2 0\nv 4 0 0\nv 1 0 0\nv 1 2 0\n"
                             "v 0 2 0\nf 1 2 3 4 5 6 7 8\n";
  tp_mesh mesh;
  tp_mesh_section section;
  tp_section_plane plane;
  tp_message message;
  fmpq x[4];
  const long values[] = {0, 1, 3, 1};
  for (int k = 0; k < 4; k++) {
    fmpq_init(x + k);
    fmpq_set_si(x + k, values[k], 1);
  }
  tp_section_plane_init(&plane);
  ck_assert(tp_section_plane_through(&plane, x, x + 1, x + 2, x + 3));
  ck_assert_int_eq(tp_mesh_read_bytes(&mesh, TP_MESH_OBJ, comb, sizeof comb - 1, "comb", &message),
                   TP_OK);
  ck_assert_int_eq(tp_mesh_cut(&section, &mesh, -1, &plane, &message), TP_OK);
  ck_assert_int_eq(section.count, 2);
  for (long k = 0; k < 2; k++) {
    const tp_polyline *line = &section.chains[k].points;
    ck_assert(!section.chains[k].closed);
    ck_assert_int_eq(line->count, 2);
    fmpq_sub(x, line->x, line->x + 1);
    fmpq_abs(x, x);
    ck_assert(fmpq_is_one(x)); /* a tooth is one wide, the gap between them three */
  }
  tp_mesh_section_clear(&section);
  tp_mesh_clear(&mesh);
  tp_section_plane_clear(&plane);
  for (int k = 0; k < 4; k++) fmpq_clear(x + k);
}
END_TEST

static void expect_side(const tp_section_plane *plane, const char *const texts[3], int side) {
  fmpq vertex[3];
  for (int k = 0; k < 3; k++) {
    fmpq_init(vertex + k);
    ck_assert_int_eq(fmpq_set_str(vertex + k, texts[k], 10), 0);
  }
  ck_assert_int_eq(tp_section_plane_side(plane, vertex), side);
  for (int k = 0; k < 3; k++) fmpq_clear(vertex + k);
}

/* Doubles propose a side, but never where they cannot know: a step of 1e-40 beside the plane, far
 * from the origin. */
START_TEST(sides_a_hair_apart) {
  static const char near[] = "30000000000000000000000000000000000000000000000001/"
                             "10000000000000000000000000000000000000000";
  static const char *const on[] = {"3000000000", "3000000000", "0"};
  static const char *const left[] = {"3000000000", near, "0"};
  static const char *const right[] = {near, "3000000000", "0"};
  tp_section_plane plane;
  fmpq x[2];
  for (int k = 0; k < 2; k++) fmpq_init(x + k);
  fmpq_set_si(x + 1, 7, 1);
  tp_section_plane_init(&plane);
  ck_assert(tp_section_plane_through(&plane, x, x, x + 1, x + 1));
  expect_side(&plane, on, 0);
  expect_side(&plane, left, 1);
  expect_side(&plane, right, -1);
  tp_section_plane_clear(&plane);
  for (int k = 0; k < 2; k++) fmpq_clear(x + k);
}
END_TEST

/* The direction of an azimuth has length one exactly, and is as near as is told. */
START_TEST(azimuth) {
  static const char *const azimuths[] = {"0",   "90",          "-90", "45",
                                         "1/3", "359999/1000", "137", "-210"};
  fmpq_t zero, angle, sum;
  fmpq_init(zero);
  fmpq_init(angle);
  fmpq_init(sum);
  for (size_t k = 0; k < sizeof azimuths / sizeof azimuths[0]; k++) {
    tp_section_plane plane;
    arb_t near, own;
    ck_assert_int_eq(fmpq_set_str(angle, azimuths[k], 10), 0);
    tp_section_plane_init(&plane);
    tp_section_plane_at(&plane, zero, zero, angle);
    fmpq_mul(sum, &plane.dx, &plane.dx);
    fmpq_addmul(sum, &plane.dy, &plane.dy);
    ck_assert(fmpq_is_one(sum));
    arb_init(near);
    arb_init(own);
    /* the sine of the angle between both: dx cos(azimuth) - dy sin(azimuth) */
    arb_set_fmpq(near, angle, 200);
    arb_div_ui(near, near, 180, 200);
    arb_sin_cos_pi(own, near, near, 200);
    arb_mul_fmpz(near, near, fmpq_numref(&plane.dx), 200);
    arb_div_fmpz(near, near, fmpq_denref(&plane.dx), 200);
    arb_mul_fmpz(own, own, fmpq_numref(&plane.dy), 200);
    arb_div_fmpz(own, own, fmpq_denref(&plane.dy), 200);
    arb_sub(near, near, own, 200);
    ck_assert_double_lt(fabs(arf_get_d(arb_midref(near), ARF_RND_NEAR)), 1e-12);
    arb_clear(near);
    arb_clear(own);
    tp_section_plane_clear(&plane);
  }
  fmpq_clear(zero);
  fmpq_clear(angle);
  fmpq_clear(sum);
}
END_TEST

SUITE(mesh) {
  state = random_numbers_from(20);
  Suite *suite = suite_create("mesh");
  TCase *cases = tcase_create("mesh");
  tcase_set_timeout(cases, 60);
  tcase_add_test(cases, planes_through_vertices);
  tcase_add_test(cases, face_with_two_pieces);
  tcase_add_test(cases, sides_a_hair_apart);
  tcase_add_test(cases, azimuth);
  suite_add_tcase(suite, cases);
  return suite;
}
