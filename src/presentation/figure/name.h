/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What kind of file a figure is, by its name. */

#ifndef TP_FIGURE_NAME_H
#define TP_FIGURE_NAME_H

#include "topple.h"

typedef enum tp_figure_kind {
  TP_FIGURE_SVG,
  TP_FIGURE_PDF,
  TP_FIGURE_PNG,
  TP_FIGURE_DXF,
  TP_FIGURE_GLB, /* of a solid alone */
  TP_FIGURE_UNKNOWN
} tp_figure_kind;

tp_figure_kind tp_figure_kind_of(const char *path);

/* Can a figure of blocks in a section be of that kind? */
bool tp_figure_is_of_blocks(const char *path);

#endif
