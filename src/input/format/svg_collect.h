/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The style sheets of an SVG file, wherever they stand in it: they hold for what comes before them,
 * too, so they are read first. */

#ifndef TP_FORMAT_SVG_COLLECT_H
#define TP_FORMAT_SVG_COLLECT_H

#include "format/svg_style.h"
#include "format/text_file.h"

/* `sheets` is empty before, and to be cleared whatever the outcome. XML that is not well-formed is
 * left for the reader of elements to refuse. */
TP_MUST_USE tp_status tp_svg_collect(tp_svg_sheets *sheets, const char *path,
                                     const tp_text_file *file, tp_message *message);

/* Without a prefix, as of "svg:path". */
const char *tp_svg_local_name(const char *name);

#endif
