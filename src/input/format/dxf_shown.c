/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of the layers that are off or frozen, the test of an entity's layer, visibility and insert
 * against it, and the note on what was left out. */

#include "format/dxf_shown.h"

#include "common/grow.h"
#include "common/outside.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { NAME = 2, LAYER = 8, INVISIBLE = 60, COLOUR = 62, FLAGS = 70 };

bool tp_dxf_layer_add(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  enum { FROZEN = 1, WHITE = 7 };
  const tp_dxf_group *name = tp_dxf_find(entity, NAME);
  long flags = 0, colour = WHITE;
  if (name == NULL || !tp_dxf_whole(r, &flags, entity, FLAGS, 0) ||
      !tp_dxf_whole(r, &colour, entity, COLOUR, WHITE)) {
    return name == NULL;
  }
  if ((flags & FROZEN) == 0 && colour >= 0) return true;
  tp_dxf_layer *layers = tp_grow(r->layers, r->layer_count, &r->layer_room, sizeof *layers);
  if (layers == NULL) return tp_dxf_fail_memory(r);
  r->layers = layers;
  layers[r->layer_count++] = (tp_dxf_layer){.name = *name, .frozen = (flags & FROZEN) != 0};
  return true;
}

/* NULL: it is on and thawed. */
static tp_dxf_layer *find_hidden(const tp_dxf_reader *r, const char *name, size_t length) {
  for (long k = 0; k < r->layer_count; k++) {
    const tp_dxf_group *own = &r->layers[k].name;
    if (own->length == length && strncasecmp(own->text, name, length) == 0) return r->layers + k;
  }
  return NULL;
}

bool tp_dxf_shown(tp_dxf_reader *r, bool *shown, const tp_dxf_entity *entity, bool insert) {
  const tp_dxf_group *name = tp_dxf_find(entity, LAYER);
  const char *text = name != NULL ? name->text : "0";
  const size_t length = name != NULL ? name->length : 1;
  long invisible = 0;
  if (!tp_dxf_whole(r, &invisible, entity, INVISIBLE, 0)) return false;
  const bool follows = r->in_block && length == 1 && text[0] == '0';
  tp_dxf_layer *layer = follows ? NULL : find_hidden(r, text, length);
  *shown = invisible != 1 && (layer == NULL || (insert && !layer->frozen));
  if (*shown) return true;
  if (r->drawing->hidden++ == 0) r->first_hidden = entity->groups->line;
  if (invisible == 1) {
    r->invisible++;
  } else {
    layer->left_out++;
  }
  return true;
}

bool tp_dxf_shown_on(tp_dxf_reader *r, const char *name) {
  tp_dxf_layer *layer = find_hidden(r, name, strlen(name));
  if (layer == NULL) return true;
  if (r->drawing->hidden++ == 0) r->first_hidden = layer->name.line;
  layer->left_out++;
  return false;
}

/* "3 on layer 'OLD', which is frozen, 2 that are invisible" */
static void tell(char *text, size_t size, const tp_dxf_reader *r) {
  enum { MOST = 8 };
  size_t at = 0;
  long told = 0;
  text[0] = '\0';
  for (long k = 0; k < r->layer_count && at < size; k++) {
    const tp_dxf_layer *own = r->layers + k;
    if (own->left_out == 0 || told++ > MOST) continue;
    const int wrote =
        told > MOST
            ? snprintf(text + at, size - at, ", …")
            : snprintf(text + at, size - at, "%s%ld on layer '%s', which is %s", at > 0 ? ", " : "",
                       own->left_out, tp_quote_of(own->name.text, own->name.length).text,
                       own->frozen ? "frozen" : "off");
    at += wrote > 0 ? (size_t)wrote : 0;
  }
  if (r->invisible > 0 && at < size) {
    snprintf(text + at, size - at, "%s%ld invisible by %s own", at > 0 ? ", " : "", r->invisible,
             r->invisible == 1 ? "its" : "their");
  }
}

bool tp_dxf_shown_note(tp_dxf_reader *r) {
  char what[800];
  const long hidden = r->drawing->hidden;
  if (hidden == 0) return true;
  tell(what, sizeof what, r);
  r->status = tp_notes_add(
      &r->drawing->notes, r->message, TP_NOTE, (tp_place){r->drawing->path, r->first_hidden, 1},
      "%ld of the drawing's objects %s not shown and left out: %s; show what is meant", hidden,
      hidden == 1 ? "is" : "are", what);
  return r->status == TP_OK;
}
