/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The figure of many blocks as a drawing of CAD (figure/dxf.h). */

#ifndef TP_FIGURE_DXF_BLOCKS_H
#define TP_FIGURE_DXF_BLOCKS_H

#include "figure/blocks.h"

/* All of it, to be freed. */
TP_MUST_USE tp_status tp_cad_draw_blocks(char **bytes, size_t *length,
                                         const tp_blocks_figure *figure, const tp_scene *scene,
                                         tp_message *message);

#endif
