/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chooses the reader of a drawing by the ending of its file name. */

#include "format/read.h"

#include "format/csv_drawing.h"
#include "format/drawing_work.h"
#include "format/dxf.h"
#include "format/geojson.h"
#include "format/gis.h"
#include "format/standing.h"
#include "format/svg.h"
#include "format/wkt.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const struct {
  const char *ending;
  tp_drawing_reader *read; /* of its text; NULL: by GDAL */
  bool is_drawing;         /* whoever names it */
} formats[] = {{".dxf", tp_dxf_read, true},
               {".svg", tp_svg_read, true},
               {".wkt", tp_wkt_read, true},
               {".geojson", tp_geojson_read, true},
               {".json", tp_geojson_read, false},
               {".csv", tp_csv_drawing_read, false},
               {".shp", NULL, true},
               {".gpkg", NULL, true}};

enum { FORMATS = sizeof formats / sizeof formats[0] };

static int format_of(const char *path) {
  const size_t length = strlen(path);
  for (int k = 0; k < FORMATS; k++) {
    const size_t own = strlen(formats[k].ending);
    if (length > own && strcasecmp(path + length - own, formats[k].ending) == 0) return k;
  }
  return -1;
}

bool tp_drawing_is_named(const char *path) {
  const int format = format_of(path);
  return format >= 0 && formats[format].is_drawing;
}

tp_status tp_drawing_read(tp_drawing *drawing, const tp_drawing_options *options,
                          tp_message *message) {
  const int format = format_of(drawing->path);
  if (format < 0) {
    return tp_refuse(
        message, TP_FAULT_FORMAT, (tp_place){drawing->path, 0, 0},
        "not a drawing by its name; drawings end in .dxf, .svg, .wkt, .geojson, .json, "
        ".csv, .shp or .gpkg");
  }
  if (formats[format].read == NULL) return tp_gis_drawing_read(drawing, message);
  tp_text_file file;
  tp_status status = tp_text_file_read(&file, drawing->path, message);
  if (status != TP_OK) return status;
  drawing->points_allowed = tp_drawing_points_allowed(file.length);
  status = formats[format].read(drawing, &file, options, message);
  if (status == TP_OK)
    status = tp_standing_read(drawing, formats[format].read, &file, options, message);
  free(file.text);
  return status;
}
