/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The parts of a figure: what each panel shows, where it lies on the page, and who draws it.
 *
 * The page is measured in points, y down. A panel's block frame (units of the block's size, y up)
 * is turned by the tilt and scaled onto it by a tp_view. */

#ifndef TP_FIGURE_FIGURE_H
#define TP_FIGURE_FIGURE_H

#include "report/page.h"
#include "shape/shape.h"

#include <cairo.h>

/* The palette of Okabe and Ito, and greys. */
typedef enum tp_ink {
  TP_INK_BLACK,
  TP_INK_GREY,
  TP_INK_WHITE,
  TP_INK_ROCK,
  TP_INK_BLOCK, /* tints */
  TP_INK_PART,
  TP_INK_OTHER_PART,
  TP_INK_TOPPLES,
  TP_INK_SLIDES_AND_TOPPLES,
  TP_INK_ORANGE,
  TP_INK_SKY,
  TP_INK_GREEN,
  TP_INK_BLUE,
  TP_INK_VERMILION,
  TP_INK_PURPLE
} tp_ink;

void tp_figure_ink(cairo_t *cr, tp_ink ink);

typedef struct tp_view {
  double cosine, sine; /* of the turn, counter-clockwise */
  double scale;        /* points per unit */
  double x, y;         /* of the unit frame's origin on the page */
} tp_view;

tp_spot tp_view_spot(const tp_view *view, tp_spot unit);

/* The direction of a vector of the block frame on the page, of length 1. */
tp_spot tp_view_direction(const tp_view *view, tp_spot vector);

/* The chain as a path. Points that no printer tells apart are dropped, and more of them where too
 * many are left. */
void tp_view_path(cairo_t *cr, const tp_view *view, const tp_chain *chain);

enum { TP_FORCES_MAX = 2 };

typedef struct tp_force {
  tp_spot at, share; /* block frame; shares of the weight */
  tp_bounded size;
} tp_force;

typedef enum tp_state_kind {
  TP_STATE_LIMIT,   /* at the static limit */
  TP_STATE_MOMENTS, /* no friction: where the weight passes the governing pivot */
  TP_STATE_SCENE,   /* at the scene's tilt */
  TP_STATE_LIES,    /* at its place on a slope, as it lies */
  TP_STATE_LEVEL
} tp_state_kind;

typedef struct tp_state {
  const tp_case *own;
  tp_state_kind kind;
  tp_bounded tilt_deg;
  double turn; /* counter-clockwise, radians */
  tp_spot centroid, gravity;
  size_t reaction_count;
  tp_force reactions[TP_FORCES_MAX];
  bool has_resultant; /* of weight and loads, against the reactions */
  tp_force resultant;
  bool meets; /* the lines of action, in a point that is not too far to show */
  tp_spot meeting;
  bool has_centre, shows_centre;
  tp_spot centre;
  double arrow; /* length of the weight's arrow, units */
} tp_state;

typedef struct tp_figure {
  const tp_problem *problem;
  const tp_solution *solution;
  tp_shape shape;
  size_t panel_count;
  tp_state states[2];
  const tp_language *language; /* of its text, and the sign before decimals; NULL: English */
  bool comma;
  bool sketch; /* on a sheet, whose text has title, verdict and pivots already: without these */
} tp_figure;

/* An English text in a language, as far as that has phrases; `comma` before decimals. */
void tp_figure_tell_in(tp_text *text, const tp_language *language, bool comma);
/* A text of the figure, which is English: in its language as far as that has phrases. A word. */
void tp_figure_tell(const tp_figure *figure, tp_text *text);
void tp_figure_set_decimals(const tp_figure *figure, char *text);
const char *tp_figure_word(const tp_figure *figure, const char *english)
    __attribute__((format_arg(2)));

/* What acts on a block as it lies: the resultant of weight and loads at its tilt, and on its line
 * the reaction of the base, where that stands. False when memory is exhausted. */
TP_MUST_USE bool tp_state_find_present(tp_state *state, const tp_figure *figure);

/* False when memory is exhausted. */
TP_MUST_USE bool tp_state_init(tp_state *state, const tp_figure *figure, const tp_case *own);

