/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rounds the exact points of a problem to doubles in units of the block's size; arcs and rounded
 * corners become curved steps of the chains, elements are limited to 400. */

#include "shape/shape.h"

#include "common/message.h"
#include "problem/drawn.h"
#include "scene/partial_factors.h"
#include "stability/earthquakes.h"
#include "stability/solution.h"

#include <arb.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ELEMENTS = 400 };

static void clear(tp_shape *shape) {
  tp_chain_clear(&shape->outline);
  for (size_t k = 0; k < shape->part_count; k++) tp_chain_clear(shape->parts + k);
  free(shape->parts);
  tp_chain_clear(&shape->base);
  tp_chain_clear(&shape->contact);
  tp_chain_clear(&shape->elements);
  memset(shape, 0, sizeof *shape);
}

double tp_shape_nearest(const fmpq_t value) {
  arf_t own;
  arf_init(own);
  (void)arf_fmpz_div_fmpz(own, fmpq_numref(value), fmpq_denref(value), DBL_MANT_DIG, ARF_RND_NEAR);
  const double near = arf_get_d(own, ARF_RND_NEAR);
  arf_clear(own);
  return near;
}

static double rounded(const fmpz *steps, const fmpq *step_m) {
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul_fmpz(metres, step_m, steps);
  const double value = tp_shape_nearest(metres);
  fmpq_clear(metres);
  return value;
}

tp_spot tp_shape_of_point(const tp_shape *shape, const tp_lattice *l, long point) {
  return (tp_spot){rounded(l->x + point, l->step_m) / shape->unit_m,
                   rounded(l->y + point, l->step_m) / shape->unit_m};
}

tp_spot tp_shape_of_metres(const tp_shape *shape, tp_bounded x_m, tp_bounded y_m) {
  const double x = (x_m.value - shape->drawn_origin_m.x) / shape->unit_m;
  const double y = (y_m.value - shape->drawn_origin_m.y) / shape->unit_m;
  return (tp_spot){shape->axis.x * x + shape->axis.y * y, shape->axis.x * y - shape->axis.y * x};
}

static double of_scene(const tp_shape *shape, const tp_problem *problem, const fmpq *value,
                       const fmpz *origin) {
  fmpq_t metres, start;
  fmpq_init(metres);
  fmpq_init(start);
  fmpq_mul_fmpz(start, problem->lattice.step_m, origin);
  fmpq_mul(metres, value, problem->scene->metres_per_unit);
  fmpq_sub(metres, metres, start);
  const double result = tp_shape_nearest(metres) / shape->unit_m;
  fmpq_clear(metres);
  fmpq_clear(start);
  return result;
}

tp_spot tp_shape_of_scene(const tp_shape *shape, const tp_problem *problem, const fmpq_t x,
                          const fmpq_t y) {
  return (tp_spot){of_scene(shape, problem, x, problem->lattice.origin_x),
                   of_scene(shape, problem, y, problem->lattice.origin_y)};
}

/* The block's size, and its box in units of it. */
static void measure(tp_shape *shape, const tp_lattice *l) {
  long low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  for (long k = 1; k < l->start[1]; k++) {
    if (fmpz_cmp(l->x + k, l->x + low_x) < 0) low_x = k;
    if (fmpz_cmp(l->x + k, l->x + high_x) > 0) high_x = k;
    if (fmpz_cmp(l->y + k, l->y + low_y) < 0) low_y = k;
    if (fmpz_cmp(l->y + k, l->y + high_y) > 0) high_y = k;
  }
  shape->unit_m = 1;
  shape->unit_m =
      fmax(tp_shape_of_point(shape, l, high_x).x - tp_shape_of_point(shape, l, low_x).x,
           tp_shape_of_point(shape, l, high_y).y - tp_shape_of_point(shape, l, low_y).y);
  shape->origin_x_m = rounded(l->origin_x, l->step_m);
  shape->origin_y_m = rounded(l->origin_y, l->step_m);
  shape->box =
      (tp_box){tp_shape_of_point(shape, l, low_x).x, tp_shape_of_point(shape, l, low_y).y,
               tp_shape_of_point(shape, l, high_x).x, tp_shape_of_point(shape, l, high_y).y};
}

