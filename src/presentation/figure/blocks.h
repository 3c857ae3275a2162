/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The figure of a scene of many blocks: what it shows, and who draws it. As in figure.h the page is
 * measured in points, y down; the blocks in units of their size, y up. */

#ifndef TP_FIGURE_BLOCKS_H
#define TP_FIGURE_BLOCKS_H

#include "figure/figure.h"
#include "shape/load_shapes.h"

typedef struct tp_blocks_figure {
  const tp_block_system *system;
  const tp_system_case *own; /* the case that is drawn */
  tp_block_shapes shapes;
  tp_load_shapes loads;
  double turn;        /* counter-clockwise, radians */
  double moved;       /* by which the fastest corner is displaced in the mechanism, units */
  double largest_n_m; /* of all forces; 0: none is drawn */
  double arrow;       /* the length of its arrow, units */
  const tp_language *language; /* of its text, and the sign before decimals; NULL: English */
  bool comma;
  bool sketch; /* on a sheet, whose text has title, verdict and numbers already: without these */
} tp_blocks_figure;

typedef struct tp_blocks_panel {
  cairo_t *cr;
  const tp_blocks_figure *figure;
  tp_view view;
  tp_box area; /* that is drawn in */
  size_t arrow_count;
  tp_spot (*arrows)[2]; /* of forces, on the page */
  bool has_thrust;      /* a line of thrust was drawn */
} tp_blocks_panel;

/* Chooses case, turn and sizes, once the blocks have their shapes. */
void tp_blocks_set_up(tp_blocks_figure *figure);

/* Does the case that is drawn certainly govern? Else it is the first. */
bool tp_blocks_governs(const tp_blocks_figure *figure);

/* Has the collapse a motion of this block? And where a spot of it is displaced to. */
bool tp_blocks_moves(const tp_blocks_figure *figure, size_t block);
tp_spot tp_blocks_moved(const tp_blocks_figure *figure, size_t block, tp_spot at);

/* The tint of a free block, by how it moves. */
tp_ink tp_blocks_tint(const tp_blocks_figure *figure, size_t block);

/* The arrow of the force in a contact, from `from` to the point where it acts: that on the free
 * block where the other is ground, between two free ones on the one that it presses down, or else
 * to the side of the tilt. False where it is negligible. */
bool tp_blocks_force(tp_spot *from, tp_spot *to, const tp_blocks_figure *figure, size_t contact);

/* "Factor of safety by strength reduction", those on driving loads and by Goodman and Bray, and
 * from which divisor of strength on a motion can begin; nothing where none of it is known. Then
 * whether a required factor is met. */
void tp_blocks_factors(tp_text *text, const tp_block_system *system, const tp_system_case *of);

/* Are there bolts; are there other loads than water? */
bool tp_blocks_pulled(const tp_blocks_figure *figure, bool by_bolts);

/* Drawing. False when memory is exhausted. */
TP_MUST_USE bool tp_blocks_draw_ground(const tp_blocks_panel *panel);
void tp_blocks_draw_free(const tp_blocks_panel *panel);
TP_MUST_USE bool tp_blocks_draw_mechanism(const tp_blocks_panel *panel);
TP_MUST_USE bool tp_blocks_draw_forces(tp_blocks_panel *panel);
void tp_blocks_draw_loads(const tp_blocks_panel *panel);
TP_MUST_USE bool tp_blocks_draw_names(const tp_blocks_panel *panel);

/* What is said above and below, from *y down to where it moves *y. */
TP_MUST_USE bool tp_blocks_heading(double *y, cairo_t *cr, const tp_blocks_figure *figure, double x,
                                   double width);
TP_MUST_USE bool tp_blocks_verdict(double *y, cairo_t *cr, const tp_blocks_figure *figure, double x,
                                   double width);
double tp_blocks_legend(const tp_blocks_panel *panel, double x, double y, double width);

/* The whole page. */
double tp_blocks_page_width(void);

/* The blocks of the scene that was solved, set up; to be cleared. Bad input where it is another
 * scene. */
TP_MUST_USE tp_status tp_blocks_figure_init(tp_blocks_figure *figure, const tp_scene *scene,
                                            const tp_block_system *system, tp_message *message);
void tp_blocks_figure_clear(tp_blocks_figure *figure);
/* As a file of the kind that a name ends in, to be freed. */
TP_MUST_USE tp_status tp_blocks_figure_bytes(char **bytes, size_t *length, const char *name,
                                             const tp_blocks_figure *figure, const tp_scene *scene,
                                             tp_message *message);
TP_MUST_USE bool tp_blocks_page(double *height, cairo_t *cr, const tp_blocks_figure *figure);

#endif
