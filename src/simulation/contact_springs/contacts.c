/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One step of all contacts: geometry of each candidate pair, springs carried over between features
 * of one contact, normal force, shear force with Coulomb's limit, and the energies held and lost
 * (docs/tilt_springs.md). */

#include "contact_springs/contacts.h"

#include "common/grow.h"
#include "contact_springs/crossing.h"
#include "contact_springs/tributary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a corner's radius: contacts go over to the next feature within it. */
static const double grace_share = 1e-3;

/* Of the block's extent: a contact in a point stands for so much; no overlap is deeper than so
 * much; what passes into another contact lies no farther from it. */
static const double least_share = 0.01, deepest_share = 0.01, heir_share = 1e-3;

/* Cosines between normals: of contacts that are one, and of those that one may go over into. */
static const double same_normal = 0.99, heir_normal = 0.9;

double tp_spring_least_area(const tp_rigid_body *body) {
  return least_share * body->extent_m * body->thickness_m;
}

bool tp_spring_contacts_init(tp_spring_contacts *c, const tp_rigid_body *body,
                             tp_spring_stiffness stiffness) {
  *c = (tp_spring_contacts){.normal_pa_m = stiffness.normal_pa_m,
                            .shear_pa_m = stiffness.shear_pa_m,
                            .thickness_m = body->thickness_m,
                            .extent_m = body->extent_m,
                            .grace_m = grace_share * stiffness.rounding_m,
                            .deepest_m = deepest_share * body->extent_m,
                            .least_area_m2 = tp_spring_least_area(body)};
  const bool done =
      tp_features_init(&c->of_block, &body->outline, stiffness.rounding_m, NULL) &&
      tp_features_init(&c->of_base, &body->base, stiffness.rounding_m, body->friction) &&
      tp_near_pairs_init(&c->candidates, &c->of_base, body->extent_m);
  if (!done) tp_spring_contacts_clear(c);
  return done;
}

void tp_spring_contacts_clear(tp_spring_contacts *c) {
  tp_features_clear(&c->of_block);
  tp_features_clear(&c->of_base);
  tp_near_pairs_clear(&c->candidates);
  free(c->holders);
  free(c->items);
  free(c->fresh);
  memset(c, 0, sizeof *c);
}

/* ---- candidates and contacts, both in the order of their pairs
 * ----------------------------------------------------------- */

static int compare(tp_pair a, tp_pair b) {
  if (a.of_block != b.of_block) return a.of_block < b.of_block ? -1 : 1;
  return a.of_base < b.of_base ? -1 : a.of_base > b.of_base;
}

static int by_pair(const void *left, const void *right) {
  const tp_spring_contact *a = left, *b = right;
  return compare(a->pair, b->pair);
}

static void set_holders(tp_spring_contacts *c) {
  long own = 0;
  for (long k = 0; k < c->candidates.count; k++) {
    const tp_pair pair = c->candidates.pairs[k];
    while (own < c->count && compare(c->items[own].pair, pair) < 0) own++;
    const bool holds = own < c->count && compare(c->items[own].pair, pair) == 0;
    c->holders[k] = holds ? own : -1;
  }
}

static bool renew_candidates(tp_spring_contacts *c, const tp_body_state *state) {
  if (!tp_near_pairs_find(&c->candidates, &c->of_block, &c->of_base, state)) return false;
  const size_t room = (size_t)c->candidates.count + 1;
  long *holders = realloc(c->holders, room * sizeof *holders);
  if (holders == NULL) return false;
  c->holders = holders;
  set_holders(c);
  return true;
}

void tp_spring_contacts_forget(tp_spring_contacts *c) {
  c->count = 0;
  if (c->holders != NULL) set_holders(c);
}

/* ---- springs
 * ---------------------------------------------------------------------------------------------- */

static void locate(tp_spring_contact *own, const tp_meeting *meeting, const tp_body_state *state) {
  own->now = *meeting;
  own->tangent = (tp_xy){meeting->normal.y, -meeting->normal.x};
  own->lever = tp_xy_minus(meeting->at, state->moved);
}

static void add_force(tp_spring_forces *forces, const tp_spring_contact *own) {
  const tp_xy force = {own->normal_n * own->now.normal.x + own->shear_n * own->tangent.x,
                       own->normal_n * own->now.normal.y + own->shear_n * own->tangent.y};
  forces->sum.x_n += force.x;
  forces->sum.y_n += force.y;
  forces->sum.moment_nm += tp_xy_cross(own->lever, force);
}