/* Where the origin and the direction of x are among the results, which have the coordinates of the
 * drawing. */
static void place(tp_shape *shape, const tp_problem *problem) {
  const tp_lattice *l = &problem->lattice;
  const fmpq *metres = problem->scene->metres_per_unit;
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_mul_fmpz(x, l->step_m, l->origin_x);
  fmpq_mul_fmpz(y, l->step_m, l->origin_y);
  fmpq_div(x, x, metres);
  fmpq_div(y, y, metres);
  tp_drawn_point(x, y, problem);
  fmpq_mul(x, x, metres);
  fmpq_mul(y, y, metres);
  shape->drawn_origin_m = (tp_spot){tp_shape_nearest(x), tp_shape_nearest(y)};
  tp_drawn_axis(x, y, problem);
  shape->axis = (tp_spot){tp_shape_nearest(x), tp_shape_nearest(y)};
  fmpq_clear(x);
  fmpq_clear(y);
}

/* A rounded corner: tangent points r / tan(theta / 2) from the vertex, towards both neighbours. */
typedef struct round_corner {
  tp_spot before, after, centre;
  double radius;
} round_corner;

static tp_spot unit_vector(tp_spot from, tp_spot to) {
  const double length = hypot(to.x - from.x, to.y - from.y);
  return (tp_spot){(to.x - from.x) / length, (to.y - from.y) / length};
}

static round_corner find_round(const tp_shape *shape, const tp_lattice *l, const tp_corner *c) {
  const tp_spot p = tp_shape_of_point(shape, l, c->vertex);
  const tp_spot u = unit_vector(p, tp_shape_of_point(shape, l, c->before));
  const tp_spot w = unit_vector(p, tp_shape_of_point(shape, l, c->after));
  const double half = atan2(w.x * u.y - w.y * u.x, u.x * w.x + u.y * w.y) / 2;
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, c->radius, l->step_m);
  const double r = fmpq_get_d(metres) / shape->unit_m, along = r / tan(half);
  fmpq_clear(metres);
  return (round_corner){{p.x + along * u.x, p.y + along * u.y},
                        {p.x + along * w.x, p.y + along * w.y},
                        /* r to the left of the edge that runs into the vertex */
                        {p.x + along * u.x + r * u.y, p.y + along * u.y - r * u.x},
                        r};
}

/* From the end of the chain to `to` about the centre, the shorter way; a flat one is straight. */
static bool add_turn(tp_chain *chain, tp_spot to, tp_spot centre) {
  const tp_spot from = chain->nodes[chain->count - 1].at;
  const tp_spot a = {from.x - centre.x, from.y - centre.y}, b = {to.x - centre.x, to.y - centre.y};
  const double sweep = atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  const double radius = hypot(a.x, a.y);
  if (fabs(sweep) < 1e-6) return tp_chain_add(chain, TP_STEP_LINE, to);
  if (!tp_chain_add_arc(chain, centre, radius, radius, atan2(a.y, a.x), sweep)) return false;
  chain->nodes[chain->count - 1].at = to; /* on the edge that goes on from there */
  return true;
}

static bool add_tip(tp_chain *chain, const tp_shape *shape, const tp_problem *problem,
                    const tp_arc_tip *tip) {
  return tp_chain_add(chain, chain->count == 0 ? TP_STEP_JUMP : TP_STEP_LINE,
                      tp_shape_of_scene(shape, problem, tip->before_x, tip->before_y)) &&
         add_turn(chain, tp_shape_of_scene(shape, problem, tip->after_x, tip->after_y),
                  tp_shape_of_scene(shape, problem, tip->centre_x, tip->centre_y));
}

static bool add_corner(tp_chain *chain, const tp_shape *shape, const tp_lattice *l,
                       const tp_corner *corner) {
  const round_corner c = find_round(shape, l, corner);
  return tp_chain_add(chain, chain->count == 0 ? TP_STEP_JUMP : TP_STEP_LINE, c.before) &&
         add_turn(chain, c.after, c.centre);
}

/* A spot of an ellipse about the origin of the scene, which is turned about that. */
static tp_spot turned(tp_spot at, const tp_ellipse *e, tp_spot origin) {
  const double c = fmpq_get_d(e->cosine), s = fmpq_get_d(e->sine);
  return (tp_spot){origin.x + c * at.x + s * at.y, origin.y + c * at.y - s * at.x};
}

