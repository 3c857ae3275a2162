/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Elements of an SVG file read by expat with a stack of open groups: transforms, layers, visibility
 * and style are inherited, and shapes that are not shown are noted. */

#include "format/svg.h"

#include "common/grow.h"
#include "common/outside.h"
#include "format/svg_collect.h"
#include "format/svg_page.h"
#include "format/svg_seen.h"
#include "format/svg_shape.h"

#include <expat.h>
#include <stdlib.h>
#include <string.h>

/* An element that is open. */
typedef struct frame {
  tp_affine_map map;
  char *layer; /* of the nearest group with a label or an id; NULL: it is its parent's */
  tp_svg_seen seen;
} frame;

/* The first shape that is not shown. */
typedef struct hidden_shape {
  const char *kind, *why;
  tp_quote name;
  tp_place place;
} hidden_shape;

typedef struct reader {
  tp_drawing *drawing;
  const tp_text_file *file;
  const tp_drawing_options *options;
  tp_message *message;
  tp_status status;
  XML_Parser parser;
  frame *frames;
  long depth, room;
  tp_svg_sheets sheets;
  hidden_shape first_hidden;
  bool copies, clips; /* <use> was noted, and what clips */
} reader;

static tp_place place_here(const reader *r) {
  return (tp_place){r->drawing->path, (int)XML_GetCurrentLineNumber(r->parser),
                    (int)XML_GetCurrentColumnNumber(r->parser) + 1};
}

/* The first failure counts: the parser may tell a little more before it stops. */
static void stop(reader *r, tp_status status) {
  if (r->status == TP_OK) r->status = status;
  XML_StopParser(r->parser, XML_FALSE);
}

static void fail(reader *r, const char *what) {
  if (r->status != TP_OK) return;
  stop(r, tp_refuse(r->message, TP_FAULT_FORMAT, place_here(r), "%s", what));
}

static void fail_memory(reader *r) {
  if (r->status == TP_OK) stop(r, tp_fail_memory(r->message, "a drawing"));
}

/* ---- groups ------------------------------------------------------------------------------------
 */

static const char *label_of(const char *const *attributes) {
  const char *label = tp_svg_attribute(attributes, "inkscape:label");
  return label != NULL ? label : tp_svg_attribute(attributes, "id");
}

static frame *push(reader *r) {
  enum { DEEPEST = 256 };
  if (r->depth == DEEPEST) {
    fail(r, "elements nested deeper than 256");
    return NULL;
  }
  frame *frames = tp_grow(r->frames, r->depth, &r->room, sizeof *frames);
  if (frames == NULL) {
    fail_memory(r);
    return NULL;
  }
  r->frames = frames;
  frame *own = frames + r->depth++;
  *own = (frame){.layer = NULL};
  tp_affine_map_init(&own->map);
  if (r->depth > 1) {
    tp_affine_map_set(&own->map, &own[-1].map);
    own->seen = own[-1].seen;
  } else {
    fmpq_neg(own->map.d, own->map.d); /* y runs down in SVG */
  }
  return own;
}

static void pop(reader *r) {
  frame *own = r->frames + --r->depth;
  tp_affine_map_clear(&own->map);
  free(own->layer);
}

static const char *layer_here(const reader *r) {
  for (long k = r->depth - 1; k >= 0; k--) {
    if (r->frames[k].layer != NULL) return r->frames[k].layer;
  }
  return "";
}

/* ---- elements ----------------------------------------------------------------------------------
 */

/* Is what a transform turns about the origin, as it is where nothing is said? */
static bool is_about_origin(const tp_svg_value values[TP_SVG_PROPERTIES]) {
  const tp_svg_value origin = values[TP_SVG_ORIGIN], box = values[TP_SVG_BOX];
  const bool plain = origin.text == NULL || tp_svg_value_is(origin, "0") ||
                     tp_svg_value_is(origin, "0 0") || tp_svg_value_is(origin, "0px 0px");
  return plain && (box.text == NULL || tp_svg_value_is(box, "view-box"));
}

static bool transform(reader *r, frame *own, const char *const *attributes,
                      const tp_svg_value values[TP_SVG_PROPERTIES]) {
  const char *value = tp_svg_attribute(attributes, "transform");
  if (value == NULL) return true;
  if (!is_about_origin(values)) {
    fail(r, "a transform about another origin (transform-origin or transform-box), which is "
            "not read; let the drawing program apply it to the points, or write it as a matrix");
    return false;
  }
  tp_svg_text text = {value, value + strlen(value), NULL};
  if (tp_svg_transform(&own->map, &text)) return true;
  fail(r, text.problem != NULL ? text.problem : "has a transform that cannot be read");
  return false;
}

