/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges out of a ring of half-edges and its twin's, in a time proportional to their number. */

#include "jointing/planar_map.h"

#include <stdlib.h>
#include <string.h>

#define NONE SIZE_MAX

void tp_planar_map_clear(tp_planar_map *m) {
  tp_geom_arrangement_clear(&m->a);
  free(m->previous);
  free(m->gone);
  free(m->cycle);
  free(m->stamp);
  free(m->seat);
  memset(m, 0, sizeof *m);
}

static tp_status make_room(tp_planar_map *m, tp_message *message) {
  const size_t edges = m->a.edge_count, vertices = m->a.vertex_count;
  m->previous = calloc(2 * edges + 1, sizeof *m->previous);
  m->gone = calloc(edges + 1, sizeof *m->gone);
  m->cycle = calloc(2 * edges + 1, sizeof *m->cycle);
  m->stamp = calloc(vertices + 1, sizeof *m->stamp);
  m->seat = calloc(vertices + 1, sizeof *m->seat);
  const bool done = m->previous != NULL && m->gone != NULL && m->cycle != NULL &&
                    m->stamp != NULL && m->seat != NULL;
  return done ? TP_OK : tp_fail_memory(message, "the blocks of the slope");
}

/* Half-edges follow each other in rings, each once, and each begins where the one before it ends.
 */
static bool set_previous(tp_planar_map *m) {
  const size_t count = 2 * m->a.edge_count;
  for (size_t h = 0; h < count; h++) m->previous[h] = NONE;
  for (size_t h = 0; h < count; h++) {
    const size_t next = m->a.next[h];
    if (next >= count || m->previous[next] != NONE || m->a.origin[next] != m->a.origin[h ^ 1]) {
      return false;
    }
    m->previous[next] = h;
  }
  return true;
}

static tp_status fail_library(tp_message *message) {
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){0},
                 "the geometry library failed on the joints; please report this scene");
}

tp_status tp_planar_map_init(tp_planar_map *m, const fmpq *ends, size_t count,
                             tp_message *message) {
  memset(m, 0, sizeof *m);
  const tp_geom_status made = tp_geom_arrange(&m->a, ends, count);
  if (made == TP_GEOM_FAILED) return fail_library(message);
  tp_status status = made == TP_GEOM_OK ? make_room(m, message)
                                        : tp_fail_memory(message, "the blocks of the slope");
  if (status == TP_OK && !set_previous(m)) status = fail_library(message);
  if (status != TP_OK) tp_planar_map_clear(m);
  return status;
}

static void link_half_edges(tp_planar_map *m, size_t before, size_t after) {
  m->a.next[before] = after;
  m->previous[after] = before;
}

void tp_planar_map_remove(tp_planar_map *m, size_t edge) {
  const size_t h = 2 * edge, t = h + 1;
  const size_t into_h = m->previous[h], out_h = m->a.next[h];
  const size_t into_t = m->previous[t], out_t = m->a.next[t];
  if (into_h != t) link_half_edges(m, into_h, out_t); /* else nothing is left at that end */
  if (into_t != h) link_half_edges(m, into_t, out_h);
  m->gone[edge] = true;
}

/* ---- tidying -----------------------------------------------------------------------------------
 */

static void remove_dangling(tp_planar_map *m) {
  for (size_t e = 0; e < m->a.edge_count; e++) {
    size_t at = e;
    while (at != NONE && !m->gone[at]) {
      const bool ends = m->a.next[2 * at] == 2 * at + 1, begins = m->a.next[2 * at + 1] == 2 * at;
      if (!ends && !begins) break;
      const size_t after = ends ? m->previous[2 * at] : m->previous[2 * at + 1];
      const bool alone = ends && begins;
      tp_planar_map_remove(m, at);
      at = alone ? NONE : after / 2; /* that may hang now in turn */
    }
  }
}

static void number_cycles(tp_planar_map *m) {
  m->cycle_count = 0;
  for (size_t h = 0; h < 2 * m->a.edge_count; h++) m->cycle[h] = NONE;
  for (size_t h = 0; h < 2 * m->a.edge_count; h++) {
    if (m->gone[h / 2] || m->cycle[h] != NONE) continue;
    for (size_t at = h; m->cycle[at] == NONE; at = m->a.next[at]) m->cycle[at] = m->cycle_count;
    m->cycle_count++;
  }
}

/* With one face on both sides. */
static void remove_bridges(tp_planar_map *m) {
  for (size_t e = 0; e < m->a.edge_count; e++) {
    if (!m->gone[e] && m->cycle[2 * e] == m->cycle[2 * e + 1]) tp_planar_map_remove(m, e);
  }
}

/* All that no walk over cycles and twins leads to from the half-edge of an edge. */
static tp_status keep_connected(tp_planar_map *m, size_t kept, tp_message *message) {
  size_t *found = calloc(2 * m->a.edge_count + 1, sizeof *found), count = 0;
  bool *reached = calloc(m->a.edge_count + 1, sizeof *reached);
  if (found == NULL || reached == NULL) {
    free(found);
    free(reached);
    return tp_fail_memory(message, "the blocks of the slope");
  }
  reached[kept] = true;
  found[count++] = kept;
  for (size_t k = 0; k < count; k++) {
    const size_t h = 2 * found[k];
    const size_t near[] = {m->a.next[h], m->a.next[h + 1], m->previous[h], m->previous[h + 1]};
    for (int n = 0; n < 4; n++) {
      if (reached[near[n] / 2]) continue;
      reached[near[n] / 2] = true;
      found[count++] = near[n] / 2;
    }
  }
  for (size_t e = 0; e < m->a.edge_count; e++) m->gone[e] = m->gone[e] || !reached[e];
  free(found);
  free(reached);
  return TP_OK;
}

/* Part a cycle that comes to a vertex twice, by `first` and later by `again`, which leave it. The
 * loop between is a cycle of its own, whose vertices are free for others. */
static void part(tp_planar_map *m, size_t first, size_t again) {
  const size_t before_first = m->previous[first], before_again = m->previous[again];
  link_half_edges(m, before_again, first);
  link_half_edges(m, before_first, again);
  for (size_t h = m->a.next[first]; h != first; h = m->a.next[h]) m->stamp[m->a.origin[h]] = NONE;
}

/* Did any cycle touch itself? */
static bool part_at_corners(tp_planar_map *m) {
  bool parted = false;
  for (size_t v = 0; v < m->a.vertex_count; v++) m->stamp[v] = NONE;
  for (size_t start = 0; start < 2 * m->a.edge_count; start++) {
    const size_t cycle = m->cycle[start];
    if (m->gone[start / 2] || cycle == NONE) continue;
    size_t h = start;
    do {
      const size_t v = m->a.origin[h];
      if (m->stamp[v] == cycle) {
        part(m, m->seat[v], h);
        parted = true;
      }
      m->stamp[v] = cycle;
      m->seat[v] = h;
      m->cycle[h] = NONE; /* seen */
      h = m->a.next[h];
    } while (m->cycle[h] != NONE);
  }
  return parted;
}

tp_status tp_planar_map_tidy(tp_planar_map *m, size_t kept, tp_message *message) {
  tp_status status = TP_OK;
  bool parted = true;
  remove_dangling(m);
  while (parted && status == TP_OK) {
    number_cycles(m);
    remove_bridges(m);
    status = keep_connected(m, kept, message);
    number_cycles(m);
    parted = part_at_corners(m);
  }
  if (status == TP_OK) number_cycles(m);
  return status;
}
