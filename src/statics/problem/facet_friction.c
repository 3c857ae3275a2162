/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Assigns each entry of facet frictions to facets of the base by number or by range of x, refuses
 * overlaps and partly covered facets, and carries the angles over to the contact facets. */

#include "problem/facet_friction.h"

#include "number/ratio.h"
#include "problem/effects.h"

#include <stdlib.h>
#include <string.h>

void tp_facet_friction_clear(tp_facet_friction *f) {
  free(f->angles);
  free(f->of_facet);
  free(f->firsts);
  free(f->lasts);
  free(f->touching);
  free(f->entry_of);
  free(f->beside);
  free(f->besides);
  memset(f, 0, sizeof *f);
}

/* What is sought, and where. */
typedef struct search {
  tp_facet_friction *found;
  const tp_scene *scene;
  const tp_base *base;
  const tp_lattice *lattice;
  const tp_contact *contact;
  tp_facets_counted counted;
  tp_message *message;
} search;

/* ---- what an entry names
 * ----------------------------------------------------------------------------- */

static tp_status claim(search *s, long facet, long entry) {
  const tp_facet_friction_description *own = s->scene->friction.facets + entry;
  if (s->found->entry_of[facet] >= 0) {
    return tp_refuse(s->message, TP_FAULT_GEOMETRY, own->place,
                     "facet %ld of the base is given a friction angle twice", facet + 1);
  }
  s->found->entry_of[facet] = entry;
  if (s->found->firsts[entry] == 0) s->found->firsts[entry] = facet + 1;
  s->found->lasts[entry] = facet + 1;
  return TP_OK;
}

static tp_status claim_numbers(search *s, long entry) {
  const tp_facet_friction_description *own = s->scene->friction.facets + entry;
  if (own->last > s->counted.count) {
    return tp_refuse(s->message, TP_FAULT_RANGE, own->place,
                     "there is no facet %ld: the base has %ld, counted from left to right along %s",
                     own->last, s->counted.count,
                     s->counted.mated ? "the underside that it is mated with" : "its profile");
  }
  tp_status status = TP_OK;
  for (long k = own->first; k <= own->last && status == TP_OK; k++) {
    status = claim(s, k - 1, entry);
  }
  return status;
}

/* How a facet lies to two abscissas. */
typedef enum within { WITHIN_NOT, WITHIN_PARTLY, WITHIN } within;

static within lies_within(const search *s, long facet, const tp_facet_friction_description *own) {
  const fmpq *x = s->base->ring.x + s->counted.first + facet;
  const int before = fmpq_cmp(x, x + 1);
  const fmpq *left = before <= 0 ? x : x + 1, *right = before <= 0 ? x + 1 : x;
  if (before == 0) { /* upright */
    return fmpq_cmp(x, own->x0.value) >= 0 && fmpq_cmp(x, own->x1.value) < 0 ? WITHIN : WITHIN_NOT;
  }
  if (fmpq_cmp(right, own->x0.value) <= 0 || fmpq_cmp(left, own->x1.value) >= 0) return WITHIN_NOT;
  return fmpq_cmp(left, own->x0.value) >= 0 && fmpq_cmp(right, own->x1.value) <= 0 ? WITHIN
                                                                                   : WITHIN_PARTLY;
}

static tp_status fail_partly(const search *s, long facet, tp_place place) {
  char left[80], right[80];
  tp_ratio_text(left, sizeof left, s->base->ring.x + s->counted.first + facet);
  tp_ratio_text(right, sizeof right, s->base->ring.x + s->counted.first + facet + 1);
  return tp_refuse(s->message, TP_FAULT_GEOMETRY, place,
                   "facet %ld of the base, from x = %s to x = %s, lies between these in part; end "
                   "them at vertices of the base, or put one where friction changes",
                   facet + 1, left, right);
}

static tp_status claim_between(search *s, long entry) {
  const tp_facet_friction_description *own = s->scene->friction.facets + entry;
  if (s->counted.turned) {
    return tp_refuse(s->message, TP_FAULT_GEOMETRY, own->place,
                     "in the frame of the world the section is turned, and x with it: name facets "
                     "by number, 'facet: [3, 7]'");
  }
  tp_status status = TP_OK;
  for (long k = 0; k < s->counted.count && status == TP_OK; k++) {
    const within lies = lies_within(s, k, own);
    if (lies == WITHIN_PARTLY) return fail_partly(s, k, own->place);
    if (lies == WITHIN) status = claim(s, k, entry);
  }
  if (status != TP_OK || s->found->firsts[entry] > 0) return status;
  return tp_refuse(s->message, TP_FAULT_GEOMETRY, own->place,
                   "no facet of the base lies between these");
}

/* ---- the angles of the contact
 * ----------------------------------------------------------------------- */

static int compare_angles(const void *left, const void *right) {
  const fmpq *const *a = left, *const *b = right;
  return fmpq_cmp(*a, *b);
}

/* Those that are not the scene's, each once. */
static void gather_angles(tp_facet_friction *f, const tp_scene *scene) {
  const fmpq *given = scene->friction_angle_deg.value;
  long all = 0;
  for (long k = 0; k < scene->friction.facet_count; k++) {
    f->angles[all++] = scene->friction.facets[k].angle_deg.value;
  }
  qsort(f->angles, (size_t)all, sizeof *f->angles, compare_angles);
  for (long k = 0; k < all; k++) {
    const fmpq *own = f->angles[k];
    const bool known = f->count > 0 && fmpq_equal(f->angles[f->count - 1], own);
    if (!known && !fmpq_equal(given, own)) f->angles[f->count++] = own;
  }
}

