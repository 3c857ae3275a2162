/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base of a slope: points; a plane from its start on into the slope; or steps about that plane,
 * a tread between two joints of a set and a riser along each, with the lower ends of the treads on
 * the plane. */

#include "jointing/slope_base.h"

#include "number/divide.h"

#include <math.h>
#include <stdlib.h>

/* A joint where it meets the plane of the base. */
typedef struct riser {
  fmpq_t way; /* from the start of the plane */
  const tp_joint_trace *joint;
} riser;

typedef struct stepping {
  tp_cuts *cuts;
  tp_message *message;
  tp_cut_point start, along, tread;
  fmpq_t length; /* longer than the plane is within the section */
} stepping;

static void cross(fmpq_t result, const tp_cut_point *a, const tp_cut_point *b) {
  fmpq_t other;
  fmpq_init(other);
  fmpq_mul(result, a->x, b->y);
  fmpq_mul(other, a->y, b->x);
  fmpq_sub(result, result, other);
  fmpq_clear(other);
}

/* How far from a point along a direction the joint is; false: it is parallel. */
static bool find_way(fmpq_t way, const tp_cut_point *from, const tp_cut_point *along,
                     const tp_joint_trace *joint) {
  tp_cut_point apart;
  fmpq_t turn;
  tp_cut_point_init(&apart);
  fmpq_init(turn);
  fmpq_sub(apart.x, joint->foot.x, from->x);
  fmpq_sub(apart.y, joint->foot.y, from->y);
  cross(way, &apart, &joint->along);
  cross(turn, along, &joint->along);
  const bool meets = tp_divide(way, way, turn);
  tp_cut_point_clear(&apart);
  fmpq_clear(turn);
  return meets;
}

static bool add_base(tp_cuts *cuts, const tp_cut_point *from, const tp_cut_point *to, int set) {
  return tp_cuts_add(cuts, from, to, (tp_cut){TP_CUT_BASE, set});
}

static tp_status add_line(tp_cuts *cuts, tp_message *message) {
  const tp_polyline *line = &cuts->slope->base_line;
  tp_cut_point ends[2];
  bool done = true;
  tp_cut_point_init(ends);
  tp_cut_point_init(ends + 1);
  for (long k = 0; k < line->count && done; k++) {
    tp_cut_point *own = ends + k % 2;
    fmpq_set(own->x, line->x + k);
    fmpq_set(own->y, line->y + k);
    if (cuts->slope->right) fmpq_neg(own->x, own->x);
    if (k > 0) done = add_base(cuts, ends + (k + 1) % 2, own, TP_EDGE_OF_BASE);
  }
  tp_cut_point_clear(ends);
  tp_cut_point_clear(ends + 1);
  return done ? TP_OK : tp_fail_memory(message, "the slope");
}

/* ---- steps -------------------------------------------------------------------------------------
 */

static int compare_risers(const void *first, const void *second) {
  const riser *a = first, *b = second;
  return fmpq_cmp(a->way, b->way);
}

static tp_place steps_place(const stepping *s) {
  return s->cuts->slope->base.place;
}

static tp_status fail_parallel(const stepping *s) {
  return tp_refuse(s->message, TP_FAULT_GEOMETRY, steps_place(s),
                   "joints of set '%s' run along the base or along its treads: name a set that "
                   "crosses both",
                   tp_joint_set_name(s->cuts->slope, s->cuts->slope->stepped_by).text);
}

/* Those behind the start, in their order along the plane. */
static tp_status find_risers(const stepping *s, riser *risers, long *count) {
  const tp_joint_traces *traces = s->cuts->traces + s->cuts->slope->stepped_by;
  for (long k = 0; k < traces->count; k++) {
    riser *own = risers + *count;
    fmpq_init(own->way);
    own->joint = traces->lines + k;
    if (!find_way(own->way, &s->start, &s->along, own->joint)) {
      fmpq_clear(own->way);
      return fail_parallel(s);
    }
    if (fmpq_sgn(own->way) > 0 && fmpq_cmp(own->way, s->length) < 0) {
      ++*count;
    } else {
      fmpq_clear(own->way);
    }
  }
  qsort(risers, (size_t)*count, sizeof *risers, compare_risers);
  return TP_OK;
}

