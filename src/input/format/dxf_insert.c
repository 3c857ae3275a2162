/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks of a DXF file, and what inserts make of them.
 *
 * A point p of a block with base point b is put at c + T (R (S (p - b) + (i, j) steps)) for an
 * insert at c with scales S, in row j and column i, turned by R; mirrored afterwards where it is
 * extruded along -z. Cosine and sine of what is no quarter of a turn are decimals within 1e-18. An
 * object on layer 0 of a block is on the layer of the insert. */

#include "common/grow.h"
#include "format/drawing_work.h"
#include "format/dxf_shown.h"
#include "format/dxf_use.h"
#include "number/divide.h"

#include <stdlib.h>
#include <string.h>

enum { X = 10, Y = 20, NAME = 2, LAYER = 8 };

bool tp_dxf_block_begin(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  if (!tp_dxf_block_end(r)) return false; /* one that has no end */
  tp_dxf_block *blocks = tp_grow(r->blocks, r->block_count, &r->block_room, sizeof *blocks);
  if (blocks == NULL) return tp_dxf_fail_memory(r);
  r->blocks = blocks;
  tp_dxf_block *block = blocks + r->block_count++;
  const tp_dxf_group *name = tp_dxf_find(entity, NAME);
  *block = (tp_dxf_block){.name = name != NULL ? *name : entity->groups[0],
                          .first_object = r->parts.count,
                          .first_insert = r->insert_count};
  fmpq_init(block->x);
  fmpq_init(block->y);
  r->in_block = true;
  return tp_dxf_real(r, block->x, entity, X, 0) && tp_dxf_real(r, block->y, entity, Y, 0);
}

bool tp_dxf_block_end(tp_dxf_reader *r) {
  if (!tp_dxf_sequence_end(r) || !r->in_block) return r->status == TP_OK;
  tp_dxf_block *block = r->blocks + r->block_count - 1;
  block->objects = r->parts.count - block->first_object;
  block->inserts = r->insert_count - block->first_insert;
  r->in_block = false;
  return true;
}

/* ---- inserts -----------------------------------------------------------------------------------
 */

static void insert_init(tp_dxf_insert *insert) {
  fmpq_init(insert->x);
  fmpq_init(insert->y);
  fmpq_init(insert->scale_x);
  fmpq_init(insert->scale_y);
  fmpq_init(insert->degrees);
  fmpq_init(insert->column_step);
  fmpq_init(insert->row_step);
}

static bool read_insert(tp_dxf_reader *r, tp_dxf_insert *insert, const tp_dxf_entity *entity) {
  enum {
    SCALE_X = 41,
    SCALE_Y = 42,
    COLUMN_STEP = 44,
    ROW_STEP = 45,
    DEGREES = 50,
    COLUMNS = 70,
    ROWS = 71,
    MOST = 10000
  };
  int side = 1;
  if (!tp_dxf_real(r, insert->x, entity, X, 0) || !tp_dxf_real(r, insert->y, entity, Y, 0) ||
      !tp_dxf_real(r, insert->scale_x, entity, SCALE_X, 1) ||
      !tp_dxf_real(r, insert->scale_y, entity, SCALE_Y, 1) ||
      !tp_dxf_real(r, insert->degrees, entity, DEGREES, 0) ||
      !tp_dxf_real(r, insert->column_step, entity, COLUMN_STEP, 0) ||
      !tp_dxf_real(r, insert->row_step, entity, ROW_STEP, 0) ||
      !tp_dxf_whole(r, &insert->columns, entity, COLUMNS, 1) ||
      !tp_dxf_whole(r, &insert->rows, entity, ROWS, 1) || !tp_dxf_extrusion(r, &side, entity)) {
    return false;
  }
  insert->mirrored = side < 0;
  if (side == 0)
    insert->problem = "is inserted into another plane than the drawing's (its extrusion); draw the "
                      "section in the plane of x and y";
  if (insert->columns > MOST || insert->rows > MOST) {
    return tp_dxf_fail(r, entity->groups, "at most 10000 rows or columns of a block are taken");
  }
  if (fmpq_is_zero(insert->scale_x) || fmpq_is_zero(insert->scale_y)) {
    return tp_dxf_fail(r, entity->groups, "the scale of a block must not be zero");
  }
  return true;
}

