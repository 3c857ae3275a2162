/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Marks the facets that contacts, events and reactions name, and lists each with its ends and its
 * number among the contact facets. */

#include "tilt/facets.h"

#include <stdlib.h>

/* By the number of a facet, up to the facets of the profile. */
typedef struct named {
  long count;
  bool *is;
} named;

static void name(named *n, long facet) {
  if (facet > 0 && facet <= n->count) n->is[facet - 1] = true;
}

static void name_all(named *n, const tp_tilt_case *own, const tp_rigid_body *body) {
  for (long k = 0; k < body->closed_count; k++) name(n, body->closed[k].facet);
  for (size_t k = 0; k < own->event_count; k++) name(n, own->events[k].facet);
  for (size_t k = 0; k < own->reaction_count; k++) name(n, own->reactions[k].facet);
}

/* The first facet of the contact on a facet of the base, counted from 1; 0: none. */
static size_t first_contact(const tp_problem *problem, long base_edge) {
  for (long k = 0; k < problem->contact.facet_count; k++) {
    if (problem->contact.facets[k].base_edge == base_edge) return (size_t)k + 1;
  }
  return 0;
}

/* The base runs from right to left. */
static tp_tilt_facet facet_of(const tp_edge *edge, const tp_rigid_body *body,
                              const tp_problem *problem) {
  const tp_xy origin = body->origin;
  return (tp_tilt_facet){.facet = edge->number,
                         .contact = first_contact(problem, edge->number - 1),
                         .x0_m = edge->to.x + origin.x,
                         .y0_m = edge->to.y + origin.y,
                         .x1_m = edge->from.x + origin.x,
                         .y1_m = edge->from.y + origin.y};
}

bool tp_tilt_facets_fill(tp_tilt_case *own, const tp_rigid_body *body, const tp_problem *problem) {
  named n = {.count = problem->base.edge_count};
  n.is = calloc((size_t)n.count + 1, sizeof *n.is);
  if (n.is == NULL) return false;
  name_all(&n, own, body);
  size_t room = 0;
  for (long k = 0; k < n.count; k++) room += n.is[k];
  own->facets = calloc(room + 1, sizeof *own->facets);
  const bool done = own->facets != NULL;
  for (long k = body->base.count; k > 0 && done; k--) {
    const tp_edge *edge = body->base.edges + k - 1;
    if (edge->number > 0 && n.is[edge->number - 1]) {
      own->facets[own->facet_count++] = facet_of(edge, body, problem);
    }
  }
  free(n.is);
  return done;
}
