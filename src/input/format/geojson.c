/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Read in one pass, without a tree. Arrays under "coordinates" hold numbers (a position), positions
 * (a ring or a line), or rings (a polygon); each of the second kind becomes an object as it ends,
 * and what the geometry is called, and the feature's properties, are given to its objects when they
 * are known, which may be later. */

#include "format/geojson.h"

#include "format/standing.h"
#include "geom/json_events.h"
#include "number/ratio.h"

#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 64, NUMBERS = 3, WORD = 32 };

/* An object or an array that is open. */
typedef struct level {
  bool array;
  bool nested;       /* an array with arrays in it */
  char key[WORD];    /* the last one in an object; long ones are none that matter */
  char type[WORD];   /* what "type" says */
  long first_object; /* of the drawing, that came in it */
  char *layer, *name;
} level;

typedef struct reader {
  tp_drawing *drawing;
  const char *text;
  size_t length;
  tp_message *message;
  tp_status status;
  level levels[DEEPEST];
  int depth;
  int coordinates; /* the level of the object whose "coordinates" are read; 0: none is */
  fmpq position[NUMBERS];
  fmpq_t height; /* of the first position of the object */
  int numbers;
  bool in_ring; /* the last object has a ring that is still open */
  long outer;   /* the first ring of the array that holds it; -1: this is it */
  size_t counted;
  int line; /* up to `counted` */
  size_t line_start;
} reader;

static tp_mark mark_at(reader *r, size_t at) {
  for (; r->counted < at; r->counted++) {
    if (r->text[r->counted] != '\n') continue;
    r->line++;
    r->line_start = r->counted + 1;
  }
  return (tp_mark){r->line, (int)(r->counted - r->line_start) + 1};
}

static bool fail(reader *r, size_t at, const char *what) {
  const tp_mark mark = mark_at(r, at);
  r->status = tp_refuse(r->message, TP_FAULT_FORMAT,
                        (tp_place){r->drawing->path, mark.line, mark.column}, "%s", what);
  return false;
}

static bool fail_memory(reader *r) {
  r->status = tp_fail_memory(r->message, "a drawing");
  return false;
}

static level *top(reader *r) {
  return r->levels + r->depth;
}

/* ---- coordinates -------------------------------------------------------------------------------
 */

/* Within the array under "coordinates", not beside it. */
static bool in_coordinates(const reader *r) {
  return r->coordinates > 0 && r->depth > r->coordinates &&
         strcmp(r->levels[r->coordinates].key, "coordinates") == 0;
}

/* Anything but a number, where one belongs. */
static bool refuse_other(reader *r, const tp_json_event *e) {
  return fail(r, e->at - e->length,
              "coordinates are numbers, not texts, null, true, false or maps: [x, y]");
}

static bool take_number(reader *r, const tp_json_event *e) {
  const char *problem = NULL;
  if (!in_coordinates(r)) return true;
  if (top(r)->nested) return refuse_other(r, e);
  if (r->numbers == NUMBERS) return true; /* a measure, which RFC 7946 has readers ignore */
  if (tp_ratio_read_field(r->position + r->numbers, e->text, e->length, &problem)) {
    r->numbers++;
    return true;
  }
  char what[120];
  snprintf(what, sizeof what, "this number %s", problem);
  return fail(r, e->at - e->length, what);
}