static double within(double value, double most) {
  return value > most ? most : value < -most ? -most : value;
}

/* Both springs, Coulomb's limit, and what friction took: the mean of its force times the slip. */
static void load(tp_spring_contact *own, tp_spring_forces *forces, const tp_spring_contacts *c,
                 double closer, double sheared_more) {
  const double normal = c->normal_pa_m * own->area, shear = c->shear_pa_m * own->area;
  const double overlap = -own->now.gap, resisted = c->normal_dashpot * closer;
  const double pressed = normal * (overlap + resisted);
  own->normal_n = pressed > 0 ? pressed : 0;
  const double before = own->sheared, trial = before + sheared_more;
  const double most = own->friction * own->normal_n / shear;
  own->sheared = within(trial, most);
  const double slip = trial - own->sheared;
  const double resisted_shear = c->shear_dashpot * (own->sheared - before);
  own->shear_n = -shear * within(own->sheared + resisted_shear, most);
  own->slipped += fabs(slip);
  forces->taken_by_friction += shear * (before + own->sheared) / 2 * slip;
  forces->taken_by_dashpots += normal * resisted * closer;
  forces->taken_by_dashpots += shear * resisted_shear * (own->sheared - before);
  forces->held += (normal * overlap * overlap + shear * own->sheared * own->sheared) / 2;
  add_force(forces, own);
}

/* The block's displacement along a contact that goes on, at the middle of the step. */
static void shear_on(tp_spring_contact *own, tp_spring_forces *forces, const tp_spring_contacts *c,
                     const tp_meeting *meeting, const tp_body_state *state, tp_xy displaced,
                     double turned) {
  const tp_xy tangent = own->tangent, lever = own->lever;
  const double gap = own->now.gap;
  locate(own, meeting, state);
  const tp_xy middle = {(tangent.x + own->tangent.x) / 2, (tangent.y + own->tangent.y) / 2};
  const tp_xy arm = {(lever.x + own->lever.x) / 2, (lever.y + own->lever.y) / 2};
  load(own, forces, c, gap - own->now.gap,
       tp_xy_dot(displaced, middle) + turned * tp_xy_cross(arm, middle));
}

/* ---- contacts that end and begin
 * -------------------------------------------------------------------------- */

static bool are_beside(long a, long b, long count) {
  const long apart = labs(a - b);
  return apart <= 1 || apart == count - 1;
}

static double apart(const tp_meeting *a, const tp_meeting *b) {
  return hypot(a->at.x - b->at.x, a->at.y - b->at.y);
}

/* Is it, but for the width of the grace, a contact that there is already? */
static bool is_there_already(const tp_spring_contacts *c, const tp_fresh_contact *fresh) {
  for (long k = 0; k < c->count; k++) {
    const tp_spring_contact *own = c->items + k;
    if (own->state == TP_CONTACT_HOLDS &&
        are_beside(own->pair.of_block, fresh->pair.of_block, c->of_block.count) &&
        are_beside(own->pair.of_base, fresh->pair.of_base, c->of_base.count) &&
        apart(&own->now, &fresh->meeting) < 4 * c->grace_m &&
        tp_xy_dot(own->now.normal, fresh->meeting.normal) > same_normal) {
      return true;
    }
  }
  return false;
}

/* The contact that has run past the end of its feature here, or NULL. */
static tp_spring_contact *predecessor(tp_spring_contacts *c, const tp_fresh_contact *fresh) {
  tp_spring_contact *best = NULL;
  double least = heir_share * c->extent_m;
  for (long k = 0; k < c->count; k++) {
    tp_spring_contact *own = c->items + k;
    if (own->state != TP_CONTACT_PASSED || apart(&own->now, &fresh->meeting) > least ||
        tp_xy_dot(own->now.normal, fresh->meeting.normal) < heir_normal) {
      continue;
    }
    least = apart(&own->now, &fresh->meeting);
    best = own;
  }
  return best;
}

