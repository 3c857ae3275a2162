/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A place in such a file is the number of a feature in its layer and of a point in its line. */

#include "format/gis.h"

#include "common/outside.h"
#include "format/gis_library.h"
#include "number/ratio.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum { MOST_POINTS = 10000000 };

typedef struct taking {
  tp_drawing *drawing;
  tp_message *message;
  tp_status status;
  long outer;          /* the outer ring that came last */
  size_t points;       /* so far */
  bool plane, degrees; /* are there layers in lengths, or in none */
  bool feet;           /* of the US survey */
  double metres;       /* of the first layer with lengths; 0: none yet */
  fmpq_t x, y, scale;
} taking;

static bool fail(taking *t, const tp_gis_part *part, const char *what) {
  t->status = tp_refuse(t->message, TP_FAULT_FORMAT, (tp_place){t->drawing->path, 0, 0},
                        "feature %ld of the layer '%s' %s", part->feature,
                        tp_quote_all(part->layer).text, what);
  return false;
}

/* ---- units -------------------------------------------------------------------------------------
 */

/* The names of the factors that are doubles as their definitions round to. */
static const char *name_of(double metres) {
  static const struct {
    double metres;
    const char *name;
  } units[] = {{1, "m"}, {0.3048, "ft"}, {0.001, "mm"}, {0.01, "cm"}, {1000, "km"}, {0.0254, "in"}};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (metres == units[k].metres) return units[k].name;
  }
  return NULL;
}

/* Of the US survey, 1200/3937 m, which files have to 10 digits or more; the international one is
 * 2e-6 of it less. */
static bool is_survey_foot(double metres) {
  return fabs(metres * 3937 / 1200 - 1) < 1e-9;
}

/* All layers are of one unit. Survey feet become metres, exactly. */
static bool take_unit(taking *t, const tp_gis_part *part) {
  if (part->system != TP_GIS_LENGTHS) return true;
  if (t->metres != 0 && part->metres != t->metres) {
    return fail(t, part,
                "is in another unit of length than those before it; save the layers of "
                "block and base in one coordinate reference system");
  }
  if (t->metres != 0) return true;
  t->metres = part->metres;
  t->feet = is_survey_foot(part->metres);
  t->drawing->unit = t->feet ? "m" : name_of(part->metres);
  t->drawing->unit_from = "its coordinate reference system";
  if (t->feet) fmpq_set_si(t->scale, 1200, 3937);
  if (t->drawing->unit != NULL) return true;
  return fail(t, part,
              "has a coordinate reference system whose unit is none of m, ft, US survey "
              "ft, mm, cm, km and in; save it in one of these");
}

/* ---- objects -----------------------------------------------------------------------------------
 */

/* What can be no outline; NULL: it can. */
static const char *problem_of(const tp_gis_part *part) {
  if (part->system == TP_GIS_DEGREES) {
    return "is in degrees of longitude and latitude, and a section is drawn in lengths; save it in "
           "a projected coordinate reference system, as by ogr2ogr -t_srs EPSG:…";
  }
  if (part->curved) {
    return "has arcs, which are not read from a GIS; make lines of them first, as by ogr2ogr -nlt "
           "CONVERT_TO_LINEAR";
  }
  return part->z_changes ? "has a z that changes along it; a section is drawn in x and y, so give "
                           "it these two alone; one that stands in a vertical plane is read from "
                           "GeoJSON, WKT or DXF: ogr2ogr -f GeoJSON makes that of it"
                         : NULL;
}

static bool add_points(taking *t, tp_drawing_object *object, const tp_gis_part *part) {
  tp_mark mark = {.line = part->feature <= INT_MAX ? (int)part->feature : 0};
  for (size_t k = 0; k < part->count; k++) {
    const double x = part->xy[2 * k], y = part->xy[2 * k + 1];
    if (!isfinite(x) || !isfinite(y) || !tp_ratio_read_double(t->x, x) ||
        !tp_ratio_read_double(t->y, y)) {
      return fail(t, part,
                  "has a coordinate that is not a number between 1e-308 and 1e308 in size");
    }
    if (t->feet) {
      fmpq_mul(t->x, t->x, t->scale);
      fmpq_mul(t->y, t->y, t->scale);
    }
    mark.column = (int)k + 1;
    if (tp_drawing_add_point(object, t->x, t->y, mark)) continue;
    t->status = tp_fail_memory(t->message, "a drawing");
    return false;
  }
  return true;
}

