/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A copy of the scene with the ring of chords, without arcs, and the note on it. */

#include "problem/chorded.h"

#include "number/ratio.h"

#include <stdlib.h>

static tp_status tell(tp_notes *notes, const tp_scene *scene, const tp_arc_chords *chords,
                      tp_message *message) {
  enum { SIZE = 64 };
  char off[SIZE];
  tp_ratio_text(off, sizeof off, scene->block.arc_tolerance.value);
  return tp_notes_add(notes, message, TP_NOTE, scene->block.arc_tolerance.place,
                      "%ld chords stand for the %ld arc%s of the outline, nowhere more than %s %s "
                      "beside them: outward arcs lose, inward ones gain, together at most %.2g %s² "
                      "of area",
                      chords->count, scene->block.arc_count, scene->block.arc_count == 1 ? "" : "s",
                      off, scene->length_unit, chords->area, scene->length_unit);
}

void tp_chorded_free(tp_chorded *own) {
  if (own == NULL) return;
  tp_arc_chords_clear(&own->chords);
  free(own);
}

tp_status tp_chorded_init(tp_chorded **chorded, const tp_scene *scene, tp_notes *notes,
                          tp_message *message) {
  if (!scene->block.arc_tolerance.given || scene->block.arc_count == 0) return TP_OK;
  tp_chorded *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the chords");
  tp_status status = tp_arc_chords_init(&own->chords, &scene->block, message);
  if (status == TP_OK) status = tell(notes, scene, &own->chords, message);
  if (status != TP_OK) {
    tp_chorded_free(own);
    return status;
  }
  own->scene = *scene;
  own->scene.block.outline = own->chords.ring;
  own->scene.block.arcs = NULL;
  own->scene.block.arc_count = 0;
  *chorded = own;
  return TP_OK;
}
