/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points in space onto a vertical plane, exactly; distances from it are for the eye. */

#include "format/standing.h"

#include "common/outside.h"
#include "format/drawing_work.h"
#include "format/roles.h"
#include "number/between.h"
#include "number/ratio.h"
#include "plane/direction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS_OF_REACH = 10000 };

/* ---- onto the plane ----------------------------------------------------------------------------
 */

static void init(tp_standing *s) {
  fmpq *const all[] = {s->x, s->y, s->far_x, s->far_y, s->cosine, s->sine};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
  s->tolerance = 0;
}

static void clear(tp_standing *s) {
  fmpq *const all[] = {s->x, s->y, s->far_x, s->far_y, s->cosine, s->sine};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

static bool add_projected(const tp_standing *s, tp_drawing_object *object, const fmpq_t x,
                          const fmpq_t y, const fmpq_t z, tp_mark mark) {
  fmpq_t dx, dy, along, across;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_init(along);
  fmpq_init(across);
  fmpq_sub(dx, x, s->x);
  fmpq_sub(dy, y, s->y);
  fmpq_mul(along, s->cosine, dx);
  fmpq_addmul(along, s->sine, dy);
  fmpq_mul(across, s->cosine, dy);
  fmpq_submul(across, s->sine, dx);
  const double off = fabs(fmpq_get_d(across));
  if (off > object->rise->off) {
    object->rise->off = off;
    object->rise->off_mark = mark;
  }
  const bool done = tp_drawing_add_point(object, along, z, mark);
  fmpq_clear(dx);
  fmpq_clear(dy);
  fmpq_clear(along);
  fmpq_clear(across);
  return done;
}

bool tp_drawing_add_in_space(const tp_drawing *drawing, tp_drawing_object *object, const fmpq_t x,
                             const fmpq_t y, const fmpq_t z, tp_mark mark) {
  if (object->rise == NULL) object->rise = tp_rise_new(z);
  if (object->rise == NULL) return false;
  object->rise->changes = object->rise->changes || !fmpq_equal(z, object->rise->z);
  return drawing->standing != NULL ? add_projected(drawing->standing, object, x, y, z, mark)
                                   : tp_drawing_add_point(object, x, y, mark);
}

/* ---- the drawing -------------------------------------------------------------------------------
 */

static bool has_word(const tp_drawing_object *object, const tp_drawing_options *options) {
  return tp_drawing_role_by(options->words, object->layer, object->name) != TP_DRAWING_UNUSED;
}

/* Where no object is called the block, any can be. */
static bool any_counts(const tp_drawing *drawing, const tp_drawing_options *options) {
  if (options->words == NULL) return true;
  bool any = false;
  for (long k = 0; k < drawing->count && !any; k++) any = has_word(drawing->objects + k, options);
  return !any;
}

/* Through the first point of a line and the one that is farthest from it, of these from the western
 * or the southern one on, where that goes farther than what the plane went through before. */
static void set_plane(tp_standing *s, const tp_polyline *line) {
  double reach = 0;
  long farthest = 0;
  for (long k = 1; k < line->count; k++) {
    const double own =
        hypot(tp_ratio_apart(line->x + k, line->x), tp_ratio_apart(line->y + k, line->y));
    if (!(own > reach)) continue;
    reach = own;
    farthest = k;
  }
  if (!(reach / PARTS_OF_REACH > s->tolerance)) return;
  fmpq_t u, v;
  fmpq_init(u);
  fmpq_init(v);
  fmpq_sub(u, line->x + farthest, line->x);
  fmpq_sub(v, line->y + farthest, line->y);
  const bool turned = fmpq_sgn(u) < 0 || (fmpq_is_zero(u) && fmpq_sgn(v) < 0);
  const long from = turned ? farthest : 0, to = turned ? 0 : farthest;
  if (turned) {
    fmpq_neg(u, u);
    fmpq_neg(v, v);
  }
  fmpq_set(s->x, line->x + from);
  fmpq_set(s->y, line->y + from);
  fmpq_set(s->far_x, line->x + to);
  fmpq_set(s->far_y, line->y + to);
  tp_direction_unit(s->cosine, s->sine, u, v);
  s->tolerance = reach / PARTS_OF_REACH;
  fmpq_clear(u);
  fmpq_clear(v);
}

static bool find_plane(tp_standing *s, const tp_drawing *drawing,
                       const tp_drawing_options *options) {
  const bool any = any_counts(drawing, options);
  bool changes = false;
  for (long k = 0; k < drawing->count; k++) {
    const tp_drawing_object *object = drawing->objects + k;
    if (object->rise == NULL || !(any || has_word(object, options))) continue;
    changes = changes || object->rise->changes;
    set_plane(s, &object->line);
  }
  return changes && s->tolerance > 0;
}

/* "(12.5, 3)" */
static void write_spot(char *text, size_t size, const fmpq_t x, const fmpq_t y) {
  char own[2][64];
  tp_ratio_text(own[0], sizeof own[0], x);
  tp_ratio_text(own[1], sizeof own[1], y);
  snprintf(text, size, "(%s, %s)", own[0], own[1]);
}

static tp_status check_object(const tp_drawing *drawing, const tp_drawing_object *object,
                              tp_message *message) {
  const tp_standing *s = drawing->standing;
  char from[160], to[160];
  write_spot(from, sizeof from, s->x, s->y);
  write_spot(to, sizeof to, s->far_x, s->far_y);
  if (object->rise == NULL) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_drawing_place(object),
                     "this %s lies in x and y, and others stand in the vertical plane through %s "
                     "and %s on the map: draw all of the section in one of the two ways",
                     object->kind, from, to);
  }
  if (object->rise->off <= s->tolerance) return TP_OK;
  const tp_mark mark = object->rise->off_mark;
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, (tp_place){drawing->path, mark.line, mark.column},
      "z changes along the section, so that it stands upright, and this point lies %.4g beside its "
      "vertical plane, through %s and %s on the map; at most %.2g is projected onto it: draw the "
      "section in one vertical plane, or in x and y",
      object->rise->off, from, to, s->tolerance);
}

