/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Nearest point of the outline in rationals for each load point off the face; both ends of a
 * pressure go to one edge where one is near both. */

#include "problem/on_face.h"

#include "block/section.h"
#include "common/notes.h"
#include "load/check.h"
#include "scene/moved.h"

#include <math.h>
#include <stdlib.h>

enum { SHARE = 1000000 }; /* of the block's size */

typedef struct face {
  const tp_polyline *ring;
  fmpq_t square; /* of the distance within which a point is put on it */
} face;

/* The nearest point of the edge from vertex k on, and the square of its distance. */
static void nearest_on(fmpq_t x, fmpq_t y, fmpq_t square, const face *f, long k, const fmpq *px,
                       const fmpq *py) {
  const tp_polyline *r = f->ring;
  const long n = k + 1 == r->count ? 0 : k + 1;
  fmpq_t along, up, share, work;
  fmpq *const own[] = {along, up, share, work};
  for (int i = 0; i < 4; i++) fmpq_init(own[i]);
  fmpq_sub(along, r->x + n, r->x + k);
  fmpq_sub(up, r->y + n, r->y + k);
  fmpq_sub(work, px, r->x + k);
  fmpq_mul(share, work, along);
  fmpq_sub(work, py, r->y + k);
  fmpq_addmul(share, work, up);
  fmpq_mul(work, along, along);
  fmpq_addmul(work, up, up);
  if (!fmpq_is_zero(work)) fmpq_div(share, share, work);
  if (fmpq_sgn(share) < 0) fmpq_zero(share);
  if (fmpq_cmp_si(share, 1) > 0) fmpq_one(share);
  fmpq_set(x, r->x + k);
  fmpq_addmul(x, share, along);
  fmpq_set(y, r->y + k);
  fmpq_addmul(y, share, up);
  fmpq_sub(work, x, px);
  fmpq_mul(square, work, work);
  fmpq_sub(work, y, py);
  fmpq_addmul(square, work, work);
  for (int i = 0; i < 4; i++) fmpq_clear(own[i]);
}

/* Put a point on the nearest edge within reach, or on the one that is given. What it was moved by,
 * squared, is the largest so far. */
static bool put(tp_quantity *x, tp_quantity *y, const face *f, long edge, fmpq_t moved) {
  fmpq_t near_x, near_y, square, best_x, best_y, best;
  fmpq *const own[] = {near_x, near_y, square, best_x, best_y, best};
  for (int i = 0; i < 6; i++) fmpq_init(own[i]);
  bool found = false;
  for (long k = edge < 0 ? 0 : edge; k < (edge < 0 ? f->ring->count : edge + 1); k++) {
    nearest_on(near_x, near_y, square, f, k, x->value, y->value);
    if (fmpq_cmp(square, f->square) > 0 || (found && fmpq_cmp(square, best) >= 0)) continue;
    found = true;
    fmpq_set(best, square);
    fmpq_set(best_x, near_x);
    fmpq_set(best_y, near_y);
  }
  if (found) {
    fmpq_set(x->value, best_x);
    fmpq_set(y->value, best_y);
    if (fmpq_cmp(best, moved) > 0) fmpq_set(moved, best);
  }
  for (int i = 0; i < 6; i++) fmpq_clear(own[i]);
  return found;
}

static bool is_near(const face *f, long k, const tp_quantity *x, const tp_quantity *y) {
  fmpq_t near_x, near_y, square;
  fmpq_init(near_x);
  fmpq_init(near_y);
  fmpq_init(square);
  nearest_on(near_x, near_y, square, f, k, x->value, y->value);
  const bool near = fmpq_cmp(square, f->square) <= 0;
  fmpq_clear(near_x);
  fmpq_clear(near_y);
  fmpq_clear(square);
  return near;
}

/* Both ends on one edge where one is near both, else each on its own. */
static void put_line(tp_line_load *load, const face *f, fmpq_t moved) {
  long edge = -1;
  for (long k = 0; k < f->ring->count; k++) {
    if (tp_loads_on_edge(f->ring, k, load->x0.value, load->y0.value) &&
        tp_loads_on_edge(f->ring, k, load->x1.value, load->y1.value)) {
      return;
    }
    if (edge < 0 && is_near(f, k, &load->x0, &load->y0) && is_near(f, k, &load->x1, &load->y1)) {
      edge = k;
    }
  }
  (void)put(&load->x0, &load->y0, f, edge, moved);
  (void)put(&load->x1, &load->y1, f, edge, moved);
}