/* What moves or shapes an element by CSS alone. */
static bool check_moved(reader *r, bool shape, const tp_svg_value values[TP_SVG_PROPERTIES]) {
  const int end = shape ? TP_SVG_PROPERTIES : TP_SVG_SHAPES;
  for (int k = TP_SVG_MOVES; k < end; k++) {
    const bool idle = values[k].text == NULL || tp_svg_value_is(values[k], "none") ||
                      tp_svg_value_is(values[k], "auto");
    if (idle || r->status != TP_OK) continue;
    stop(r,
         tp_refuse(r->message, TP_FAULT_FORMAT, place_here(r),
                   "CSS moves or shapes this element by its '%s', which is not read; write it as "
                   "an attribute of SVG, or let the drawing program apply it to the points",
                   tp_svg_property_name(k)));
  }
  return r->status == TP_OK;
}

/* A drawing within a drawing has a frame of its own, and so has one that is stretched to fit. */
static bool check_frame(reader *r, const char *name, const char *const *attributes) {
  if (strcmp(name, "svg") != 0) return true;
  const char *fit = tp_svg_attribute(attributes, "preserveAspectRatio");
  if (r->depth > 1) {
    fail(r, "an <svg> within the drawing has separate coordinates, which are not read; ungroup it "
            "in the drawing program, or make a <g> of it");
  } else if (fit != NULL && strstr(fit, "none") != NULL &&
             tp_svg_attribute(attributes, "viewBox") != NULL) {
    fail(r, "preserveAspectRatio=\"none\" stretches x and y differently, which is not read; leave "
            "it out");
  }
  return r->status == TP_OK;
}

static void take_shape(reader *r, const char *kind, const frame *own,
                       const char *const *attributes) {
  const tp_place place = place_here(r);
  const char *problem = NULL;
  tp_svg_target target = {.drawing = r->drawing,
                          .kind = kind,
                          .layer = layer_here(r),
                          .name = label_of(attributes),
                          .mark = {place.line, place.column},
                          .options = r->options,
                          .message = r->message,
                          .map = &own->map};
  if (tp_svg_shape(&target, attributes, &problem)) return;
  if (target.status != TP_OK) {
    stop(r, target.status);
  } else if (problem == NULL || target.no_memory) {
    fail_memory(r);
  } else if (r->status == TP_OK) {
    stop(r, tp_refuse(r->message, TP_FAULT_FORMAT, place, "this %s %s", kind, problem));
  }
}

static void note(reader *r, tp_note_kind kind, bool *noted, const char *what) {
  if (*noted) return;
  *noted = true;
  const tp_status status =
      tp_notes_add(&r->drawing->notes, r->message, kind, place_here(r), "%s", what);
  if (status != TP_OK) stop(r, status);
}

static void leave_out(reader *r, const char *kind, const char *const *attributes, const char *why) {
  const char *name = label_of(attributes);
  if (r->drawing->hidden++ > 0) return;
  r->first_hidden =
      (hidden_shape){kind, why, tp_quote_all(name != NULL ? name : layer_here(r)), place_here(r)};
}

static tp_status note_hidden(const reader *r) {
  const hidden_shape *first = &r->first_hidden;
  const bool named = first->name.text[0] != '\0';
  if (r->drawing->hidden == 0) return TP_OK;
  return tp_notes_add(&r->drawing->notes, r->message, TP_NOTE, first->place,
                      "%ld of the drawing's shapes %s not shown and left out%s %s%s%s%s (%s); show "
                      "what is meant",
                      r->drawing->hidden, r->drawing->hidden == 1 ? "is" : "are",
                      r->drawing->hidden == 1 ? ", a" : ", the first of them a", first->kind,
                      named ? " '" : "", first->name.text, named ? "'" : "", first->why);
}

/* What an element is, within its frame, if it is seen. */
static void take(reader *r, const char *name, const frame *own, const char *const *attributes,
                 const tp_svg_value values[TP_SVG_PROPERTIES]) {
  const char *kind = tp_svg_shape_kind(name), *unseen = tp_svg_unseen(&own->seen);
  const bool clips = (values[TP_SVG_CLIP_PATH].text != NULL || values[TP_SVG_MASK].text != NULL) &&
                     !tp_svg_value_is(values[TP_SVG_CLIP_PATH], "none") &&
                     !tp_svg_value_is(values[TP_SVG_MASK], "none");
  if (kind != NULL && unseen != NULL) leave_out(r, kind, attributes, unseen);
  if (unseen != NULL) return;
  if (clips) {
    note(
        r, TP_CAUTION, &r->clips,
        "what clips or masks an element (clip-path, mask) is not applied: all of its shapes count");
  }
  if (kind != NULL) take_shape(r, kind, own, attributes);
  if (strcmp(name, "use") == 0) {
    note(r, TP_CAUTION, &r->copies,
         "copies of other elements (<use>) are left out; make objects of them in the drawing "
         "program");
  }
}

