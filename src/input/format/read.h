/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Drawings out of files of any format. */

#ifndef TP_FORMAT_READ_H
#define TP_FORMAT_READ_H

#include "format/drawing.h"

/* Is a file a drawing by its name, whoever names it? Not of CSV, which holds points of an outline
 * as well, nor of JSON. */
bool tp_drawing_is_named(const char *path);

/* Read a file by the ending of its name. `drawing` was initialised with its path, and is to be
 * cleared whatever the outcome. */
TP_MUST_USE tp_status tp_drawing_read(tp_drawing *drawing, const tp_drawing_options *options,
                                      tp_message *message);

#endif
