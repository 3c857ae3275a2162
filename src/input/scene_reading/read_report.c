/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key report of a scene: letterhead, language, decimal sign and extent of its calculation
 * sheet. The logo is looked at here, so that a report is refused before anything is solved. */

#include "scene_reading/read.h"

#include "common/outside.h"
#include "document/logo.h"
#include "terms/phrases.h"

#include <string.h>

/* Longer ones are no line of a letterhead. */
enum { LONGEST = 200 };

static tp_status read_text(char **text, const tp_reader *reader, const tp_node *node,
                           const char *key) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SCALAR) {
    return tp_read_fail(reader, TP_FAULT_KEY, node, "'%s' of a report must be text", key);
  }
  if (strlen(node->text) > LONGEST) {
    return tp_read_fail(reader, TP_FAULT_RANGE, node,
                        "'%s' of a report has at most %d bytes, so that it fits on the page", key,
                        LONGEST);
  }
  *text = strdup(node->text);
  return *text != NULL ? TP_OK : tp_fail_memory(reader->message, "the letterhead");
}

static tp_status read_language(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  const char *code = node->kind == TP_NODE_SCALAR ? node->text : "";
  reader->scene->letterhead.language = tp_language_find(code);
  if (reader->scene->letterhead.language != NULL) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node, "'%s' is no language of reports; known are: %s",
                      tp_quote_all(code).text, tp_language_codes);
}

static tp_status read_decimal(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  const char *word = node->kind == TP_NODE_SCALAR ? node->text : "";
  if (tp_decimal_sign_read(&reader->scene->letterhead.decimal, word)) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node, "decimal must be point or comma, not '%s'",
                      tp_quote_all(word).text);
}

/* A name that the file has already, of a scene that is read again. */
static const char *known_name(const tp_scene_file *file, const char *name) {
  const size_t length = strlen(name);
  for (long k = 0; k < file->name_count; k++) {
    const size_t own = strlen(file->names[k]);
    if (own >= length && strcmp(file->names[k] + own - length, name) == 0) return file->names[k];
  }
  return NULL;
}

static tp_status read_logo(const tp_reader *reader, const tp_node *node) {
  tp_letterhead *own = &reader->scene->letterhead;
  tp_scene_file *file = reader->scene->file;
  tp_logo logo = {0};
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SCALAR || node->text[0] == '\0') {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "logo is the name of a PNG, JPEG or SVG file beside the scene");
  }
  const bool again = reader->reading->again;
  const char *path = again ? known_name(file, node->text) : tp_scene_file_name(file, node->text);
  own->logo = path != NULL ? strdup(path) : NULL;
  if (own->logo == NULL) return tp_fail_memory(reader->message, "the letterhead");
  own->logo_place = tp_node_place(node, reader->scene->path);
  if (again) return TP_OK;
  const tp_status status = tp_logo_read(&logo, own->logo, own->logo_place, reader->message);
  tp_logo_clear(&logo);
  return status;
}

tp_status tp_read_report(const tp_reader *reader, const tp_node *node) {
  tp_letterhead *own = &reader->scene->letterhead;
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_report, "report");
  for (int k = 0; k < TP_LETTERHEAD_TEXTS && status == TP_OK; k++) {
    const char *key = tp_letterhead_key((tp_letterhead_text)k);
    status = read_text(own->texts + k, reader, tp_node_get(node, key), key);
  }
  if (status == TP_OK) status = read_language(reader, tp_node_get(node, "language"));
  if (status == TP_OK) status = read_decimal(reader, tp_node_get(node, "decimal"));
  const tp_node *appendix = tp_node_get(node, "appendix");
  if (status == TP_OK && appendix != NULL) {
    bool whole = true;
    status = tp_read_bool(reader, &whole, appendix, "appendix");
    own->brief = !whole;
  }
  return status == TP_OK ? read_logo(reader, tp_node_get(node, "logo")) : status;
}
