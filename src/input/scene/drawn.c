/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chains of the drawing put into the frame and the unit of the scene by an affine map; arcs kept on
 * the outline, made chords elsewhere, with a note on their deviation. */

#include "scene/drawn.h"

#include "format/affine.h"
#include "format/curve.h"
#include "format/drawing_work.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

void tp_drawn_clear(tp_drawn *drawn) {
  tp_polyline_clear(&drawn->outline);
  tp_polyline_clear(&drawn->base);
  for (long k = 0; k < drawn->arc_count; k++) {
    fmpq_clear(drawn->arcs[k].x);
    fmpq_clear(drawn->arcs[k].y);
    fmpq_clear(drawn->arcs[k].bulge);
  }
  for (long k = 0; k < drawn->hole_count; k++) tp_polyline_clear(drawn->holes + k);
  for (long k = 0; k < drawn->part_count; k++) tp_polyline_clear(drawn->parts + k);
  for (long k = 0; k < drawn->part_count; k++) free(drawn->part_layers[k]);
  for (long k = 0; k < drawn->object_count; k++) {
    free(drawn->objects[k].layer);
    free(drawn->objects[k].name);
  }
  free(drawn->arcs);
  free(drawn->holes);
  free(drawn->parts);
  free(drawn->part_words);
  free(drawn->part_layers);
  free(drawn->objects);
  tp_notes_clear(&drawn->notes);
  *drawn = (tp_drawn){.path = drawn->path, .length_unit = drawn->length_unit};
}

/* Sign of the area within the chords; an outline that has none is refused where arcs are applied.
 */
static int turn_of(const tp_polyline *line) {
  tp_polyline copy;
  if (!tp_polyline_copy(&copy, line)) return 0;
  tp_polyline_orient_by_area(&copy);
  const int sign = copy.reversed == line->reversed ? 1 : -1;
  tp_polyline_clear(&copy);
  return sign;
}

static bool take_arcs(tp_drawn *drawn, const tp_drawing_object *chain) {
  const tp_polyline *line = &chain->line;
  const int turn = turn_of(line);
  drawn->arcs = calloc((size_t)line->count + 1, sizeof *drawn->arcs);
  if (drawn->arcs == NULL || turn == 0) return false;
  for (long k = 0; k < line->count; k++) {
    const fmpq *bulge = tp_drawing_bulge(chain, k);
    if (bulge == NULL) continue;
    tp_drawn_arc *arc = drawn->arcs + drawn->arc_count++;
    arc->mark = line->marks[k];
    fmpq_init(arc->x);
    fmpq_init(arc->y);
    fmpq_init(arc->bulge);
    fmpq_set(arc->x, line->x + k);
    fmpq_set(arc->y, line->y + k);
    fmpq_mul_si(arc->bulge, bulge, turn);
  }
  return true;
}

/* Its points become the scene's, which may share them. */
static bool take_line(tp_polyline *to, tp_drawing_object *chain) {
  *to = chain->line;
  chain->line = (tp_polyline){.file = to->file, .mark = to->mark};
  return tp_polyline_make_shared(to);
}

static const char *chords_of(tp_drawing_role role) {
  switch (role) {
  case TP_DRAWING_BLOCK:
    return "the outline";
  case TP_DRAWING_BASE:
    return "the base";
  case TP_DRAWING_HOLE:
    return "a hole";
  default:
    return "a part";
  }
}

static tp_status note_deviation(tp_drawn *drawn, const tp_drawing_object *chain,
                                tp_drawing_role role, tp_message *message) {
  if (fmpq_is_zero(chain->deviation)) return TP_OK;
  return tp_notes_add(&drawn->notes, message, TP_NOTE, tp_drawing_place(chain),
                      "curves of %s are chords, which leave them by at most %.3g; "
                      "'drawing: {tolerance: …}' says by how much they may",
                      chords_of(role), fmpq_get_d(chain->deviation));
}

/* The scene keeps arcs of an outline alone. */
static tp_status flatten(tp_drawing *chains, tp_drawing_object *chain,
                         const tp_drawing_options *options, tp_message *message) {
  if (!tp_drawing_has_arcs(chain)) return TP_OK;
  fmpq_t size, tolerance;
  fmpq_init(size);
  fmpq_init(tolerance);
  tp_polyline_size(size, tolerance, &chain->line);
  if (fmpq_cmp(tolerance, size) > 0) fmpq_swap(tolerance, size);
  tp_curve_tolerance(tolerance, options, size);
  const tp_curve_outcome outcome = tp_curve_flatten(chain, tolerance);
  fmpq_clear(size);
  fmpq_clear(tolerance);
  if (outcome == TP_CURVE_DONE) return tp_drawing_count(chains, chain, message);
  if (outcome == TP_CURVE_NO_MEMORY) return tp_fail_memory(message, "a drawing");
  return tp_refuse(message, TP_FAULT_FORMAT, tp_drawing_place(chain), TP_CURVE_TOO_FINE_TEXT);
}