/* Where the lines p + t u and q + s v meet; false where they are nearly parallel. */
bool tp_spot_meet(tp_spot *at, tp_spot p, tp_spot u, tp_spot q, tp_spot v);

/* Is the point not further from the block than its size? */
bool tp_figure_in_sight(const tp_figure *figure, tp_spot p);

/* The point's place in the list of pivots, from 1; 0 where it is none. */
size_t tp_state_pivot_at(const tp_figure *figure, const tp_state *state, tp_spot at);

/* The pivots that are numbered and listed, in their order: the governing and the admissible ones,
 * those that carry the block, then from the toe on. */
enum { TP_PIVOTS_LISTED = 12 };
size_t tp_state_pivots(size_t listed[TP_PIVOTS_LISTED], const tp_figure *figure,
                       const tp_state *state);
tp_spot tp_figure_pivot_spot(const tp_figure *figure, const tp_case *own, size_t pivot);

enum { TP_LABEL_ROOM_MAX = 64 };

typedef struct tp_label_room {
  tp_box area;
  size_t label_count, line_count;
  tp_box labels[TP_LABEL_ROOM_MAX];
  tp_spot lines[TP_LABEL_ROOM_MAX][2]; /* arrows and the like, avoided where possible */
  size_t side_count;
  tp_spot (*sides)[2]; /* of the block: never touched */
} tp_label_room;

/* Sides of the block as the view shows it. False when memory is exhausted. */
TP_MUST_USE bool tp_label_room_init(tp_label_room *room, cairo_t *cr, const tp_figure *figure,
                                    const tp_view *view, tp_box area);
void tp_label_room_clear(tp_label_room *room);
void tp_label_room_line(tp_label_room *room, tp_spot from, tp_spot to);

/* How a box lies among the sides of an area (even-odd). */
typedef enum tp_box_place { TP_BOX_OUTSIDE, TP_BOX_ACROSS, TP_BOX_INSIDE } tp_box_place;
tp_box_place tp_box_among_sides(const tp_box *box, const tp_spot (*sides)[2], size_t count);

/* Room for a box of the given size beside the anchor, at most `reach` points away, first in the
 * direction (of length 1): off the block, other labels and the lines (where possible, or `strict`).
 * It is kept for the label; false where there is none. */
bool tp_label_room_find(tp_box *box, tp_label_room *room, tp_spot anchor, tp_spot direction,
                        double width, double height, double reach, bool strict);

typedef struct tp_panel {
  cairo_t *cr;
  const tp_figure *figure;
  const tp_state *state;
  tp_view view;
  tp_label_room room;
} tp_panel;

/* The rock that is shown: of the profile between two abscissae, down to a depth. */
typedef struct tp_rock {
  double x0, x1, bottom;
} tp_rock;

tp_rock tp_figure_rock(const tp_figure *figure);
TP_MUST_USE bool tp_figure_draw_base(const tp_panel *panel);
void tp_figure_draw_block(const tp_panel *panel);
void tp_figure_draw_contact(const tp_panel *panel);
/* Sited water: its levels, and its pressures as areas over the lines that they act on. */
void tp_figure_draw_wetted(const tp_panel *panel);
/* These areas, in the frame of the shape: how wide a unit of depth is drawn, no pressure wider than
 * a share of what the figure shows; and the area over a line. */
double tp_figure_wet_width(const tp_figure *figure, const tp_wetted *wetted);
void tp_figure_wet_area(tp_spot corners[4], const tp_figure *figure, const tp_line_load *line,
                        double width);
/* Water of a height: the pressure on the up-dip face and the uplift below the base, as triangles;
 * how many there are. */
int tp_figure_water_areas(tp_spot areas[2][3], const tp_figure *figure, const tp_state *state);
void tp_figure_draw_loads(tp_panel *panel);
void tp_figure_draw_forces(tp_panel *panel);
void tp_figure_draw_tilt(tp_panel *panel);

/* Labels, once all lines are known: the more important first. */
void tp_figure_draw_pivots(tp_panel *panel);
void tp_figure_label_forces(tp_panel *panel);
void tp_figure_label_tilt(tp_panel *panel);

void tp_figure_arrow(cairo_t *cr, tp_spot tail, tp_spot tip, double width);

