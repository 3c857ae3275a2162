/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of a drawing's objects with layer, name, kind and role. */

#include "common/host.h"
#include "output/encode.h"
#include "scene/scene.h"

/* A column of text from outside: plain, and as wide as it says where it is no longer. */
static void add_column(tp_text *t, const char *text, int width) {
  const size_t before = t->length;
  tp_encode_plain(t, text);
  const int wrote = (int)(t->length - before);
  tp_text_add(t, "%*s", wrote < width ? width - wrote + 1 : 1, "");
}

static void add_object(tp_text *t, const tp_drawn_object *object) {
  tp_text_add(t, "  %6d  %-10s  ", object->mark.line, object->kind);
  add_column(t, object->layer, 12);
  add_column(t, object->name, 12);
  tp_text_add(t, "%6ld %4ld  %-6s  %s\n", object->points, object->arcs,
              object->closed ? "closed" : "open", tp_drawing_role_name(object->role));
}

tp_status tp_report_drawing(char **text, const tp_scene *scene) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, scene);
  const tp_drawn *drawn = scene->drawn;
  tp_text t = {0};
  tp_text_add(&t, "%s", "");
  if (drawn != NULL) {
    tp_text_add(&t, "\nThe drawing ");
    tp_encode_plain(&t, drawn->path);
    tp_text_add(&t, ", in %s: role of each of its objects\n", drawn->length_unit);
    tp_text_add(&t, "    line  object      layer        name         points arcs\n");
    for (long k = 0; k < drawn->object_count; k++) add_object(&t, drawn->objects + k);
  }
  return tp_text_finish(&t, text);
}