/* A tread from `at` to the joint, and from there along it to the plane, which is `at` then. */
static tp_status add_step(const stepping *s, const riser *own, tp_cut_point *at,
                          tp_cut_point *foot) {
  fmpq_t way;
  fmpq_init(way);
  const bool meets = find_way(way, at, &s->tread, own->joint);
  const bool behind = meets && fmpq_sgn(way) > 0;
  tp_status status = TP_OK;
  if (behind) {
    tp_cut_point_go(foot, at, way, &s->tread);
    bool done = add_base(s->cuts, at, foot, TP_EDGE_OF_BASE);
    tp_cut_point_go(at, &s->start, own->way, &s->along);
    done = done && add_base(s->cuts, foot, at, (int)s->cuts->slope->stepped_by);
    if (!done) status = tp_fail_memory(s->message, "the slope");
  }
  fmpq_clear(way);
  if (behind) return status;
  return meets ? tp_refuse(s->message, TP_FAULT_GEOMETRY, steps_place(s),
                           "joints of set '%s' cross each other near the base, which cannot have "
                           "steps there: give a smaller scatter of their dip",
                           tp_joint_set_name(s->cuts->slope, s->cuts->slope->stepped_by).text)
               : fail_parallel(s);
}

static tp_status add_steps(const stepping *s) {
  long count = 0;
  const size_t room = (size_t)s->cuts->traces[s->cuts->slope->stepped_by].count + 1;
  riser *risers = calloc(room, sizeof *risers);
  if (risers == NULL) return tp_fail_memory(s->message, "the slope");
  tp_cut_point at, foot;
  tp_cut_point_init(&at);
  tp_cut_point_init(&foot);
  fmpq_set(at.x, s->start.x);
  fmpq_set(at.y, s->start.y);
  tp_status status = find_risers(s, risers, &count);
  for (long k = 0; k < count && status == TP_OK; k++) status = add_step(s, risers + k, &at, &foot);
  tp_cut_point_go(&foot, &at, s->length, &s->tread);
  if (status == TP_OK && !add_base(s->cuts, &at, &foot, TP_EDGE_OF_BASE)) {
    status = tp_fail_memory(s->message, "the slope");
  }
  for (long k = 0; k < count; k++) fmpq_clear(risers[k].way);
  free(risers);
  tp_cut_point_clear(&at);
  tp_cut_point_clear(&foot);
  return status;
}

/* Normal to the set, into the slope; or as it is given. */
static void set_tread(stepping *s, const tp_jointed_slope *slope) {
  if (slope->tread_dip_deg.given) {
    tp_direction_of_degrees(&s->tread, slope->tread_dip_deg.value);
    return;
  }
  const tp_joint_set *set = slope->sets + slope->stepped_by;
  fmpq_t angle;
  fmpq_init(angle);
  fmpq_sub_si(angle, set->dip_deg.value, 90);
  if (set->left == slope->right) fmpq_neg(angle, angle);
  tp_direction_of_degrees(&s->tread, angle);
  fmpq_clear(angle);
}

/* ---- the plane ---------------------------------------------------------------------------------
 */

static tp_status add_plane(const stepping *s) {
  tp_cut_point end;
  tp_cut_point_init(&end);
  tp_cut_point_go(&end, &s->start, s->length, &s->along);
  const bool done = add_base(s->cuts, &s->start, &end, TP_EDGE_OF_BASE);
  tp_cut_point_clear(&end);
  return done ? TP_OK : tp_fail_memory(s->message, "the slope");
}

/* A power of two above the distance of the start to all of the section. */
static void set_length(stepping *s) {
  fmpq_t difference;
  fmpq_init(difference);
  fmpq_sub(difference, s->start.x, s->cuts->toe.x);
  double far = fabs(fmpq_get_d(difference));
  fmpq_sub(difference, s->start.y, s->cuts->toe.y);
  far += fabs(fmpq_get_d(difference));
  const int exponent = ilogb(far + tp_cuts_size(s->cuts)) + 2;
  fmpq_one(s->length);
  if (exponent >= 0) {
    fmpq_mul_2exp(s->length, s->length, (unsigned long)exponent);
  } else {
    fmpq_div_2exp(s->length, s->length, (unsigned long)-exponent);
  }
  fmpq_clear(difference);
}

tp_status tp_cuts_base(tp_cuts *cuts, tp_message *message) {
  const tp_jointed_slope *slope = cuts->slope;
  if (slope->base_line.count > 0) return add_line(cuts, message);
  stepping s = {.cuts = cuts, .message = message};
  tp_cut_point_init(&s.start);
  tp_cut_point_init(&s.along);
  tp_cut_point_init(&s.tread);
  fmpq_init(s.length);
  fmpq_set(s.start.x, slope->base_x.given ? slope->base_x.value : slope->toe_x.value);
  fmpq_set(s.start.y, slope->base_x.given ? slope->base_y.value : slope->toe_y.value);
  if (slope->right) fmpq_neg(s.start.x, s.start.x);
  tp_direction_of_degrees(&s.along, slope->base.dip_deg.value);
  set_length(&s);
  if (slope->stepped_by >= 0) set_tread(&s, slope);
  const tp_status status = slope->stepped_by >= 0 ? add_steps(&s) : add_plane(&s);
  tp_cut_point_clear(&s.start);
  tp_cut_point_clear(&s.along);
  tp_cut_point_clear(&s.tread);
  fmpq_clear(s.length);
  return status;
}
