/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Kind of a figure by the ending of its file name, case ignored: SVG, PDF, PNG, DXF or GLB. */

#include "figure/name.h"

#include <string.h>
#include <strings.h>

tp_figure_kind tp_figure_kind_of(const char *path) {
  const char *ending = strrchr(path, '.');
  if (ending == NULL || ending == path || ending[-1] == '/') return TP_FIGURE_UNKNOWN;
  if (strcasecmp(ending, ".svg") == 0) return TP_FIGURE_SVG;
  if (strcasecmp(ending, ".pdf") == 0) return TP_FIGURE_PDF;
  if (strcasecmp(ending, ".dxf") == 0) return TP_FIGURE_DXF;
  if (strcasecmp(ending, ".glb") == 0) return TP_FIGURE_GLB;
  return strcasecmp(ending, ".png") == 0 ? TP_FIGURE_PNG : TP_FIGURE_UNKNOWN;
}

bool tp_figure_is_of_blocks(const char *path) {
  const tp_figure_kind kind = tp_figure_kind_of(path);
  return kind != TP_FIGURE_UNKNOWN && kind != TP_FIGURE_GLB;
}

bool tp_figure_is_file_name(const char *path) {
  return path != NULL && tp_figure_kind_of(path) != TP_FIGURE_UNKNOWN;
}
