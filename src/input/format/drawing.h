/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What any drawing gives, whatever the format of its file: objects, which are chains of exact
 * points with their place in the file, straight or with arcs kept as arcs.
 *
 * Coordinates are in the unit of the file, x to the right and y upwards. A point that stands in the
 * file is taken to the last digit of its decimals; one that was computed (an end of an arc by its
 * angles) may be meant up to `uncertainty` beside it, and what was made chords of leaves them by at
 * most `deviation`. Which object is the block, and which the base, is told apart by layer and name
 * (format/roles.h), and pieces are joined end to end before (format/join.h). */

#ifndef TP_FORMAT_DRAWING_H
#define TP_FORMAT_DRAWING_H

#include "common/notes.h"
#include "plane/polyline.h"

typedef enum tp_drawing_closure {
  TP_DRAWING_OPEN,
  TP_DRAWING_CLOSED, /* the last point is not the first one again */
  TP_DRAWING_EITHER  /* the format does not say: a list of points */
} tp_drawing_closure;

typedef struct tp_drawing_object {
  const char *kind;       /* the word of its format: "LWPOLYLINE", "path", "POLYGON" */
  TP_OUTSIDE char *layer; /* never NULL */
  TP_OUTSIDE char *name;  /* an id or a label; empty where it has none */
  long pieces;            /* that it was joined of; 1 */
  long ring_of; /* this is an inner ring of the polygon whose outer one is that object; -1 */
  tp_drawing_closure closure;
  tp_polyline line; /* its `file` is the drawing's path */
  fmpq *bulges;     /* of the edge from each point to the next: the tangent of a quarter of the
                       arc's angle, above zero where it runs counter-clockwise, as in DXF; see
                       tp_drawing_bulge */
  long bulge_room;  /* edges from there on are straight */
  fmpq_t uncertainty, deviation; /* lengths; 0: exact */
  const char *problem;           /* why it can be no outline, a static text; NULL: it can */
  double most_points;            /* that curves may make of it */
  struct tp_rise *rise; /* of points with a z (format/standing.h); NULL: none had one; owned */
} tp_drawing_object;

typedef struct tp_drawing {
  const char *path;      /* borrowed: outlives it */
  const char *unit;      /* "mm", "cm", "m", "km", "in", "ft"; NULL: the file does not say */
  const char *unit_from; /* where the file says it, a static text; with the unit */
  double page_unit_m;    /* how long one of its units is on its page; 0: it has none */
  long count, room;
  tp_drawing_object *objects;
  long hidden;    /* objects of the file that are not shown, and were left out */
  tp_notes notes; /* on what was read */
  const struct tp_standing *standing; /* the vertical plane that it is read in; NULL: x and y */
  double points_made, points_allowed; /* by curves and inserted blocks (format/drawing_work.h) */
} tp_drawing;

struct tp_drawing_words;

/* How curves become chains, and what else only the reader of a file can do. */
typedef struct tp_drawing_options {
  fmpq_t tolerance; /* by which chords may leave a curve, in the unit of the file; 0: 1/10000 of
                       the greater side of the curve's box */
  const char *reference; /* the id of an object of known length, which scales the drawing; NULL */
  fmpq_t length;         /* of it */
  const struct tp_drawing_words *words; /* layers and names that have a role; NULL: not known */
} tp_drawing_options;

void tp_drawing_options_init(tp_drawing_options *options);
void tp_drawing_options_clear(tp_drawing_options *options);

void tp_drawing_init(tp_drawing *drawing, const char *path);
void tp_drawing_clear(tp_drawing *drawing);

/* Another object without points, at its end; the texts are copied, NULL is an empty one. NULL when
 * memory is exhausted. It may move when the next one is added. */
tp_drawing_object *tp_drawing_add(tp_drawing *drawing, const char *kind, const char *layer,
                                  const char *name, tp_mark mark);
/* Take the last object out again, or one by its number, which no ring may be of. */
void tp_drawing_drop(tp_drawing *drawing);
void tp_drawing_remove(tp_drawing *drawing, long number);

/* One more point, straight on from it; false when memory is exhausted. */
TP_MUST_USE bool tp_drawing_add_point(tp_drawing_object *object, const fmpq_t x, const fmpq_t y,
                                      tp_mark mark);
/* The edge from the last point on is an arc of that bulge, which is not zero. */
TP_MUST_USE bool tp_drawing_bend(tp_drawing_object *object, const fmpq_t bulge);

/* Append the points of another object with its edges between them; closure and problem are
 * its, bounds the greater ones. False when memory is exhausted. */
TP_MUST_USE bool tp_drawing_append(tp_drawing_object *object, const tp_drawing_object *more);

/* Of the edge from a point to the next; NULL: it is straight. */
const fmpq *tp_drawing_bulge(const tp_drawing_object *object, long edge);
bool tp_drawing_has_arcs(const tp_drawing_object *object);

/* Drop the last point. */
void tp_drawing_drop_point(tp_drawing_object *object);

/* Make all edges straight. */
void tp_drawing_straighten(tp_drawing_object *object);

/* Drop points that repeat the one before them, and a last one that repeats the first: then the
 * object is closed. */
void tp_drawing_tidy(tp_drawing_object *object);

/* Run through it the other way; false when memory is exhausted. */
TP_MUST_USE bool tp_drawing_reverse(tp_drawing_object *object);

tp_place tp_drawing_place(const tp_drawing_object *object);

#endif
