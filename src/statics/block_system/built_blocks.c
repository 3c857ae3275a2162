/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sections shifted to their places and checked; the noise of a survey taken out of them where the
 * scene gives its size, and told of where it does not. */

#include "block_system/built_system.h"

#include "assemblage/close_gaps.h"
#include "assemblage/near_blocks.h"
#include "block/arc_chords.h"
#include "block/check.h"
#include "common/notes.h"
#include "common/outside.h"

#include <stdlib.h>

/* Of the size of blocks: gaps below that may be noise. */
static const double noise = 1e-3;

static tp_status shift(tp_section *section, const tp_listed_block *listed, tp_message *message) {
  if (!listed->at_x.given) return TP_OK;
  for (long r = 0; r < section->ring_count; r++) {
    tp_polyline *ring = section->rings + r;
    if (!tp_polyline_separate(ring)) return tp_fail_memory(message, "the blocks");
    for (long k = 0; k < ring->count; k++) {
      fmpq_add(ring->x + k, ring->x + k, listed->at_x.value);
      fmpq_add(ring->y + k, ring->y + k, listed->at_y.value);
    }
  }
  return TP_OK;
}

/* The block of its unit weight, with chords for its arcs. */
static tp_status set_section(tp_section *section, const tp_scene *scene,
                             const tp_listed_block *listed, tp_message *message) {
  tp_block_description own = listed->shape; /* shares all with it */
  own.unit_weight_kn_m3 = *tp_listed_block_unit_weight(scene, listed);
  if (own.arc_count == 0) return tp_section_init(section, &own, message);
  tp_arc_chords chords;
  const tp_status status = tp_arc_chords_init(&chords, &own, message);
  if (status != TP_OK) return status;
  own.outline = chords.ring;
  own.arcs = NULL;
  own.arc_count = 0;
  const tp_status made = tp_section_init(section, &own, message);
  tp_arc_chords_clear(&chords);
  return made;
}

static tp_status check(const tp_section *section, const fmpq_t metres_per_unit,
                       tp_message *message) {
  const tp_polyline **chains = calloc((size_t)section->ring_count + 1, sizeof *chains);
  if (chains == NULL) return tp_fail_memory(message, "the blocks");
  for (long r = 0; r < section->ring_count; r++) chains[r] = section->rings + r;
  tp_lattice lattice;
  tp_status status =
      tp_lattice_init(&lattice, chains, section->ring_count, metres_per_unit, message);
  free(chains);
  if (status != TP_OK) return status;
  tp_geom_triangulation triangulation = {0};
  status = tp_check_section(&triangulation, section, &lattice, message);
  tp_geom_triangulation_clear(&triangulation);
  tp_lattice_clear(&lattice);
  return status;
}

static tp_status set_block(tp_built_system *s, const tp_listed_block *listed, tp_message *message) {
  tp_section *section = s->sections + s->count;
  tp_status status = set_section(section, s->scene, listed, message);
  if (status != TP_OK) return status;
  s->given[s->count++] = (tp_given_block){
      .section = section, .name = listed->name, .place = listed->place, .fixed = listed->fixed};
  status = tp_notes_append(&s->notes, &section->notes, message);
  if (status == TP_OK) status = shift(section, listed, message);
  return status == TP_OK ? check(section, s->scene->metres_per_unit, message) : status;
}

static tp_status close_gaps(tp_built_system *s, tp_message *message) {
  const tp_quantity *within = &s->scene->base.within;
  tp_closing closing;
  tp_status status =
      tp_close_gaps(&closing, s->sections, s->given, s->count, within->value, message);
  for (long k = 0; k < s->count && status == TP_OK; k++) {
    status = check(s->sections + k, s->scene->metres_per_unit, message);
  }
  if (status != TP_OK) return status;
  if (closing.moved == 0) {
    return tp_notes_add(&s->notes, message, TP_NOTE, within->place,
                        "no corner had to be moved so that blocks touch");
  }
  return tp_notes_add(
      &s->notes, message, TP_NOTE, within->place,
      "%ld corners were moved so that blocks touch, by up to %.3g %s, of '%s'; edges "
      "took in %ld corners of neighbours",
      closing.moved, closing.most, s->scene->length_unit,
      tp_quote_all(s->given[closing.block].name).text, closing.taken_in);
}

tp_status tp_built_system_set_blocks(tp_built_system *s, tp_message *message) {
  const tp_block_list *many = &s->scene->many;
  s->sections = calloc((size_t)many->count, sizeof *s->sections);
  s->given = calloc((size_t)many->count, sizeof *s->given);
  if (s->sections == NULL || s->given == NULL) return tp_fail_memory(message, "the blocks");
  tp_status status = TP_OK;
  for (long k = 0; k < many->count && status == TP_OK; k++) {
    status = set_block(s, many->blocks + k, message);
  }
  return status == TP_OK && s->scene->base.within.given ? close_gaps(s, message) : status;
}

tp_status tp_built_system_note_gaps(tp_built_system *s, tp_message *message) {
  tp_near_blocks near;
  if (s->scene->base.within.given || s->scene->many.slope.place.file != NULL) return TP_OK;
  const tp_status status = tp_near_blocks_find(&near, &s->assemblage, noise, message);
  if (status != TP_OK || near.count == 0) return status;
  return tp_notes_add(
      &s->notes, message, TP_CAUTION, s->given[near.block[1]].place,
      "blocks '%s' and '%s' lie %.3g %s apart and do not touch%s; if that is noise of "
      "a survey, 'contact: {within: %.1g}' closes it",
      tp_quote_all(s->given[near.block[0]].name).text,
      tp_quote_all(s->given[near.block[1]].name).text, near.distance, s->scene->length_unit,
      near.count > 1 ? ", nor do others as near" : "", 2 * near.distance);
}