static bool take(void *context, const tp_gis_part *part) {
  taking *t = context;
  t->points += part->count;
  if (t->points > MOST_POINTS) {
    return fail(t, part, "is beyond 10 million points; save the layers of block and base alone");
  }
  t->degrees |= part->system == TP_GIS_DEGREES;
  t->plane |= part->system != TP_GIS_DEGREES;
  if (!take_unit(t, part)) return false;
  const char *layer = part->layer_field != NULL ? part->layer_field : part->layer;
  tp_drawing_object *object =
      tp_drawing_add(t->drawing, part->polygon ? "Polygon" : "LineString", layer, part->name_field,
                     (tp_mark){.line = part->feature <= INT_MAX ? (int)part->feature : 0});
  if (object == NULL) {
    t->status = tp_fail_memory(t->message, "a drawing");
    return false;
  }
  if (!part->inner) t->outer = t->drawing->count - 1;
  object->ring_of = part->inner ? t->outer : -1;
  object->problem = problem_of(part);
  if (!add_points(t, object, part)) return false;
  tp_drawing_tidy(object);
  if (part->polygon) object->closure = TP_DRAWING_CLOSED;
  return true;
}

/* ---- the file ----------------------------------------------------------------------------------
 */

/* GDAL takes names of many things for files: only what is one, by the system, is opened. */
static tp_status check_file(const char *path, tp_message *message) {
  struct stat own;
  if (stat(path, &own) != 0) return tp_fail_file(message, path, "opened", errno);
  if (S_ISREG(own.st_mode) && strncmp(path, "/vsi", 4) != 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 0, 0}, "is not a regular file");
}

static tp_status conclude(taking *t, tp_gis_outcome outcome, const char *why) {
  const tp_place whole = {t->drawing->path, 0, 0};
  if (outcome == TP_GIS_ENDED) return t->status;
  if (outcome == TP_GIS_NO_MEMORY) return tp_fail_memory(t->message, "a drawing");
  if (outcome == TP_GIS_FAILED) {
    return tp_refuse(
        t->message, TP_FAULT_FORMAT, whole,
        "not a Shapefile (with its .shx beside it) or GeoPackage that GDAL can read: %s",
        tp_quote_all(why).text);
  }
  if (t->degrees && !t->plane) {
    return tp_refuse(t->message, TP_FAULT_FORMAT, whole, "all that it holds %s",
                     problem_of(&(tp_gis_part){.system = TP_GIS_DEGREES}));
  }
  if (!t->feet) return TP_OK;
  return tp_notes_add(&t->drawing->notes, t->message, TP_NOTE, whole,
                      "its coordinate reference system is in US survey feet; lengths were made "
                      "metres, 1200/3937 of each");
}

tp_status tp_gis_drawing_read(tp_drawing *drawing, tp_message *message) {
  char why[TP_GIS_WHY_SIZE] = "";
  tp_status status = check_file(drawing->path, message);
  if (status != TP_OK) return status;
  tp_library_why why_not = {.text = "it is another library of this name"};
  tp_gis_read_function *read = tp_gis_library(&why_not);
  if (read == NULL) {
    return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){drawing->path, 0, 0},
                   "is read by " TP_GIS_LIBRARY
                   ", which does not load (%s); './run --with gis' in Topple's folder installs "
                   "GDAL (libgdal-dev) and builds it, or save the drawing as GeoJSON",
                   tp_quote_all(why_not.text).text);
  }
  taking t = {.drawing = drawing, .message = message, .outer = -1};
  fmpq_init(t.x);
  fmpq_init(t.y);
  fmpq_init(t.scale);
  status = conclude(&t, read(drawing->path, take, &t, why), why);
  fmpq_clear(t.x);
  fmpq_clear(t.y);
  fmpq_clear(t.scale);
  return status;
}
