/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Objects of an SVG file: paths and basic shapes, by the transforms of themselves and of their
 * groups, y turned upwards. Read by expat; document types, and with them entities, are refused, and
 * nothing that the file refers to is ever opened. */

#ifndef TP_FORMAT_SVG_H
#define TP_FORMAT_SVG_H

#include "format/drawing.h"
#include "format/text_file.h"

TP_MUST_USE tp_status tp_svg_read(tp_drawing *drawing, const tp_text_file *file,
                                  const tp_drawing_options *options, tp_message *message);

#endif
