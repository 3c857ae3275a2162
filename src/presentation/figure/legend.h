/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A legend of any figure: the scale bar, and signs with their words. */

#ifndef TP_FIGURE_LEGEND_H
#define TP_FIGURE_LEGEND_H

#include "figure/figure.h"

typedef enum tp_sign {
  TP_SIGN_TINT,
  TP_SIGN_LINE,
  TP_SIGN_THIN,
  TP_SIGN_DASHES,
  TP_SIGN_ARROW,
  TP_SIGN_CROSS,
  TP_SIGN_DISC,
  TP_SIGN_CENTROID
} tp_sign;

typedef struct tp_legend_entry {
  bool shown;
  tp_sign sign;
  tp_ink ink;
  const char *text;
} tp_legend_entry;

typedef struct tp_legend {
  double points;               /* of one scene length */
  const char *length_unit;     /* of the scene */
  const tp_language *language; /* of its words; NULL: English */
  bool comma;                  /* before decimals */
  size_t count;
  const tp_legend_entry *entries;
} tp_legend;

/* From the height down; the height at which it ends. */
double tp_legend_draw(cairo_t *cr, const tp_legend *legend, double x, double y, double width);

#endif
