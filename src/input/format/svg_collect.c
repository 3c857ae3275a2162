/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* First pass over the file with expat: the text of every style element is parsed as a sheet; sheets
 * outside the file and entities are refused. */

#include "format/svg_collect.h"

#include "format/svg_shape.h"
#include "output/text.h"

#include <expat.h>
#include <string.h>

typedef struct collector {
  tp_svg_sheets *sheets;
  const char *path;
  tp_message *message;
  tp_status status;
  XML_Parser parser;
  bool within; /* a <style> */
  tp_text text;
  tp_place begin; /* of its text */
} collector;

const char *tp_svg_local_name(const char *name) {
  const char *colon = strrchr(name, ':');
  return colon != NULL ? colon + 1 : name;
}

static tp_place place_here(const collector *c) {
  return (tp_place){c->path, (int)XML_GetCurrentLineNumber(c->parser),
                    (int)XML_GetCurrentColumnNumber(c->parser) + 1};
}

static void stop(collector *c, tp_status status) {
  if (c->status == TP_OK) c->status = status;
  XML_StopParser(c->parser, XML_FALSE);
}

/* A place in the text of the sheet. */
static tp_place place_in(const collector *c, size_t at) {
  tp_place place = c->begin;
  for (size_t k = 0; k < at && k < c->text.length; k++) {
    place.column++;
    if (c->text.data[k] != '\n') continue;
    place.line++;
    place.column = 1;
  }
  return place;
}

static void begin(void *context, const XML_Char *name, const XML_Char **given) {
  collector *c = context;
  const char *const *attributes = given;
  if (strcmp(tp_svg_local_name(name), "style") != 0 || c->status != TP_OK) return;
  const char *type = tp_svg_attribute(attributes, "type");
  const char *medium = tp_svg_attribute(attributes, "media");
  if (type != NULL && strcmp(type, "text/css") != 0) return;
  if (medium != NULL && strcmp(medium, "all") != 0 && strcmp(medium, "screen") != 0) {
    stop(c, tp_refuse(c->message, TP_FAULT_FORMAT, place_here(c),
                      "a style sheet for one medium alone is not read; save as plain SVG"));
  }
  c->within = true;
  c->begin = (tp_place){c->path, 0, 0};
}

static void take_text(void *context, const XML_Char *text, int length) {
  collector *c = context;
  if (!c->within || c->status != TP_OK) return;
  if (c->begin.line == 0) c->begin = place_here(c);
  tp_text_append(&c->text, text, (size_t)length);
}

static void end(void *context, const XML_Char *name) {
  collector *c = context;
  if (!c->within || c->status != TP_OK || strcmp(tp_svg_local_name(name), "style") != 0) return;
  c->within = false;
  const char *problem = NULL;
  size_t at = 0;
  tp_svg_sheet_outcome outcome = TP_SVG_SHEET_DONE;
  if (c->text.failed) {
    outcome = TP_SVG_SHEET_NO_MEMORY;
  } else if (c->text.data != NULL) {
    outcome = tp_svg_sheets_add(c->sheets, c->text.data, &problem, &at);
  }
  if (outcome == TP_SVG_SHEET_NO_MEMORY) stop(c, tp_fail_memory(c->message, "a drawing"));
  if (outcome == TP_SVG_SHEET_REFUSED) {
    stop(c, tp_refuse(c->message, TP_FAULT_FORMAT, place_in(c, at), "%s", problem));
  }
  tp_text_drop(&c->text);
}

/* With entities: the reader of elements refuses it. */
static void take_document_type(void *context, const XML_Char *name, const XML_Char *system,
                               const XML_Char *public, int internal) {
  const collector *c = context;
  (void)name;
  (void)system;
  (void)public;
  if (internal != 0) XML_StopParser(c->parser, XML_FALSE);
}

/* A sheet that the file names, by <?xml-stylesheet …?>. */
static void take_instruction(void *context, const XML_Char *target, const XML_Char *data) {
  collector *c = context;
  (void)data;
  if (strcmp(target, "xml-stylesheet") != 0 || c->status != TP_OK) return;
  stop(c, tp_refuse(c->message, TP_FAULT_FORMAT, place_here(c),
                    "a style sheet in another file is not opened, and might hide or move shapes; "
                    "save as plain SVG"));
}

tp_status tp_svg_collect(tp_svg_sheets *sheets, const char *path, const tp_text_file *file,
                         tp_message *message) {
  if (strstr(file->text, "style") == NULL) return TP_OK;
  collector c = {
      .sheets = sheets, .path = path, .message = message, .parser = XML_ParserCreate("UTF-8")};
  if (c.parser == NULL) return tp_fail_memory(message, "a drawing");
  XML_SetUserData(c.parser, &c);
  XML_SetElementHandler(c.parser, begin, end);
  XML_SetCharacterDataHandler(c.parser, take_text);
  XML_SetStartDoctypeDeclHandler(c.parser, take_document_type);
  XML_SetProcessingInstructionHandler(c.parser, take_instruction);
  const enum XML_Status parsed = XML_Parse(c.parser, file->text, (int)file->length, XML_TRUE);
  if (parsed != XML_STATUS_OK && c.status == TP_OK &&
      XML_GetErrorCode(c.parser) == XML_ERROR_NO_MEMORY) {
    c.status = tp_fail_memory(message, "a drawing");
  }
  tp_text_drop(&c.text);
  XML_ParserFree(c.parser);
  return c.status;
}
