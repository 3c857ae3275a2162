/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The twists of a bracket run against the motion: no force does work on them. Joints dilate in it
 * by their friction (the flow rule of limit analysis), so that one that slips opens by tan(phi) of
 * the slip; one that opens by more than that opens. */

#include "block_system/collapse.h"

#include <math.h>
#include <stdlib.h>

static const double at_rest = 1e-3; /* of the fastest corner */
static const double newtons = 1000; /* in a kN */

typedef struct point {
  double x, y;
} point;

typedef struct moving {
  const tp_assemblage *a;
  const double *twists; /* by row */
  double fastest;       /* of all corners, in the measure of the twists */
} moving;

static double length(const tp_assemblage *a, const fmpz_t from, const fmpz_t to) {
  return tp_assemblage_length(a, from, to).value;
}

/* Of a block's point p, of the lattice. */
static point velocity(const moving *m, const tp_rigid_block *b, double arm_x, double arm_y) {
  if (b->number < 0) return (point){0, 0};
  const double *twist = m->twists + 3 * b->number;
  return (point){-(twist[0] - twist[2] * arm_y), -(twist[1] + twist[2] * arm_x)};
}

static point velocity_at(const moving *m, const tp_rigid_block *b, long p) {
  const tp_lattice *l = &m->a->lattice;
  return velocity(m, b, length(m->a, b->x, l->x + p), length(m->a, b->y, l->y + p));
}

static double fastest_corner(const moving *m, const tp_rigid_block *b) {
  double most = 0;
  for (long p = b->outline; p < b->end && b->number >= 0; p++) {
    const point v = velocity_at(m, b, p);
    most = fmax(most, hypot(v.x, v.y));
  }
  return most;
}

/* ---- joints ------------------------------------------------------------------------------------
 */

typedef struct relative {
  double opens, slips; /* the first block against the second */
} relative;

static relative relative_at(const moving *m, const tp_block_contact *c, long end) {
  const tp_lattice *l = &m->a->lattice;
  const point first = velocity_at(m, m->a->blocks + c->block[0], end);
  const point second = velocity_at(m, m->a->blocks + c->block[1], end);
  const double dx = length(m->a, l->x + c->along[0], l->x + c->along[1]);
  const double dy = length(m->a, l->y + c->along[0], l->y + c->along[1]);
  const double size = hypot(dx, dy) * m->fastest;
  const double x = first.x - second.x, y = first.y - second.y;
  return (relative){(dx * y - dy * x) / size, (dx * x + dy * y) / size};
}

static bool is_hinge(const relative *r) {
  return fabs(r->opens) <= at_rest && fabs(r->slips) <= at_rest;
}