/* The ellipse above its flat, in the scene about x = 0. */
static bool add_ellipse(tp_shape *shape, const tp_problem *problem) {
  const tp_ellipse *e = problem->section.ellipse;
  const double unit = shape->unit_m / fmpq_get_d(problem->scene->metres_per_unit);
  const double half_x = fmpq_get_d(e->width.value) / 2 / unit;
  const double half_y = fmpq_get_d(e->height.value) / 2 / unit;
  const double cut = asin(fmpq_get_d(e->flat.value) / fmpq_get_d(e->width.value));
  fmpq_t zero;
  fmpq_init(zero);
  const tp_spot origin = tp_shape_of_scene(shape, problem, zero, zero);
  fmpq_clear(zero);
  tp_spot centre = e->cosine == NULL ? origin : (tp_spot){0, 0};
  centre.y += half_y * cos(cut);
  const double half_turn = acos(-1);
  const tp_spot start = {centre.x + half_x * sin(cut), centre.y - half_y * cos(cut)};
  const bool done = tp_chain_add(&shape->outline, TP_STEP_JUMP, start) &&
                    tp_chain_add_arc(&shape->outline, centre, half_x, half_y, cut - half_turn / 2,
                                     2 * (half_turn - cut));
  for (size_t k = 0; e->cosine != NULL && k < shape->outline.count; k++) {
    tp_chain_node *node = shape->outline.nodes + k;
    node->at = turned(node->at, e, origin);
    for (int i = 0; i < 2; i++) node->control[i] = turned(node->control[i], e, origin);
  }
  return done;
}

static bool add_ring(tp_chain *chain, const tp_shape *shape, const tp_lattice *l, long ring) {
  bool done = true;
  for (long k = l->start[ring]; k < l->start[ring + 1] && done; k++) {
    done = tp_chain_add(chain, k == l->start[ring] ? TP_STEP_JUMP : TP_STEP_LINE,
                        tp_shape_of_point(shape, l, k));
  }
  return done;
}

static bool add_outline(tp_shape *shape, const tp_problem *problem) {
  const tp_lattice *l = &problem->lattice;
  const tp_arc_tips *tips = &problem->section.arc_tips;
  if (problem->section.ellipse != NULL) return add_ellipse(shape, problem);
  tp_chain *chain = &shape->outline;
  bool done = true;
  long tip = 0; /* in the order of the ring */
  for (long k = 0; k < l->start[1] && done; k++) {
    const tp_corner *corner = tp_corners_at(&problem->corners, k);
    if (tip < tips->count && tips->items[tip].vertex == k) {
      done = add_tip(chain, shape, problem, tips->items + tip++);
    } else if (corner != NULL) {
      done = add_corner(chain, shape, l, corner);
    } else {
      done = tp_chain_add(chain, chain->count == 0 ? TP_STEP_JUMP : TP_STEP_LINE,
                          tp_shape_of_point(shape, l, k));
    }
  }
  return done;
}

static tp_spot contact_spot(const tp_shape *shape, const tp_problem *problem, tp_outline_point at) {
  if (at.cut == NULL) return tp_shape_of_point(shape, &problem->lattice, at.point);
  const round_corner c = find_round(shape, &problem->lattice, at.cut);
  return at.after ? c.after : c.before;
}

static bool add_contact(tp_shape *shape, const tp_problem *problem) {
  tp_chain *chain = &shape->contact;
  bool done = true;
  for (long k = 0; k < problem->contact.facet_count && done; k++) {
    const tp_facet *f = problem->contact.facets + k;
    if (f->q0 == f->q1) continue;
    const tp_spot from = contact_spot(shape, problem, tp_facet_begin(f));
    const tp_spot *last = chain->count > 0 ? &chain->nodes[chain->count - 1].at : NULL;
    if (last == NULL || last->x != from.x || last->y != from.y) {
      done = tp_chain_add(chain, TP_STEP_JUMP, from);
    }
    done = done && tp_chain_add(chain, TP_STEP_LINE, contact_spot(shape, problem, tp_facet_end(f)));
  }
  return done;
}