static tp_spring_contact begin(bool *inherits, tp_spring_contacts *c, const tp_fresh_contact *fresh,
                               const tp_body_state *state) {
  tp_spring_contact own = {.pair = fresh->pair, .story = fresh->pair};
  tp_spring_contact *before = predecessor(c, fresh);
  const tp_placing placing = tp_placing_of(state);
  const tp_feature *base = c->of_base.items + fresh->pair.of_base;
  *inherits = before != NULL;
  if (before != NULL) {
    own.story = before->story;
    own.area = before->area;
    own.sheared = before->sheared;
    own.slipped = before->slipped;
    before->sheared = 0; /* it has its heir */
    before->state = TP_CONTACT_OPENED;
  } else {
    own.area = c->thickness_m * tp_tributary_length(&c->of_block, fresh->pair.of_block, &c->of_base,
                                                    fresh->pair.of_base, &placing,
                                                    c->least_area_m2 / c->thickness_m);
  }
  own.friction = base->friction;
  own.facet = base->facet;
  locate(&own, &fresh->meeting, state);
  const tp_xy velocity = tp_xy_plus(state->speed, state->turning, tp_xy_left(own.lever));
  own.closing_m_s = fmax(0, -tp_xy_dot(velocity, own.now.normal));
  return own;
}

/* Take in what is fresh, leave out what has ended. */
static bool change(tp_spring_contacts *c, tp_spring_forces *forces, const tp_body_state *state,
                   tp_xy displaced, double turned) {
  const long old = c->count;
  bool done = true;
  for (long k = 0; k < c->fresh_count && done; k++) {
    if (is_there_already(c, c->fresh + k)) continue;
    bool inherits;
    tp_spring_contact own = begin(&inherits, c, c->fresh + k, state);
    load(&own, forces, c, 0, 0);
    if (!inherits) tp_spring_closes(forces, &own, displaced, turned);
    tp_spring_contact *items = tp_grow(c->items, c->count, &c->room, sizeof *items);
    done = items != NULL;
    if (!done) break;
    c->items = items;
    c->items[c->count++] = own;
    c->changed = true;
  }
  long kept = 0;
  for (long k = 0; k < c->count; k++) {
    if (k < old && c->items[k].state != TP_CONTACT_HOLDS) {
      forces->taken_by_friction += tp_spring_let_go(c->items + k, c->shear_pa_m, displaced, turned);
      c->changed = true;
      continue;
    }
    c->items[kept++] = c->items[k];
  }
  c->count = kept;
  qsort(c->items, (size_t)c->count, sizeof *c->items, by_pair);
  set_holders(c);
  return done;
}

static bool add_fresh(tp_spring_contacts *c, tp_pair pair, const tp_meeting *meeting) {
  tp_fresh_contact *fresh = tp_grow(c->fresh, c->fresh_count, &c->fresh_room, sizeof *fresh);
  if (fresh == NULL) return false;
  c->fresh = fresh;
  fresh[c->fresh_count++] = (tp_fresh_contact){pair, *meeting};
  return true;
}

bool tp_spring_contacts_step(tp_spring_forces *forces, tp_spring_contacts *c,
                             const tp_body_state *state, tp_xy displaced, double turned) {
  memset(forces, 0, sizeof *forces);
  c->changed = false;
  if (tp_near_pairs_are_old(&c->candidates, state) && !renew_candidates(c, state)) return false;
  const tp_placing placing = tp_placing_of(state);
  bool ended = false;
  c->fresh_count = 0;
  for (long k = 0; k < c->candidates.count; k++) {
    const tp_pair pair = c->candidates.pairs[k];
    const bool is_contact = c->holders[k] >= 0;
    tp_meeting meeting;
    const bool meets = tp_features_meet(&meeting, c->of_block.items + pair.of_block,
                                        c->of_base.items + pair.of_base, &placing,
                                        is_contact ? c->grace_m : grace_share * c->grace_m, 0) &&
                       meeting.gap > -c->deepest_m;
    if (meets && is_contact) {
      shear_on(c->items + c->holders[k], forces, c, &meeting, state, displaced, turned);
    } else if (is_contact) {
      c->items[c->holders[k]].state = meeting.gap < 0 ? TP_CONTACT_PASSED : TP_CONTACT_OPENED;
      if (meeting.gap >= 0) {
        tp_spring_opens(forces, c->items + c->holders[k], c->normal_pa_m, displaced, turned);
      }
      ended = true;
    } else if (meets && !add_fresh(c, pair, &meeting)) {
      return false;
    }
  }
  return (!ended && c->fresh_count == 0) || change(c, forces, state, displaced, turned);
}

void tp_spring_contacts_stiffness(double *straight_n_m, double *turning_nm,
                                  const tp_spring_contacts *c) {
  *straight_n_m = *turning_nm = 0;
  for (long k = 0; k < c->count; k++) {
    const double stiffness = (c->normal_pa_m + c->shear_pa_m) * c->items[k].area;
    *straight_n_m += stiffness;
    *turning_nm += stiffness * tp_xy_dot(c->items[k].lever, c->items[k].lever);
  }
}
