/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A facet of the contact is a piece of an edge of the block and of one of the base, which both run
 * from left to right (base/facets.h). Where it ends at a vertex of the base, other than a notch,
 * the next facet of the base begins. What slips over that vertex has its friction, or that of the
 * facet on which the block lies: which of the two, nothing tells, and the onset allows for both.
 * In a notch each facet bears by itself, and where the block lies on both facets of a straight
 * vertex, each has its own ends there: nothing is added. */

#include "problem/facet_besides.h"

#include "common/grow.h"
#include "common/message.h"
#include "common/notes.h"

typedef struct looking {
  tp_facet_friction *f;
  const tp_scene *scene;
  const tp_base *base;
  const tp_lattice *l;
  const tp_contact *contact;
  long ring; /* the first point of the base's */
} looking;

/* Does the block lie on the edge? Facets of one side of a facet in the list are next to it. */
static bool lies_on(const looking *s, long near, long edge) {
  const tp_contact *c = s->contact;
  for (long k = near - 1; k <= near + 1; k++) {
    if (k >= 0 && k < c->facet_count && c->facets[k].base_edge == edge &&
        c->facets[k].q0 != c->facets[k].q1) {
      return true;
    }
  }
  return false;
}

/* Does the block's edge go on past the end of the facet? The outline is the first ring. */
static bool goes_on(const looking *s, const tp_facet *f, bool at_end) {
  const long point = at_end ? f->q1 : f->q0, own = at_end ? f->t1 : f->t0;
  const tp_lattice *l = s->l;
  if (!tp_lattice_same_point(l, point, own)) return true;
  if (own >= l->start[1]) return false; /* the base's direction: of a mated one */
  const long last = l->start[1] - 1;
  const long before = own == 0 ? last : own - 1, after = own == last ? 0 : own + 1;
  return tp_lattice_cross(l, before, own, own, after) == 0;
}

static tp_status look_at(looking *s, long k, bool at_end, tp_message *message) {
  const tp_facet *facet = s->contact->facets + k;
  const long vertex = facet->base_edge + (at_end ? 1 : 0), own = s->ring + vertex;
  const long beside = facet->base_edge + (at_end ? 1 : -1);
  if (beside < 0 || beside >= s->base->edge_count) return TP_OK; /* an upright end of the base */
  const tp_outline_point end = at_end ? tp_facet_end(facet) : tp_facet_begin(facet);
  if (end.cut != NULL || !tp_lattice_same_point(s->l, end.point, own)) return TP_OK;
  const long friction = tp_facet_friction_index(s->f, s->scene, beside);
  if (friction == s->f->of_facet[k]) return TP_OK;
  const int turn = tp_lattice_cross(s->l, own - 1, own, own, own + 1);
  if (turn > 0 || (turn == 0 && lies_on(s, k, beside))) return TP_OK;
  tp_facet_beside *more =
      tp_grow(s->f->besides, s->f->beside_count, &s->f->beside_room, sizeof *more);
  if (more == NULL) return tp_fail_memory(message, "the friction of facets");
  s->f->besides = more;
  const long entry = tp_facet_friction_entry(s->f, beside);
  if (entry >= 0) s->f->beside[entry] = true;
  more[s->f->beside_count++] = (tp_facet_beside){k, at_end, goes_on(s, facet, at_end), friction};
  return TP_OK;
}

static tp_status note_untouched(tp_notes *notes, const tp_facet_friction *f, const tp_scene *scene,
                                tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < f->entry_count && status == TP_OK; k++) {
    if (f->touching[k] > 0) continue;
    status =
        tp_notes_add(notes, message, TP_NOTE, scene->friction.facets[k].place,
                     f->beside[k] ? "the block lies on none of these facets of the base, but they "
                                    "begin where the contact ends: their friction counts in "
                                    "the onset, for what slips there"
                                  : "the block touches none of these facets of the base; "
                                    "their friction is not used");
  }
  return status;
}

tp_status tp_facet_besides_find(tp_facet_friction *f, const tp_scene *scene, const tp_base *base,
                                const tp_lattice *l, const tp_contact *contact, tp_notes *notes,
                                tp_message *message) {
  /* tp_problem: the chain before the last */
  looking s = {f, scene, base, l, contact, l->start[l->chain_count - 2]};
  tp_status status = TP_OK;
  for (long k = 0; k < contact->facet_count && status == TP_OK; k++) {
    const tp_facet *facet = contact->facets + k;
    if (facet->q0 == facet->q1 || facet->t0 == facet->t1) continue;
    if (facet->base_edge < 0 || facet->base_edge >= base->edge_count) continue;
    for (int end = 0; end < 2 && status == TP_OK; end++) {
      status = look_at(&s, k, end == 1, message);
    }
  }
  return status == TP_OK ? note_untouched(notes, f, scene, message) : status;
}