/* The disc that numbers a pivot. */
void tp_figure_disc(cairo_t *cr, tp_spot centre, size_t number, bool governs);

/* Sizes of letters, points. */
#define TP_TITLE_SIZE 10.5
#define TP_HEAD_SIZE 8.5
#define TP_BODY_SIZE 7.5
#define TP_SMALL_SIZE 6.5
#define TP_LINE_HEIGHT 1.3 /* times the size */

void tp_figure_font(cairo_t *cr, double size, bool bold);
double tp_figure_text_width(cairo_t *cr, const char *text);
void tp_figure_text(cairo_t *cr, double x, double y, const char *text);

/* Cut a line that is wider, between two characters, in the font set. Its room is that of all lines.
 */
enum { TP_LINE_SIZE = 512 };
void tp_figure_shorten(cairo_t *cr, char line[TP_LINE_SIZE], double width);

/* A label in the middle of a box. */
void tp_figure_text_in(cairo_t *cr, tp_box box, const char *text);

/* Words on lines of at most the width, from the top `y` down in the font set; where it ends. */
double tp_figure_paragraph(cairo_t *cr, double x, double y, double width, double size, bool bold,
                           const char *text);

/* What a panel says above and below its drawing, from *y down to where it moves *y. False when
 * memory is exhausted. */
TP_MUST_USE bool tp_figure_heading(double *y, cairo_t *cr, const tp_figure *figure,
                                   const tp_state *state, double x, double width);
TP_MUST_USE bool tp_figure_verdict(double *y, cairo_t *cr, const tp_figure *figure,
                                   const tp_state *state, double x, double width);

/* Of a block that is drawn as it lies: its heading, a line that names both sides of the section and
 * ends at the height returned, one of its arrows with its word, and the verdict with what comes
 * after it; false where the onset does not tell it. */
void tp_figure_lies_heading(tp_text *text, const tp_figure *figure, const tp_state *state);
double tp_figure_sides(cairo_t *cr, const tp_figure *figure, double x, double y, double width);
void tp_figure_side(cairo_t *cr, bool left, const char *text, double x, double y);
TP_MUST_USE bool tp_figure_lies_verdict(tp_text *verdict, tp_text *more, const tp_figure *figure,
                                        const tp_state *state);

/* The pivots; where they end. The legend, from *y down to where it moves *y; false when memory is
 * exhausted. */
double tp_figure_table(cairo_t *cr, const tp_figure *figure, const tp_state *state, double x,
                       double y, double width);
TP_MUST_USE bool tp_figure_legend(double *y, cairo_t *cr, const tp_figure *figure, double scale,
                                  double x, double width);

/* The whole page, and its height. False when memory is exhausted. */
#define TP_FIGURE_MARGIN 14.0
double tp_figure_width(const tp_figure *figure);
TP_MUST_USE bool tp_figure_page(double *height, cairo_t *cr, const tp_figure *figure);

/* Letters measure alike on every kind of page: no fitting of them to its dots. */
void tp_figure_set_up(cairo_t *cr);

/* Draw the page, so many dots to the point; CAIRO_STATUS_NO_MEMORY where its own memory is
 * exhausted. */
cairo_status_t tp_figure_draw(double *height, cairo_surface_t *surface, const tp_figure *figure,
                              double dots);

/* The height that the page takes, found by drawing it on a page of one dot. */
cairo_status_t tp_figure_measure(double *height, const tp_figure *figure);

/* A figure in memory, to be freed, of the kind that a name of this ending has. */
TP_MUST_USE tp_status tp_figure_bytes(char **bytes, size_t *length, const char *path,
                                      const tp_figure *figure, tp_message *message);

/* What is done with the figure of a solved scene, and doing it. */
typedef tp_status tp_figure_work(const tp_figure *figure, void *context, tp_message *message);
TP_MUST_USE tp_status tp_figure_prepare(const tp_scene *scene, const tp_solution *solution,
                                        tp_figure_work *work, void *context, tp_message *message);

TP_MUST_USE tp_status tp_figure_write(const char *path, const tp_figure *figure,
                                      tp_figure_consent consent, tp_message *message);

#endif
