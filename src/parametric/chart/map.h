/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mechanism map of a scene: what it is sampled for, and how borders between certified
 * mechanisms are found. Shared by the map along one scalar and the map over two. */

#ifndef TP_CHART_MAP_H
#define TP_CHART_MAP_H

#include "case_filter/keyed_filter.h"
#include "chart/chart.h"
#include "chart/motion_names.h"
#include "stability/varied.h"

/* What begins to move first, by the limit analysis; at the scene's tilt, what the block does. */
typedef enum tp_regime {
  TP_REGIME_NONE,   /* the scene has no answer there */
  TP_REGIME_STANDS, /* at the scene's tilt */
  TP_REGIME_SLIDES,
  TP_REGIME_TOPPLES,
  TP_REGIME_BOTH,
  TP_REGIME_TIE,         /* two mechanisms have the same limit */
  TP_REGIME_MAY_MOVE,    /* forces hold it at every tilt, but a motion can begin */
  TP_REGIME_INTERLOCKED, /* nothing does */
  TP_REGIME_NOWHERE,     /* it does not stand at any tilt */
  TP_REGIME_LEAVES_BASE,
  TP_REGIME_CAN_HOLD, /* many blocks, by some forces */
  TP_REGIME_UNDECIDED
} tp_regime;

const char *tp_regime_name(tp_regime regime);
tp_chart_style tp_regime_line(tp_regime regime);
tp_chart_style tp_regime_region(tp_regime regime);

typedef struct tp_map {
  tp_chart *chart;
  const tp_chart_map_options *options;
  tp_varied varied;
  tp_message *message;    /* not NULL */
  tp_status status;       /* of the system: memory; that a scene has no answer is none */
  tp_message why;         /* why the last scene had no answer */
  bool of_many;           /* of many blocks, which take longer and are told less closely: */
  int side, border_steps; /* samples along an axis; halvings of an edge between two */
  double flat, bracket;   /* shares of a level and of an edge, as near as a contour is looked for */
  bool patton;            /* its friction is Patton's law */
  bool at_tilt;           /* regimes are what the block does at the scene's tilt: */
  bool has_tilt;          /* a sample had one */
  bool tilts_differ;      /* it is a number that an axis takes along */
  double tilt_deg;        /* else this */
  tp_keyed_filter *filter; /* where borders are looked for: tells regimes in doubles; or NULL */
} tp_map;

/* Tilts throughout which the same motions can begin from rest, as in tp_motion_range; none: it is
 * certain to stand there, between others. Each strip begins where the one before it ends. */
typedef struct tp_strip {
  unsigned motions;
  tp_bounded from_deg, to_deg;
} tp_strip;

enum { TP_STRIPS_MAX = 12 };

typedef struct tp_map_sample {
  double values[TP_VARIED_MAX];
  tp_regime regime;
  bool has_limit;
  tp_bounded limit_deg;
  bool has_onset; /* below the limit: from there on history decides */
  tp_bounded onset_deg;
  bool has_toppling, has_sliding;
  size_t governing;
  tp_bounded toppling_deg, sliding_deg;
  bool has_strips; /* where they were asked for, and are no more than there is room for */
  bool has_fos;    /* the factor of safety that governs at the scene's tilt is a number: */
  tp_bounded fos;
  size_t strip_count;
  tp_strip strips[TP_STRIPS_MAX]; /* from level, or the first beyond, to 90 degrees at most */
} tp_map_sample;

/* Solve the scene with the values. */
tp_map_sample tp_map_take_sample(tp_map *map, const double *values);

/* The same of a scene of many blocks (map_system.c). */
tp_map_sample tp_map_take_system(tp_map *map, const double *values);

/* Are the regimes the same, and the motions of the strips, one after the other? */
bool tp_map_sample_is_like(const tp_map_sample *one, const tp_map_sample *other);

/* Along the line between two samples that are not alike: the last point like the first and the next
 * double, along the axis that moves, that is not. */
void tp_map_border(tp_map *map, tp_map_sample *low, tp_map_sample *high);

/* "slides | topples" */
void tp_map_border_name(char *text, size_t size, tp_regime one, tp_regime other);

/* A series of the chart: its kind and what it is of. */
void tp_map_begin(tp_map *map, tp_chart_style style, const char *series, const char *of);

/* The complaint when the scene has an answer nowhere. */
tp_status tp_map_no_answer(const tp_map *map);

/* Draw the map along one scalar, whose number is the scene's first, or over two. */
void tp_map_draw_line(tp_map *map, bool scalar_is_x);
void tp_map_draw_plane(tp_map *map);

#endif
