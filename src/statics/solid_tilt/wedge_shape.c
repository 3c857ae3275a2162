/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points as meetings of planes and lines, by balls of 256 bits. */

#include "solid_tilt/wedge_shape.h"

#include <string.h>

enum { BITS = TP_WEDGE_BITS, PLACES = 100 };

/* ---- vectors -----------------------------------------------------------------------------------
 */

static void init_vectors(arb_struct *v, int count) {
  for (int k = 0; k < 3 * count; k++) arb_init(v + k);
}

static void clear_vectors(arb_struct *v, int count) {
  for (int k = 0; k < 3 * count; k++) arb_clear(v + k);
}

void tp_wedge_dot(arb_t product, const arb_struct a[3], const arb_struct b[3]) {
  arb_mul(product, a, b, BITS);
  arb_addmul(product, a + 1, b + 1, BITS);
  arb_addmul(product, a + 2, b + 2, BITS);
}

void tp_wedge_cross(arb_struct product[3], const arb_struct a[3], const arb_struct b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    arb_mul(product + k, a + i, b + j, BITS);
    arb_submul(product + k, a + j, b + i, BITS);
  }
}

/* point = from + share (to - from) */
static void set_between(arb_struct point[3], const arb_struct from[3], const arb_struct to[3],
                        const arb_t share) {
  arb_t way;
  arb_init(way);
  for (int k = 0; k < 3; k++) {
    arb_sub(way, to + k, from + k, BITS);
    arb_mul(way, way, share, BITS);
    arb_add(point + k, from + k, way, BITS);
  }
  arb_clear(way);
}

/* (sin d sin t, sin d cos t, cos d): upwards, towards where the plane dips. */
static void set_normal(arb_struct normal[3], const tp_wedge_plane *plane) {
  fmpq_t half_turns;
  arb_t sine;
  fmpq_init(half_turns);
  arb_init(sine);
  fmpq_div_fmpz(half_turns, plane->dip_deg.value, (fmpz[]){180});
  arb_sin_cos_pi_fmpq(sine, normal + 2, half_turns, BITS);
  fmpq_div_fmpz(half_turns, plane->dip_direction_deg.value, (fmpz[]){180});
  arb_sin_cos_pi_fmpq(normal, normal + 1, half_turns, BITS);
  arb_mul(normal, normal, sine, BITS);
  arb_mul(normal + 1, normal + 1, sine, BITS);
  arb_clear(sine);
  fmpq_clear(half_turns);
}

/* ---- points ------------------------------------------------------------------------------------
 */

static tp_status refuse(const tp_wedge_description *w, tp_message *message, const char *what) {
  return tp_refuse(message, TP_FAULT_RANGE, w->place, "%s", what);
}

/* Up the line of both joints; false: it does not rise. */
static bool set_line(tp_wedge_shape *s) {
  arb_t length;
  arb_init(length);
  tp_wedge_cross(s->line, s->normals[TP_WEDGE_A], s->normals[TP_WEDGE_B]);
  tp_wedge_dot(length, s->line, s->line);
  arb_sqrt(length, length, BITS);
  if (arb_is_negative(s->line + 2)) arb_neg(length, length);
  for (int k = 0; k < 3; k++) arb_div(s->line + k, s->line + k, length, BITS);
  arb_clear(length);
  return arb_is_positive(s->line + 2);
}

/* Where a joint meets the crest: along joint x face, up to the ground above. */
static void set_end(arb_struct end[3], const tp_wedge_shape *s, int joint,
                    const arb_struct top[3]) {
  arb_t share, own;
  arb_struct way[3];
  arb_init(share);
  arb_init(own);
  init_vectors(way, 1);
  tp_wedge_cross(way, s->normals[joint], s->normals[TP_WEDGE_FACE]);
  tp_wedge_dot(share, s->normals[TP_WEDGE_UPPER], top);
  tp_wedge_dot(own, s->normals[TP_WEDGE_UPPER], way);
  arb_div(share, share, own, BITS);
  for (int k = 0; k < 3; k++) arb_mul(end + k, way + k, share, BITS);
  clear_vectors(way, 1);
  arb_clear(share);
  arb_clear(own);
}

/* The sign of a point over a plane through the toe: of certain balls. */
static bool is_over(const tp_wedge_shape *s, int plane, const arb_struct point[3], int sign) {
  arb_t own;
  arb_init(own);
  tp_wedge_dot(own, s->normals[plane], point);
  const bool is = sign > 0 ? arb_is_positive(own) : arb_is_negative(own);
  arb_clear(own);
  return is;
}

