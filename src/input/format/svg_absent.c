/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In place of svg.c and its like, where Topple is built without expat. */

#include "format/svg.h"

tp_status tp_svg_read(tp_drawing *drawing, const tp_text_file *file,
                      const tp_drawing_options *options, tp_message *message) {
  (void)file;
  (void)options;
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){drawing->path, 0, 0},
                   "this Topple was built without expat, which SVG is read with: install "
                   "libexpat1-dev and build it again, or save the drawing as DXF");
}
