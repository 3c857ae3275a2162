/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In place of gis.c and its like, where Topple is built without GDAL. */

#include "format/gis.h"

tp_status tp_gis_drawing_read(tp_drawing *drawing, tp_message *message) {
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){drawing->path, 0, 0},
                   "this Topple was built without GDAL, which Shapefile and GeoPackage are read "
                   "with: './run --with gis' in its folder installs GDAL (libgdal-dev) and builds "
                   "it, or save the "
                   "drawing as GeoJSON");
}
