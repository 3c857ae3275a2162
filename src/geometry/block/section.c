/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings, densities and weights of a section from the block's description: outline by vertices,
 * teeth or ellipse, holes, parts and arcs, each turned counter-clockwise. */

#include "block/section.h"

#include "block/ellipse.h"
#include "block/outline.h"
#include "block/repair.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tp_section_clear(tp_section *section) {
  for (long r = 0; r < section->ring_count; r++) {
    if (section->rings != NULL) tp_polyline_clear(section->rings + r);
    if (section->ring_weights != NULL) fmpz_clear(section->ring_weights + r);
  }
  for (long k = 0; k <= section->part_count; k++) {
    if (section->density_weights != NULL) fmpz_clear(section->density_weights + k);
  }
  free(section->rings);
  free(section->ring_weights);
  free(section->density_weights);
  tp_polyline_clear(&section->element_corners);
  tp_notes_clear(&section->notes);
  tp_arc_tips_clear(&section->arc_tips);
  fmpq_clear(section->weight_unit);
  memset(section, 0, sizeof *section);
}

void tp_section_ring_name(char *text, size_t size, const tp_section *section, long ring) {
  if (ring == 0) {
    snprintf(text, size, "the outline");
  } else if (ring <= section->hole_count) {
    snprintf(text, size, "hole %ld", ring);
  } else {
    snprintf(text, size, "part %ld", ring - section->hole_count);
  }
}

/* Unit weights over their greatest common measure. */
static void set_weights(tp_section *section, const tp_block_description *block) {
  fmpz *own = section->density_weights;
  if (!block->unit_weight_kn_m3.given) {
    fmpq_one(section->weight_unit);
    fmpz_one(own);
  } else {
    fmpq_t quotient;
    fmpq_init(quotient);
    fmpq_set(section->weight_unit, block->unit_weight_kn_m3.value);
    for (long k = 0; k < block->part_count; k++) {
      fmpq_gcd(section->weight_unit, section->weight_unit, block->parts[k].unit_weight_kn_m3.value);
    }
    fmpq_div(quotient, block->unit_weight_kn_m3.value, section->weight_unit);
    fmpz_set(own, fmpq_numref(quotient));
    for (long k = 0; k < block->part_count; k++) {
      fmpq_div(quotient, block->parts[k].unit_weight_kn_m3.value, section->weight_unit);
      fmpz_set(own + k + 1, fmpq_numref(quotient));
    }
    fmpq_clear(quotient);
  }
  for (long r = 0; r < section->ring_count; r++) {
    fmpz *weight = section->ring_weights + r;
    if (r == 0) {
      fmpz_set(weight, own);
    } else if (r <= section->hole_count) {
      fmpz_neg(weight, own);
    } else {
      fmpz_sub(weight, own + (r - section->hole_count), own);
    }
  }
}

/* The scene's own points, where nothing changes them: a million take 40 MB. */
static bool set_outline(tp_polyline *outline, const tp_block_description *block) {
  const tp_polyline *given = &block->outline;
  const bool changes = block->repair || block->arc_count > 0 || tp_polyline_orientation(given) < 0;
  if (changes || given->users == NULL) return tp_polyline_copy(outline, given);
  *outline = tp_polyline_share(given);
  return true;
}

static bool set_rings(tp_section *section, const tp_block_description *block) {
  const tp_mark mark = {block->place.line, block->place.column};
  tp_polyline *outline = section->rings;
  outline->file = block->place.file;
  outline->mark = mark;
  bool done = true;
  switch (block->form) {
  case TP_OUTLINE_VERTICES:
    if (block->ellipse.cosine != NULL) section->ellipse = &block->ellipse; /* turned, by its hull */
    done = set_outline(outline, block);
    break;
  case TP_OUTLINE_TEETH:
  case TP_OUTLINE_SLAB:
    done = tp_outline_teeth(outline, &block->teeth, mark) &&
           tp_outline_teeth_elements(&section->element_corners, &block->teeth);
    break;
  case TP_OUTLINE_OF_EACH:
  case TP_OUTLINE_OF_SOLID:
    break;
  case TP_OUTLINE_ELLIPSE:
    section->ellipse = &block->ellipse;
    done = tp_ellipse_hull(outline, &block->ellipse, mark);
    break;
  }
  for (long k = 0; k < block->hole_count && done; k++) {
    done = tp_polyline_copy(section->rings + 1 + k, block->holes + k);
  }
  for (long k = 0; k < block->part_count && done; k++) {
    done = tp_polyline_copy(section->rings + 1 + block->hole_count + k, &block->parts[k].outline);
  }
  for (long r = 0; r < section->ring_count && done; r++) tp_polyline_orient(section->rings + r);
  return done;
}

static tp_status check_counts(const tp_section *section, tp_message *message) {
  for (long r = 0; r < section->ring_count; r++) {
    const tp_polyline *ring = section->rings + r;
    if (ring->count >= 3) continue;
    char name[40];
    tp_section_ring_name(name, sizeof name, section, r);
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, -1),
                     "%s has %ld %s; it needs at least three", name, ring->count,
                     ring->count == 1 ? "vertex" : "vertices");
  }
  return TP_OK;
}

/* Those that cross themselves by less than their last digits, where the scene asks for it. */
static tp_status repair_rings(tp_section *section, tp_message *message) {
  tp_status status = TP_OK;
  for (long r = 0; r < section->ring_count && status == TP_OK; r++) {
    char name[40];
    tp_section_ring_name(name, sizeof name, section, r);
    status = tp_repair_with_notes(section->rings + r, name, &section->notes, message);
    tp_polyline_orient(section->rings + r);
  }
  return status;
}

tp_status tp_section_init(tp_section *section, const tp_block_description *block,
                          tp_message *message) {
  memset(section, 0, sizeof *section);
  tp_status status = tp_check_one_block(block, message);
  if (status != TP_OK) return status;
  fmpq_init(section->weight_unit);
  section->hole_count = block->hole_count;
  section->part_count = block->part_count;
  section->ring_count = 1 + block->hole_count + block->part_count;
  const size_t rings = (size_t)section->ring_count;
  section->rings = calloc(rings, sizeof *section->rings);
  section->ring_weights = calloc(rings, sizeof *section->ring_weights);
  section->density_weights =
      calloc((size_t)section->part_count + 1, sizeof *section->density_weights);
  if (section->rings == NULL || section->ring_weights == NULL || section->density_weights == NULL ||
      !set_rings(section, block)) {
    status = tp_fail_memory(message, "the block");
  } else {
    status = check_counts(section, message);
  }
  section->repairable = !block->repair && block->arc_count == 0;
  if (status == TP_OK && block->repair) status = repair_rings(section, message);
  if (status == TP_OK) status = tp_arcs_apply(&section->arc_tips, section->rings, block, message);
  if (status == TP_OK) {
    set_weights(section, block);
  } else {
    tp_section_clear(section);
  }
  return status;
}

bool tp_section_is_arc(const tp_section *section, long vertex) {
  if (section->ellipse != NULL) return true;
  const long next = vertex + 1 == section->rings[0].count ? 0 : vertex + 1;
  for (long k = 0; k < section->arc_tips.count; k++) {
    const tp_arc_tip *tip = section->arc_tips.items + k;
    if (tip->vertex == vertex || (!tip->inwards && tip->vertex == next)) return true;
  }
  return false;
}
