/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arcs of SVG paths.
 *
 * Half-axes rx, ry along directions turned by an angle: in coordinates along these, divided by rx
 * and ry, the arc is one of the unit circle, from p to q. With half its chord s <= 1 and h = sqrt(1
 * - s^2) the tangent of a quarter of its angle is s / (1 + h), or (1 + h) / s for the large one,
 * positive where it sweeps. Where the chord is too long for the half-axes these grow until it fits
 * (SVG 1.1, F.6.6): s = 1. Of a circle the arc stays one, with its ends as they stand. */

#include "format/svg_path.h"

#include "number/divide.h"

enum { BITS = 256 };

/* From the square of the chord over four, in the unit of the radius. */
static void set_bulge(fmpq_t bulge, const fmpq_t half_square, const tp_svg_arc *arc) {
  arb_t s, h;
  arb_init(s);
  arb_init(h);
  fmpq_one(bulge);
  if (fmpq_cmp(half_square, bulge) < 0) {
    arb_set_fmpq(s, half_square, BITS);
    arb_sub_ui(h, s, 1, BITS);
    arb_neg(h, h);
    arb_sqrt(h, h, BITS);
    arb_add_ui(h, h, 1, BITS);
    arb_sqrt(s, s, BITS);
    if (arc->large) {
      arb_div(s, h, s, BITS);
    } else {
      arb_div(s, s, h, BITS);
    }
    tp_curve_decimal(bulge, s);
  }
  if (!arc->sweep) fmpq_neg(bulge, bulge);
  arb_clear(s);
  arb_clear(h);
}

/* Along the half-axes, in their lengths. */
static void to_unit(fmpq_t x, fmpq_t y, const tp_svg_arc *arc) {
  tp_affine_map map;
  fmpq_t back, inverse_x, inverse_y;
  tp_affine_map_init(&map);
  fmpq_init(back);
  fmpq_init(inverse_x);
  fmpq_init(inverse_y);
  fmpq_inv(inverse_x, arc->rx);
  fmpq_inv(inverse_y, arc->ry);
  fmpq_neg(back, arc->degrees);
  tp_affine_map_scale(&map, inverse_x, inverse_y);
  tp_svg_turn(&map, back);
  tp_affine_map_point(x, y, &map);
  tp_affine_map_clear(&map);
  fmpq_clear(back);
  fmpq_clear(inverse_x);
  fmpq_clear(inverse_y);
}

static void set_half_square(fmpq_t square, const fmpq *px, const fmpq *py, const fmpq *qx,
                            const fmpq *qy) {
  fmpq_t d;
  fmpq_init(d);
  fmpq_sub(d, qx, px);
  fmpq_mul(square, d, d);
  fmpq_sub(d, qy, py);
  fmpq_addmul(square, d, d);
  fmpq_div_2exp(square, square, 2);
  fmpq_clear(d);
}

static bool add_circular(tp_svg_target *target, tp_drawing_object *object, const tp_svg_arc *arc) {
  const tp_polyline *line = &object->line;
  const long last = line->count - 1;
  fmpq_t square, radius, bulge;
  fmpq_init(square);
  fmpq_init(radius);
  fmpq_init(bulge);
  set_half_square(square, line->x + last, line->y + last, arc->x, arc->y);
  fmpq_mul(radius, arc->rx, arc->rx);
  fmpq_div(square, square, radius);
  set_bulge(bulge, square, arc);
  const bool done = (fmpq_is_zero(bulge) || tp_drawing_bend(object, bulge)) &&
                    tp_drawing_add_point(object, arc->x, arc->y, target->mark);
  fmpq_clear(square);
  fmpq_clear(radius);
  fmpq_clear(bulge);
  return done;
}

