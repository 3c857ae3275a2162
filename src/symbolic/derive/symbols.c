/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings read once more from the scene's nodes as rational functions: vertices, teeth, slabs, holes
 * and parts, in the order that the numerical section has. */

#include "derive/symbols.h"

#include "block/outline.h"
#include "derive/field_work.h"
#include "derive/made_profile.h"

#include <stdlib.h>
#include <string.h>

void tp_symbolic_chain_clear(tp_symbolic_chain *chain, const fmpz_mpoly_ctx_t ring) {
  for (long k = 0; k < chain->count; k++) {
    fmpz_mpoly_q_clear(chain->x + k, ring);
    fmpz_mpoly_q_clear(chain->y + k, ring);
  }
  free(chain->x);
  free(chain->y);
  *chain = (tp_symbolic_chain){0};
}

static bool init_chain(tp_symbolic_chain *chain, long count, const fmpz_mpoly_ctx_t ring) {
  chain->x = calloc((size_t)count + 1, sizeof *chain->x);
  chain->y = calloc((size_t)count + 1, sizeof *chain->y);
  if (chain->x == NULL || chain->y == NULL) {
    tp_symbolic_chain_clear(chain, ring);
    return false;
  }
  for (long k = 0; k < count; k++) {
    fmpz_mpoly_q_init(chain->x + k, ring);
    fmpz_mpoly_q_init(chain->y + k, ring);
  }
  chain->count = count;
  return true;
}

void tp_symbols_clear(tp_symbols *symbols) {
  for (long r = 0; symbols->rings != NULL && r < symbols->ring_count; r++) {
    tp_symbolic_chain_clear(symbols->rings + r, symbols->field.ring);
  }
  free(symbols->rings);
  tp_symbolic_chain_clear(&symbols->profile, symbols->field.ring);
  tp_symbolic_chain_clear(&symbols->corners, symbols->field.ring);
  tp_field_clear(&symbols->field);
  memset(symbols, 0, sizeof *symbols);
}

/* What building a chain takes. */
typedef struct builder {
  tp_symbols *symbols;
  const tp_scene *scene;
  tp_message *message;
} builder;

static tp_status read_number(const builder *b, fmpz_mpoly_q_t value, const tp_node *node) {
  return tp_field_read(value, &b->symbols->field, node, b->scene, b->message);
}

/* A last vertex that closes a ring is none of its own: for every value of the parameters. */
static tp_status check_closing(const builder *b, const tp_symbolic_chain *chain, long first,
                               const tp_node *last) {
  const fmpz_mpoly_ctx_struct *ring = b->symbols->field.ring;
  fmpz_mpoly_q_t x, y;
  fmpz_mpoly_q_init(x, ring);
  fmpz_mpoly_q_init(y, ring);
  tp_status status = read_number(b, x, last->first);
  if (status == TP_OK) status = read_number(b, y, last->last);
  if (status == TP_OK && !(fmpz_mpoly_q_equal(x, chain->x + first, ring) &&
                           fmpz_mpoly_q_equal(y, chain->y + first, ring))) {
    status = tp_refuse(b->message, TP_FAULT_KEY, tp_node_place(last, b->scene->path),
                       "this vertex closes the outline for the parameters as they are, but not for "
                       "others; leave it out, or move it");
  }
  fmpz_mpoly_q_clear(x, ring);
  fmpz_mpoly_q_clear(y, ring);
  return status;
}

/* A chain given as a list of [x, y], or by a file or a drawing: then its numbers. */
static tp_status set_points(const builder *b, tp_symbolic_chain *chain, const tp_node *node,
                            const tp_polyline *numbers) {
  const long count = numbers->count;
  const fmpz_mpoly_ctx_struct *ring = b->symbols->field.ring;
  if (!init_chain(chain, count, ring)) return tp_fail_memory(b->message, "the formulas");
  const bool list = node != NULL && node->kind == TP_NODE_SEQUENCE;
  const tp_node *point = list ? node->first : NULL;
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    const long at = numbers->reversed ? count - 1 - k : k;
    if (point != NULL) {
      status = read_number(b, chain->x + at, point->first);
      if (status == TP_OK) status = read_number(b, chain->y + at, point->last);
      point = point->next;
    } else {
      fmpz_mpoly_q_set_fmpq(chain->x + k, numbers->x + k, ring);
      fmpz_mpoly_q_set_fmpq(chain->y + k, numbers->y + k, ring);
    }
  }
  if (status == TP_OK && point != NULL) {
    status = check_closing(b, chain, numbers->reversed ? count - 1 : 0, point);
  }
  return status;
}

