/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Groups of DXF, release 12: a code on a line, its value on the next. Coordinates are the shortest
 * decimals that name their doubles, so that a reader has the same. Text is ASCII: what is not is
 * written by its code point, \U+XXXX. The unit ($INSUNITS) is of a later release; readers of this
 * one pass over it. */

#include "figure/dxf.h"
#include "number/shortest.h"
#include "output/encode.h"

#include <math.h>
#include <string.h>

static const struct {
  const char *name;
  int colour; /* of AutoCAD's index */
} layers[TP_CAD_LAYERS] = {{"BLOCK", 7},     {"HOLE", 8},  {"PART", 2},  {"BASE", 8},
                           {"CONTACT", 3},   {"WATER", 4}, {"BOLTS", 6}, {"FORCES", 1},
                           {"MECHANISM", 5}, {"TEXT", 7}};

static void add_group(tp_text *t, int code, const char *value) {
  tp_text_add(t, "%3d\n%s\n", code, value);
}

static void add_number(tp_text *t, int code, double value) {
  char n[TP_SHORTEST_SIZE];
  add_group(t, code, tp_shortest(n, value));
}

static void add_whole(tp_text *t, int code, int value) {
  tp_text_add(t, "%3d\n%6d\n", code, value);
}

/* `first` is the code of x: 10, and 11 for a second point. */
static void add_point(tp_text *t, int first, tp_spot at) {
  add_number(t, first, at.x);
  add_number(t, first + 10, at.y);
  add_number(t, first + 20, 0);
}

static void add_entity(tp_text *t, const char *kind, tp_cad_layer layer) {
  add_group(t, 0, kind);
  add_group(t, 8, layers[layer].name);
}

static int code_of_unit(const char *unit) {
  static const struct {
    const char *unit;
    int code;
  } codes[] = {{"in", 1}, {"ft", 2}, {"mm", 4}, {"cm", 5}, {"m", 6}, {"km", 7}};
  for (size_t k = 0; k < sizeof codes / sizeof codes[0]; k++) {
    if (strcmp(codes[k].unit, unit) == 0) return codes[k].code;
  }
  return 0;
}

static void begin_section(tp_text *t, const char *name) {
  add_group(t, 0, "SECTION");
  add_group(t, 2, name);
}

void tp_cad_begin(tp_text *t, const char *unit) {
  add_group(t, 999, "topple " TP_VERSION);
  begin_section(t, "HEADER");
  add_group(t, 9, "$ACADVER");
  add_group(t, 1, "AC1009");
  add_group(t, 9, "$INSUNITS");
  add_whole(t, 70, code_of_unit(unit));
  add_group(t, 0, "ENDSEC");
  begin_section(t, "TABLES");
  add_group(t, 0, "TABLE");
  add_group(t, 2, "LAYER");
  add_whole(t, 70, TP_CAD_LAYERS);
  for (int k = 0; k < TP_CAD_LAYERS; k++) {
    add_group(t, 0, "LAYER");
    add_group(t, 2, layers[k].name);
    add_whole(t, 70, 0);
    add_whole(t, 62, layers[k].colour);
    add_group(t, 6, "CONTINUOUS");
  }
  add_group(t, 0, "ENDTAB");
  add_group(t, 0, "ENDSEC");
  begin_section(t, "ENTITIES");
}

void tp_cad_end(tp_text *t) {
  add_group(t, 0, "ENDSEC");
  add_group(t, 0, "EOF");
}

void tp_cad_polyline(tp_text *t, tp_cad_layer layer, bool closed) {
  add_entity(t, "POLYLINE", layer);
  add_whole(t, 66, 1); /* vertices follow */
  add_point(t, 10, (tp_spot){0, 0});
  add_whole(t, 70, closed ? 1 : 0);
}

void tp_cad_vertex(tp_text *t, tp_cad_layer layer, tp_spot at, double bulge) {
  add_entity(t, "VERTEX", layer);
  add_point(t, 10, at);
  if (bulge != 0) add_number(t, 42, bulge);
}

void tp_cad_polyline_end(tp_text *t, tp_cad_layer layer) {
  add_entity(t, "SEQEND", layer);
}

void tp_cad_line(tp_text *t, tp_cad_layer layer, tp_spot from, tp_spot to) {
  add_entity(t, "LINE", layer);
  add_point(t, 10, from);
  add_point(t, 11, to);
}

void tp_cad_arrow(tp_text *t, tp_cad_layer layer, tp_spot tail, tp_spot tip) {
  const double share = 0.15, slope = 0.35; /* of the head to the arrow, and of its half width */
  const tp_spot back = {share * (tail.x - tip.x), share * (tail.y - tip.y)};
  if (tail.x == tip.x && tail.y == tip.y) return;
  tp_cad_line(t, layer, tail, tip);
  for (int side = -1; side <= 1; side += 2) {
    tp_cad_line(
        t, layer, tip,
        (tp_spot){tip.x + back.x - side * slope * back.y, tip.y + back.y + side * slope * back.x});
  }
}

void tp_cad_circle(tp_text *t, tp_cad_layer layer, tp_spot centre, double radius) {
  add_entity(t, "CIRCLE", layer);
  add_point(t, 10, centre);
  add_number(t, 40, radius);
}

/* The code point that begins there, and how many bytes it takes; the text is UTF-8. */
static unsigned code_point(const char *text, size_t *size) {
  const unsigned char first = (unsigned char)text[0];
  const size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  unsigned code = more == 0 ? first : first & (0x3fU >> more);
  for (size_t k = 1; k <= more; k++) code = code << 6 | ((unsigned char)text[k] & 0x3fU);
  *size = 1 + more;
  return code;
}

static void add_words(tp_text *t, const char *words) {
  size_t size = 1;
  for (const char *c = words; *c != '\0'; c += size) {
    const unsigned code = code_point(c, &size);
    if (code < 0x80) {
      tp_text_append(t, c, 1);
    } else {
      tp_text_add(t, code <= 0xffff ? "\\U+%04X" : "?", code);
    }
  }
}

void tp_cad_text(tp_text *t, tp_cad_layer layer, tp_spot at, double height, const char *words) {
  tp_text plain = {0};
  tp_encode_plain(&plain, words);
  add_entity(t, "TEXT", layer);
  add_point(t, 10, at);
  add_number(t, 40, height);
  tp_text_add(t, "%3d\n", 1);
  if (plain.data != NULL) add_words(t, plain.data);
  tp_text_add(t, "\n");
  t->failed = t->failed || plain.failed;
  tp_text_drop(&plain);
}
