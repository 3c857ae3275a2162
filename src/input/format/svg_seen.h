/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is an element of an SVG seen where it stands? */

#ifndef TP_FORMAT_SVG_SEEN_H
#define TP_FORMAT_SVG_SEEN_H

#include "format/svg_style.h"

/* What an element has by itself and from those around it. */
typedef struct tp_svg_seen {
  bool kept;          /* to be used elsewhere: a definition, a mask */
  const char *hidden; /* why nothing in it is seen, a static text; NULL: it may be */
  bool invisible;     /* by its visibility, which an inner element may take back */
  bool fill_none, fill_clear, stroke_none, stroke_clear, stroke_thin;
} tp_svg_seen;

/* From what the element around it has to what this one has. False for a value that is none of
 * CSS's: `*bad` is its property. */
bool tp_svg_seen_within(tp_svg_seen *seen, const char *element,
                        const tp_svg_value values[TP_SVG_PROPERTIES], tp_svg_property *bad);

/* Why a shape is not seen: "display: none"; NULL: it is. One that says of neither fill nor stroke
 * that there is none is taken, whatever is drawn of it. */
const char *tp_svg_unseen(const tp_svg_seen *seen);

#endif
