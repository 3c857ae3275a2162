/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The drawing of a solved scene for CAD, layer by layer: outlines exact to a double, arcs and
 * rounded corners as bulges, ellipses as chords; what acts on the block in the direction that
 * governs; and what the report says first. */

#include "figure/dxf.h"

#include "common/message.h"
#include "output/encode.h"
#include "report/governing.h"
#include "report/words.h"
#include "stability/severity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- outlines ----------------------------------------------------------------------------------
 */

static void add_ring(tp_cad *d, tp_cad_layer layer, long first, long end, bool closed) {
  tp_cad_polyline(&d->text, layer, closed);
  for (long k = first; k < end; k++) tp_cad_vertex(&d->text, layer, tp_cad_of_point(d, k), 0);
  tp_cad_polyline_end(&d->text, layer);
}

/* How far a cubic step of a chain goes round: of an arc of a circle the bulge of its ends. */
static double bulge_of(const tp_chain_node *from, const tp_chain_node *to) {
  const tp_spot u = {to->control[0].x - from->at.x, to->control[0].y - from->at.y};
  const tp_spot v = {to->at.x - to->control[1].x, to->at.y - to->control[1].y};
  return tan(atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y) / 4);
}

static tp_spot between(const tp_chain_node *from, const tp_chain_node *to, double t) {
  const double s = 1 - t;
  const double w[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  return (tp_spot){
      w[0] * from->at.x + w[1] * to->control[0].x + w[2] * to->control[1].x + w[3] * to->at.x,
      w[0] * from->at.y + w[1] * to->control[0].y + w[2] * to->control[1].y + w[3] * to->at.y};
}

/* Vertices as they come, of those in one place the last. */
typedef struct tracing {
  tp_cad *d;
  bool any;
  tp_spot first, at; /* at: not yet written, */
  double bulge;      /* with that of what goes on from it */
} tracing;

static bool is_same(tp_spot p, tp_spot q) {
  return p.x == q.x && p.y == q.y;
}

static void go_on(tracing *t, tp_spot to, double bulge) {
  if (!t->any) t->first = to;
  if (t->any && !is_same(t->at, to)) {
    tp_cad_vertex(&t->d->text, TP_CAD_BLOCK, t->at, t->bulge);
  }
  t->any = true;
  t->at = to;
  t->bulge = bulge;
}

static void close_ring(tracing *t) {
  if (t->any && !is_same(t->at, t->first)) {
    tp_cad_vertex(&t->d->text, TP_CAD_BLOCK, t->at, t->bulge);
  }
}

/* The steps of the chain from a node on that go round: the last one's node; a flat arc is one
 * straight step. The first node lies at `from`, exactly, and the last at `to`, where known. */
static size_t add_turn(tracing *t, const tp_chain *chain, size_t node, const tp_spot *from,
                       const tp_spot *to) {
  const tp_chain_node *n = chain->nodes;
  size_t last = node + 1;
  while (last + 1 < chain->count && n[last].step == TP_STEP_CURVE &&
         n[last + 1].step == TP_STEP_CURVE) {
    last++;
  }
  for (size_t k = node; k < last; k++) {
    const double bulge = n[k + 1].step == TP_STEP_CURVE ? bulge_of(n + k, n + k + 1) : 0;
    go_on(t, k == node && from != NULL ? *from : tp_cad_of_spot(t->d, n[k].at), bulge);
  }
  go_on(t, to != NULL ? *to : tp_cad_of_spot(t->d, n[last].at), 0);
  return last;
}

/* The outer ring with arcs and rounded corners: nodes of the chain are, vertex by vertex, that of a
 * corner, or those of what takes its place (shape.c). */
static void add_curved(tp_cad *d) {
  const tp_problem *problem = d->figure->problem;
  const tp_chain *chain = &d->figure->shape.outline;
  const tp_arc_tips *tips = &problem->section.arc_tips;
  tracing t = {.d = d};
  size_t node = 0;
  long tip = 0;
  tp_cad_polyline(&d->text, TP_CAD_BLOCK, true);
  for (long k = 0; k < problem->lattice.start[1]; k++, node++) {
    const tp_arc_tip *own =
        tip < tips->count && tips->items[tip].vertex == k ? tips->items + tip : NULL;
    if (own != NULL) {
      tip++;
      const tp_spot from = tp_cad_of_scene(d, own->before_x, own->before_y);
      const tp_spot to = tp_cad_of_scene(d, own->after_x, own->after_y);
      node = add_turn(&t, chain, node, &from, &to);
    } else if (tp_corners_at(&problem->corners, k) != NULL) {
      node = add_turn(&t, chain, node, NULL, NULL);
    } else {
      go_on(&t, tp_cad_of_point(d, k), 0);
    }
  }
  close_ring(&t);
  tp_cad_polyline_end(&d->text, TP_CAD_BLOCK);
}

static void add_ellipse(tp_cad *d) {
  enum { CHORDS = 64 }; /* of each cubic step */
  const tp_chain *chain = &d->figure->shape.outline;
  tracing t = {.d = d};
  tp_cad_polyline(&d->text, TP_CAD_BLOCK, true);
  for (size_t k = 1; k < chain->count && chain->nodes[k].step == TP_STEP_CURVE; k++) {
    for (int c = k == 1 ? 0 : 1; c <= CHORDS; c++) {
      const tp_spot at = between(chain->nodes + k - 1, chain->nodes + k, (double)c / CHORDS);
      go_on(&t, tp_cad_of_spot(d, at), 0);
    }
  }
  close_ring(&t);
  tp_cad_polyline_end(&d->text, TP_CAD_BLOCK);
}

static void add_outlines(tp_cad *d) {
  const tp_problem *problem = d->figure->problem;
  const tp_section *section = &problem->section;
  const long *start = problem->lattice.start;
  if (section->ellipse != NULL) {
    add_ellipse(d);
  } else if (section->arc_tips.count > 0 || problem->corners.count > 0) {
    add_curved(d);
  } else {
    add_ring(d, TP_CAD_BLOCK, start[0], start[1], true);
  }
  for (long k = 1; k < section->ring_count; k++) {
    const bool hole = k <= section->hole_count;
    add_ring(d, hole ? TP_CAD_HOLE : TP_CAD_PART, start[k], start[k + 1], true);
  }
  const long base = start[section->ring_count];
  add_ring(d, TP_CAD_BASE, base, base + problem->base.edge_count + 1, false);
}

static void add_contact(tp_cad *d) {
  const tp_chain *chain = &d->figure->shape.contact;
  for (size_t k = 1; k < chain->count; k++) {
    if (chain->nodes[k].step == TP_STEP_JUMP) continue;
    tp_cad_line(&d->text, TP_CAD_CONTACT, tp_cad_of_spot(d, chain->nodes[k - 1].at),
                tp_cad_of_spot(d, chain->nodes[k].at));
  }
}

/* ---- forces ------------------------------------------------------------------------------------
 */

static void add_force(tp_cad *d, tp_spot from, tp_spot share, double times, bool ends_there) {
  const tp_spot other = {from.x + times * share.x, from.y + times * share.y};
  tp_cad_arrow(&d->text, TP_CAD_FORCES, tp_cad_of_spot(d, ends_there ? other : from),
               tp_cad_of_spot(d, ends_there ? from : other));
}

static void add_forces(tp_cad *d, const tp_state *s) {
  const double dot = 0.01;
  add_force(d, s->centroid, s->gravity, s->arrow, false);
  tp_cad_circle(&d->text, TP_CAD_FORCES, tp_cad_of_spot(d, s->centroid), dot * tp_cad_unit(d));
  if (s->has_resultant) {
    add_force(d, s->resultant.at, s->resultant.share, s->arrow, false);
  }
  for (size_t k = 0; k < s->reaction_count; k++) {
    add_force(d, s->reactions[k].at, s->reactions[k].share, -s->arrow, true);
  }
}

/* ---- words -------------------------------------------------------------------------------------
 */

/* Lines below the block, one under the other. */
typedef struct column {
  tp_cad *d;
  tp_spot at;
  double height;
} column;

static void add_line(column *c, tp_text *line) {
  const double spacing = 1.7;
  if (line->data != NULL) tp_cad_text(&c->d->text, TP_CAD_TEXT, c->at, c->height, line->data);
  c->at.y -= spacing * c->height;
  c->d->text.failed = c->d->text.failed || line->failed;
  tp_text_drop(line);
}

/* Left of and below all that is drawn of the block as it lies. */
static tp_spot lower_left(const tp_cad *d, double height) {
  const tp_box *box = &d->figure->shape.box;
  const tp_spot corners[4] = {
      {box->x0, box->y0}, {box->x1, box->y0}, {box->x1, box->y1}, {box->x0, box->y1}};
  tp_spot least = {INFINITY, INFINITY};
  for (int k = 0; k < 4; k++) {
    const tp_spot at = tp_cad_of_spot(d, corners[k]);
    least = (tp_spot){fmin(least.x, at.x), fmin(least.y, at.y)};
  }
  return (tp_spot){least.x, least.y - 6 * height};
}

static void add_words(tp_cad *d, const tp_state *state) {
  const tp_solution *s = d->figure->solution;
  const double height = 0.03 * tp_cad_unit(d);
  column c = {d, lower_left(d, height), height};
  char n[TP_NUMBER_SIZE];
  if (s->title != NULL) {
    tp_text title = {0};
    tp_encode_plain(&title, s->title);
    add_line(&c, &title);
  }
  tp_text stance = {0}, factor = {0}, unit = {0};
  tp_text_add(&stance, "%s", tp_text_stance(s, state->own));
  if (state->kind != TP_STATE_LIES && state->kind != TP_STATE_LEVEL) {
    tp_text_add(&stance, ": forces at a tilt of %s°", tp_text_fixed(n, state->tilt_deg, 3));
  }
  add_line(&c, &stance);
  tp_text_governing(&factor, state->own, " ");
  add_line(&c, &factor);
  const char *lengths = d->figure->problem->scene->length_unit;
  tp_text_add(&unit, "Lengths in %s; forces are not to scale. topple " TP_VERSION, lengths);
  add_line(&c, &unit);
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static void lie_down(tp_cad *d) {
  const tp_problem *problem = d->figure->problem;
  const tp_world *world = problem->placement.world;
  tp_turn_init(&d->lie);
  d->turned = world != NULL && !world->level && world->turn.rises != 0;
  if (d->turned) {
    tp_turn_by(&d->lie, problem->scene->tilt_angle_deg.value, &world->turn);
  }
}

tp_status tp_cad_draw(char **bytes, size_t *length, const tp_figure *figure, tp_message *message) {
  tp_cad d = {.figure = figure};
  const size_t worst = figure->solution->case_count > 0 ? tp_severity_worst(figure->solution) : 0;
  lie_down(&d);
  tp_cad_begin(&d.text, figure->problem->scene->length_unit);
  add_outlines(&d);
  add_contact(&d);
  if (worst < figure->panel_count) {
    tp_cad_add_loads(&d, figure->states + worst);
    add_forces(&d, figure->states + worst);
    add_words(&d, figure->states + worst);
  }
  tp_cad_end(&d.text);
  tp_turn_clear(&d.lie);
  *length = d.text.length;
  return tp_text_finish(&d.text, bytes) == TP_OK ? TP_OK : tp_fail_memory(message, "the figure");
}
