/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Objects of a text of geometries in WKT, one after another: lines and polygons, points left out.
 */

#ifndef TP_FORMAT_WKT_H
#define TP_FORMAT_WKT_H

#include "format/drawing.h"
#include "format/text_file.h"

TP_MUST_USE tp_status tp_wkt_read(tp_drawing *drawing, const tp_text_file *file,
                                  const tp_drawing_options *options, tp_message *message);

#endif
