/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ways of rough blocks of growing size. The sums are measured on bare coordinates, without the
 * scene and the checks of a block: ten million vertices would not fit in memory with them. */

#include "accuracy/rough_outline.h"
#include "accuracy/ways.h"
#include "common/host.h"
#include "common/message.h"

#include <stdlib.h>

/* Beyond these a way by triangles or by the limit takes minutes, and is left out. */
enum { MOST_TRIANGLES = 1000000, MOST_FACETS = 100000 };

static bool allocate(tp_lattice *l, size_t count) {
  l->start = calloc(2, sizeof *l->start);
  l->x = calloc(count, sizeof *l->x);
  l->y = calloc(count, sizeof *l->y);
  l->u = calloc(count, sizeof *l->u);
  l->v = calloc(count, sizeof *l->v);
  return l->start != NULL && l->x != NULL && l->y != NULL && l->u != NULL && l->v != NULL;
}

/* About the middle, as the lattice of a scene. */
static void fill(tp_lattice *l, long count) {
  tp_rough_outline(l->u, l->v, count);
  const double middle_x = (double)(long)(l->u[count - 2] / 2);
  const double middle_y = (double)(long)(l->v[count - 2] / 2);
  for (long k = 0; k < count; k++) {
    l->u[k] -= middle_x;
    l->v[k] -= middle_y;
    fmpz_set_si(l->x + k, (long)l->u[k]);
    fmpz_set_si(l->y + k, (long)l->v[k]);
  }
  fmpz_set_si(l->origin_x, (long)middle_x);
  fmpz_set_si(l->origin_y, (long)middle_y);
  l->chain_count = 1;
  l->start[1] = l->count = count;
  l->bits = 1 + (long)(fmpz_bits(l->x) > fmpz_bits(l->y) ? fmpz_bits(l->x) : fmpz_bits(l->y));
}

static bool bare_init(tp_accuracy_subject *s, long count) {
  *s = (tp_accuracy_subject){.towards = TP_TOWARDS_LEFT, .has_pivot = true};
  tp_section *section = &s->problem.section;
  tp_lattice *lattice = &s->problem.lattice;
  fmpz_init(lattice->origin_x);
  fmpz_init(lattice->origin_y);
  fmpq_init(lattice->step_m);
  fmpq_one(lattice->step_m);
  fmpq_init(s->scene.metres_per_unit);
  fmpq_one(s->scene.metres_per_unit);
  fmpq_init(section->weight_unit);
  fmpq_one(section->weight_unit);
  section->ring_weights = calloc(1, sizeof *section->ring_weights);
  section->density_weights = calloc(1, sizeof *section->density_weights);
  if (section->ring_weights == NULL || section->density_weights == NULL ||
      !allocate(lattice, (size_t)count)) {
    return false;
  }
  tp_contact *contact = &s->problem.contact; /* the pivot alone */
  contact->points = calloc(1, sizeof *contact->points);
  if (contact->points == NULL) return false;
  contact->point_count = 1;
  section->ring_count = 1;
  fmpz_one(section->ring_weights);
  fmpz_one(section->density_weights);
  fill(lattice, count);
  return true;
}

static void bare_clear(tp_accuracy_subject *s) {
  tp_contact_clear(&s->problem.contact);
  tp_section_clear(&s->problem.section);
  tp_lattice_clear(&s->problem.lattice);
  fmpq_clear(s->scene.metres_per_unit);
}

static tp_status add_sums(tp_accuracy *accuracy, size_t count) {
  tp_accuracy_subject s;
  tp_status status = bare_init(&s, (long)count) ? TP_OK : TP_OUT_OF_MEMORY;
  tp_accuracy_way way = {TP_ACCURACY_BOUNDARY,
                         tp_accuracy_by_boundary,
                         &s,
                         TP_LEVEL_EXACT,
                         count,
                         tp_accuracy_prices_of(TP_ACCURACY_BOUNDARY, true)};
  if (status == TP_OK) status = tp_accuracy_measure(accuracy, &way);
  if (status == TP_OK && count <= MOST_TRIANGLES) {
    way.method = TP_ACCURACY_TRIANGLES;
    way.prices = tp_accuracy_prices_of(TP_ACCURACY_TRIANGLES, true);
    way.evaluate = tp_accuracy_by_triangles;
    status = tp_accuracy_measure(accuracy, &way);
  }
  bare_clear(&s);
  return status;
}

static tp_status fill_scene(tp_scene *scene, const double *xy, size_t count, tp_message *message) {
  tp_status status = tp_scene_set_outline(scene, tp_coordinates_of(xy, count), message);
  if (status == TP_OK) status = tp_scene_set_base_mated(scene, false, message);
  if (status == TP_OK) status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(30), message);
  if (status == TP_OK) status = tp_scene_set_tilt_towards(scene, true, false, message);
  return status;
}

/* The same block as a scene on a mated base, for the limit. */
static tp_status new_scene(tp_scene **scene, size_t count, tp_message *message) {
  double *x = calloc(count, sizeof *x), *y = calloc(count, sizeof *y);
  double *xy = calloc(count, 2 * sizeof *xy);
  tp_scene *own = NULL;
  tp_status status = TP_OUT_OF_MEMORY;
  if (x != NULL && y != NULL && xy != NULL) {
    tp_rough_outline(x, y, (long)count);
    for (size_t k = 0; k < count; k++) {
      xy[2 * k] = x[k];
      xy[2 * k + 1] = y[k];
    }
    status = tp_scene_new(&own, "mm", message);
    if (status == TP_OK) status = fill_scene(own, xy, count, message);
  }
  free(x);
  free(y);
  free(xy);
  if (status == TP_OK) {
    *scene = own;
  } else {
    tp_scene_free(own);
  }
  return status;
}

static tp_status add_limit(tp_accuracy *accuracy, size_t count, tp_message *message) {
  tp_scene *scene = NULL;
  tp_status status = new_scene(&scene, count, message);
  if (status == TP_OK) {
    status = tp_accuracy_add_scene(
        accuracy, scene, 1U << TP_ACCURACY_LIMIT | 1U << TP_ACCURACY_ONSET, true, message);
  }
  tp_scene_free(scene);
  return status;
}

tp_status tp_accuracy_sweep(tp_accuracy **accuracy, size_t least, size_t most,
                            tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, accuracy);
  enum { LEAST = 10, MOST = 10000000 };
  if (least < LEAST || most > MOST || least > most) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "a sweep goes from 10 vertices at the least to 10000000 at the most");
  }
  tp_accuracy *own = tp_accuracy_new();
  tp_status status = own != NULL ? TP_OK : TP_OUT_OF_MEMORY;
  if (own != NULL) own->sweep = true;
  for (size_t count = least; count <= most && status == TP_OK; count *= 10) {
    status = add_sums(own, count);
    if (status == TP_OK && count <= MOST_FACETS) status = add_limit(own, count, message);
  }
  if (status == TP_OK) {
    *accuracy = own;
    return TP_OK;
  }
  tp_accuracy_free(own);
  return status == TP_OUT_OF_MEMORY ? tp_fail_memory(message, "the sweep") : status;
}