static void put_anchor(tp_anchor_description *anchor, const face *f, fmpq_t moved) {
  if (tp_loads_in_outline(f->ring, anchor->x.value, anchor->y.value)) return;
  (void)put(&anchor->x, &anchor->y, f, -1, moved);
}

static tp_status note(tp_notes *notes, const tp_scene *scene, tp_place place, const char *what,
                      const fmpq_t moved, bool *any, tp_message *message) {
  if (fmpq_is_zero(moved)) return TP_OK;
  *any = true;
  return tp_notes_add(notes, message, TP_NOTE, place,
                      "this %s acts %.2g %s beside the block's face, less than a millionth of the "
                      "block's size: it is moved onto it",
                      what, sqrt(fmpq_get_d(moved)), scene->length_unit);
}

static tp_status put_lines(tp_line_load *loads, long count, const char *what, const face *f,
                           const tp_scene *scene, tp_notes *notes, bool *any, tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    fmpq_t moved;
    fmpq_init(moved);
    put_line(loads + k, f, moved);
    status = note(notes, scene, loads[k].place, what, moved, any, message);
    fmpq_clear(moved);
  }
  return status;
}

static tp_status put_all(tp_on_face *own, const face *f, tp_notes *notes, bool *any,
                         tp_message *message) {
  const tp_scene *scene = &own->scene;
  tp_loads_description *loads = &own->scene.loads;
  tp_status status =
      put_lines(loads->pressures, loads->pressure_count, "pressure", f, scene, notes, any, message);
  if (status == TP_OK) {
    status = put_lines(loads->surcharges, loads->surcharge_count, "surcharge", f, scene, notes, any,
                       message);
  }
  if (status == TP_OK) {
    status = put_lines(loads->supports, loads->support_count, "support pressure", f, scene, notes,
                       any, message);
  }
  for (long k = 0; k < loads->anchor_count && status == TP_OK; k++) {
    fmpq_t moved;
    fmpq_init(moved);
    put_anchor(loads->anchors + k, f, moved);
    status = note(notes, scene, loads->anchors[k].place, "anchor", moved, any, message);
    fmpq_clear(moved);
  }
  return status;
}

/* The square of the share of the greater side of its box. */
static void set_reach(face *f) {
  fmpq_t other;
  fmpq_init(other);
  tp_polyline_size(f->square, other, f->ring);
  if (fmpq_cmp(other, f->square) > 0) fmpq_swap(other, f->square);
  fmpq_set_si(other, 1, SHARE);
  fmpq_mul(f->square, f->square, other);
  fmpq_mul(f->square, f->square, f->square);
  fmpq_clear(other);
}

static tp_status put_on(tp_on_face **own, const tp_scene *scene, const tp_polyline *ring,
                        tp_notes *notes, tp_message *message) {
  const tp_point_map stay = {NULL, NULL};
  tp_on_face *made = calloc(1, sizeof *made);
  if (made == NULL) return tp_fail_memory(message, "the loads");
  made->scene = *scene;
  made->scene.loads.pressures = made->scene.loads.surcharges = NULL;
  made->scene.loads.supports = NULL;
  made->scene.loads.anchors = NULL;
  face f = {.ring = ring};
  fmpq_t none;
  fmpq_init(none);
  fmpq_init(f.square);
  set_reach(&f);
  bool any = false;
  tp_status status = tp_moved_loads(&made->scene, scene, none, &stay)
                         ? put_all(made, &f, notes, &any, message)
                         : tp_fail_memory(message, "the loads");
  fmpq_clear(none);
  fmpq_clear(f.square);
  if (status == TP_OK && any) {
    *own = made;
  } else {
    tp_on_face_free(made);
  }
  return status;
}

tp_status tp_on_face_init(tp_on_face **own, const tp_scene *scene, tp_notes *notes,
                          tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  if (loads->pressure_count + loads->surcharge_count + loads->support_count + loads->anchor_count ==
      0) {
    return TP_OK;
  }
  if (scene->block.form == TP_OUTLINE_VERTICES) {
    return put_on(own, scene, &scene->block.outline, notes, message);
  }
  tp_section section;
  tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  status = put_on(own, scene, section.rings, notes, message);
  tp_section_clear(&section);
  return status;
}

void tp_on_face_free(tp_on_face *own) {
  if (own == NULL) return;
  tp_moved_clear_loads(&own->scene);
  free(own);
}