static tp_status set_tetrahedron(tp_wedge_shape *s, const tp_wedge_description *w,
                                 tp_message *message) {
  arb_struct *top = s->points[TP_WEDGE_DEEP];
  arb_t length;
  if (!set_line(s)) {
    return refuse(w, message, "the joints A and B meet in no line that rises from the face");
  }
  arb_init(length);
  arb_set_fmpq(length, w->height.value, BITS);
  arb_div(length, length, s->line + 2, BITS);
  for (int k = 0; k < 3; k++) arb_mul(top + k, s->line + k, length, BITS);
  arb_clear(length);
  if (!is_over(s, TP_WEDGE_FACE, top, -1)) {
    return refuse(w, message,
                  "the line of both joints does not come out of the face: it must plunge towards "
                  "it, and less steeply");
  }
  if (!is_over(s, TP_WEDGE_UPPER, top, 1)) {
    return refuse(w, message, "the line of both joints does not rise to the ground above");
  }
  set_end(s->points[TP_WEDGE_END_A], s, TP_WEDGE_A, top);
  set_end(s->points[TP_WEDGE_END_B], s, TP_WEDGE_B, top);
  if (!is_over(s, TP_WEDGE_B, s->points[TP_WEDGE_END_A], 1) ||
      !is_over(s, TP_WEDGE_A, s->points[TP_WEDGE_END_B], 1)) {
    return refuse(w, message,
                  "the joints enclose no wedge that rests on both of them below the crest");
  }
  for (int k = 0; k < 3; k++) {
    arb_set(s->points[TP_WEDGE_BACK_A] + k, top + k);
    arb_set(s->points[TP_WEDGE_BACK_B] + k, top + k);
  }
  return TP_OK;
}

/* ---- the crack ---------------------------------------------------------------------------------
 */

static bool is_share(const arb_t share) {
  arb_t rest;
  arb_init(rest);
  arb_sub_ui(rest, share, 1, BITS);
  const bool is = arb_is_positive(share) && arb_is_negative(rest);
  arb_clear(rest);
  return is;
}

/* From D_A on, where the plane of the crack cuts the line from a point to the old top; false: it
 * does not between them. */
static bool cut(arb_struct point[3], const tp_wedge_shape *s, const arb_struct from[3],
                const arb_struct top[3]) {
  arb_struct ways[6];
  arb_t share, own;
  init_vectors(ways, 2);
  arb_init(share);
  arb_init(own);
  for (int k = 0; k < 3; k++) {
    arb_sub(ways + k, s->points[TP_WEDGE_BACK_A] + k, from + k, BITS);
    arb_sub(ways + 3 + k, top + k, from + k, BITS);
  }
  tp_wedge_dot(share, s->normals[TP_WEDGE_CRACK], ways);
  tp_wedge_dot(own, s->normals[TP_WEDGE_CRACK], ways + 3);
  arb_div(share, share, own, BITS);
  const bool done = is_share(share);
  set_between(point, from, top, share);
  clear_vectors(ways, 2);
  arb_clear(share);
  arb_clear(own);
  return done;
}

static tp_status set_crack(tp_wedge_shape *s, const tp_wedge_description *w, tp_message *message) {
  arb_struct top[3], way[3];
  arb_t share, length;
  init_vectors(top, 1);
  init_vectors(way, 1);
  arb_init(share);
  arb_init(length);
  for (int k = 0; k < 3; k++) {
    arb_set(top + k, s->points[TP_WEDGE_DEEP] + k);
    arb_sub(way + k, top + k, s->points[TP_WEDGE_END_A] + k, BITS);
  }
  tp_wedge_dot(length, way, way);
  arb_sqrt(length, length, BITS);
  arb_set_fmpq(share, w->crack_distance.value, BITS);
  arb_div(share, share, length, BITS);
  bool done = is_share(share);
  set_between(s->points[TP_WEDGE_BACK_A], s->points[TP_WEDGE_END_A], top, share);
  done = done && cut(s->points[TP_WEDGE_DEEP], s, s->points[TP_WEDGE_TOE], top);
  done = done && cut(s->points[TP_WEDGE_BACK_B], s, s->points[TP_WEDGE_END_B], top);
  clear_vectors(top, 1);
  clear_vectors(way, 1);
  arb_clear(share);
  arb_clear(length);
  return done ? TP_OK
              : refuse(w, message,
                       "the crack does not cut the wedge across both joints, between its crest "
                       "and its end: give it another distance or dip");
}