static bool add_position(reader *r, size_t at) {
  if (r->numbers == 1) return fail(r, at, "a position has two numbers, x and y");
  const tp_mark mark = mark_at(r, at);
  if (!r->in_ring) {
    tp_drawing_object *object = tp_drawing_add(r->drawing, "", NULL, NULL, mark);
    if (object == NULL) return fail_memory(r);
    object->ring_of = r->outer;
    if (r->outer < 0) r->outer = r->drawing->count - 1;
    r->in_ring = true;
    fmpq_set(r->height, r->position + 2);
    if (r->numbers < NUMBERS) fmpq_zero(r->height);
  }
  tp_drawing_object *object = r->drawing->objects + r->drawing->count - 1;
  if (r->numbers < NUMBERS) fmpq_zero(r->position + 2);
  if (r->drawing->standing == NULL && !fmpq_equal(r->position + 2, r->height)) {
    object->problem = "has a z that changes along it; a section is drawn in x and y, so give it "
                      "these two alone";
  }
  r->numbers = 0;
  return tp_drawing_add_in_space(r->drawing, object, r->position, r->position + 1, r->position + 2,
                                 mark) ||
         fail_memory(r);
}

/* The end of a position, of a ring, or of a polygon. */
static bool end_array(reader *r, const tp_json_event *e) {
  if (!in_coordinates(r)) return true;
  if (r->numbers > 0) return add_position(r, e->at);
  if (r->in_ring) {
    r->in_ring = false;
  } else {
    r->outer = -1;
  }
  return true;
}

/* ---- geometries and features -------------------------------------------------------------------
 */

static bool is_in(const char *word, const char *const *words) {
  for (; *words != NULL; words++) {
    if (strcmp(word, *words) == 0) return true;
  }
  return false;
}

/* What the objects of a geometry are: rings of polygons, lines, or points, which are no outlines.
 */
static bool end_geometry(reader *r, const level *own) {
  static const char *const polygons[] = {"Polygon", "MultiPolygon", NULL};
  static const char *const lines[] = {"LineString", "MultiLineString", NULL};
  const bool polygon = is_in(own->type, polygons), line = is_in(own->type, lines);
  while (!polygon && !line && r->drawing->count > own->first_object) tp_drawing_drop(r->drawing);
  for (long k = own->first_object; k < r->drawing->count; k++) {
    tp_drawing_object *object = r->drawing->objects + k;
    object->kind = polygon ? "Polygon" : "LineString";
    tp_drawing_tidy(object);
    if (polygon) object->closure = TP_DRAWING_CLOSED;
    if (line) object->ring_of = -1;
  }
  return true;
}

static bool give(char **text, const char *given) {
  if (given == NULL || **text != '\0') return true;
  char *copy = strdup(given);
  if (copy == NULL) return false;
  free(*text);
  *text = copy;
  return true;
}

static bool end_object(reader *r) {
  level *own = top(r);
  bool done = true;
  if (r->coordinates == r->depth) {
    done = end_geometry(r, own);
    r->coordinates = 0;
  }
  if (strcmp(own->type, "Feature") == 0) {
    for (long k = own->first_object; k < r->drawing->count && done; k++) {
      done = give(&r->drawing->objects[k].layer, own->layer) &&
             give(&r->drawing->objects[k].name, own->name);
    }
  }
  return done || fail_memory(r);
}

/* The name of a coordinate reference system in degrees, {"crs": {"properties": {"name": …}}}. */
static bool is_of_globe(reader *r, const tp_json_event *e) {
  const level *own = top(r);
  return r->depth > 2 && strcmp(own->key, "name") == 0 && strcmp(own[-1].key, "properties") == 0 &&
         strcmp(own[-2].key, "crs") == 0 &&
         (strstr(e->text, "CRS84") != NULL || strstr(e->text, "EPSG:4326") != NULL ||
          strstr(e->text, "EPSG::4326") != NULL);
}

/* A text of "properties" is the feature's, and a feature may have an id. */
static bool take_string(reader *r, const tp_json_event *e) {
  level *own = top(r);
  if (in_coordinates(r)) return refuse_other(r, e);
  if (own->array) return true;
  if (is_of_globe(r, e)) {
    return fail(r, e->at - e->length,
                "its coordinates are degrees on the globe ('crs'), which are not lengths: give x "
                "along the section and y upwards");
  }
  if (strcmp(own->key, "type") == 0 && e->length < WORD) strcpy(own->type, e->text);
  level *feature = r->depth > 1 && strcmp(own[-1].key, "properties") == 0 ? own - 1 : own;
  const bool is_id = feature == own && strcmp(own->key, "id") == 0;
  char **to = feature != own && strcmp(own->key, "layer") == 0             ? &feature->layer
              : (feature != own && strcmp(own->key, "name") == 0) || is_id ? &feature->name
                                                                           : NULL;
  if (to == NULL) return true;
  free(*to);
  *to = strdup(e->text);
  return *to != NULL || fail_memory(r);
}

