/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moves the outline by base/snap.h, then points of holes, parts and loads that lie on moved edges
 * at the same share of the edge; exact throughout. */

#include "problem/snapped.h"

#include "number/ratio.h"
#include "problem/as_given.h"
#include "problem/snapped_loads.h"
#include "problem/with_outline.h"

#include <stdlib.h>
#include <string.h>

static tp_status check_form(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  if (scene->base.mated) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->base.within.place,
                     "a mated base touches its block already; 'contact: {within: …}' is for a base "
                     "with a separate 'profile'");
  }
  if (block->form == TP_OUTLINE_ELLIPSE || block->arc_count > 0 || block->rounded.count > 0) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, scene->base.within.place,
        "'contact: {within: …}' moves the corners of a block: it is for straight edges, "
        "without 'arcs', 'rounded' corners and ellipses; 'arc_tolerance' of the block makes chords "
        "of "
        "its arcs");
  }
  return TP_OK;
}

static tp_status check_edges(const tp_closeness *near, const tp_scene *scene, tp_message *message) {
  const fmpq *within = scene->base.within.value;
  fmpq_t square;
  bool of_base = false;
  long edge = 0;
  tp_status status = TP_OK;
  fmpq_init(square);
  if (tp_snap_short_edge(square, &of_base, &edge, near, within)) {
    const tp_polyline *line = of_base ? &near->base->ring : near->section->rings;
    const long next = edge + 1 == line->count ? 0 : edge + 1;
    char text[64], where[300];
    tp_ratio_text(text, sizeof text, within);
    tp_place_text(where, sizeof where, tp_polyline_place(line, edge));
    status = tp_refuse(
        message, TP_FAULT_RANGE, scene->base.within.place,
        "within %s %s corners could not be distinguished: the edge from vertex %ld to "
        "vertex %ld of the %s (%s) is %.3g %s long; give at most the shortest edge",
        text, scene->length_unit, tp_polyline_number(line, edge), tp_polyline_number(line, next),
        of_base ? "profile" : "outline", where, tp_closeness_root(square), scene->length_unit);
  }
  fmpq_clear(square);
  return status;
}

static tp_status snap(tp_snapped *s, const tp_closeness *near, const tp_scene *scene,
                      tp_message *message) {
  tp_status status = check_edges(near, scene, message);
  if (status != TP_OK) return status;
  if (!tp_snap_find(&s->snap, near, scene->base.within.value)) {
    return tp_fail_memory(message, "the moved block");
  }
  if (!s->snap.touches) return TP_OK; /* the contact's: it says what is nearest */
  return tp_snap_gap(&s->gap, &s->gap_error, &s->snap, near)
             ? TP_OK
             : tp_fail_memory(message, "the moved block");
}

/* Pressures and surcharges go with the edges that they act on, and these may have become several.
 */
static bool move_lines(tp_line_load **lines, long *count, const tp_line_load *own, long own_count,
                       const tp_snapped_outline *outline) {
  long split_count = 0;
  tp_line_load *split = tp_snapped_lines(&split_count, own, own_count, outline);
  if (split == NULL) return false;
  tp_moved_clear_lines(*lines, *count);
  *lines = split;
  *count = split_count;
  return true;
}

static bool move_loads(tp_snapped *s, const tp_scene *scene, const tp_section *section) {
  const tp_snapped_outline outline = {section->rings, &s->snap.moved, &s->snap.outline};
  const tp_loads_description *own = &scene->loads;
  tp_loads_description *loads = &s->scene.loads;
  return move_lines(&loads->pressures, &loads->pressure_count, own->pressures, own->pressure_count,
                    &outline) &&
         move_lines(&loads->surcharges, &loads->surcharge_count, own->surcharges,
                    own->surcharge_count, &outline) &&
         move_lines(&loads->supports, &loads->support_count, own->supports, own->support_count,
                    &outline);
}

static bool move(tp_snapped *s, const tp_scene *scene, const tp_section *section) {
  const tp_moved_outline context = {section->rings, &s->snap.moved};
  const tp_point_map map = {tp_move_with_outline, &context}, stay = {NULL, NULL};
  const tp_polyline none = {0};
  fmpq_t turn;
  fmpq_init(turn);
  s->scene.block.form = TP_OUTLINE_VERTICES;
  const bool done = tp_moved_rings(&s->scene, scene, &none, section->rings + 1, &map) &&
                    tp_moved_block(&s->scene, scene, turn, &map) &&
                    tp_moved_profile(&s->scene, scene, &stay) && move_loads(s, scene, section);
  fmpq_clear(turn);
  if (!done) return false;
  tp_polyline_clear(&s->scene.block.outline);
  s->scene.block.outline = s->snap.outline;
  s->snap.outline = (tp_polyline){0};
  return true;
}

/* ------------------------------------------------------------------------------------------------
 */

void tp_snapped_free(tp_snapped *s) {
  if (s == NULL) return;
  tp_moved_clear(&s->scene);
  tp_snap_clear(&s->snap);
  free(s);
}

static tp_status fill(tp_snapped *s, const tp_scene *scene, const tp_section *section,
                      tp_message *message) {
  tp_base base;
  tp_lattice lattice = {0};
  tp_closeness near;
  tp_status status = tp_base_init(&base, scene, section, message);
  if (status != TP_OK) return status;
  status = tp_as_given_check(&lattice, scene, section, &base.ring, message);
  if (status == TP_OK) {
    tp_closeness_init(&near, section, &base, &lattice);
    status = snap(s, &near, scene, message);
    tp_lattice_clear(&lattice);
  }
  tp_base_clear(&base);
  if (status == TP_OK && !move(s, scene, section)) {
    status = tp_fail_memory(message, "the moved block");
  }
  return status;
}

tp_status tp_snapped_init(tp_snapped **snapped, const tp_scene *scene, tp_message *message) {
  tp_section section;
  tp_status status = check_form(scene, message);
  if (status == TP_OK) status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_snapped *s = calloc(1, sizeof *s);
  if (s == NULL) {
    status = tp_fail_memory(message, "the moved block");
  } else {
    tp_moved_begin(&s->scene, scene);
    tp_snap_init(&s->snap);
    status = fill(s, scene, &section, message);
  }
  tp_section_clear(&section);
  if (status == TP_OK) {
    *snapped = s;
  } else {
    tp_snapped_free(s);
  }
  return status;
}

void tp_snapped_explain(const tp_scene *scene, tp_message *message) {
  if (message == NULL) return;
  tp_message inner = *message;
  char within[64];
  tp_ratio_text(within, sizeof within, scene->base.within.value);
  (void)tp_refuse(message, TP_FAULT_GEOMETRY, scene->base.within.place,
                  "with all within %s %s of its contact moved there: %s", within,
                  scene->length_unit, inner.text);
}
