/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Draws pivots with their numbers, the governing one first, where there is room, and the angle of
 * the tilt as a wedge. */

#include "figure/figure.h"

#include <math.h>
#include <stdio.h>

enum { FEW = 6 }; /* pivots, whose numbers may stand further off */

#define DISC_RADIUS 4.6
#define NEAR 10.0 /* points: where a number needs no leader */

static double disc_half_width(cairo_t *cr, size_t number) {
  char text[24];
  snprintf(text, sizeof text, "%zu", number);
  tp_figure_font(cr, TP_SMALL_SIZE, true);
  return fmax(DISC_RADIUS, tp_figure_text_width(cr, text) / 2 + 2);
}

void tp_figure_disc(cairo_t *cr, tp_spot c, size_t number, bool governs) {
  char text[24];
  const double half = disc_half_width(cr, number), quarter = 2 * atan(1);
  snprintf(text, sizeof text, "%zu", number);
  cairo_new_path(cr);
  cairo_arc(cr, c.x + half - DISC_RADIUS, c.y, DISC_RADIUS, -quarter, quarter);
  cairo_arc(cr, c.x - half + DISC_RADIUS, c.y, DISC_RADIUS, quarter, 3 * quarter);
  cairo_close_path(cr);
  tp_figure_ink(cr, governs ? TP_INK_VERMILION : TP_INK_WHITE);
  cairo_fill_preserve(cr);
  tp_figure_ink(cr, governs ? TP_INK_VERMILION : TP_INK_BLACK);
  cairo_set_line_width(cr, 0.6);
  cairo_stroke(cr);
  tp_figure_ink(cr, governs ? TP_INK_WHITE : TP_INK_BLACK);
  tp_figure_font(cr, TP_SMALL_SIZE, true);
  tp_figure_text_in(cr, (tp_box){c.x - half, c.y - DISC_RADIUS, c.x + half, c.y + DISC_RADIUS},
                    text);
}

/* How far the number of a pivot may stand from it: near, so that it is clear whose it is. */
static double reach_of(const tp_panel *p, size_t pivot) {
  const tp_case *own = p->state->own;
  if (own->has_toppling_pivot && pivot == own->toppling_pivot) return 60;
  for (size_t k = 0; k < p->state->reaction_count; k++) {
    if (tp_state_pivot_at(p->figure, p->state, p->state->reactions[k].at) == pivot + 1) return 30;
  }
  return own->candidate_count <= FEW ? 24 : NEAR - 1;
}

