/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Forces in contacts as arrows, and lines of thrust: through a block that two contacts alone hold,
 * from where the one presses to where the other does. */

#include "figure/blocks.h"

#include <math.h>
#include <stdlib.h>

/* By block: how many contacts press it, and where the first two do. */
typedef struct pressed {
  size_t count;
  tp_spot at[2];
} pressed;

static void press(pressed *own, tp_spot at) {
  if (own->count < 2) own->at[own->count] = at;
  own->count++;
}

static void draw_thrust(tp_blocks_panel *p, const pressed *all) {
  static const double dashes[] = {4, 1.5, 1, 1.5};
  cairo_save(p->cr);
  cairo_set_dash(p->cr, dashes, 4, 0);
  cairo_set_line_width(p->cr, 0.7);
  tp_figure_ink(p->cr, TP_INK_BLUE);
  cairo_new_path(p->cr);
  for (size_t k = 0; k < p->figure->shapes.count; k++) {
    if (all[k].count != 2 || p->figure->system->blocks[k].ground) continue;
    p->has_thrust = true;
    const tp_spot a = tp_view_spot(&p->view, all[k].at[0]);
    const tp_spot b = tp_view_spot(&p->view, all[k].at[1]);
    cairo_move_to(p->cr, a.x, a.y);
    cairo_line_to(p->cr, b.x, b.y);
  }
  cairo_stroke(p->cr);
  cairo_restore(p->cr);
}

bool tp_blocks_draw_forces(tp_blocks_panel *p) {
  const tp_blocks_figure *f = p->figure;
  pressed *all = calloc(f->shapes.count + 1, sizeof *all);
  p->arrows = calloc(f->own->force_count + 1, sizeof *p->arrows);
  const bool done = all != NULL && p->arrows != NULL;
  for (size_t k = 0; k < f->own->force_count && done; k++) {
    tp_spot from, to;
    if (!tp_blocks_force(&from, &to, f, k)) continue;
    press(all + f->system->contacts[k].first, to);
    press(all + f->system->contacts[k].second, to);
    p->arrows[p->arrow_count][0] = tp_view_spot(&p->view, from);
    p->arrows[p->arrow_count++][1] = tp_view_spot(&p->view, to);
  }
  if (done) draw_thrust(p, all);
  tp_figure_ink(p->cr, TP_INK_BLUE);
  for (size_t k = 0; k < p->arrow_count && done; k++) {
    tp_figure_arrow(p->cr, p->arrows[k][0], p->arrows[k][1], 1);
  }
  free(all);
  return done;
}
