/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loading of the optional library libtopple-gis, which reads Shapefiles and GeoPackages through
 * GDAL (gis/gis.h). */

#ifndef TP_FORMAT_GIS_LIBRARY_H
#define TP_FORMAT_GIS_LIBRARY_H

#include "common/library_beside.h"
#include "gis/gis.h"

typedef tp_gis_outcome tp_gis_read_function(const char *path, tp_gis_take *take, void *context,
                                            char why[TP_GIS_WHY_SIZE]);

/* tp_gis_read of libtopple-gis; NULL: `why` tells. */
tp_gis_read_function *tp_gis_library(tp_library_why *why);

#endif
