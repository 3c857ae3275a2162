/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Objects of a GeoJSON file (RFC 7946): lines and polygons, alone or in features, whose properties
 * "layer" and "name" are theirs. */

#ifndef TP_FORMAT_GEOJSON_H
#define TP_FORMAT_GEOJSON_H

#include "format/drawing.h"
#include "format/text_file.h"

TP_MUST_USE tp_status tp_geojson_read(tp_drawing *drawing, const tp_text_file *file,
                                      const tp_drawing_options *options, tp_message *message);

#endif
