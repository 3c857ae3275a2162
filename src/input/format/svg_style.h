/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What CSS says of an element of an SVG, as far as it bears on an outline: whether it is seen, and
 * what would move or shape it.
 *
 * A property is set by an attribute of its name, by a rule of a style sheet (<style>), or by the
 * attribute "style", the later in this order before the earlier, rules by how closely their
 * selector names an element, and what is !important before all others. */

#ifndef TP_FORMAT_SVG_STYLE_H
#define TP_FORMAT_SVG_STYLE_H

#include "format/svg_sheet.h"

/* What an element of a name and attributes has set; the values point into these and the sheets. */
void tp_svg_style(tp_svg_value values[TP_SVG_PROPERTIES], const tp_svg_sheets *sheets,
                  const char *element, const char *const *attributes);

#endif