bool tp_dxf_insert_add(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  const tp_dxf_group *name = tp_dxf_find(entity, NAME), *layer = tp_dxf_find(entity, LAYER);
  static const tp_dxf_group zero = {.text = "0", .length = 1};
  if (name == NULL) return tp_dxf_fail(r, entity->groups, "an INSERT names no block (group 2)");
  tp_dxf_insert *inserts = tp_grow(r->inserts, r->insert_count, &r->insert_room, sizeof *inserts);
  if (inserts == NULL) return tp_dxf_fail_memory(r);
  r->inserts = inserts;
  tp_dxf_insert *insert = inserts + r->insert_count++;
  *insert = (tp_dxf_insert){.block = *name, .layer = layer != NULL ? *layer : zero};
  insert_init(insert);
  return read_insert(r, insert, entity);
}

/* ---- what they make ----------------------------------------------------------------------------
 */

static void turn(tp_affine_map *map, const fmpq_t degrees) {
  enum { BITS = 192, HALF = 180 };
  arb_t s, c;
  fmpq_t sine, cosine, share;
  arb_init(s);
  arb_init(c);
  fmpq_init(sine);
  fmpq_init(cosine);
  fmpq_init(share);
  fmpq_set_si(share, 1, HALF);
  fmpq_mul(share, share, degrees);
  arb_sin_cos_pi_fmpq(s, c, share, BITS);
  tp_curve_decimal(sine, s);
  tp_curve_decimal(cosine, c);
  tp_affine_map_turn(map, cosine, sine);
  arb_clear(s);
  arb_clear(c);
  fmpq_clear(sine);
  fmpq_clear(cosine);
  fmpq_clear(share);
}

/* `map` becomes what puts points of the block where they are outside. */
static void put(tp_affine_map *map, const tp_dxf_insert *insert, const tp_dxf_block *block,
                long column, long row) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  if (insert->mirrored) {
    fmpq_set_si(x, -1, 1);
    fmpq_one(y);
    tp_affine_map_scale(map, x, y);
  }
  tp_affine_map_shift(map, insert->x, insert->y);
  turn(map, insert->degrees);
  fmpq_mul_si(x, insert->column_step, column);
  fmpq_mul_si(y, insert->row_step, row);
  tp_affine_map_shift(map, x, y);
  tp_affine_map_scale(map, insert->scale_x, insert->scale_y);
  fmpq_neg(x, block->x);
  fmpq_neg(y, block->y);
  tp_affine_map_shift(map, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
}

/* Arcs that the map does not keep become chords first. */
static bool flatten(tp_dxf_reader *r, tp_drawing_object *object, const tp_affine_map *map) {
  if (tp_affine_map_keeps_circles(map) || !tp_drawing_has_arcs(object)) return true;
  if (!tp_dxf_use_object(r, object->layer, object->name)) return true; /* as no shape is wanted */
  fmpq_t size, tolerance, stretch;
  fmpq_init(size);
  fmpq_init(tolerance);
  fmpq_init(stretch);
  tp_polyline_size(size, tolerance, &object->line);
  if (fmpq_cmp(tolerance, size) > 0) fmpq_swap(tolerance, size);
  tp_affine_map_stretch(stretch, map);
  fmpq_mul(size, size, stretch);
  tp_curve_tolerance(tolerance, r->options, size);
  /* a map that makes a point of it: any chords do */
  if (!tp_divide(tolerance, tolerance, stretch)) fmpq_one(tolerance);
  const bool done =
      fmpq_is_zero(tolerance) || tp_dxf_curve(r, object, tp_curve_flatten(object, tolerance));
  fmpq_clear(size);
  fmpq_clear(tolerance);
  fmpq_clear(stretch);
  return done;
}