static long index_of(const tp_facet_friction *f, const fmpq *angle) {
  const fmpq **own =
      bsearch(&angle, f->angles, (size_t)f->count, sizeof *f->angles, compare_angles);
  return own != NULL ? own - f->angles + 1 : 0;
}

long tp_facet_friction_entry(const tp_facet_friction *f, long edge) {
  const long facet = edge - f->counted.first;
  return facet >= 0 && facet < f->counted.count ? f->entry_of[facet] : -1;
}

static const fmpq *angle_of(const search *s, long entry) {
  return entry < 0 ? s->scene->friction_angle_deg.value
                   : s->scene->friction.facets[entry].angle_deg.value;
}

/* A contact in a point bears on both edges as one: the other edge of the base at it, which is a
 * vertex of the base and no notch of it. The facet's edge itself where there is none. -1 and the
 * number of edges are the upright faces at which the base ends. */
static long other_edge(const search *s, const tp_facet *facet) {
  const tp_lattice *l = s->lattice;
  if (facet->q0 != facet->q1) return facet->base_edge;
  const long point = facet->q0;
  const long ring = l->start[l->chain_count - 2]; /* tp_problem: the chain before the last */
  const long edge = facet->base_edge, last = s->base->edge_count;
  const bool begins = edge >= 0 && tp_lattice_same_point(l, point, ring + edge);
  const bool ends = edge < last && tp_lattice_same_point(l, point, ring + edge + 1);
  if (!begins && !ends) return edge;
  const long corner = ring + (begins ? edge : edge + 1);
  const long before = corner == ring ? ring + last + 2 : corner - 1; /* the ring has two more */
  const bool notch =
      facet->t0 >= ring && tp_lattice_cross(l, before, corner, corner, corner + 1) > 0;
  return notch ? edge : begins ? edge - 1 : edge + 1;
}

long tp_facet_friction_index(const tp_facet_friction *f, const tp_scene *scene, long edge) {
  const long entry = tp_facet_friction_entry(f, edge);
  return index_of(f, entry < 0 ? scene->friction_angle_deg.value
                               : scene->friction.facets[entry].angle_deg.value);
}

static void settle_facet(search *s, long k) {
  const tp_facet *facet = s->contact->facets + k;
  long entry = tp_facet_friction_entry(s->found, facet->base_edge);
  const long beside = tp_facet_friction_entry(s->found, other_edge(s, facet));
  if (fmpq_cmp(angle_of(s, beside), angle_of(s, entry)) < 0) entry = beside;
  if (entry < 0) return;
  s->found->of_facet[k] = index_of(s->found, angle_of(s, entry));
  s->found->touching[entry]++;
}

static tp_status find(search *s) {
  tp_status status = TP_OK;
  for (long k = 0; k < s->counted.count; k++) s->found->entry_of[k] = -1;
  for (long entry = 0; entry < s->found->entry_count && status == TP_OK; entry++) {
    status = s->scene->friction.facets[entry].x0.given ? claim_between(s, entry)
                                                       : claim_numbers(s, entry);
  }
  if (status != TP_OK) return status;
  gather_angles(s->found, s->scene);
  const tp_facet *facets = s->contact->facets;
  long first = -1;
  for (long k = 0; k < s->contact->facet_count; k++) {
    const long *own = s->found->of_facet;
    settle_facet(s, k);
    if (facets[k].t0 == facets[k].t1) continue; /* restrains nothing */
    if (first < 0) first = k;
    s->found->uneven = s->found->uneven || own[k] != own[first];
  }
  return TP_OK;
}

tp_status tp_facet_friction_init(tp_facet_friction *f, const tp_scene *scene, const tp_base *base,
                                 const tp_lattice *lattice, const tp_contact *contact,
                                 tp_facets_counted counted, tp_solution *solution,
                                 tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  search s = {.found = f,
              .scene = scene,
              .base = base,
              .lattice = lattice,
              .contact = contact,
              .counted = counted,
              .message = message};
  const size_t entries = (size_t)scene->friction.facet_count + 1;
  memset(f, 0, sizeof *f);
  f->entry_count = scene->friction.facet_count;
  f->angles = calloc(entries, sizeof *f->angles);
  f->firsts = calloc(entries, sizeof *f->firsts);
  f->lasts = calloc(entries, sizeof *f->lasts);
  f->touching = calloc(entries, sizeof *f->touching);
  f->of_facet = calloc((size_t)contact->facet_count + 1, sizeof *f->of_facet);
  f->beside = calloc(entries, sizeof *f->beside);
  f->counted = counted;
  f->entry_of = calloc((size_t)counted.count + 1, sizeof *f->entry_of);
  const bool room = f->angles != NULL && f->firsts != NULL && f->lasts != NULL &&
                    f->touching != NULL && f->of_facet != NULL && f->beside != NULL &&
                    f->entry_of != NULL;
  if (!room) {
    tp_facet_friction_clear(f);
    return tp_fail_memory(message, "the friction of facets");
  }
  tp_status status = find(&s);
  status = tp_effects_entered(
      status, message,
      tp_effects_note(solution, "facets", scene->friction.facets[0].place, "", began));
  if (status != TP_OK) tp_facet_friction_clear(f);
  return status;
}