static bool begin(reader *r, const tp_json_event *e, bool array) {
  if (r->depth + 1 == DEEPEST) return fail(r, e->at, "nested deeper than 63");
  if (in_coordinates(r) && (!array || r->numbers > 0)) return refuse_other(r, e);
  const level *outer = top(r);
  if (array && r->coordinates == 0 && r->depth > 0 && !outer->array &&
      strcmp(outer->key, "coordinates") == 0) {
    r->coordinates = r->depth;
    r->in_ring = false;
    r->outer = -1;
    r->numbers = 0;
  }
  top(r)->nested = array && top(r)->array;
  r->depth++;
  *top(r) = (level){.array = array, .first_object = r->drawing->count};
  return true;
}

static void end(reader *r) {
  free(top(r)->layer);
  free(top(r)->name);
  r->depth--;
}

static bool visit(void *context, const tp_json_event *e) {
  reader *r = context;
  bool done = true;
  switch (e->kind) {
  case TP_JSON_EVENT_NUMBER:
    return take_number(r, e);
  case TP_JSON_EVENT_STRING:
    return take_string(r, e);
  case TP_JSON_EVENT_KEY:
    strcpy(top(r)->key, e->length < WORD && strlen(e->text) == e->length ? e->text : "");
    return true;
  case TP_JSON_EVENT_OTHER:
    return !in_coordinates(r) || refuse_other(r, e);
  case TP_JSON_EVENT_OBJECT:
    return begin(r, e, false);
  case TP_JSON_EVENT_ARRAY:
    return begin(r, e, true);
  case TP_JSON_EVENT_OBJECT_END:
    done = end_object(r);
    break;
  case TP_JSON_EVENT_ARRAY_END:
    done = end_array(r, e);
    break;
  }
  end(r);
  return done;
}

static tp_status read_text(reader *r) {
  const char *problem = NULL;
  size_t at = 0;
  const tp_geom_status visited = tp_json_visit(r->text, r->length, visit, r, &problem, &at);
  while (r->depth > 0) end(r);
  if (r->status != TP_OK) return r->status;
  if (visited != TP_GEOM_OK) return tp_fail_memory(r->message, "a drawing");
  if (problem == NULL) return TP_OK;
  r->counted = r->line_start = 0;
  r->line = 1;
  fail(r, at, problem);
  return r->status;
}

tp_status tp_geojson_read(tp_drawing *drawing, const tp_text_file *file,
                          const tp_drawing_options *options, tp_message *message) {
  (void)options; /* no curves */
  const tp_place whole = {drawing->path, 0, 0};
  if (!tp_json_events_are_there()) {
    return tp_refuse(message, TP_FAULT_FORMAT, whole,
                     "this Topple was built without RapidJSON, which GeoJSON is read with: install "
                     "rapidjson-dev and build it again, or save the drawing as WKT");
  }
  if (memchr(file->text, '\0', file->length) != NULL) {
    return tp_refuse(message, TP_FAULT_FORMAT, whole, "not a text: it has zero bytes");
  }
  reader r = {.drawing = drawing,
              .text = file->text,
              .length = file->length,
              .message = message,
              .line = 1,
              .outer = -1};
  for (int k = 0; k < NUMBERS; k++) fmpq_init(r.position + k);
  fmpq_init(r.height);
  const tp_status status = read_text(&r);
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(r.position + k);
  fmpq_clear(r.height);
  return status;
}