/* The number beside the pivot, where there is room. */
static void draw_number(tp_panel *p, size_t pivot, bool governs) {
  cairo_t *cr = p->cr;
  const tp_spot at = tp_view_spot(&p->view, tp_figure_pivot_spot(p->figure, p->state->own, pivot));
  const tp_spot down = tp_view_direction(&p->view, (tp_spot){0, -1});
  const size_t number = p->state->own->pivots[pivot].index + 1;
  const double half = disc_half_width(cr, number), reach = reach_of(p, pivot);
  tp_box box;
  if (tp_label_room_find(&box, &p->room, at, down, 2 * half + 1, 2 * DISC_RADIUS + 1, reach,
                         reach < NEAR)) {
    const tp_spot centre = {(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
    tp_figure_ink(cr, TP_INK_BLACK);
    cairo_set_line_width(cr, 0.4);
    cairo_move_to(cr, at.x, at.y);
    cairo_line_to(cr, centre.x, centre.y);
    cairo_stroke(cr);
    tp_label_room_line(&p->room, at, centre);
    tp_figure_disc(cr, centre, number, governs);
  }
}

static void draw_dot(const tp_panel *p, size_t pivot, bool governs) {
  cairo_t *cr = p->cr;
  const tp_spot at = tp_view_spot(&p->view, tp_figure_pivot_spot(p->figure, p->state->own, pivot));
  cairo_new_path(cr);
  cairo_arc(cr, at.x, at.y, governs ? 2.2 : 1.5, 0, 8 * atan(1));
  tp_figure_ink(cr, governs ? TP_INK_VERMILION : TP_INK_WHITE);
  cairo_fill_preserve(cr);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 0.5);
  cairo_stroke(cr);
}

/* The governing pivot first, then those that carry the block, then the others. */
void tp_figure_draw_pivots(tp_panel *p) {
  size_t listed[TP_PIVOTS_LISTED];
  const tp_case *own = p->state->own;
  const size_t count = tp_state_pivots(listed, p->figure, p->state);
  if (own->has_toppling_pivot) draw_number(p, own->toppling_pivot, true);
  for (int others = 0; others < 2; others++) {
    for (size_t k = 0; k < count; k++) {
      const bool governs = own->has_toppling_pivot && listed[k] == own->toppling_pivot;
      if (!governs && (reach_of(p, listed[k]) < NEAR) == (others == 1)) {
        draw_number(p, listed[k], false);
      }
    }
  }
  for (size_t k = 0; k < count; k++) draw_dot(p, listed[k], false);
  if (own->has_toppling_pivot) draw_dot(p, own->toppling_pivot, true);
}

/* The lower edge of the rock, and its angle with the horizontal through its lower end. */
typedef struct wedge {
  tp_spot low, high, level; /* ends of the edge and of the horizontal */
  double radius;
  tp_spot middle, on_arc; /* halfway: direction and point */
} wedge;

/* The base of a block that is laid level, under an earthquake up-dip, dips in its frame. */
static tp_spot up_the_base(const tp_panel *p, double side) {
  const tp_world *world = p->figure->problem->placement.world;
  if (world == NULL || !world->level) return tp_view_direction(&p->view, (tp_spot){side, 0});
  return tp_view_direction(
      &p->view, (tp_spot){side * fmpq_get_d(world->cosine), side * fmpq_get_d(world->sine)});
}

/* Which side is low: -1 the left, 1 the right; 0 where the base is level. */
static int low_side(const tp_panel *p) {
  const double rise = -up_the_base(p, 1).y;
  return rise > 0 ? -1 : rise < 0 ? 1 : 0;
}

static wedge find_wedge(const tp_panel *p) {
  enum { SHORTEST = 34, LONGEST = 60 };
  const tp_rock rock = tp_figure_rock(p->figure);
  const bool low_left = low_side(p) < 0;
  const tp_spot left = tp_view_spot(&p->view, (tp_spot){rock.x0, rock.bottom});
  const tp_spot right = tp_view_spot(&p->view, (tp_spot){rock.x1, rock.bottom});
  const double side = low_left ? 1 : -1, length = hypot(right.x - left.x, right.y - left.y);
  const tp_spot slope = up_the_base(p, side);
  wedge w = {.low = low_left ? left : right};
  w.radius = fmax(SHORTEST, fmin(LONGEST, 0.6 * length));
  const double reach = 1.25 * w.radius, far = fmax(reach, length);
  w.level = (tp_spot){w.low.x + side * reach, w.low.y};
  w.high = (tp_spot){w.low.x + far * slope.x, w.low.y + far * slope.y};
  const double half = atan2(-slope.y, side * slope.x) / 2;
  w.middle = (tp_spot){side * cos(half), -sin(half)};
  w.on_arc = (tp_spot){w.low.x + w.radius * w.middle.x, w.low.y + w.radius * w.middle.y};
  return w;
}

void tp_figure_draw_tilt(tp_panel *p) {
  cairo_t *cr = p->cr;
  if (low_side(p) == 0) return;
  const wedge w = find_wedge(p);
  const double from = atan2(w.high.y - w.low.y, w.high.x - w.low.x);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 0.6);
  cairo_move_to(cr, w.level.x, w.level.y);
  cairo_line_to(cr, w.low.x, w.low.y);
  cairo_line_to(cr, w.high.x, w.high.y);
  cairo_stroke(cr);
  tp_label_room_line(&p->room, w.low, w.level);
  tp_label_room_line(&p->room, w.low, w.high);
  if (low_side(p) < 0) {
    cairo_arc(cr, w.low.x, w.low.y, w.radius, from, 0);
  } else {
    cairo_arc_negative(cr, w.low.x, w.low.y, w.radius, from, -4 * atan(1));
  }
  cairo_stroke(cr);
  const tp_spot along = up_the_base(p, low_side(p) < 0 ? 1 : -1);
  tp_label_room_line(
      &p->room, (tp_spot){w.low.x + w.radius * along.x, w.low.y + w.radius * along.y}, w.on_arc);
  const double level = w.level.x > w.low.x ? w.radius : -w.radius;
  tp_label_room_line(&p->room, w.on_arc, (tp_spot){w.low.x + level, w.low.y});
}

/* What the wedge shows. */
static tp_bounded dip_of(const tp_panel *p) {
  const tp_frame_result *frame = &p->figure->solution->frame;
  return frame->level ? frame->dip_deg : p->state->tilt_deg;
}

void tp_figure_label_tilt(tp_panel *p) {
  if (low_side(p) == 0) return;
  const wedge w = find_wedge(p);
  char number[TP_NUMBER_SIZE], text[TP_NUMBER_SIZE + 8];
  tp_box box;
  snprintf(text, sizeof text, "%s°", tp_text_fixed(number, dip_of(p), 2));
  tp_figure_set_decimals(p->figure, text);
  tp_figure_font(p->cr, TP_BODY_SIZE, true);
  tp_figure_ink(p->cr, TP_INK_BLACK);
  if (tp_label_room_find(&box, &p->room, w.on_arc, w.middle, tp_figure_text_width(p->cr, text) + 2,
                         TP_BODY_SIZE + 1, 40, false)) {
    tp_figure_text_in(p->cr, box, text);
  }
}