static tp_status read_key(const tp_symbols *symbols, const tp_scene *scene, fmpz_mpoly_q_t value,
                          const tp_node *map, const char *key, tp_message *message) {
  const tp_node *node = tp_node_get(map, key);
  return node == NULL ? TP_OK : tp_field_read(value, &symbols->field, node, scene, message);
}

void tp_teeth_formulas_init(tp_teeth_formulas *f, const tp_field *field) {
  fmpz_mpoly_q_init(f->a, field->ring);
  fmpz_mpoly_q_init(f->b, field->ring);
  fmpz_mpoly_q_init(f->c, field->ring);
  fmpz_mpoly_q_init(f->count, field->ring);
}

void tp_teeth_formulas_clear(tp_teeth_formulas *f, const tp_field *field) {
  fmpz_mpoly_q_clear(f->a, field->ring);
  fmpz_mpoly_q_clear(f->b, field->ring);
  fmpz_mpoly_q_clear(f->c, field->ring);
  fmpz_mpoly_q_clear(f->count, field->ring);
}

/* From the general parameters: a = lambda / 2, b = y - A / 2, c = A, N = dx / a. */
static void set_general(tp_teeth_formulas *f, const tp_field *field) {
  fmpz_mpoly_q_t half;
  fmpq_t value;
  fmpz_mpoly_q_init(half, field->ring);
  fmpq_init(value);
  fmpq_set_si(value, 1, 2);
  fmpz_mpoly_q_set_fmpq(half, value, field->ring);
  tp_field_mul(f->a, f->a, half, field);
  tp_field_mul(half, half, f->c, field);
  tp_field_sub(f->b, f->b, half, field);
  tp_field_div(f->count, f->count, f->a, field);
  fmpz_mpoly_q_clear(half, field->ring);
  fmpq_clear(value);
}

tp_status tp_teeth_formulas_read(tp_teeth_formulas *f, const tp_symbols *symbols,
                                 const tp_scene *scene, tp_message *message) {
  const tp_node *block = tp_node_get(scene->source, "block"), *teeth = tp_node_get(block, "teeth");
  const tp_node *map = teeth != NULL ? teeth : tp_node_get(block, "slab");
  const bool general = tp_node_get(map, "wavelength") != NULL;
  const struct {
    fmpz_mpoly_q_struct *value;
    const char *key;
  } keys[] = {{f->a, general ? "wavelength" : "width"},
              {f->b, general ? "mean_height" : "height"},
              {f->c, general ? "amplitude" : "depth"},
              {f->count, general ? "block_width" : ""}};
  tp_status status = TP_OK;
  for (size_t k = 0; k < sizeof keys / sizeof keys[0] && status == TP_OK; k++) {
    status = read_key(symbols, scene, keys[k].value, map, keys[k].key, message);
  }
  if (status != TP_OK) return status;
  if (general) {
    set_general(f, &symbols->field);
  } else {
    tp_field_count_symbol(f->count, &symbols->field);
  }
  return TP_OK;
}

static void set_multiple(fmpz_mpoly_q_t x, const fmpz_mpoly_q_t unit, long count,
                         const fmpz_mpoly_ctx_t ring) {
  fmpz_t factor;
  fmpz_init_set_si(factor, count);
  fmpz_mpoly_q_mul_fmpz(x, unit, factor, ring);
  fmpz_clear(factor);
}

