/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Forces in contacts as arrows, and lines of thrust: through a block that two contacts alone hold,
 * from where the one presses to where the other does; through one on the ground, as a column in a
 * row, between the two blocks that press it from either side. */

#include "figure/blocks.h"

#include <math.h>
#include <stdlib.h>

/* Where two contacts press a block, of more in number, and the way in which they do. */
typedef struct ends {
  size_t count;
  tp_spot at[2], way[2];
} ends;

/* By block: of all contacts, and of those with blocks that are free. */
typedef struct pressed {
  ends all, free;
} pressed;

static void add_end(ends *own, tp_spot at, tp_spot way) {
  if (own->count < 2) {
    own->at[own->count] = at;
    own->way[own->count] = way;
  }
  own->count++;
}

static void press(pressed *own, bool by_ground, tp_spot at, tp_spot way) {
  add_end(&own->all, at, way);
  if (!by_ground) add_end(&own->free, at, way);
}

/* NULL: no one line goes through the block. */
static const ends *thrust_of(const pressed *own) {
  const ends *free = &own->free;
  if (own->all.count == 2) return &own->all;
  const double turn = free->way[0].x * free->way[1].x + free->way[0].y * free->way[1].y;
  return free->count == 2 && turn < 0 ? free : NULL;
}

static void draw_thrust(tp_blocks_panel *p, const pressed *all) {
  static const double dashes[] = {4, 1.5, 1, 1.5};
  cairo_save(p->cr);
  cairo_set_dash(p->cr, dashes, 4, 0);
  cairo_set_line_width(p->cr, 0.7);
  tp_figure_ink(p->cr, TP_INK_BLUE);
  cairo_new_path(p->cr);
  for (size_t k = 0; k < p->figure->shapes.count; k++) {
    const ends *own = p->figure->system->blocks[k].ground ? NULL : thrust_of(all + k);
    if (own == NULL) continue;
    p->has_thrust = true;
    const tp_spot a = tp_view_spot(&p->view, own->at[0]);
    const tp_spot b = tp_view_spot(&p->view, own->at[1]);
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
    const tp_system_contact *contact = f->system->contacts + k;
    const tp_system_block *blocks = f->system->blocks;
    const tp_spot along = f->shapes.contacts[k].along;
    press(all + contact->first, blocks[contact->second].ground, to, (tp_spot){-along.y, along.x});
    press(all + contact->second, blocks[contact->first].ground, to, (tp_spot){along.y, -along.x});
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
