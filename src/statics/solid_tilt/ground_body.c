/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Meshes joined, the ground's in lengths of the rock's; a ground looks down where the sum of its
 * triangles' normals, by area, does. */

#include "solid_tilt/ground_body.h"

#include "solid/gate.h"

#include <stdlib.h>

/* Lengths that are roots of rationals are known to 2^-200 of themselves, which coordinates would
 * have to bear: their quotient is taken to 2^-64 of itself. */
static void round_factor(fmpq_t factor) {
  enum { BITS = 64, LEAST = 128 };
  const slong top = (slong)fmpz_bits(fmpq_numref(factor));
  const slong bottom = (slong)fmpz_bits(fmpq_denref(factor)), shift = BITS + bottom - top;
  if (top <= LEAST && bottom <= LEAST) return;
  fmpz_t whole;
  fmpz_init(whole);
  if (shift >= 0) fmpq_mul_2exp(factor, factor, (ulong)shift);
  if (shift < 0) fmpq_div_2exp(factor, factor, (ulong)-shift);
  fmpz_fdiv_q(whole, fmpq_numref(factor), fmpq_denref(factor));
  fmpq_set_fmpz(factor, whole);
  if (shift >= 0) fmpq_div_2exp(factor, factor, (ulong)shift);
  if (shift < 0) fmpq_mul_2exp(factor, factor, (ulong)-shift);
  fmpz_clear(whole);
}

static tp_status join(tp_ground_body *own, const tp_mesh *rock, long object,
                      const tp_solid_description *solid, tp_message *message) {
  const tp_ground_description *ground = &solid->ground;
  own->joined.file = ground->mesh->file;
  fmpq_t factor;
  fmpq_init(factor);
  fmpq_div(factor, ground->metres_per_unit, solid->metres_per_unit);
  round_factor(factor);
  tp_status status = tp_mesh_join(&own->joined, rock, object, message);
  if (status == TP_OK) {
    status = tp_mesh_join_scaled(&own->joined, ground->mesh, ground->object, factor, message);
  }
  fmpq_clear(factor);
  return status;
}

/* The sign of (sum of normals) . up. */
static int way_up(const tp_relief *r, const fmpq up[3]) {
  tp_whole own, sum;
  fmpq_t part, height;
  tp_whole_init(&own);
  tp_whole_init(&sum);
  fmpq_init(part);
  fmpq_init(height);
  for (long t = 0; t < r->surface.triangle_count; t++) {
    tp_relief_normal(&own, r, t);
    for (int k = 0; k < 3; k++) fmpz_add(sum.at + k, sum.at + k, own.at + k);
  }
  for (int k = 0; k < 3; k++) {
    fmpq_mul_fmpz(part, up + k, sum.at + k);
    fmpq_add(height, height, part);
  }
  const int sign = fmpq_sgn(height);
  tp_whole_clear(&own);
  tp_whole_clear(&sum);
  fmpq_clear(part);
  fmpq_clear(height);
  return sign;
}

static tp_status check(const tp_ground_body *own, const tp_solid_description *solid,
                       tp_message *message) {
  return way_up(&own->ground, solid->up) >= 0
             ? TP_OK
             : tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){own->joined.file, 0, 0},
                         "the ground is upside down: most of its triangles run clockwise seen from "
                         "above, so that it would lie over the rock; flip its faces, or say which "
                         "way is up by 'up'");
}

static tp_status make(tp_ground_body *own, const tp_mesh *rock, long object,
                      const tp_solid_description *solid, tp_message *message) {
  tp_status status = join(own, rock, object, solid, message);
  if (status == TP_OK) status = tp_surface_init(&own->whole, &own->joined, -1, message);
  if (status != TP_OK) return status;
  const tp_surface surfaces[2] = {tp_surface_of_object(&own->whole, 0),
                                  tp_surface_of_object(&own->whole, 1)};
  if (surfaces[1].triangle_count == 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){own->joined.file, 0, 0},
                     "there is no face in this mesh of the ground");
  }
  status = tp_gate_ground(surfaces + 1, message);
  if (status == TP_OK &&
      !(tp_relief_init(&own->rock, surfaces) && tp_relief_init(&own->ground, surfaces + 1))) {
    status = tp_fail_memory(message, "a ground");
  }
  return status == TP_OK ? check(own, solid, message) : status;
}

tp_status tp_ground_body_make(tp_ground_body **body, const tp_mesh *rock, long object,
                              const tp_solid_description *solid, tp_message *message) {
  tp_ground_body *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a ground");
  const tp_status status = make(own, rock, object, solid, message);
  if (status == TP_OK) {
    *body = own;
  } else {
    tp_ground_body_free(own);
  }
  return status;
}

void tp_ground_body_free(tp_ground_body *own) {
  if (own == NULL) return;
  tp_relief_clear(&own->rock);
  tp_relief_clear(&own->ground);
  tp_surface_clear(&own->whole);
  tp_mesh_clear(&own->joined);
  free(own);
}
