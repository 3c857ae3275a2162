/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Objects of a CSV file with named columns: x and y, and where there are such, layer, name and
 * bulge. Rows of one layer and name that follow each other are one object. */

#ifndef TP_FORMAT_CSV_DRAWING_H
#define TP_FORMAT_CSV_DRAWING_H

#include "format/drawing.h"
#include "format/text_file.h"

TP_MUST_USE tp_status tp_csv_drawing_read(tp_drawing *drawing, const tp_text_file *file,
                                          const tp_drawing_options *options, tp_message *message);

#endif
