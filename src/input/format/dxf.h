/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Objects of a DXF file, as text from R12 on. */

#ifndef TP_FORMAT_DXF_H
#define TP_FORMAT_DXF_H

#include "format/drawing.h"
#include "format/text_file.h"

TP_MUST_USE tp_status tp_dxf_read(tp_drawing *drawing, const tp_text_file *file,
                                  const tp_drawing_options *options, tp_message *message);

#endif