static tp_joint_state state_of(const moving *m, const tp_block_contact *c, double tangent) {
  bool slips = false, opens = false;
  for (int e = 0; e < 2; e++) {
    const relative r = relative_at(m, c, c->ends[e]);
    slips = slips || fabs(r.slips) > at_rest;
    opens = opens || r.opens > tangent * fabs(r.slips) + at_rest;
  }
  return opens ? TP_JOINT_OPENS : slips ? TP_JOINT_SLIPS : TP_JOINT_AT_REST;
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

/* By the number of a block: it turns about an end of one of its joints. */
static bool *find_hinged(const moving *m) {
  bool *hinged = calloc((size_t)m->a->count, sizeof *hinged);
  for (long k = 0; k < m->a->contact_count && hinged != NULL; k++) {
    const tp_block_contact *c = m->a->contacts + k;
    for (int e = 0; e < 2; e++) {
      const relative r = relative_at(m, c, c->ends[e]);
      if (!is_hinge(&r)) continue;
      hinged[c->block[0]] = hinged[c->block[1]] = true;
    }
  }
  return hinged;
}

static void describe_block(tp_system_motion *own, const moving *m, long block, bool hinged,
                           double metre) {
  const tp_rigid_block *b = m->a->blocks + block;
  *own = (tp_system_motion){.mechanism = TP_STANDS};
  const double corner = fastest_corner(m, b);
  if (corner <= at_rest * m->fastest) return;
  const point centre = velocity(m, b, b->arm_x.value, b->arm_y.value);
  own->velocity_x = centre.x / m->fastest;
  own->velocity_y = centre.y / m->fastest;
  const bool turns = corner - hypot(centre.x, centre.y) > at_rest * corner;
  if (turns) own->turn_per_m = -m->twists[3 * b->number + 2] / m->fastest / metre;
  own->mechanism = !turns ? TP_SLIDES : hinged ? TP_TOPPLES : TP_SLIDES_AND_TOPPLES;
}

/* ---- forces ------------------------------------------------------------------------------------
 */

/* So much of a column, as it acts on the first block. */
static void add_force(point *sum, const tp_force_column *column, double force) {
  const int side = column->row[0] >= 0 ? 0 : 1;
  const double own = side == 0 ? force : -force;
  sum->x += own * column->entry[side][0].value;
  sum->y += own * column->entry[side][1].value;
}

static point place_of(const tp_assemblage *a, long p) {
  const tp_lattice *l = &a->lattice;
  fmpq_t metres;
  fmpq_init(metres);
  point place;
  tp_lattice_metres_x(metres, l, l->x + p);
  place.x = fmpq_get_d(metres);
  tp_lattice_metres_y(metres, l, l->y + p);
  place.y = fmpq_get_d(metres);
  fmpq_clear(metres);
  return place;
}

/* Normal forces of both ends and the shear force: the cones', less the tension by which those were
 * moved, half of it at each end, and what is used of the cohesion. */
static void split_forces(double normals[2], double *shear, const tp_force_program *p, long contact,
                         const tp_contact_strength *strength, const double *forces) {
  const tp_block_contact *c = p->assemblage->contacts + contact;
  const tp_lattice *l = &p->assemblage->lattice;
  const double dx = length(p->assemblage, l->x + c->along[0], l->x + c->along[1]);
  const double dy = length(p->assemblage, l->y + c->along[0], l->y + c->along[1]);
  const double size = hypot(dx, dy);
  const double touching = hypot(length(p->assemblage, l->x + c->ends[0], l->x + c->ends[1]),
                                length(p->assemblage, l->y + c->ends[0], l->y + c->ends[1]));
  const long cones = touching > 0 ? 4 : 2;
  normals[0] = normals[1] = *shear = 0;
  for (long k = p->first[contact]; k < p->first[contact + 1]; k++) {
    const long own = k - p->first[contact];
    point f = {0, 0};
    add_force(&f, p->columns + k, forces[k] - (own < cones ? 0 : p->columns[k].most.value / 2));
    *shear += (dx * f.x + dy * f.y) / size;
    if (own < cones) normals[own / 2] += (dx * f.y - dy * f.x) / size;
  }
  for (int e = 0; e < 2; e++) normals[e] -= strength->tension.value * touching / 2;
}

static void describe_force(tp_system_force *own, const tp_force_program *p, long contact,
                           const tp_contact_strength *strength, const double *forces,
                           double scale) {
  const tp_block_contact *c = p->assemblage->contacts + contact;
  const point ends[2] = {place_of(p->assemblage, c->ends[0]), place_of(p->assemblage, c->ends[1])};
  double normals[2], shear;
  split_forces(normals, &shear, p, contact, strength, forces);
  const double sum = normals[0] + normals[1];
  const bool pressed = normals[0] >= 0 && normals[1] >= 0 && sum > 0;
  const double share = pressed ? normals[1] / sum : 1.0 / 2;
  own->normal_n_m = sum * scale;
  own->shear_n_m = shear * scale;
  own->x_m = ends[0].x + share * (ends[1].x - ends[0].x);
  own->y_m = ends[0].y + share * (ends[1].y - ends[0].y);
}

/* ---- both --------------------------------------------------------------------------------------
 */

static tp_status move_blocks(tp_system_motion *motions, moving *m, tp_message *message) {
  const tp_assemblage *a = m->a;
  const double metre = ldexp(fmpq_get_d(a->lattice.step_m), (int)a->length_exponent);
  for (long k = 0; k < a->count; k++) {
    m->fastest = fmax(m->fastest, fastest_corner(m, a->blocks + k));
  }
  if (!(m->fastest > 0)) return TP_OK;
  bool *hinged = find_hinged(m);
  if (hinged == NULL) return tp_fail_memory(message, "the motions");
  for (long k = 0; k < a->count; k++) describe_block(motions + k, m, k, hinged[k], metre);
  free(hinged);
  return TP_OK;
}

tp_status tp_collapse_motions(tp_system_motion *motions, const tp_assemblage *a,
                              const double *twists, tp_message *message) {
  moving m = {.a = a, .twists = twists};
  return move_blocks(motions, &m, message);
}

static tp_status describe_motions(tp_system_case *own, const tp_built_system *s, moving *m,
                                  double divisor, tp_message *message) {
  const tp_assemblage *a = m->a;
  const tp_status status = move_blocks(own->motions, m, message);
  for (long k = 0; k < a->contact_count && status == TP_OK && m->fastest > 0; k++) {
    own->forces[k].state = state_of(m, a->contacts + k, s->strengths[k].tangent.value / divisor);
  }
  return status;
}

tp_status tp_collapse_describe(tp_system_case *own, const tp_built_system *s,
                               const tp_load_bracket *bracket, const tp_system_state *state,
                               double scale, tp_message *message) {
  const tp_assemblage *a = &s->assemblage;
  tp_force_program program;
  tp_status status = tp_built_system_program(&program, s, &state->loads, state->divisor, message);
  if (status != TP_OK) return status;
  const double unit = ldexp(newtons * scale, (int)a->weight_exponent);
  for (long k = 0; k < a->contact_count; k++) {
    const tp_contact_strength strength = tp_built_system_strength(s, k, state->divisor);
    describe_force(own->forces + k, &program, k, &strength, bracket->forces, unit);
  }
  moving m = {.a = a, .twists = bracket->twists};
  status = describe_motions(own, s, &m, state->divisor, message);
  tp_force_program_clear(&program);
  return status;
}