bool tp_teeth_formulas_outline(tp_symbolic_chain *outline, const tp_teeth_formulas *f,
                               const tp_teeth *teeth, const tp_field *field) {
  if (!init_chain(outline, teeth->count + 3, field->ring)) return false;
  for (long k = 0; k < outline->count; k++) {
    const tp_teeth_point p = tp_outline_teeth_point(teeth, k);
    set_multiple(outline->x + k, f->a, p.x_a, field->ring);
    if (p.y_b != 0) tp_field_add(outline->y + k, outline->y + k, f->b, field);
    if (p.y_c != 0) tp_field_add(outline->y + k, outline->y + k, f->c, field);
  }
  return true;
}

/* The element corners, point by point as block/outline.c places them. */
static bool set_corners(tp_symbolic_chain *corners, const tp_teeth_formulas *f,
                        const tp_teeth *teeth, const tp_field *field) {
  if (!init_chain(corners, 2 * (teeth->count + 1), field->ring)) return false;
  for (long k = 0; k < corners->count; k++) {
    set_multiple(corners->x + k, f->a, k / 2, field->ring);
    fmpz_mpoly_q_set(corners->y + k, f->c, field->ring);
    if (k % 2 == 1) tp_field_add(corners->y + k, corners->y + k, f->b, field);
  }
  return true;
}

static tp_status set_outline(const builder *b, const tp_section *section, const tp_node *block) {
  if (b->scene->block.form == TP_OUTLINE_VERTICES) {
    return set_points(b, b->symbols->rings, tp_node_get(block, "outline"), section->rings);
  }
  tp_symbols *symbols = b->symbols;
  const tp_teeth *teeth = &b->scene->block.teeth;
  tp_teeth_formulas f;
  tp_teeth_formulas_init(&f, &symbols->field);
  tp_status status = tp_teeth_formulas_read(&f, symbols, b->scene, b->message);
  if (status == TP_OK && !(tp_teeth_formulas_outline(symbols->rings, &f, teeth, &symbols->field) &&
                           set_corners(&symbols->corners, &f, teeth, &symbols->field))) {
    status = tp_fail_memory(b->message, "the formulas");
  }
  tp_teeth_formulas_clear(&f, &symbols->field);
  return status;
}

static tp_status set_rings(const builder *b, const tp_section *section) {
  const tp_node *block = tp_node_get(b->scene->source, "block");
  const tp_node *holes = tp_node_get(block, "holes"), *parts = tp_node_get(block, "parts");
  tp_symbols *symbols = b->symbols;
  tp_status status = set_outline(b, section, block);
  const tp_node *node = holes != NULL ? holes->first : NULL;
  for (long r = 1; r < section->ring_count && status == TP_OK; r++) {
    const bool part = r > section->hole_count;
    if (r == section->hole_count + 1) node = parts != NULL ? parts->first : NULL;
    status = set_points(b, symbols->rings + r, part ? tp_node_get(node, "outline") : node,
                        section->rings + r);
    node = node != NULL ? node->next : NULL; /* those of a drawing come last, and have none */
  }
  const tp_node *base = tp_node_get(b->scene->source, "base");
  const tp_node *profile = base != NULL ? tp_node_get(base, "profile") : NULL;
  if (status == TP_OK && profile != NULL && profile->kind == TP_NODE_MAPPING) {
    status = tp_made_profile_check(b->scene, profile, b->message);
  }
  if (status == TP_OK && b->scene->base.profile.count > 0) {
    status = set_points(b, &symbols->profile, profile, &b->scene->base.profile);
  }
  return status;
}

tp_status tp_symbols_init(tp_symbols *symbols, const tp_scene *scene, const tp_section *section,
                          const tp_symbol_names *more, tp_message *message) {
  memset(symbols, 0, sizeof *symbols);
  tp_status status = tp_field_init(&symbols->field, scene, more, message);
  if (status != TP_OK) return status;
  symbols->rings = calloc((size_t)section->ring_count, sizeof *symbols->rings);
  if (symbols->rings == NULL) {
    status = tp_fail_memory(message, "the formulas");
  } else {
    symbols->ring_count = section->ring_count;
    const builder b = {symbols, scene, message};
    status = set_rings(&b, section);
  }
  if (status != TP_OK) tp_symbols_clear(symbols);
  return status;
}
