/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines, polylines with bulges, circles, arcs and ellipses of a DXF file from their groups,
 * mirrored where the extrusion is; heights that differ are refused. */

#include "format/affine.h"
#include "format/dxf_reader.h"
#include "format/standing.h"
#include "number/divide.h"

enum { X = 10, Y = 20, Z = 30, END = 1, RADIUS = 40, BULGE = 42, FLAGS = 70 };

static const char other_plane[] =
    "lies in another plane than the drawing's (its extrusion); draw the section in the plane of x "
    "and y";
static const char leaves_plane[] =
    "leaves the plane of the drawing: its z changes; draw the section in the plane of x and y";

static tp_mark mark_of(const tp_dxf_group *group) {
  return (tp_mark){group->line, 1};
}

/* A point of the groups X, Y, Z + `offset`, and is it as high as the one before? */
static bool add_point(tp_dxf_reader *r, tp_drawing_object *object, const tp_dxf_entity *entity,
                      int offset) {
  fmpq_t x, y, z;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(z);
  const tp_dxf_group *first = tp_dxf_find(entity, X + offset);
  bool done = tp_dxf_real(r, x, entity, X + offset, 0) &&
              tp_dxf_real(r, y, entity, Y + offset, 0) && tp_dxf_real(r, z, entity, Z + offset, 0);
  if (done) {
    const bool flat = r->drawing->standing == NULL;
    if (flat && r->has_height && !fmpq_equal(z, r->height)) object->problem = leaves_plane;
    fmpq_set(r->height, z);
    r->has_height = true;
    done = tp_drawing_add_in_space(r->drawing, object, x, y, z,
                                   mark_of(first != NULL ? first : entity->groups)) ||
           tp_dxf_fail_memory(r);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(z);
  return done;
}

bool tp_dxf_line(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  tp_drawing_object *object = tp_dxf_add(r, "LINE", entity);
  r->has_height = false;
  return object != NULL && add_point(r, object, entity, 0) && add_point(r, object, entity, END);
}

/* The edge from the last point on is an arc where the bulge is not zero. */
static bool bend(tp_dxf_reader *r, tp_drawing_object *object, const tp_dxf_group *group) {
  fmpq_t bulge;
  fmpq_init(bulge);
  bool done = tp_dxf_number(r, bulge, group);
  if (done && !fmpq_is_zero(bulge)) {
    done = tp_drawing_bend(object, bulge) || tp_dxf_fail_memory(r);
  }
  fmpq_clear(bulge);
  return done;
}

/* Points without a repeated one, mirrored where the entity is. */
static void finish(tp_drawing_object *object, bool mirrored) {
  if (mirrored) tp_dxf_mirror(object);
  tp_drawing_tidy(object);
}

/* A vertex begins with its x, and what else it has follows it. */
bool tp_dxf_light_polyline(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  long flags = 0;
  int side = 1;
  tp_drawing_object *object = tp_dxf_add(r, "LWPOLYLINE", entity);
  if (object == NULL || !tp_dxf_whole(r, &flags, entity, FLAGS, 0) ||
      !tp_dxf_extrusion(r, &side, entity)) {
    return false;
  }
  if (side == 0) object->problem = other_plane;
  if ((flags & 1) != 0) object->closure = TP_DRAWING_CLOSED;
  r->has_height = false;
  for (size_t k = 1; k < entity->count; k++) {
    if (entity->groups[k].code != X) continue;
    size_t end = k + 1;
    while (end < entity->count && entity->groups[end].code != X) end++;
    const tp_dxf_entity vertex = {entity->groups + k - 1, end - k + 1};
    if (!add_point(r, object, &vertex, 0)) return false;
    const tp_dxf_group *bulge = tp_dxf_find(&vertex, BULGE);
    if (bulge != NULL && !bend(r, object, bulge)) return false;
  }
  finish(object, side < 0);
  return true;
}

bool tp_dxf_polyline(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  enum { CLOSED = 1, MESH = 16, FACES = 64 };
  long flags = 0;
  int side = 1;
  if (!tp_dxf_whole(r, &flags, entity, FLAGS, 0) || !tp_dxf_extrusion(r, &side, entity)) {
    return false;
  }
  if ((flags & (MESH | FACES)) != 0) return true;
  r->polyline = tp_dxf_add(r, "POLYLINE", entity);
  if (r->polyline == NULL) return false;
  if (side == 0) r->polyline->problem = other_plane;
  if ((flags & CLOSED) != 0) r->polyline->closure = TP_DRAWING_CLOSED;
  r->mirrored = side < 0;
  r->has_height = false;
  return true;
}

bool tp_dxf_vertex(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  enum { FRAME = 16 }; /* a control point of a spline, whose points follow */
  long flags = 0;
  if (r->polyline == NULL) return true;
  if (!tp_dxf_whole(r, &flags, entity, FLAGS, 0)) return false;
  if ((flags & FRAME) != 0) return true;
  if (!add_point(r, r->polyline, entity, 0)) return false;
  const tp_dxf_group *bulge = tp_dxf_find(entity, BULGE);
  return bulge == NULL || bend(r, r->polyline, bulge);
}

bool tp_dxf_sequence_end(tp_dxf_reader *r) {
  if (r->polyline != NULL) finish(r->polyline, r->mirrored);
  r->polyline = NULL;
  return true;
}

/* ---- circles, arcs, ellipses -------------------------------------------------------------------
 */

typedef struct round_numbers {
  fmpq_t x, y, radius, from, to; /* angles as they stand */
} round_numbers;

static void round_init(round_numbers *n) {
  fmpq_init(n->x);
  fmpq_init(n->y);
  fmpq_init(n->radius);
  fmpq_init(n->from);
  fmpq_init(n->to);
}

static void round_clear(round_numbers *n) {
  fmpq_clear(n->x);
  fmpq_clear(n->y);
  fmpq_clear(n->radius);
  fmpq_clear(n->from);
  fmpq_clear(n->to);
}

static bool read_circle(tp_dxf_reader *r, round_numbers *n, int *side,
                        const tp_dxf_entity *entity) {
  if (!tp_dxf_real(r, n->x, entity, X, 0) || !tp_dxf_real(r, n->y, entity, Y, 0) ||
      !tp_dxf_real(r, n->radius, entity, RADIUS, 0) || !tp_dxf_extrusion(r, side, entity)) {
    return false;
  }
  const tp_dxf_group *radius = tp_dxf_find(entity, RADIUS);
  return fmpq_sgn(n->radius) > 0 ||
         tp_dxf_fail(r, radius != NULL ? radius : entity->groups, "a radius must be above zero");
}

static bool finish_round(tp_drawing_object *object, int side) {
  if (side == 0) object->problem = other_plane;
  if (side < 0) tp_dxf_mirror(object);
  return true;
}

bool tp_dxf_circle(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  int side = 1;
  round_numbers n;
  round_init(&n);
  tp_drawing_object *object = NULL;
  bool done = read_circle(r, &n, &side, entity);
  if (done) done = (object = tp_dxf_add(r, "CIRCLE", entity)) != NULL;
  if (done) {
    done = tp_curve_circle(object, n.x, n.y, n.radius, mark_of(entity->groups)) ||
           tp_dxf_fail_memory(r);
  }
  round_clear(&n);
  return done && finish_round(object, side);
}

/* In degrees, counter-clockwise from the one to the other. */
static bool add_arc(tp_dxf_reader *r, tp_drawing_object *object, round_numbers *n, tp_mark mark) {
  enum { BITS = 192, HALF = 180 };
  arb_t from, to;
  arb_init(from);
  arb_init(to);
  arb_const_pi(from, BITS);
  arb_div_ui(from, from, HALF, BITS);
  arb_set(to, from);
  arb_t degrees;
  arb_init(degrees);
  arb_set_fmpq(degrees, n->from, BITS);
  arb_mul(from, from, degrees, BITS);
  arb_set_fmpq(degrees, n->to, BITS);
  arb_mul(to, to, degrees, BITS);
  arb_clear(degrees);
  const bool done = tp_curve_arc(object, n->x, n->y, n->radius, from, to, mark);
  arb_clear(from);
  arb_clear(to);
  return done || tp_dxf_fail_memory(r);
}

/* Angles that no CAD program writes would be turned back for ever. */
static bool check_angles(tp_dxf_reader *r, const round_numbers *n, const tp_dxf_group *group) {
  enum { TURNS = 3600 };
  const bool small = fmpq_cmp_si(n->from, TURNS) <= 0 && fmpq_cmp_si(n->from, -TURNS) >= 0 &&
                     fmpq_cmp_si(n->to, TURNS) <= 0 && fmpq_cmp_si(n->to, -TURNS) >= 0;
  return small || tp_dxf_fail(r, group, "the angles of an arc lie within ten turns");
}

bool tp_dxf_arc(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  enum { FROM = 50, TO = 51, TURN = 360 };
  int side = 1;
  round_numbers n;
  round_init(&n);
  tp_drawing_object *object = NULL;
  bool done = read_circle(r, &n, &side, entity) && tp_dxf_real(r, n.from, entity, FROM, 0) &&
              tp_dxf_real(r, n.to, entity, TO, TURN) && check_angles(r, &n, entity->groups);
  if (done) done = (object = tp_dxf_add(r, "ARC", entity)) != NULL;
  if (done) {
    while (fmpq_cmp(n.to, n.from) > 0) fmpq_add_si(n.to, n.to, -TURN);
    fmpq_add_si(n.to, n.to, TURN); /* a whole circle where both are the same */
    done = add_arc(r, object, &n, mark_of(entity->groups));
  }
  round_clear(&n);
  return done && finish_round(object, side);
}

/* The unit circle, or an arc of it, in its own plane. */
static bool add_unit(tp_dxf_reader *r, tp_drawing_object *object, round_numbers *n, bool whole,
                     tp_mark mark) {
  enum { BITS = 192 };
  fmpq_t one;
  arb_t from, to, turn;
  fmpq_init(one);
  arb_init(from);
  arb_init(to);
  arb_init(turn);
  fmpq_one(one);
  arb_set_fmpq(from, n->from, BITS);
  arb_set_fmpq(to, n->to, BITS);
  arb_const_pi(turn, BITS);
  arb_mul_2exp_si(turn, turn, 1);
  if (arb_lt(to, from)) arb_add(to, to, turn, BITS);
  fmpq_zero(n->from); /* the centre */
  const bool done = whole ? tp_curve_circle(object, n->from, n->from, one, mark)
                          : tp_curve_arc(object, n->from, n->from, one, from, to, mark);
  fmpq_clear(one);
  arb_clear(from);
  arb_clear(to);
  arb_clear(turn);
  return done || tp_dxf_fail_memory(r);
}

/* Chords, unless the map makes a circle of the unit circle. */
static bool map_unit(tp_dxf_reader *r, tp_drawing_object *object, const tp_affine_map *map) {
  fmpq_t size, tolerance;
  fmpq_init(size);
  fmpq_init(tolerance);
  bool done = true;
  if (!tp_affine_map_keeps_circles(map)) {
    tp_affine_map_stretch(size, map);
    tp_curve_tolerance(tolerance, r->options, size);
    /* a map that makes a point of it: any chords do */
    if (!tp_divide(tolerance, tolerance, size)) fmpq_one(tolerance);
    done = tp_dxf_curve(r, object, tp_curve_flatten(object, tolerance));
  }
  tp_affine_map_object(object, map);
  fmpq_clear(size);
  fmpq_clear(tolerance);
  return done;
}

/* Is the one parameter a whole turn beyond the other? Within 1e-9, as decimals of 2 pi are cut. */
static bool is_whole(const round_numbers *n) {
  enum { BITS = 192, NEAR = 1000000000 };
  arb_t difference, turn;
  fmpq_t angle;
  arb_init(difference);
  arb_init(turn);
  fmpq_init(angle);
  fmpq_sub(angle, n->to, n->from);
  arb_set_fmpq(difference, angle, BITS);
  arb_const_pi(turn, BITS);
  arb_mul_2exp_si(turn, turn, 1);
  arb_sub(difference, difference, turn, BITS);
  arb_mul_ui(difference, difference, NEAR, BITS);
  arb_abs(difference, difference);
  arb_one(turn);
  const bool whole = fmpq_is_zero(angle) || arb_lt(difference, turn);
  arb_clear(difference);
  arb_clear(turn);
  fmpq_clear(angle);
  return whole;
}

static bool read_parameters(tp_dxf_reader *r, round_numbers *n, bool *whole,
                            const tp_dxf_entity *entity) {
  enum { FROM = 41, TO = 42 };
  if (!tp_dxf_real(r, n->from, entity, FROM, 0) || !tp_dxf_real(r, n->to, entity, TO, 0) ||
      !check_angles(r, n, entity->groups)) {
    return false;
  }
  *whole = is_whole(n);
  return true;
}

/* x' = centre + major cos u + minor sin u; the minor axis is `ratio` of the major one, turned left,
 * or right where it is extruded along -z. */
static bool read_axes(tp_dxf_reader *r, tp_affine_map *map, int *side,
                      const tp_dxf_entity *entity) {
  enum { MAJOR = 1, RATIO = 40 };
  fmpq_t ratio;
  fmpq_init(ratio);
  bool done = tp_dxf_real(r, map->e, entity, X, 0) && tp_dxf_real(r, map->f, entity, Y, 0) &&
              tp_dxf_real(r, map->a, entity, X + MAJOR, 0) &&
              tp_dxf_real(r, map->b, entity, Y + MAJOR, 0) &&
              tp_dxf_real(r, ratio, entity, RATIO, 1) && tp_dxf_extrusion(r, side, entity);
  if (done && (fmpq_sgn(ratio) <= 0 || (fmpq_is_zero(map->a) && fmpq_is_zero(map->b)))) {
    done = tp_dxf_fail(r, entity->groups, "the axes of an ellipse must be longer than zero");
  }
  if (*side < 0) fmpq_neg(ratio, ratio);
  fmpq_mul(map->d, map->a, ratio);
  fmpq_mul(map->c, map->b, ratio);
  fmpq_neg(map->c, map->c);
  fmpq_clear(ratio);
  return done;
}

bool tp_dxf_ellipse(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  int side = 1;
  bool whole = true;
  round_numbers n;
  tp_affine_map map;
  round_init(&n);
  tp_affine_map_init(&map);
  tp_drawing_object *object = NULL;
  bool done = read_axes(r, &map, &side, entity) && read_parameters(r, &n, &whole, entity);
  if (done) done = (object = tp_dxf_add(r, "ELLIPSE", entity)) != NULL;
  if (done) {
    if (side == 0) object->problem = other_plane;
    done = add_unit(r, object, &n, whole, mark_of(entity->groups)) && map_unit(r, object, &map);
  }
  round_clear(&n);
  tp_affine_map_clear(&map);
  return done;
}
