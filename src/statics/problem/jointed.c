/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Underside of the block as a separate profile, checked for overhangs, and the block moved by the
 * shift along x; coming to rest follows in problem/rested.h. */

#include "problem/jointed.h"

#include "base/profile.h"
#include "base/underside.h"
#include "number/ratio.h"
#include "problem/as_given.h"

#include <stdlib.h>

static tp_status check_form(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  if (block->form != TP_OUTLINE_ELLIPSE && block->arc_count == 0 && block->rounded.count == 0) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_scene_shift_place(scene),
                   "a shifted block comes to rest on its corners: 'joint' is for straight edges, "
                   "without 'arcs', 'rounded' corners and ellipses; 'arc_tolerance' of the block "
                   "makes chords of "
                   "its arcs");
}

/* It is lifted along y, shifted and set down again: nothing of its base may reach over it. */
static tp_status check_way_down(const tp_base *base, const tp_scene *scene, tp_message *message) {
  for (long k = 0; k < base->edge_count; k++) {
    if (fmpq_cmp(base->ring.x + k, base->ring.x + k + 1) <= 0) continue;
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_scene_shift_place(scene),
                     "the mated base turns back over the block between x = %.9g and x = %.9g %s: "
                     "that holds it, and it can not be set down anew along y; narrow the contact "
                     "with 'between'",
                     fmpq_get_d(base->ring.x + k + 1), fmpq_get_d(base->ring.x + k),
                     scene->length_unit);
  }
  return TP_OK;
}

/* Does some of the shifted block stand over its base? */
static tp_status check_shift(const tp_base *base, const tp_polyline *outline, const tp_scene *scene,
                             const fmpq_t shift, tp_message *message) {
  const fmpq *low = outline->x, *high = outline->x;
  fmpq_t end;
  fmpq_init(end);
  for (long k = 1; k < outline->count; k++) {
    if (fmpq_cmp(outline->x + k, low) < 0) low = outline->x + k;
    if (fmpq_cmp(outline->x + k, high) > 0) high = outline->x + k;
  }
  fmpq_add(end, high, shift);
  bool beside = fmpq_cmp(end, base->ring.x) < 0;
  fmpq_add(end, low, shift);
  beside = beside || fmpq_cmp(end, base->ring.x + base->edge_count) > 0;
  fmpq_clear(end);
  if (!beside) return TP_OK;
  char text[80];
  tp_ratio_text(text, sizeof text, shift);
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_scene_shift_place(scene),
                   "shifted by %s %s no part of the block stands over its base any more; let the "
                   "base go on, 'beyond: {left: …, right: …}', or shift the block less",
                   text, scene->length_unit);
}

static void shift_along(fmpq_t x, fmpq_t y, const void *context) {
  (void)y;
  fmpq_add(x, x, context);
}

/* The mated base as a profile: its ring without the two corners below. */
static bool take_profile(tp_scene *own, const tp_base *base) {
  tp_polyline *profile = &own->base.profile;
  profile->file = base->ring.file;
  profile->mark = base->ring.mark;
  bool done = tp_polyline_reserve(profile, base->edge_count + 1);
  for (long k = 0; k <= base->edge_count && done; k++) {
    done = tp_polyline_append(profile, base->ring.x + k, base->ring.y + k, base->ring.marks[k]);
  }
  return done;
}

static bool move(tp_jointed *j, const tp_scene *scene, const tp_section *section,
                 const tp_base *base) {
  const tp_point_map map = {shift_along, j->shift};
  fmpq_t none;
  fmpq_init(none);
  tp_base_description *own = &j->scene.base;
  j->scene.block.form = TP_OUTLINE_VERTICES;
  own->mated = own->whole = false;
  own->rests = true;
  own->rests_place = tp_scene_shift_place(scene);
  j->sole = (tp_sole){base->outline_first, base->mated_count};
  j->base_first = base->mated_first;
  const bool done = tp_moved_rings(&j->scene, scene, section->rings, section->rings + 1, &map) &&
                    tp_moved_block(&j->scene, scene, none, &map) && take_profile(&j->scene, base);
  fmpq_clear(none);
  return done;
}

static tp_status fill(tp_jointed *j, const tp_scene *scene, const tp_section *section,
                      tp_message *message) {
  tp_base base;
  tp_lattice lattice = {0};
  tp_status status = tp_base_init(&base, scene, section, message);
  if (status != TP_OK) return status;
  status = tp_as_given_check(&lattice, scene, section, &base.ring, message);
  if (status == TP_OK) tp_lattice_clear(&lattice);
  if (status == TP_OK && base.none != NULL) status = tp_underside_fail(base.none, scene, message);
  if (status == TP_OK) status = check_way_down(&base, scene, message);
  if (status == TP_OK) status = check_shift(&base, section->rings, scene, j->shift, message);
  if (status == TP_OK && !move(j, scene, section, &base)) {
    status = tp_fail_memory(message, "the shifted block");
  }
  tp_base_clear(&base);
  return status;
}

void tp_jointed_free(tp_jointed *j) {
  if (j == NULL) return;
  tp_moved_clear(&j->scene);
  fmpq_clear(j->shift);
  fmpq_clear(j->before);
  free(j);
}

tp_status tp_jointed_init(tp_jointed **jointed, const tp_scene *scene, const fmpq_t shift,
                          tp_message *message) {
  tp_section section;
  tp_status status = check_form(scene, message);
  if (status == TP_OK) status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_jointed *j = calloc(1, sizeof *j);
  if (j == NULL) {
    status = tp_fail_memory(message, "the shifted block");
  } else {
    tp_moved_begin(&j->scene, scene);
    fmpq_init(j->shift);
    fmpq_init(j->before);
    fmpq_set(j->shift, shift);
    status = fill(j, scene, &section, message);
  }
  tp_section_clear(&section);
  if (status == TP_OK) {
    *jointed = j;
  } else {
    tp_jointed_free(j);
  }
  return status;
}
