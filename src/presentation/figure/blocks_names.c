/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of blocks where they fit: level, or along a side of what is drawn, in letters that can
 * still be read, off the arrows where possible. */

#include "figure/blocks.h"
#include "output/encode.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 100 }; /* bytes of a name that may fit */
#define ROOM 1.2        /* around a name, points */

/* The sides of a block on the page, about its centroid, as one sees them who reads along a
 * direction. */
typedef struct field {
  size_t side_count;
  tp_spot (*sides)[2];
  size_t arrow_count;
  tp_spot (*arrows)[2];
} field;

static tp_spot seen(tp_spot p, tp_spot middle, double angle) {
  const double x = p.x - middle.x, y = p.y - middle.y;
  return (tp_spot){cos(angle) * x + sin(angle) * y, cos(angle) * y - sin(angle) * x};
}

static void see(field *seen_field, const tp_blocks_panel *p, const tp_chain *outline,
                tp_spot middle, double angle) {
  seen_field->side_count = 0;
  size_t first = 0;
  for (size_t k = 0; k < outline->count; k++) {
    if (outline->nodes[k].step == TP_STEP_JUMP) first = k;
    const bool last = k + 1 == outline->count || outline->nodes[k + 1].step == TP_STEP_JUMP;
    const tp_spot a = tp_view_spot(&p->view, outline->nodes[k].at);
    const tp_spot b = tp_view_spot(&p->view, outline->nodes[last ? first : k + 1].at);
    seen_field->sides[seen_field->side_count][0] = seen(a, middle, angle);
    seen_field->sides[seen_field->side_count++][1] = seen(b, middle, angle);
  }
  for (size_t k = 0; k < p->arrow_count; k++) {
    seen_field->arrows[k][0] = seen(p->arrows[k][0], middle, angle);
    seen_field->arrows[k][1] = seen(p->arrows[k][1], middle, angle);
  }
  seen_field->arrow_count = p->arrow_count;
}

/* A place for a box of this size; first off the arrows, then on them. */
static bool find_place(tp_box *place, const field *own, double width, double height) {
  static const double shifts[] = {0, 1, -1, 2, -2, 3, -3, 4, -4};
  enum { SHIFTS = sizeof shifts / sizeof shifts[0] };
  for (int off_arrows = 1; off_arrows >= 0; off_arrows--) {
    for (int k = 0; k < SHIFTS * SHIFTS; k++) {
      const tp_spot at = {shifts[k % SHIFTS] * height, shifts[k / SHIFTS] * height};
      const tp_box box = {at.x - width / 2 - ROOM, at.y - height / 2 - ROOM,
                          at.x + width / 2 + ROOM, at.y + height / 2 + ROOM};
      const tp_spot(*sides)[2] = (const tp_spot(*)[2])own->sides;
      if (tp_box_among_sides(&box, sides, own->side_count) != TP_BOX_INSIDE) continue;
      const tp_spot(*arrows)[2] = (const tp_spot(*)[2])own->arrows;
      if (off_arrows == 1 && tp_box_among_sides(&box, arrows, own->arrow_count) == TP_BOX_ACROSS) {
        continue;
      }
      *place = box;
      return true;
    }
  }
  return false;
}

/* On a rim of the block's own tint, so that lines end beside it. */
static void write_in(cairo_t *cr, const tp_box *box, tp_ink tint, const char *name) {
  cairo_text_extents_t ink;
  cairo_text_extents(cr, name, &ink);
  const double x = (box->x0 + box->x1 - ink.width) / 2 - ink.x_bearing;
  const double y = (box->y0 + box->y1 - ink.height) / 2 - ink.y_bearing;
  cairo_new_path(cr);
  cairo_move_to(cr, x, y);
  cairo_text_path(cr, name);
  tp_figure_ink(cr, tint);
  cairo_set_line_width(cr, 2 * ROOM);
  cairo_stroke(cr);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_text(cr, x, y, name);
}

static void write_at(const tp_blocks_panel *p, size_t block, const char *name, tp_spot middle,
                     double angle, const tp_box *box) {
  cairo_save(p->cr);
  cairo_translate(p->cr, middle.x, middle.y);
  cairo_rotate(p->cr, angle);
  write_in(p->cr, box, tp_blocks_tint(p->figure, block), name);
  cairo_restore(p->cr);
}

/* An angle of the page, y down, at which letters stand upright or lean to the left. */
static double readable(double angle) {
  const double turn = 4 * atan(1);
  while (angle > turn / 2) angle -= turn;
  while (angle <= -turn / 2 - 1e-9) angle += turn;
  return angle;
}

static void draw_name(const tp_blocks_panel *p, size_t block, const char *name, field *own) {
  static const double sizes[] = {7.5, 6.5, 5.5, 4.5};
  const tp_block_shape *shape = p->figure->shapes.blocks + block;
  const double turn = p->figure->turn, quarter = 2 * atan(1);
  const double angles[] = {0, readable(-turn), readable(-turn - quarter)};
  const tp_spot middle = tp_view_spot(&p->view, shape->centroid);
  for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
    tp_figure_font(p->cr, sizes[s], false);
    cairo_text_extents_t ink;
    cairo_text_extents(p->cr, name, &ink);
    for (size_t k = 0; k < sizeof angles / sizeof angles[0]; k++) {
      tp_box place;
      see(own, p, &shape->outline, middle, angles[k]);
      if (!find_place(&place, own, ink.width, sizes[s])) continue;
      write_at(p, block, name, middle, angles[k], &place);
      return;
    }
  }
}

/* Smaller than any letter: nothing is tried. */
static bool is_large(const tp_blocks_panel *p, size_t block) {
  const double least = 4.5;
  const double unit = p->view.scale / p->figure->shapes.unit_m;
  return unit * sqrt(p->figure->system->blocks[block].area_m2.value) > least;
}

bool tp_blocks_draw_names(const tp_blocks_panel *p) {
  const tp_blocks_figure *f = p->figure;
  size_t most = 0;
  for (size_t k = 0; k < f->shapes.count; k++) {
    const size_t count = f->shapes.blocks[k].outline.count;
    if (count > most) most = count;
  }
  field own = {.sides = calloc(most + 1, sizeof *own.sides),
               .arrows = calloc(p->arrow_count + 1, sizeof *own.arrows)};
  bool done = own.sides != NULL && own.arrows != NULL;
  for (size_t k = 0; k < f->shapes.count && done; k++) {
    const char *name = f->system->blocks[k].name;
    if (f->system->blocks[k].ground || strlen(name) > LONGEST || !is_large(p, k)) continue;
    tp_text plain = {0};
    tp_text_add(&plain, "%s", "");
    tp_encode_plain(&plain, name);
    done = !plain.failed;
    if (done) draw_name(p, k, plain.data, &own);
    tp_text_drop(&plain);
  }
  free(own.sides);
  free(own.arrows);
  return done;
}
