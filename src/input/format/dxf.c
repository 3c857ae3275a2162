/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A DXF file as groups, two lines each, and what is to be done with each entity. */

#include "format/dxf.h"

#include "common/grow.h"
#include "format/dxf_shown.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static tp_status fail(const tp_drawing *drawing, tp_message *message, int line, const char *what) {
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){drawing->path, line, line > 0 ? 1 : 0},
                   "%s", what);
}

/* ---- groups ------------------------------------------------------------------------------------
 */

typedef struct groups {
  tp_dxf_group *items;
  long count, room;
} groups;

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/* The next line without blanks around it; false at the end of the text. */
static bool next_line(const char **at, const char *end, const char **line, size_t *length) {
  if (*at == end) return false;
  const char *stop = memchr(*at, '\n', (size_t)(end - *at));
  const char *from = *at, *to = stop != NULL ? stop : end;
  *at = stop != NULL ? stop + 1 : end;
  while (from < to && is_blank(*from)) from++;
  while (to > from && is_blank(to[-1])) to--;
  *line = from;
  *length = (size_t)(to - from);
  return true;
}

static bool read_code(int *code, const char *text, size_t length) {
  enum { DIGITS = 4 };
  if (length > 1 && text[0] == '-') { /* of tools, for their own use */
    *code = -1;
    return true;
  }
  if (length == 0 || length > DIGITS) return false;
  *code = 0;
  for (size_t k = 0; k < length; k++) {
    if (!isdigit((unsigned char)text[k])) return false;
    *code = 10 * *code + (text[k] - '0');
  }
  return true;
}

static bool is_eof(const tp_dxf_group *group) {
  return group->code == 0 && tp_dxf_says(group, "EOF");
}

static tp_status split(groups *all, const tp_drawing *drawing, const tp_text_file *file,
                       tp_message *message) {
  const char *at = file->text, *end = file->text + file->length, *text = NULL;
  size_t length = 0;
  int line = 0;
  while (next_line(&at, end, &text, &length)) {
    tp_dxf_group group = {.line = line += 2};
    if (!read_code(&group.code, text, length)) {
      return fail(drawing, message, line - 1,
                  all->count == 0
                      ? "this is not a DXF: it does not begin with the code of a group, a number"
                      : "no code of a group, a number, where one belongs: a line is missing or "
                        "too many before this one");
    }
    if (!next_line(&at, end, &group.text, &group.length)) {
      return fail(drawing, message, line - 1, "the last group has no value; is the file cut off?");
    }
    tp_dxf_group *items = tp_grow(all->items, all->count, &all->room, sizeof *items);
    if (items == NULL) return tp_fail_memory(message, "a drawing");
    all->items = items;
    items[all->count++] = group;
    if (is_eof(&group)) return TP_OK;
  }
  return fail(drawing, message, line,
              "the file ends before its EOF; is it cut off? Export it again");
}

/* ---- the header --------------------------------------------------------------------------------
 */

/* By its code in $INSUNITS; NULL: no unit that Topple takes. */
static const char *unit_of(long code) {
  static const char *const units[] = {NULL, "in", "ft", NULL, "mm", "cm", "m", "km"};
  return code >= 0 && code < (long)(sizeof units / sizeof units[0]) ? units[code] : NULL;
}

static bool take_unit(tp_dxf_reader *r, const tp_dxf_entity *variable) {
  enum { CODE = 70 };
  long code = 0;
  if (!tp_dxf_whole(r, &code, variable, CODE, 0)) return false;
  r->drawing->unit = unit_of(code);
  r->drawing->unit_from = "its $INSUNITS, the units of a CAD program";
  if (code == 0 || r->drawing->unit != NULL) return true;
  const tp_place place = {r->drawing->path, variable->groups->line, 1};
  r->status = tp_notes_add(&r->drawing->notes, r->message, TP_NOTE, place,
                           "the file's $INSUNITS is %ld, none of in, ft, mm, cm, m, km", code);
  return r->status == TP_OK;
}

/* AC1009 is R12, AC1032 2018; what came between is read alike. */
static bool take_version(tp_dxf_reader *r, const tp_dxf_entity *variable) {
  enum { FIRST = 1009, LAST = 1032, PREFIX = 2, DIGITS = 4 };
  const tp_dxf_group *value = tp_dxf_find(variable, 1);
  int version = 0;
  if (value == NULL || value->length != PREFIX + DIGITS || memcmp(value->text, "AC", 2) != 0 ||
      !read_code(&version, value->text + PREFIX, DIGITS) || version < FIRST) {
    return tp_dxf_fail(r, value != NULL ? value : variable->groups,
                       "a version of DXF that is not read ($ACADVER); save it as DXF R12 "
                       "(AC1009) or any later one up to 2018 (AC1032)");
  }
  if (version <= LAST) return true;
  const tp_place place = {r->drawing->path, value->line, 1};
  r->status = tp_notes_add(&r->drawing->notes, r->message, TP_CAUTION, place,
                           "a version of DXF after 2018 (AC1032), read as if it were that; look "
                           "at the figure");
  return r->status == TP_OK;
}

