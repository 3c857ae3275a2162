/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rounds the points of an assemblage, which is built again: a result holds no geometry. */

#include "shape/block_shapes.h"

#include "block_system/built_system.h"
#include "common/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What points are told from, and by which unit. */
typedef struct frame {
  const tp_assemblage *a;
  long origin; /* a point of the lattice */
  double unit_m;
} frame;

static double units(const frame *f, const fmpz_t from, const fmpz_t to) {
  fmpz_t steps;
  fmpq_t metres;
  fmpz_init(steps);
  fmpq_init(metres);
  fmpz_sub(steps, to, from);
  fmpq_mul_fmpz(metres, f->a->lattice.step_m, steps);
  const double value = tp_shape_nearest(metres) / f->unit_m;
  fmpz_clear(steps);
  fmpq_clear(metres);
  return value;
}

static tp_spot spot_of(const frame *f, const fmpz_t x, const fmpz_t y) {
  const tp_lattice *l = &f->a->lattice;
  return (tp_spot){units(f, l->x + f->origin, x), units(f, l->y + f->origin, y)};
}

static tp_spot spot_at(const frame *f, long point) {
  const tp_lattice *l = &f->a->lattice;
  return spot_of(f, l->x + point, l->y + point);
}

/* ---- the size of all ---------------------------------------------------------------------------
 */

static void include(tp_box *box, tp_spot p) {
  *box = (tp_box){fmin(box->x0, p.x), fmin(box->y0, p.y), fmax(box->x1, p.x), fmax(box->y1, p.y)};
}

static void measure(tp_block_shapes *shapes, frame *f) {
  const tp_assemblage *a = f->a;
  for (long k = a->count - 1; k >= 0; k--) {
    if (a->blocks[k].number >= 0) f->origin = a->blocks[k].outline;
  }
  f->unit_m = 1;
  for (long k = 0; k < a->count; k++) {
    const tp_rigid_block *b = a->blocks + k;
    for (long p = b->outline; p < b->end && b->number >= 0; p++) {
      include(&shapes->box, spot_at(f, p));
    }
  }
  const tp_box *box = &shapes->box;
  f->unit_m = fmax(box->x1 - box->x0, box->y1 - box->y0);
  shapes->unit_m = f->unit_m;
  shapes->box =
      (tp_box){box->x0 / f->unit_m, box->y0 / f->unit_m, box->x1 / f->unit_m, box->y1 / f->unit_m};
  fmpq_t metres;
  fmpq_init(metres);
  tp_lattice_metres_x(metres, &a->lattice, a->lattice.x + f->origin);
  shapes->origin_m.x = tp_shape_nearest(metres);
  tp_lattice_metres_y(metres, &a->lattice, a->lattice.y + f->origin);
  shapes->origin_m.y = tp_shape_nearest(metres);
  fmpq_clear(metres);
}

/* ---- blocks and contacts -----------------------------------------------------------------------
 */

/* All rings of a block lie in the lattice one behind the other. */
static bool add_block(tp_block_shape *own, const frame *f, const tp_section *section, long first) {
  const tp_lattice *l = &f->a->lattice;
  bool done = true;
  own->outline.closed = own->parts.closed = true;
  for (long r = 0; r < section->ring_count && done; r++) {
    tp_chain *chain = r <= section->hole_count ? &own->outline : &own->parts;
    for (long p = l->start[first + r]; p < l->start[first + r + 1] && done; p++) {
      done = tp_chain_add(chain, p == l->start[first + r] ? TP_STEP_JUMP : TP_STEP_LINE,
                          spot_at(f, p));
    }
  }
  return done;
}

static tp_spot centroid_of(const frame *f, const tp_rigid_block *b) {
  const tp_assemblage *a = f->a;
  const double length = ldexp(tp_shape_nearest(a->lattice.step_m), (int)a->length_exponent);
  const tp_spot near = spot_of(f, b->x, b->y);
  return (tp_spot){near.x + b->arm_x.value * length / f->unit_m,
                   near.y + b->arm_y.value * length / f->unit_m};
}

static tp_contact_line contact_of(const frame *f, const tp_block_contact *c) {
  const tp_spot from = spot_at(f, c->from), to = spot_at(f, c->to);
  const double length = hypot(to.x - from.x, to.y - from.y);
  return (tp_contact_line){{spot_at(f, c->ends[0]), spot_at(f, c->ends[1])},
                           {(to.x - from.x) / length, (to.y - from.y) / length}};
}

static bool fill(tp_block_shapes *shapes, const tp_built_system *s) {
  const tp_assemblage *a = &s->assemblage;
  frame f = {.a = a};
  measure(shapes, &f);
  shapes->blocks = calloc((size_t)a->count, sizeof *shapes->blocks);
  shapes->contacts = calloc((size_t)a->contact_count + 1, sizeof *shapes->contacts);
  bool done = shapes->blocks != NULL && shapes->contacts != NULL;
  long ring = 0;
  for (long k = 0; k < a->count && done; k++) {
    done = add_block(shapes->blocks + k, &f, s->sections + k, ring);
    shapes->blocks[k].centroid = centroid_of(&f, a->blocks + k);
    shapes->count++;
    ring += s->sections[k].ring_count;
  }
  for (long k = 0; k < a->contact_count && done; k++) {
    shapes->contacts[k] = contact_of(&f, a->contacts + k);
    shapes->contact_count++;
  }
  return done;
}

tp_status tp_block_shapes_init(tp_block_shapes *shapes, const tp_scene *scene,
                               const tp_block_system *system, tp_message *message) {
  tp_built_system built;
  memset(shapes, 0, sizeof *shapes);
  if (tp_scene_block_count(scene) != system->block_count || system->case_count == 0) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "the result is not of this scene: solve the scene, and draw that");
  }
  const tp_status status = tp_built_system_init(&built, scene, message);
  if (status != TP_OK) return status;
  const bool done = fill(shapes, &built);
  tp_built_system_clear(&built);
  if (done && shapes->contact_count == system->contact_count) return TP_OK;
  tp_block_shapes_clear(shapes);
  return !done ? tp_fail_memory(message, "the figure")
               : tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                           "the scene has changed since it was solved: solve it again");
}

void tp_block_shapes_clear(tp_block_shapes *shapes) {
  for (size_t k = 0; k < shapes->count; k++) {
    tp_chain_clear(&shapes->blocks[k].outline);
    tp_chain_clear(&shapes->blocks[k].parts);
  }
  free(shapes->blocks);
  free(shapes->contacts);
  memset(shapes, 0, sizeof *shapes);
}

tp_spot tp_block_shapes_force(const tp_block_shapes *shapes, size_t contact, double x_m,
                              double y_m) {
  const tp_spot *ends = shapes->contacts[contact].ends;
  const tp_spot way = {ends[1].x - ends[0].x, ends[1].y - ends[0].y};
  const double square = way.x * way.x + way.y * way.y;
  if (!(square > 0)) return ends[0];
  const double x = (x_m - shapes->origin_m.x) / shapes->unit_m - ends[0].x;
  const double y = (y_m - shapes->origin_m.y) / shapes->unit_m - ends[0].y;
  /* on the contact, also where numbers far from the origin have few digits */
  const double share = fmin(fmax((x * way.x + y * way.y) / square, 0), 1);
  return (tp_spot){ends[0].x + share * way.x, ends[0].y + share * way.y};
}
