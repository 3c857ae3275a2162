/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks for CAD, by the layers of one block: outlines exact to a double, the ground on BASE,
 * contacts, loads, the forces just before the collapse, and on MECHANISM where blocks begin to go.
 * In the scene's own coordinates, so that BLOCK, HOLE and BASE can be read back by a scene's
 * `drawing`; on a slope turned by its dip about the origin, as they lie. */

#include "figure/dxf_blocks.h"

#include "block_system/built_system.h"
#include "common/message.h"
#include "figure/dxf.h"
#include "output/encode.h"
#include "report/system_words.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <string.h>

typedef struct cad {
  tp_text text;
  const tp_blocks_figure *figure;
  const tp_scene *scene;
  bool turned;
  double sine, cosine; /* if turned */
} cad;

/* ---- places ------------------------------------------------------------------------------------
 */

static tp_spot as_it_lies(const cad *d, tp_spot p) {
  if (!d->turned) return p;
  return (tp_spot){d->cosine * p.x - d->sine * p.y, d->sine * p.x + d->cosine * p.y};
}

static tp_spot of_lattice(const cad *d, const tp_lattice *l, long point) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_lattice_metres_x(x, l, l->x + point);
  tp_lattice_metres_y(y, l, l->y + point);
  fmpq_div(x, x, d->scene->metres_per_unit);
  fmpq_div(y, y, d->scene->metres_per_unit);
  const tp_spot at = {tp_shape_nearest(x), tp_shape_nearest(y)};
  fmpq_clear(x);
  fmpq_clear(y);
  return as_it_lies(d, at);
}

static double unit_of(const cad *d) {
  return d->figure->shapes.unit_m / fmpq_get_d(d->scene->metres_per_unit);
}