/* Numbers that are written are no larger; transforms and scales multiply them. */
static tp_status check_size(const tp_drawing_object *chain, tp_message *message) {
  const tp_polyline *line = &chain->line;
  for (long k = 0; k < line->count; k++) {
    for (int axis = 0; axis < 2; axis++) {
      const fmpq *value = axis == 0 ? line->x + k : line->y + k;
      const slong bits =
          (slong)fmpz_bits(fmpq_numref(value)) - (slong)fmpz_bits(fmpq_denref(value));
      if (bits < DBL_MAX_EXP) continue;
      return tp_refuse(message, TP_FAULT_RANGE, tp_drawing_place(chain),
                       "lies beyond 1e308, the largest number that Topple takes, as its transforms "
                       "and the drawing's unit or reference have it");
    }
  }
  return TP_OK;
}

static tp_status take_chain(tp_drawn *drawn, tp_drawing *chains, tp_drawing_object *chain,
                            tp_drawing_role role, long part, const tp_drawing_words *words,
                            const tp_drawing_options *options, const tp_affine_map *map,
                            tp_message *message) {
  bool done = role != TP_DRAWING_BLOCK || tp_curve_split_lens(chain);
  tp_status status = TP_OK;
  if (done && role != TP_DRAWING_BLOCK) status = flatten(chains, chain, options, message);
  if (status == TP_OK) status = note_deviation(drawn, chain, role, message);
  if (!done || status != TP_OK) return done ? status : tp_fail_memory(message, "a drawing");
  tp_affine_map_object(chain, map);
  status = check_size(chain, message);
  if (status != TP_OK) return status;
  switch (role) {
  case TP_DRAWING_BLOCK:
    done = take_arcs(drawn, chain) && take_line(&drawn->outline, chain);
    break;
  case TP_DRAWING_BASE:
    done = take_line(&drawn->base, chain);
    break;
  case TP_DRAWING_HOLE:
    done = take_line(drawn->holes + drawn->hole_count++, chain);
    break;
  default:
    drawn->part_words[drawn->part_count] = part;
    drawn->part_layers[drawn->part_count] = strdup(words->parts[part]);
    done = drawn->part_layers[drawn->part_count] != NULL;
    done = take_line(drawn->parts + drawn->part_count++, chain) && done;
    break;
  }
  return done ? TP_OK : tp_fail_memory(message, "a drawing");
}

static bool take_objects(tp_drawn *drawn, const tp_drawing_choice *choice,
                         const tp_drawing *drawing) {
  drawn->objects = calloc((size_t)drawing->count + 1, sizeof *drawn->objects);
  bool done = drawn->objects != NULL;
  for (long k = 0; k < drawing->count && done; k++) {
    const tp_drawing_object *object = drawing->objects + k;
    tp_drawn_object *own = drawn->objects + drawn->object_count++;
    *own = (tp_drawn_object){.role = choice->objects[k],
                             .kind = object->kind,
                             .layer = strdup(object->layer),
                             .name = strdup(object->name),
                             .mark = object->line.mark,
                             .points = object->line.count,
                             .closed = object->closure == TP_DRAWING_CLOSED};
    for (long i = 0; i < object->line.count; i++) own->arcs += tp_drawing_bulge(object, i) != NULL;
    done = own->layer != NULL && own->name != NULL;
  }
  return done;
}

tp_status tp_drawn_make(tp_drawn *drawn, tp_drawing_choice *choice, const tp_drawing *drawing,
                        const tp_drawing_words *words, const tp_drawing_options *options,
                        const fmpq_t scale, tp_message *message) {
  const size_t count = (size_t)choice->chains.count + 1;
  drawn->holes = calloc(count, sizeof *drawn->holes);
  drawn->parts = calloc(count, sizeof *drawn->parts);
  drawn->part_words = calloc(count, sizeof *drawn->part_words);
  drawn->part_layers = calloc(count, sizeof *drawn->part_layers);
  const bool room = drawn->holes != NULL && drawn->parts != NULL && drawn->part_words != NULL &&
                    drawn->part_layers != NULL && take_objects(drawn, choice, drawing);
  tp_affine_map map;
  tp_affine_map_init(&map);
  tp_affine_map_scale(&map, scale, scale);
  tp_status status = room ? tp_notes_append(&drawn->notes, &drawing->notes, message)
                          : tp_fail_memory(message, "a drawing");
  if (status == TP_OK) status = tp_notes_append(&drawn->notes, &choice->chains.notes, message);
  for (long k = 0; k < choice->chains.count && status == TP_OK; k++) {
    status = take_chain(drawn, &choice->chains, choice->chains.objects + k, choice->roles[k],
                        choice->parts[k], words, options, &map, message);
  }
  tp_affine_map_clear(&map);
  if (status != TP_OK) tp_drawn_clear(drawn);
  return status;
}