static bool add_element(tp_chain *chain, const tp_shape *shape, const tp_lattice *l,
                        const tp_exact_element *element) {
  const bool slab = element->kind == TP_ELEMENT_SLAB;
  const tp_spot p = tp_shape_of_point(shape, l, element->corner[0]),
                q = tp_shape_of_point(shape, l, element->corner[1]);
  const tp_spot corners[4] = {p,
                              slab ? (tp_spot){q.x, p.y} : q,
                              slab ? q : tp_shape_of_point(shape, l, element->corner[2]),
                              {p.x, q.y}};
  bool done = true;
  for (int k = 0; k < (slab ? 4 : 3) && done; k++) {
    done = tp_chain_add(chain, k == 0 ? TP_STEP_JUMP : TP_STEP_LINE, corners[k]);
  }
  return done;
}

static bool fill(tp_shape *shape, const tp_problem *problem, bool elements) {
  const tp_lattice *l = &problem->lattice;
  const tp_section *section = &problem->section;
  bool done = add_outline(shape, problem) && add_contact(shape, problem);
  for (long k = 0; k < section->hole_count && done; k++) {
    done = add_ring(&shape->outline, shape, l, 1 + k);
  }
  for (size_t k = 0; k < shape->part_count && done; k++) {
    shape->parts[k].closed = true;
    done = add_ring(shape->parts + k, shape, l, 1 + section->hole_count + (long)k);
  }
  for (long k = 0; k <= problem->base.edge_count && done; k++) {
    done = tp_chain_add(&shape->base, k == 0 ? TP_STEP_JUMP : TP_STEP_LINE,
                        tp_shape_of_point(shape, l, l->start[section->ring_count] + k));
  }
  if (!elements || !problem->has_elements || problem->elements.count > MOST_ELEMENTS) return done;
  for (long k = 0; k < problem->elements.count && done; k++) {
    done = add_element(&shape->elements, shape, l, problem->elements.items + k);
  }
  return done;
}

/* On failure `shape` is cleared. */
static tp_status init(tp_shape *shape, const tp_problem *problem, bool elements,
                      tp_message *message) {
  memset(shape, 0, sizeof *shape);
  shape->outline.closed = shape->elements.closed = true;
  measure(shape, &problem->lattice);
  place(shape, problem);
  shape->part_count = (size_t)problem->section.part_count;
  shape->parts = calloc(shape->part_count + 1, sizeof *shape->parts);
  if (shape->parts != NULL && fill(shape, problem, elements)) return TP_OK;
  if (shape->parts == NULL) shape->part_count = 0;
  clear(shape);
  return tp_fail_memory(message, "the figure");
}

/* The scene that the solution is of: with partial factors those of the combination that governs. */
static tp_status work_on(const tp_scene *scene, const tp_solution *solution, tp_shape_work *work,
                         void *context, tp_message *message) {
  tp_solution *notes = tp_solution_new(); /* of the preparation, not wanted */
  if (notes == NULL) return tp_fail_memory(message, "the figure");
  tp_problem problem;
  tp_scene shaken;
  tp_earthquake_scene(&shaken, scene, solution);
  tp_solve_options options = tp_solve_options_default();
  options.elements = solution->case_count > 0 && solution->cases[0].elements.account_count > 0;
  tp_status status = tp_problem_init(&problem, &shaken, &options, notes, message);
  if (status == TP_OK) {
    tp_shape shape;
    status = init(&shape, &problem, options.elements, message);
    if (status == TP_OK) {
      status = work(&problem, &shape, context, message);
      clear(&shape);
    }
    tp_problem_clear(&problem);
  }
  tp_solution_free(notes);
  return status;
}

tp_status tp_shape_work_on(const tp_scene *scene, const tp_solution *solution, tp_shape_work *work,
                           void *context, tp_message *message) {
  if (scene->partial_factors == NULL || solution->partial_factors == NULL) {
    return work_on(scene, solution, work, context, message);
  }
  tp_scene factored;
  tp_status status = tp_factored_init(&factored, scene, solution->combination, message);
  if (status != TP_OK) return status;
  status = work_on(&factored, solution, work, context, message);
  tp_factored_clear(&factored);
  return status;
}
