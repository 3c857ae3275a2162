/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A figure as SVG for a page that shows many: a tenth of the bytes, with text as text. */

#ifndef TP_FIGURE_SMALL_SVG_H
#define TP_FIGURE_SMALL_SVG_H

#include "figure/figure.h"

/* `*bytes` is to be freed; a 0 follows them. */
TP_MUST_USE tp_status tp_figure_small_svg(char **bytes, size_t *length, const tp_figure *figure,
                                          tp_message *message);

#endif