static bool copy_object(tp_dxf_reader *r, const tp_drawing_object *from, const tp_affine_map *map,
                        const char *layer, const char *problem) {
  const bool follows = strcmp(from->layer, "0") == 0;
  const char *own = follows ? layer : from->layer;
  if (follows && !tp_dxf_shown_on(r, own)) return true;
  if (r->sparing && !tp_dxf_use_object(r, own, from->name)) return true;
  tp_drawing_object *object =
      tp_drawing_add(r->drawing, from->kind, own, from->name, from->line.mark);
  if (object == NULL || !tp_drawing_append(object, from)) return tp_dxf_fail_memory(r);
  r->status = tp_drawing_count(r->drawing, object, r->message);
  if (r->status != TP_OK) return false;
  if (problem != NULL) object->problem = problem;
  if (!flatten(r, object, map)) return false;
  tp_affine_map_object(object, map);
  return true;
}

static bool insert_block(tp_dxf_reader *r, const tp_dxf_insert *insert, const tp_affine_map *outer,
                         const char *outer_layer, int depth);

static bool insert_once(tp_dxf_reader *r, const tp_dxf_block *block, const tp_affine_map *map,
                        const char *layer, const char *problem, int depth) {
  bool done = true;
  r->drawing->points_made++;
  if (r->drawing->points_made > r->drawing->points_allowed) {
    return tp_dxf_fail(r, &block->name,
                       "more inserted blocks than are followed, half a million and more; explode "
                       "them, or export the layers of block and base alone");
  }
  for (long k = 0; k < block->objects && done; k++) {
    done = copy_object(r, r->parts.objects + block->first_object + k, map, layer, problem);
  }
  for (long k = 0; k < block->inserts && done; k++) {
    done = insert_block(r, r->inserts + block->first_insert + k, map, layer, depth + 1);
  }
  return done;
}

static bool insert_block(tp_dxf_reader *r, const tp_dxf_insert *insert, const tp_affine_map *outer,
                         const char *outer_layer, int depth) {
  const tp_dxf_block *block = tp_dxf_block_find(r, &insert->block);
  if (block == NULL) {
    const tp_place place = {r->drawing->path, insert->block.line, 1};
    r->status = tp_notes_add(&r->drawing->notes, r->message, TP_CAUTION, place,
                             "a block is inserted that the file has not; it is left out");
    return r->status == TP_OK;
  }
  if (depth == TP_DXF_DEEPEST) {
    return tp_dxf_fail(r, &insert->block, "blocks within blocks, more than 16 deep; explode them");
  }
  const bool follows = insert->layer.length == 1 && insert->layer.text[0] == '0' && depth > 0;
  char *layer = follows ? strdup(outer_layer) : strndup(insert->layer.text, insert->layer.length);
  if (layer == NULL) return tp_dxf_fail_memory(r);
  bool done = true;
  tp_affine_map map;
  tp_affine_map_init(&map);
  const bool used = tp_dxf_use_insert(r, block, layer);
  const long columns = insert->columns > 1 ? insert->columns : 1;
  const long rows = insert->rows > 1 ? insert->rows : 1;
  for (long k = 0; k < columns * rows && used && done; k++) {
    tp_affine_map_set(&map, outer);
    put(&map, insert, block, k % columns, k / columns);
    done = insert_once(r, block, &map, layer, insert->problem, depth);
  }
  tp_affine_map_clear(&map);
  free(layer);
  return done;
}

bool tp_dxf_insert_all(tp_dxf_reader *r) {
  if (!tp_dxf_block_end(r) || !tp_dxf_use_tell(r)) return false;
  tp_affine_map map;
  tp_affine_map_init(&map);
  bool done = true;
  for (long k = tp_dxf_first_insert(r); k < r->insert_count && done; k++) {
    done = insert_block(r, r->inserts + k, &map, "0", 0);
  }
  tp_affine_map_clear(&map);
  return done;
}

void tp_dxf_inserts_clear(tp_dxf_reader *r) {
  for (long k = 0; k < r->block_count; k++) {
    fmpq_clear(r->blocks[k].x);
    fmpq_clear(r->blocks[k].y);
  }
  for (long k = 0; k < r->insert_count; k++) {
    tp_dxf_insert *insert = r->inserts + k;
    fmpq_clear(insert->x);
    fmpq_clear(insert->y);
    fmpq_clear(insert->scale_x);
    fmpq_clear(insert->scale_y);
    fmpq_clear(insert->degrees);
    fmpq_clear(insert->column_step);
    fmpq_clear(insert->row_step);
  }
  free(r->blocks);
  free(r->inserts);
}
