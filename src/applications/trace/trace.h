/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline of a block traced in a photograph, as a scene, with a number by which it moves in and
 * out and the standard deviation of that number. In a library of its own, which alone needs OpenCV,
 * libpng, libjpeg and Cairo; the program loads it for `topple trace`.
 *
 * The deviation is put together, as a root of squares, of three: that of a place within the change
 * from inside to outside across the outline; of the mean distance between the outlines that rough
 * polygons of three sizes lead to; of a place within a pixel, 1/sqrt(12). It is one number for the
 * outline as a whole, the precision with which its edge is found: what a shadow, moss or soil hides
 * is not in it, nor what another hand would take for the block. Of an outline that was clicked it
 * is the last of the three alone. */

#ifndef TP_TRACE_TRACE_H
#define TP_TRACE_TRACE_H

#include "trace/refine.h"

/* What no picture shows: texts as the scene is to have them, numbers or expressions of numbers;
 * NULL where not known. */
typedef struct tp_trace_rock {
  TP_OUTSIDE const char *title;
  const char *unit_weight; /* kN/m3 */
  const char *thickness;   /* in the unit of the scene */
  const char *friction;    /* degrees */
} tp_trace_rock;

typedef struct tp_trace_options {
  const char *image;
  tp_trace_ring rough;      /* around the block; empty where the outline is given */
  tp_trace_ring outline;    /* of the block itself, as it was clicked; empty: it is looked for */
  const char *outline_file; /* a CSV that has it; NULL */
  tp_trace_point scale[2];
  double length;    /* between them, in `unit` */
  const char *unit; /* of the scene */
  bool plumb_given;
  tp_trace_point plumb[2]; /* two points of a line that hangs down */
  bool between_given;
  tp_trace_point between[2]; /* where the contact with the base begins and ends, either first */
  double tolerance; /* of the outline's points, in `unit`; 0: half of that across its edge */
  const tp_trace_rock *rock;
  const char *scene;  /* file to write; NULL: the scene is the report */
  const char *figure; /* .png to write; NULL: none */
  bool json;          /* the report as JSON */
} tp_trace_options;

/* What was traced. */
typedef struct tp_trace {
  tp_trace_ring ring;    /* in pixels, clockwise as it is seen */
  tp_trace_point *moves; /* of its points, outwards */
  double per_pixel;      /* length of one */
  tp_trace_point down, origin;
  long between[2];   /* the points of the ring in which the contact ends, left one first */
  double between_px; /* from what was given to these, the farther of the two */
  double missed_px;  /* by which the outline misses what was given, the farther of the two */
  double edge_px, runs_px, deviation_px;
  double tolerance_px; /* the points left out lie nearer to the outline than this */
  double weak, touching;
} tp_trace;

/* What the program calls, by this name. `around` has x and y of each corner of the rough polygon,
 * `outline` those of the block's own outline in its place, or `outline_file` names a CSV that has
 * them (else NULL), `scale` two points and their distance, `plumb` and `between` two points, NULL
 * where there are none; `rock` title, unit weight, thickness and friction as above; files may be
 * NULL. `report`, to be freed, is what is to be printed. */
TP_MUST_USE tp_status tp_trace_run(char **report, const char *image, const double *around,
                                   size_t corners, const double *outline, size_t clicks,
                                   const char *outline_file, const double scale[5],
                                   const double *plumb, const double *between, double tolerance,
                                   const char *unit, const char *const rock[4], const char *scene,
                                   const char *figure, bool json, tp_message *message);

/* Parts of it: scale, down and the origin, the lower left corner of the outline's box; a point in
 * the scene's coordinates, x to the right and y up, by the plumb line; the points nearest to the
 * ends of the contact, false where both are one; the outline as the text of a
 * scene; summed up; laid over the picture, as the bytes of a PNG. */
void tp_trace_place(tp_trace *trace, const tp_trace_options *options);
tp_trace_point tp_trace_to_scene(const tp_trace *trace, tp_trace_point pixel);
/* An outline that was clicked, out of the CSV where one is named, clockwise as it is seen. */
TP_MUST_USE tp_status tp_trace_read_clicks(tp_trace_options *options, tp_message *message);
TP_MUST_USE tp_status tp_trace_take_clicks(tp_trace *trace, const tp_trace_options *options,
                                           tp_message *message);
TP_MUST_USE bool tp_trace_find_between(tp_trace *trace, const tp_trace_options *options);
TP_MUST_USE tp_status tp_trace_scene_text(char **text, const tp_trace *trace,
                                          const tp_trace_picture *picture,
                                          const tp_trace_options *options);
/* The least scene with what is known of the rock: a slab, to learn whether a scene takes it. */
TP_MUST_USE tp_status tp_trace_rock_text(char **text, const tp_trace_options *options);
TP_MUST_USE tp_status tp_trace_report(char **text, const tp_trace *trace,
                                      const tp_trace_options *options);
TP_MUST_USE tp_status tp_trace_draw(char **bytes, size_t *length, const tp_trace *trace,
                                    const tp_trace_picture *picture,
                                    const tp_trace_options *options, tp_message *message);

#endif