/* The unit circle's arc as chords, mapped back, behind the object; its ends are there already. */
static bool add_chords(tp_svg_target *target, tp_drawing_object *object, tp_drawing_object *unit,
                       const tp_svg_arc *arc) {
  tp_affine_map map, whole;
  fmpq_t stretch, tolerance;
  tp_affine_map_init(&map);
  tp_affine_map_init(&whole);
  fmpq_init(stretch);
  fmpq_init(tolerance);
  tp_svg_turn(&map, arc->degrees);
  tp_affine_map_scale(&map, arc->rx, arc->ry);
  tp_affine_map_set(&whole, target->map);
  tp_affine_map_compose(&whole, &map);
  tp_affine_map_stretch(stretch, &whole);
  tp_curve_tolerance(tolerance, target->options, stretch);
  /* a map that makes a point of it: any chords do */
  if (!tp_divide(tolerance, tolerance, stretch)) fmpq_one(tolerance);
  const tp_curve_outcome outcome = tp_curve_flatten(unit, tolerance);
  if (outcome == TP_CURVE_TOO_FINE) {
    object->problem = TP_CURVE_TOO_FINE_TEXT;
  }
  tp_affine_map_object(unit, &map);
  bool done = outcome != TP_CURVE_NO_MEMORY;
  for (long k = 1; k + 1 < unit->line.count && done; k++) {
    done = tp_drawing_add_point(object, unit->line.x + k, unit->line.y + k, target->mark);
  }
  tp_affine_map_stretch(stretch, &map);
  fmpq_mul(tolerance, tolerance, stretch);
  tp_curve_deviates(object, tolerance);
  done = done && tp_drawing_add_point(object, arc->x, arc->y, target->mark);
  tp_affine_map_clear(&map);
  tp_affine_map_clear(&whole);
  fmpq_clear(stretch);
  fmpq_clear(tolerance);
  return done;
}

static bool add_elliptical(tp_svg_target *target, tp_drawing_object *object,
                           const tp_svg_arc *arc) {
  const long last = object->line.count - 1;
  tp_drawing own;
  tp_drawing_init(&own, target->drawing->path);
  tp_drawing_object *unit = tp_drawing_add(&own, "", NULL, NULL, target->mark);
  fmpq_t px, py, qx, qy, bulge;
  fmpq_init(px);
  fmpq_init(py);
  fmpq_init(qx);
  fmpq_init(qy);
  fmpq_init(bulge);
  fmpq_set(px, object->line.x + last);
  fmpq_set(py, object->line.y + last);
  fmpq_set(qx, arc->x);
  fmpq_set(qy, arc->y);
  to_unit(px, py, arc);
  to_unit(qx, qy, arc);
  set_half_square(bulge, px, py, qx, qy);
  set_bulge(bulge, bulge, arc);
  bool done = unit != NULL && tp_drawing_add_point(unit, px, py, target->mark) &&
              (fmpq_is_zero(bulge) || tp_drawing_bend(unit, bulge)) &&
              tp_drawing_add_point(unit, qx, qy, target->mark);
  done = done && add_chords(target, object, unit, arc);
  tp_drawing_clear(&own);
  fmpq_clear(px);
  fmpq_clear(py);
  fmpq_clear(qx);
  fmpq_clear(qy);
  fmpq_clear(bulge);
  return done;
}

bool tp_svg_add_arc(tp_svg_target *target, tp_drawing_object *object, tp_svg_arc *arc) {
  const long last = object->line.count - 1;
  fmpq_abs(arc->rx, arc->rx);
  fmpq_abs(arc->ry, arc->ry);
  const bool stays =
      fmpq_equal(object->line.x + last, arc->x) && fmpq_equal(object->line.y + last, arc->y);
  bool done = true;
  if (fmpq_is_zero(arc->rx) || fmpq_is_zero(arc->ry)) {
    done = tp_drawing_add_point(object, arc->x, arc->y, target->mark);
  } else if (!stays) {
    done = fmpq_equal(arc->rx, arc->ry) ? add_circular(target, object, arc)
                                        : add_elliptical(target, object, arc);
  }
  if (!done) target->no_memory = true;
  return done;
}