static void begin(void *context, const XML_Char *qualified, const XML_Char **given) {
  reader *r = context;
  const char *const *attributes = given;
  const char *name = tp_svg_local_name(qualified);
  if (r->status != TP_OK) return;
  if (r->depth == 0 && strcmp(name, "svg") != 0) {
    fail(r, "this is not an SVG: its first element is not <svg>");
    return;
  }
  tp_svg_value values[TP_SVG_PROPERTIES];
  tp_svg_property bad = TP_SVG_VISIBILITY;
  frame *own = push(r);
  if (own == NULL) return;
  if (r->depth == 1) r->drawing->page_unit_m = tp_svg_page_unit(attributes);
  tp_svg_style(values, &r->sheets, name, attributes);
  if (!tp_svg_seen_within(&own->seen, name, values, &bad)) {
    stop(r, tp_refuse(r->message, TP_FAULT_FORMAT, place_here(r), "its '%s' is not a value of CSS",
                      tp_svg_property_name(bad)));
    return;
  }
  if (strcmp(name, "g") == 0 && label_of(attributes) != NULL) {
    own->layer = strdup(label_of(attributes));
    if (own->layer == NULL) fail_memory(r);
  }
  if (own->seen.kept) return;
  if (own->seen.hidden == NULL && !(check_frame(r, name, attributes) &&
                                    check_moved(r, tp_svg_shape_kind(name) != NULL, values) &&
                                    transform(r, own, attributes, values))) {
    return;
  }
  take(r, name, own, attributes, values);
}

static void end(void *context, const XML_Char *name) {
  reader *r = context;
  (void)name;
  if (r->status == TP_OK && r->depth > 0) pop(r);
}

/* ---- what is never followed --------------------------------------------------------------------
 */

static const char entities[] = "has entities (&name;), which are not read; save it as plain SVG";

/* Is there an entity besides those that XML itself has? Expat leaves others out of attributes
 * without a word where a document type might have declared them. */
static bool has_entities(const tp_text_file *file) {
  static const char *const own[] = {"amp;", "lt;", "gt;", "quot;", "apos;", "#"};
  for (const char *at = strchr(file->text, '&'); at != NULL; at = strchr(at + 1, '&')) {
    bool known = false;
    for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) {
      known = known || strncmp(at + 1, own[k], strlen(own[k])) == 0;
    }
    if (!known) return true;
  }
  return false;
}

static void document_type(void *context, const XML_Char *name, const XML_Char *system,
                          const XML_Char *public, int internal) {
  reader *r = context;
  (void)name;
  (void)system;
  (void)public;
  if (internal != 0) {
    fail(r, "a document type definition (<!DOCTYPE … [ … ]>), with which entities come, is not "
            "read; save it as plain SVG");
  } else if (has_entities(r->file)) {
    fail(r, entities);
  }
}

static void skipped(void *context, const XML_Char *name, int parameter) {
  (void)name;
  (void)parameter;
  fail(context, entities);
}

static tp_status parse(reader *r) {
  XML_SetUserData(r->parser, r);
  XML_SetElementHandler(r->parser, begin, end);
  XML_SetStartDoctypeDeclHandler(r->parser, document_type);
  XML_SetSkippedEntityHandler(r->parser, skipped);
  const enum XML_Status parsed =
      XML_Parse(r->parser, r->file->text, (int)r->file->length, XML_TRUE);
  if (r->status != TP_OK) return r->status;
  if (parsed == XML_STATUS_OK) return TP_OK;
  const enum XML_Error error = XML_GetErrorCode(r->parser);
  if (error == XML_ERROR_NO_MEMORY) return tp_fail_memory(r->message, "a drawing");
  return tp_refuse(r->message, TP_FAULT_FORMAT, place_here(r), "not well-formed XML: %s",
                   XML_ErrorString(error));
}

tp_status tp_svg_read(tp_drawing *drawing, const tp_text_file *file,
                      const tp_drawing_options *options, tp_message *message) {
  reader r = {.drawing = drawing,
              .file = file,
              .options = options,
              .message = message,
              .parser = XML_ParserCreate("UTF-8")}; /* as the text is, whatever it says of itself */
  if (r.parser == NULL) return tp_fail_memory(message, "a drawing");
  tp_status status = tp_svg_collect(&r.sheets, drawing->path, file, message);
  if (status == TP_OK) status = parse(&r);
  if (status == TP_OK) status = note_hidden(&r);
  tp_svg_sheets_clear(&r.sheets);
  while (r.depth > 0) pop(&r);
  free(r.frames);
  XML_ParserFree(r.parser);
  return status;
}