/* ---- entities ----------------------------------------------------------------------------------
 */

/* Of a sheet of paper, not of the model. */
static bool is_of_paper(tp_dxf_reader *r, const tp_dxf_entity *entity, bool *paper) {
  enum { SPACE = 67 };
  long space = 0;
  *paper = false;
  if (!tp_dxf_whole(r, &space, entity, SPACE, 0)) return false;
  *paper = space == 1;
  return true;
}

static bool take_entity(tp_dxf_reader *r, tp_dxf_event event, const tp_dxf_entity *entity) {
  switch (event) {
  case TP_DXF_LINE:
    return tp_dxf_line(r, entity);
  case TP_DXF_LWPOLYLINE:
    return tp_dxf_light_polyline(r, entity);
  case TP_DXF_POLYLINE:
    return tp_dxf_polyline(r, entity);
  case TP_DXF_ARC:
    return tp_dxf_arc(r, entity);
  case TP_DXF_CIRCLE:
    return tp_dxf_circle(r, entity);
  case TP_DXF_ELLIPSE:
    return tp_dxf_ellipse(r, entity);
  case TP_DXF_SPLINE:
    return tp_dxf_spline(r, entity);
  case TP_DXF_INSERT:
    return tp_dxf_insert_add(r, entity);
  default:
    return true;
  }
}

static bool visit(void *context, tp_dxf_event event, const tp_dxf_group *items, size_t count) {
  tp_dxf_reader *r = context;
  const tp_dxf_entity entity = {items, count};
  bool paper = false, shown = true;
  switch (event) {
  case TP_DXF_LAYER:
    return tp_dxf_layer_add(r, &entity);
  case TP_DXF_VARIABLE:
    return tp_dxf_says(items, "$INSUNITS") ? take_unit(r, &entity) : take_version(r, &entity);
  case TP_DXF_BLOCK:
    return tp_dxf_block_begin(r, &entity);
  case TP_DXF_BLOCK_END:
    return tp_dxf_block_end(r);
  case TP_DXF_VERTEX:
    return tp_dxf_vertex(r, &entity);
  case TP_DXF_SEQUENCE_END:
    return tp_dxf_sequence_end(r);
  default:
    break;
  }
  if (!tp_dxf_sequence_end(r) || !is_of_paper(r, &entity, &paper)) return false;
  if (paper) return true;
  if (!tp_dxf_shown(r, &shown, &entity, event == TP_DXF_INSERT)) return false;
  return !shown || take_entity(r, event, &entity);
}

static tp_status read_groups(tp_dxf_reader *r, const groups *all) {
  const tp_geom_status visited = tp_dxf_visit(all->items, (size_t)all->count, visit, r);
  if (r->status != TP_OK) return r->status;
  if (visited == TP_GEOM_OUT_OF_MEMORY) return tp_fail_memory(r->message, "a drawing");
  if (visited != TP_GEOM_OK) {
    return fail(r->drawing, r->message, 0, "dxflib does not read this DXF; export it again");
  }
  if (!tp_dxf_sequence_end(r) || !tp_dxf_insert_all(r) || !tp_dxf_shown_note(r)) return r->status;
  return TP_OK;
}

static bool begins(const tp_text_file *file, const char *with) {
  const size_t length = strlen(with);
  return file->length >= length && memcmp(file->text, with, length) == 0;
}

static tp_status check_file(const tp_drawing *drawing, const tp_text_file *file,
                            tp_message *message) {
  if (begins(file, "AutoCAD Binary DXF")) {
    return fail(drawing, message, 0, "a binary DXF; save it as ASCII DXF");
  }
  if (begins(file, "AC10")) {
    return fail(drawing, message, 0, "a DWG, by its first bytes; save it as ASCII DXF");
  }
  if (memchr(file->text, '\0', file->length) != NULL) {
    return fail(drawing, message, 0, "not a text: it has zero bytes; save it as ASCII DXF");
  }
  if (!tp_dxf_is_there()) {
    return fail(drawing, message, 0,
                "this Topple was built without dxflib, which DXF is read with: install "
                "libdxflib-dev and build it again, or save the drawing as SVG");
  }
  return TP_OK;
}

tp_status tp_dxf_read(tp_drawing *drawing, const tp_text_file *file,
                      const tp_drawing_options *options, tp_message *message) {
  tp_status status = check_file(drawing, file, message);
  groups all = {NULL, 0, 0};
  if (status == TP_OK) status = split(&all, drawing, file, message);
  if (status == TP_OK) {
    tp_dxf_reader reader = {.drawing = drawing, .options = options, .message = message};
    tp_drawing_init(&reader.parts, drawing->path);
    reader.parts.points_allowed = drawing->points_allowed;
    fmpq_init(reader.height);
    status = read_groups(&reader, &all);
    tp_dxf_inserts_clear(&reader);
    free(reader.layers);
    tp_drawing_clear(&reader.parts);
    fmpq_clear(reader.height);
  }
  free(all.items);
  return status;
}
