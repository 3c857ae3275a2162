/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Texts of a drawing that is to keep them apart, as elements <text>. */

#ifndef TP_FIGURE_KEPT_TEXTS_H
#define TP_FIGURE_KEPT_TEXTS_H

#include "output/text.h"

#include <cairo.h>

/* What is drawn on the surface from now on keeps its texts there. */
cairo_status_t tp_kept_texts_begin(cairo_surface_t *surface, tp_text *texts);

/* Keep a text with its place, size and ink; false where the drawing keeps none, or it is turned: it
 * is to be drawn. */
bool tp_kept_texts_add(cairo_t *cr, double x, double y, const char *text);

#endif