tp_status tp_wedge_shape_init(tp_wedge_shape *shape, const tp_wedge_description *wedge,
                              tp_message *message) {
  shape->has_crack = wedge->has_crack;
  init_vectors(shape->normals[0], TP_WEDGE_PLANES);
  init_vectors(shape->points[0], TP_WEDGE_POINTS);
  init_vectors(shape->line, 1);
  for (int k = 0; k < TP_WEDGE_PLANES; k++) set_normal(shape->normals[k], wedge->planes + k);
  const tp_status status = set_tetrahedron(shape, wedge, message);
  return status == TP_OK && wedge->has_crack ? set_crack(shape, wedge, message) : status;
}

void tp_wedge_shape_clear(tp_wedge_shape *shape) {
  clear_vectors(shape->normals[0], TP_WEDGE_PLANES);
  clear_vectors(shape->points[0], TP_WEDGE_POINTS);
  clear_vectors(shape->line, 1);
}

/* ---- its surface -------------------------------------------------------------------------------
 */

static tp_status add_point(int *index, tp_mesh *mesh, const arb_struct point[3],
                           tp_message *message) {
  fmpq own[3];
  arf_t middle;
  arf_init(middle);
  for (int k = 0; k < 3; k++) {
    fmpq_init(own + k);
    arf_mul_2exp_si(middle, arb_midref(point + k), PLACES);
    arf_get_fmpz(fmpq_numref(own + k), middle, ARF_RND_NEAR);
    fmpq_div_2exp(own + k, own + k, PLACES);
  }
  const tp_status status = tp_mesh_add_vertex(mesh, index, own, message);
  for (int k = 0; k < 3; k++) fmpq_clear(own + k);
  arf_clear(middle);
  return status;
}

/* Is A to the left of B, seen from the face? Then faces as below run inwards. */
static bool is_turned(const tp_wedge_shape *s) {
  arb_struct across[3];
  arb_t volume;
  init_vectors(across, 1);
  arb_init(volume);
  tp_wedge_cross(across, s->points[TP_WEDGE_END_A], s->points[TP_WEDGE_END_B]);
  tp_wedge_dot(volume, across, s->points[TP_WEDGE_DEEP]);
  const bool is = arb_is_negative(volume);
  clear_vectors(across, 1);
  arb_clear(volume);
  return is;
}

/* A tetrahedron, or that with its end cut off: quadrilaterals as two triangles each. */
static const signed char faces_whole[][3] = {{TP_WEDGE_TOE, TP_WEDGE_END_B, TP_WEDGE_END_A},
                                             {TP_WEDGE_TOE, TP_WEDGE_END_A, TP_WEDGE_DEEP},
                                             {TP_WEDGE_TOE, TP_WEDGE_DEEP, TP_WEDGE_END_B},
                                             {TP_WEDGE_END_A, TP_WEDGE_END_B, TP_WEDGE_DEEP}};
static const signed char faces_cut[][3] = {{TP_WEDGE_TOE, TP_WEDGE_END_B, TP_WEDGE_END_A},
                                           {TP_WEDGE_TOE, TP_WEDGE_END_A, TP_WEDGE_BACK_A},
                                           {TP_WEDGE_TOE, TP_WEDGE_BACK_A, TP_WEDGE_DEEP},
                                           {TP_WEDGE_TOE, TP_WEDGE_DEEP, TP_WEDGE_BACK_B},
                                           {TP_WEDGE_TOE, TP_WEDGE_BACK_B, TP_WEDGE_END_B},
                                           {TP_WEDGE_END_A, TP_WEDGE_END_B, TP_WEDGE_BACK_B},
                                           {TP_WEDGE_END_A, TP_WEDGE_BACK_B, TP_WEDGE_BACK_A},
                                           {TP_WEDGE_BACK_A, TP_WEDGE_BACK_B, TP_WEDGE_DEEP}};

tp_status tp_wedge_shape_mesh(tp_mesh *mesh, const tp_wedge_shape *shape, const char *file,
                              tp_message *message) {
  const long count = shape->has_crack ? (long)(sizeof faces_cut / sizeof faces_cut[0])
                                      : (long)(sizeof faces_whole / sizeof faces_whole[0]);
  const signed char(*faces)[3] = shape->has_crack ? faces_cut : faces_whole;
  const bool turned = is_turned(shape);
  int points[TP_WEDGE_POINTS];
  memset(mesh, 0, sizeof *mesh);
  mesh->file = file;
  tp_status status = tp_mesh_begin_object(mesh, "", 0, message);
  for (int k = 0; k < TP_WEDGE_POINTS && status == TP_OK; k++) {
    status = add_point(points + k, mesh, shape->points[k], message);
  }
  for (long k = 0; k < count && status == TP_OK; k++) {
    int corners[3];
    for (int i = 0; i < 3; i++) corners[i] = points[(int)faces[k][turned ? 2 - i : i]];
    status = tp_mesh_add_face(mesh, corners, 3, 0, message);
  }
  return status;
}
