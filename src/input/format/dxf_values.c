/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Values of the groups of an entity as exact numbers, whole numbers or texts, by group code; a
 * decimal comma is read as a point and noted once. */

#include "format/drawing_work.h"
#include "format/dxf_reader.h"
#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const tp_dxf_group *tp_dxf_find(const tp_dxf_entity *entity, int code) {
  for (size_t k = 1; k < entity->count; k++) {
    if (entity->groups[k].code == code) return entity->groups + k;
  }
  return NULL;
}

bool tp_dxf_says(const tp_dxf_group *group, const char *word) {
  return group->length == strlen(word) && memcmp(group->text, word, group->length) == 0;
}

bool tp_dxf_fail(tp_dxf_reader *reader, const tp_dxf_group *group, const char *what) {
  reader->status = tp_refuse(reader->message, TP_FAULT_FORMAT,
                             (tp_place){reader->drawing->path, group->line, 1}, "%s", what);
  return false;
}

bool tp_dxf_fail_memory(tp_dxf_reader *reader) {
  reader->status = tp_fail_memory(reader->message, "a drawing");
  return false;
}

bool tp_dxf_curve(tp_dxf_reader *reader, tp_drawing_object *object, tp_curve_outcome outcome) {
  if (outcome == TP_CURVE_NO_MEMORY) return tp_dxf_fail_memory(reader);
  if (outcome == TP_CURVE_TOO_FINE) {
    object->problem = TP_CURVE_TOO_FINE_TEXT;
  }
  const bool in_block = reader->in_block;
  reader->status =
      tp_drawing_count(in_block ? &reader->parts : reader->drawing, object, reader->message);
  return reader->status == TP_OK;
}

/* A line holds one number, so that a comma in it is a point; that is noted once. */
static bool read_comma(tp_dxf_reader *reader, fmpq_t value, const tp_dxf_group *group) {
  enum { LONGEST = 400 };
  char text[LONGEST];
  const char *problem = NULL;
  const char *comma = memchr(group->text, ',', group->length);
  if (comma == NULL || group->length >= LONGEST) return false;
  memcpy(text, group->text, group->length);
  text[comma - group->text] = '.';
  if (!tp_ratio_read_field(value, text, group->length, &problem)) return false;
  if (reader->comma) return true;
  reader->comma = true;
  reader->status = tp_notes_add(&reader->drawing->notes, reader->message, TP_NOTE,
                                (tp_place){reader->drawing->path, group->line, 1},
                                "numbers of this file have a decimal comma, read as a point");
  return reader->status == TP_OK;
}

bool tp_dxf_number(tp_dxf_reader *reader, fmpq_t value, const tp_dxf_group *group) {
  const char *problem = NULL;
  if (tp_ratio_read_field(value, group->text, group->length, &problem)) return true;
  if (read_comma(reader, value, group)) return true;
  if (reader->status != TP_OK) return false;
  char what[120];
  snprintf(what, sizeof what, "this entry %s; group %d is a number",
           problem != NULL ? problem : "is not a number", group->code);
  return tp_dxf_fail(reader, group, what);
}

bool tp_dxf_real(tp_dxf_reader *reader, fmpq_t value, const tp_dxf_entity *entity, int code,
                 long fallback) {
  const tp_dxf_group *group = tp_dxf_find(entity, code);
  if (group != NULL) return tp_dxf_number(reader, value, group);
  fmpq_set_si(value, fallback, 1);
  return true;
}

bool tp_dxf_whole(tp_dxf_reader *reader, long *value, const tp_dxf_entity *entity, int code,
                  long fallback) {
  enum { MOST = 1000000000 };
  const tp_dxf_group *group = tp_dxf_find(entity, code);
  *value = fallback;
  if (group == NULL) return true;
  fmpq_t number;
  fmpq_init(number);
  bool done = tp_dxf_number(reader, number, group);
  if (done && (!fmpz_is_one(fmpq_denref(number)) || fmpz_cmp_si(fmpq_numref(number), MOST) > 0 ||
               fmpz_cmp_si(fmpq_numref(number), -MOST) < 0)) {
    done = tp_dxf_fail(reader, group, "not a whole number of plausible size");
  }
  if (done) *value = fmpz_get_si(fmpq_numref(number));
  fmpq_clear(number);
  return done;
}

bool tp_dxf_extrusion(tp_dxf_reader *reader, int *side, const tp_dxf_entity *entity) {
  enum { X = 210, Y = 220, Z = 230 };
  fmpq_t x, y, z;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(z);
  const bool done = tp_dxf_real(reader, x, entity, X, 0) && tp_dxf_real(reader, y, entity, Y, 0) &&
                    tp_dxf_real(reader, z, entity, Z, 1);
  if (done) {
    *side = fmpq_is_zero(x) && fmpq_is_zero(y) ? fmpq_sgn(z) : 0;
  }
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(z);
  return done;
}

void tp_dxf_mirror(tp_drawing_object *object) {
  tp_polyline *line = &object->line;
  for (long k = 0; k < line->count; k++) fmpq_neg(line->x + k, line->x + k);
  for (long k = 0; k < object->bulge_room; k++) fmpq_neg(object->bulges + k, object->bulges + k);
}

tp_drawing_object *tp_dxf_add(tp_dxf_reader *reader, const char *kind,
                              const tp_dxf_entity *entity) {
  enum { LAYER = 8 };
  const tp_dxf_group *group = tp_dxf_find(entity, LAYER);
  char *layer = group != NULL ? strndup(group->text, group->length) : strdup("0");
  const char *block = "";
  char *name = NULL;
  if (reader->in_block) {
    const tp_dxf_group *own = &reader->blocks[reader->block_count - 1].name;
    name = strndup(own->text, own->length);
    block = name;
  }
  tp_drawing_object *object = NULL;
  if (layer != NULL && block != NULL) {
    object = tp_drawing_add(reader->in_block ? &reader->parts : reader->drawing, kind, layer, block,
                            (tp_mark){entity->groups->line, 1});
  }
  if (object == NULL) tp_dxf_fail_memory(reader);
  free(layer);
  free(name);
  return object;
}
