/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "derive/symbols.h"

#include "block/outline.h"

#include <stdlib.h>
#include <string.h>

static void clear_chain(tp_symbolic_chain *chain, const fmpz_mpoly_ctx_t ring) {
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
  if (chain->x == NULL || chain->y == NULL) return false;
  for (long k = 0; k < count; k++) {
    fmpz_mpoly_q_init(chain->x + k, ring);
    fmpz_mpoly_q_init(chain->y + k, ring);
  }
  chain->count = count;
  return true;
}

void tp_symbols_clear(tp_symbols *symbols) {
  for (long r = 0; r < symbols->ring_count; r++) {
    clear_chain(symbols->rings + r, symbols->field.ring);
  }
  free(symbols->rings);
  clear_chain(&symbols->profile, symbols->field.ring);
  clear_chain(&symbols->corners, symbols->field.ring);
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

/* A chain given as a list of [x, y], or by a file: then its numbers. */
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
  return status;
}

/* Width a, height b and depth c of the teeth, by whichever keys the scene gives (section 5.1 of the
 * paper): a = lambda / 2, b = y - A / 2, c = A. A slab is one tooth of depth 0. */
typedef struct teeth_formulas {
  fmpz_mpoly_q_t a, b, c;
} teeth_formulas;

static tp_status read_key(const builder *b, fmpz_mpoly_q_t value, const tp_node *map,
                          const char *key) {
  const tp_node *node = tp_node_get(map, key);
  return node == NULL ? TP_OK : read_number(b, value, node);
}

static tp_status read_teeth(const builder *b, teeth_formulas *f, const tp_node *block) {
  const fmpz_mpoly_ctx_struct *ring = b->symbols->field.ring;
  const tp_node *teeth = tp_node_get(block, "teeth");
  const tp_node *map = teeth != NULL ? teeth : tp_node_get(block, "slab");
  const bool general = tp_node_get(map, "wavelength") != NULL;
  tp_status status = read_key(b, f->a, map, general ? "wavelength" : "width");
  if (status == TP_OK) status = read_key(b, f->b, map, general ? "mean_height" : "height");
  if (status == TP_OK) status = read_key(b, f->c, map, general ? "amplitude" : "depth");
  if (status == TP_OK && general) {
    fmpz_mpoly_q_t half;
    fmpq_t value;
    fmpz_mpoly_q_init(half, ring);
    fmpq_init(value);
    fmpq_set_si(value, 1, 2);
    fmpz_mpoly_q_set_fmpq(half, value, ring);
    fmpz_mpoly_q_mul(f->a, f->a, half, ring);
    fmpz_mpoly_q_mul(half, half, f->c, ring);
    fmpz_mpoly_q_sub(f->b, f->b, half, ring);
    fmpz_mpoly_q_clear(half, ring);
    fmpq_clear(value);
  }
  return status;
}

static void set_multiple(fmpz_mpoly_q_t x, const fmpz_mpoly_q_t unit, long count,
                         const fmpz_mpoly_ctx_t ring) {
  fmpz_t factor;
  fmpz_init_set_si(factor, count);
  fmpz_mpoly_q_mul_fmpz(x, unit, factor, ring);
  fmpz_clear(factor);
}

/* The outline and the element corners, point by point as block/outline.c places them. */
static tp_status set_teeth(const builder *b, const teeth_formulas *f) {
  const fmpz_mpoly_ctx_struct *ring = b->symbols->field.ring;
  const tp_teeth *teeth = &b->scene->block.teeth;
  tp_symbolic_chain *outline = b->symbols->rings, *corners = &b->symbols->corners;
  if (!init_chain(outline, teeth->count + 3, ring) ||
      !init_chain(corners, 2 * (teeth->count + 1), ring)) {
    return tp_fail_memory(b->message, "the formulas");
  }
  for (long k = 0; k < outline->count; k++) {
    const tp_teeth_point p = tp_outline_teeth_point(teeth, k);
    set_multiple(outline->x + k, f->a, p.x_a, ring);
    if (p.y_b != 0) fmpz_mpoly_q_add(outline->y + k, outline->y + k, f->b, ring);
    if (p.y_c != 0) fmpz_mpoly_q_add(outline->y + k, outline->y + k, f->c, ring);
  }
  for (long k = 0; k < corners->count; k++) {
    set_multiple(corners->x + k, f->a, k / 2, ring);
    fmpz_mpoly_q_set(corners->y + k, f->c, ring);
    if (k % 2 == 1) fmpz_mpoly_q_add(corners->y + k, corners->y + k, f->b, ring);
  }
  return TP_OK;
}

static tp_status set_outline(const builder *b, const tp_section *section, const tp_node *block) {
  if (b->scene->block.form == TP_OUTLINE_VERTICES) {
    return set_points(b, b->symbols->rings, tp_node_get(block, "outline"), section->rings);
  }
  const fmpz_mpoly_ctx_struct *ring = b->symbols->field.ring;
  teeth_formulas f;
  fmpz_mpoly_q_init(f.a, ring);
  fmpz_mpoly_q_init(f.b, ring);
  fmpz_mpoly_q_init(f.c, ring);
  tp_status status = read_teeth(b, &f, block);
  if (status == TP_OK) status = set_teeth(b, &f);
  fmpz_mpoly_q_clear(f.a, ring);
  fmpz_mpoly_q_clear(f.b, ring);
  fmpz_mpoly_q_clear(f.c, ring);
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
    if (r == section->hole_count + 1) node = parts->first;
    status = set_points(b, symbols->rings + r, part ? tp_node_get(node, "outline") : node,
                        section->rings + r);
    node = node->next;
  }
  const tp_node *base = tp_node_get(b->scene->source, "base");
  const tp_node *profile = base != NULL ? tp_node_get(base, "profile") : NULL;
  if (status == TP_OK && profile != NULL) {
    status = set_points(b, &symbols->profile, profile, &b->scene->base.profile);
  }
  return status;
}

tp_status tp_symbols_init(tp_symbols *symbols, const tp_scene *scene, const tp_section *section,
                          tp_message *message) {
  memset(symbols, 0, sizeof *symbols);
  tp_status status = tp_field_init(&symbols->field, scene, message);
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
