/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How long one unit of an SVG is on its page, which is no true length: width over the width of the
 * viewBox, or a pixel, 1/96 inch, where there is none. Only to tell where a unit that is said to be
 * that of the drawing is likely another one. */

#ifndef TP_SVG_PAGE_H
#define TP_SVG_PAGE_H

/* In metres, by the attributes of <svg>; 0: they give the page no size. */
double tp_svg_page_unit(const char *const *attributes);

#endif