static tp_spot of_spot(const cad *d, tp_spot spot) {
  const tp_block_shapes *s = &d->figure->shapes;
  const double metres = fmpq_get_d(d->scene->metres_per_unit);
  return as_it_lies(d, (tp_spot){(s->origin_m.x + s->unit_m * spot.x) / metres,
                                 (s->origin_m.y + s->unit_m * spot.y) / metres});
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static void add_rings(cad *d, const tp_built_system *built) {
  const tp_lattice *l = &built->assemblage.lattice;
  long ring = 0;
  for (long k = 0; k < built->count; k++) {
    const tp_section *section = built->sections + k;
    for (long r = 0; r < section->ring_count; r++, ring++) {
      const tp_cad_layer layer = r > section->hole_count ? TP_CAD_PART
                                 : r > 0                 ? TP_CAD_HOLE
                                 : built->given[k].fixed ? TP_CAD_BASE
                                                         : TP_CAD_BLOCK;
      tp_cad_polyline(&d->text, layer, true);
      for (long p = l->start[ring]; p < l->start[ring + 1]; p++) {
        tp_cad_vertex(&d->text, layer, of_lattice(d, l, p), 0);
      }
      tp_cad_polyline_end(&d->text, layer);
    }
  }
}

static void add_names(cad *d) {
  const double height = 0.012 * unit_of(d);
  for (size_t k = 0; k < d->figure->shapes.count; k++) {
    tp_text name = {0};
    if (d->figure->system->blocks[k].ground) continue;
    tp_encode_plain(&name, d->figure->system->blocks[k].name);
    if (name.data != NULL) {
      tp_cad_text(&d->text, TP_CAD_TEXT, of_spot(d, d->figure->shapes.blocks[k].centroid), height,
                  name.data);
    }
    d->text.failed = d->text.failed || name.failed;
    tp_text_drop(&name);
  }
}

static void add_contacts(cad *d) {
  for (size_t k = 0; k < d->figure->shapes.contact_count; k++) {
    const tp_spot *ends = d->figure->shapes.contacts[k].ends;
    if (ends[0].x == ends[1].x && ends[0].y == ends[1].y) continue; /* a corner */
    tp_cad_line(&d->text, TP_CAD_CONTACT, of_spot(d, ends[0]), of_spot(d, ends[1]));
  }
}

/* Outlines of what moves, displaced as the figure has them. */
static void add_mechanism(cad *d) {
  for (size_t k = 0; k < d->figure->shapes.count; k++) {
    const tp_chain *chain = &d->figure->shapes.blocks[k].outline;
    if (d->figure->system->blocks[k].ground || !tp_blocks_moves(d->figure, k)) continue;
    for (size_t n = 0; n < chain->count; n++) {
      if (chain->nodes[n].step == TP_STEP_JUMP) {
        if (n > 0) tp_cad_polyline_end(&d->text, TP_CAD_MECHANISM);
        tp_cad_polyline(&d->text, TP_CAD_MECHANISM, true);
      }
      const tp_spot to = tp_blocks_moved(d->figure, k, chain->nodes[n].at);
      tp_cad_vertex(&d->text, TP_CAD_MECHANISM, of_spot(d, to), 0);
    }
    tp_cad_polyline_end(&d->text, TP_CAD_MECHANISM);
  }
}

/* ---- loads and forces --------------------------------------------------------------------------
 */

static void add_load(cad *d, const tp_load_shape *own) {
  const tp_spot tail = {own->at.x - d->figure->arrow * own->along.x,
                        own->at.y - d->figure->arrow * own->along.y};
  const tp_spot tip = {own->at.x + d->figure->arrow * own->along.x,
                       own->at.y + d->figure->arrow * own->along.y};
  switch (own->kind) {
  case TP_LOAD_PULLS:
    if (own->ends) {
      tp_cad_line(&d->text, TP_CAD_BOLTS, of_spot(d, own->at), of_spot(d, own->to));
    } else {
      tp_cad_arrow(&d->text, TP_CAD_BOLTS, of_spot(d, own->at), of_spot(d, tip));
    }
    break;
  case TP_LOAD_PUSHES:
    tp_cad_arrow(&d->text, TP_CAD_FORCES, of_spot(d, tail), of_spot(d, own->at));
    break;
  default: /* along a line */
    tp_cad_line(&d->text, TP_CAD_FORCES, of_spot(d, own->at), of_spot(d, own->to));
    break;
  }
}

static void add_loads(cad *d) {
  const tp_load_shapes *loads = &d->figure->loads;
  for (size_t k = 0; k < loads->count; k++) add_load(d, loads->items + k);
  if (loads->water.count == 0) return;
  tp_cad_polyline(&d->text, TP_CAD_WATER, false);
  for (size_t k = 0; k < loads->water.count; k++) {
    tp_cad_vertex(&d->text, TP_CAD_WATER, of_spot(d, loads->water.nodes[k].at), 0);
  }
  tp_cad_polyline_end(&d->text, TP_CAD_WATER);
}

static void add_forces(cad *d) {
  for (size_t k = 0; k < d->figure->own->force_count; k++) {
    tp_spot from, to;
    if (!tp_blocks_force(&from, &to, d->figure, k)) continue;
    tp_cad_arrow(&d->text, TP_CAD_FORCES, of_spot(d, from), of_spot(d, to));
  }
}

/* ---- words -------------------------------------------------------------------------------------
 */

/* Left of and below all free blocks as they lie. */
static tp_spot below(const cad *d, double height) {
  const tp_box *b = &d->figure->shapes.box;
  const tp_spot corners[4] = {{b->x0, b->y0}, {b->x1, b->y0}, {b->x1, b->y1}, {b->x0, b->y1}};
  tp_spot least = {INFINITY, INFINITY};
  for (int k = 0; k < 4; k++) {
    const tp_spot at = of_spot(d, corners[k]);
    least = (tp_spot){fmin(least.x, at.x), fmin(least.y, at.y)};
  }
  return (tp_spot){least.x, least.y - 6 * height};
}

static void add_words(cad *d) {
  enum { LINES = 4 };
  const double height = 0.02 * unit_of(d), spacing = 1.7;
  const tp_system_case *c = d->figure->own;
  tp_text lines[LINES] = {{0}, {0}, {0}, {0}};
  if (d->figure->system->title != NULL) tp_encode_plain(lines, d->figure->system->title);
  tp_text_system_stance(lines + 1, d->figure->system, c);
  tp_text_add(lines + 1, ": %s", tp_system_verdict_name(tp_system_case_worst_verdict(c)));
  if (tp_system_case_worst_verdict(c) != c->verdict) {
    tp_text_add(lines + 1, " without the earthquake");
  }
  tp_blocks_factors(lines + 2, d->figure->system, c);
  tp_text_add(lines + 3,
              "Lengths in %s; forces and the mechanism are not to scale. topple " TP_VERSION,
              d->scene->length_unit);
  tp_spot at = below(d, height);
  for (int k = 0; k < LINES; k++) {
    if (lines[k].data != NULL) {
      tp_cad_text(&d->text, TP_CAD_TEXT, at, height, lines[k].data);
      at.y -= spacing * height;
    }
    d->text.failed = d->text.failed || lines[k].failed;
    tp_text_drop(lines + k);
  }
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

tp_status tp_cad_draw_blocks(char **bytes, size_t *length, const tp_blocks_figure *figure,
                             const tp_scene *scene, tp_message *message) {
  tp_built_system built;
  const tp_status status = tp_built_system_init(&built, scene, message);
  if (status != TP_OK) return status;
  cad d = {.figure = figure,
           .scene = scene,
           .turned = tp_scene_lies_in_place(scene) && figure->turn != 0,
           .sine = sin(figure->turn),
           .cosine = cos(figure->turn)};
  tp_cad_begin(&d.text, scene->length_unit);
  add_rings(&d, &built);
  add_contacts(&d);
  add_mechanism(&d);
  add_loads(&d);
  add_forces(&d);
  add_names(&d);
  add_words(&d);
  tp_cad_end(&d.text);
  tp_built_system_clear(&built);
  *length = d.text.length;
  return tp_text_finish(&d.text, bytes) == TP_OK ? TP_OK : tp_fail_memory(message, "the figure");
}
