/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact points of a problem, turned to how they lie with the cosine and sine of problem/world.h
 * (off by a share of 1e-76) and rounded once to doubles: a section in the frame of the world is
 * given back as its decimals were. Points of the shape are rounded before. */

#include "figure/dxf.h"

#include "number/ratio.h"

tp_spot tp_cad_of_scene(const tp_cad *d, const fmpq_t x, const fmpq_t y) {
  fmpq_t to_x, to_y;
  fmpq_init(to_x);
  fmpq_init(to_y);
  fmpq_set(to_x, x);
  fmpq_set(to_y, y);
  if (d->turned) tp_turn_point(to_x, to_y, &d->lie);
  const tp_spot spot = {tp_shape_nearest(to_x), tp_shape_nearest(to_y)};
  fmpq_clear(to_x);
  fmpq_clear(to_y);
  return spot;
}

tp_spot tp_cad_of_point(const tp_cad *d, long point) {
  const tp_lattice *l = &d->figure->problem->lattice;
  const fmpq *unit = d->figure->problem->scene->metres_per_unit;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_lattice_metres_x(x, l, l->x + point);
  tp_lattice_metres_y(y, l, l->y + point);
  fmpq_div(x, x, unit);
  fmpq_div(y, y, unit);
  const tp_spot spot = tp_cad_of_scene(d, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
  return spot;
}

double tp_cad_unit(const tp_cad *d) {
  return d->figure->shape.unit_m / fmpq_get_d(d->figure->problem->scene->metres_per_unit);
}

/* A share of the shape's unit from the lattice's origin, in scene lengths. */
static void from_origin(fmpq_t length, const tp_cad *d, double share, const fmpz_t origin) {
  const tp_problem *problem = d->figure->problem;
  fmpq_t start;
  fmpq_init(start);
  if (!tp_ratio_read_double(length, share * d->figure->shape.unit_m)) fmpq_zero(length);
  fmpq_mul_fmpz(start, problem->lattice.step_m, origin);
  fmpq_add(length, length, start);
  fmpq_div(length, length, problem->scene->metres_per_unit);
  fmpq_clear(start);
}

tp_spot tp_cad_of_spot(const tp_cad *d, tp_spot spot) {
  const tp_lattice *l = &d->figure->problem->lattice;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  from_origin(x, d, spot.x, l->origin_x);
  from_origin(y, d, spot.y, l->origin_y);
  const tp_spot at = tp_cad_of_scene(d, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
  return at;
}