/* Clockwise from y, which points to the north. */
static double azimuth_deg(const tp_standing *s) {
  return atan2(fmpq_get_d(s->cosine), fmpq_get_d(s->sine)) * 45 / atan(1);
}

/* Lie all objects with a role there? */
static tp_status check(tp_drawing *drawing, const tp_drawing_options *options,
                       tp_message *message) {
  const bool any = any_counts(drawing, options);
  tp_status status = TP_OK;
  double off = 0;
  for (long k = 0; k < drawing->count && status == TP_OK; k++) {
    const tp_drawing_object *object = drawing->objects + k;
    if (!any && !has_word(object, options)) continue;
    if (any && object->rise == NULL) continue;
    status = check_object(drawing, object, message);
    if (object->rise != NULL) off = fmax(off, object->rise->off);
  }
  if (status != TP_OK) return status;
  char from[160], projected[60] = "";
  write_spot(from, sizeof from, drawing->standing->x, drawing->standing->y);
  if (off > 0)
    snprintf(projected, sizeof projected, "; points up to %.2g beside it are projected", off);
  return tp_notes_add(&drawing->notes, message, TP_NOTE, (tp_place){drawing->path, 0, 0},
                      "the section stands in a vertical plane: from %s on the map x runs towards "
                      "the azimuth %.2f°, and y is its z, so that 'frame: world' is how it lies%s",
                      from, azimuth_deg(drawing->standing), projected);
}

tp_status tp_standing_read(tp_drawing *drawing, tp_drawing_reader *read, const tp_text_file *file,
                           const tp_drawing_options *options, tp_message *message) {
  tp_standing standing;
  tp_status status = TP_OK;
  init(&standing);
  if (find_plane(&standing, drawing, options)) {
    const double allowed = tp_drawing_points_allowed(file->length);
    tp_drawing_clear(drawing);
    drawing->points_allowed = allowed;
    drawing->standing = &standing;
    status = read(drawing, file, options, message);
    if (status == TP_OK) status = check(drawing, options, message);
    drawing->standing = NULL;
  }
  clear(&standing);
  return status;
}
