/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The elements of an SVG file, and the groups that they are in. */

#include "format/svg.h"

#include "format/svg_shape.h"
#include "grow.h"

#include <expat.h>
#include <stdlib.h>
#include <string.h>

/* An element that is open. */
typedef struct frame {
  tp_affine_map map;
  char *layer; /* of the nearest group with a label or an id; NULL: it is its parent's */
  bool hidden; /* nothing in it is drawn where it stands */
} frame;

typedef struct reader {
  tp_drawing *drawing;
  const tp_text_file *file;
  const tp_drawing_options *options;
  tp_message *message;
  tp_status status;
  XML_Parser parser;
  frame *frames;
  long depth, room;
  bool copies; /* <use> was noted */
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
  stop(r, tp_fail(r->message, TP_BAD_INPUT, place_here(r), "%s", what));
}

static void fail_memory(reader *r) {
  if (r->status == TP_OK) stop(r, tp_fail_memory(r->message, "a drawing"));
}

/* ---- groups ------------------------------------------------------------------------------------
 */

/* Without a prefix, as of "svg:path". */
static const char *local_name(const char *name) {
  const char *colon = strrchr(name, ':');
  return colon != NULL ? colon + 1 : name;
}

static const char *label_of(const char *const *attributes) {
  const char *label = tp_svg_attribute(attributes, "inkscape:label");
  return label != NULL ? label : tp_svg_attribute(attributes, "id");
}

/* What is kept to be used elsewhere, or not shown at all. */
static bool is_hidden(const char *name, const char *const *attributes) {
  static const char *const kept[] = {"defs",     "symbol",         "clipPath",
                                     "mask",     "marker",         "pattern",
                                     "metadata", "linearGradient", "radialGradient"};
  for (size_t k = 0; k < sizeof kept / sizeof kept[0]; k++) {
    if (strcmp(name, kept[k]) == 0) return true;
  }
  const char *display = tp_svg_attribute(attributes, "display");
  const char *style = tp_svg_attribute(attributes, "style");
  return (display != NULL && strcmp(display, "none") == 0) ||
         (style != NULL && strstr(style, "display:none") != NULL);
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
    own->hidden = own[-1].hidden;
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

static bool transform(reader *r, frame *own, const char *const *attributes) {
  const char *value = tp_svg_attribute(attributes, "transform");
  if (value == NULL) return true;
  tp_svg_text text = {value, value + strlen(value), NULL};
  if (tp_svg_transform(&own->map, &text)) return true;
  fail(r, text.problem != NULL ? text.problem : "has a transform that cannot be read");
  return false;
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
    stop(r, tp_fail(r->message, TP_BAD_INPUT, place, "this %s %s", kind, problem));
  }
}

static void note_copy(reader *r) {
  if (r->copies) return;
  r->copies = true;
  const tp_status status =
      tp_notes_add(&r->drawing->notes, r->message, TP_CAUTION, place_here(r),
                   "copies of other elements (<use>) are left out; make objects of them in the "
                   "drawing program");
  if (status != TP_OK) stop(r, status);
}

static void begin(void *context, const XML_Char *qualified, const XML_Char **given) {
  reader *r = context;
  const char *const *attributes = given;
  const char *name = local_name(qualified);
  if (r->status != TP_OK) return;
  if (r->depth == 0 && strcmp(name, "svg") != 0) {
    fail(r, "this is no SVG: its first element is not <svg>");
    return;
  }
  frame *own = push(r);
  if (own == NULL || !transform(r, own, attributes)) return;
  own->hidden = own->hidden || is_hidden(name, attributes);
  if (strcmp(name, "g") == 0 && label_of(attributes) != NULL) {
    own->layer = strdup(label_of(attributes));
    if (own->layer == NULL) fail_memory(r);
  }
  const char *kind = tp_svg_shape_kind(name);
  if (own->hidden) return;
  if (kind != NULL) take_shape(r, kind, own, attributes);
  if (strcmp(name, "use") == 0) note_copy(r);
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
    fail(r, "a document type of its own (<!DOCTYPE … [ … ]>), with which entities come, is not "
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
  return tp_fail(r->message, TP_BAD_INPUT, place_here(r), "no well-formed XML: %s",
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
  const tp_status status = parse(&r);
  while (r.depth > 0) pop(&r);
  free(r.frames);
  XML_ParserFree(r.parser);
  return status;
}
