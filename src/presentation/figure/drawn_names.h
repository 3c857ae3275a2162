/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the legend calls the objects of a drawing: by layer, and by name where they have one. */

#ifndef TP_FIGURE_DRAWN_NAMES_H
#define TP_FIGURE_DRAWN_NAMES_H

#include "figure/figure.h"
#include "output/text.h"

enum { TP_TINTS_OF_PARTS = 2 };

/* In which tint a part of the block is drawn: by turns, those of one layer alike. */
int tp_part_tint(const tp_scene *scene, long part);

/* Plain text in the language of the figure, each an entry of the legend. Where the scene has no
 * drawing, the words alone. */
typedef struct tp_drawn_names {
  tp_text block, base, hole, parts[TP_TINTS_OF_PARTS]; /* of parts: of each tint */
  bool has_part[TP_TINTS_OF_PARTS];
  tp_text unused; /* a sentence; empty: nothing is left over */
} tp_drawn_names;

/* False when memory is exhausted; to be cleared in any case. */
TP_MUST_USE bool tp_drawn_names_init(tp_drawn_names *names, const tp_figure *figure);
void tp_drawn_names_clear(tp_drawn_names *names);

#endif
