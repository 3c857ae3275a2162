/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Objects of a Shapefile or a GeoPackage: lines and polygons with the layers and attributes that
 * they have there. Coordinates are doubles in such files, and each is taken as the shortest decimal
 * that names it, which is what a GIS shows of it. */

#ifndef TP_FORMAT_GIS_H
#define TP_FORMAT_GIS_H

#include "format/drawing.h"

TP_MUST_USE tp_status tp_gis_drawing_read(tp_drawing *drawing, tp_message *message);

#endif
