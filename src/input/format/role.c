/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks of a chain for its role, with the width of a gap and its places in the message;
 * orientation and closing of the chain that is taken. */

#include "format/role.h"

#include "format/join.h"

#include <stdio.h>

const char *tp_drawing_role_name(tp_drawing_role role) {
  static const char *const names[] = {"not used", "block", "base", "hole", "part"};
  return names[role];
}

/* Of an open chain: how wide it gapes, and between which places. */
static tp_status fail_open(const tp_drawing *chains, const tp_drawing_object *chain,
                           const char *what, tp_message *message) {
  const tp_polyline *line = &chain->line;
  const long last = line->count - 1;
  double nearest = tp_drawing_distance(line, last, line, 0);
  tp_place other = tp_polyline_place(line, 0);
  for (long k = 0; k < chains->count; k++) {
    const tp_drawing_object *own = chains->objects + k;
    if (own == chain || own->closure != TP_DRAWING_OPEN || own->line.count == 0) continue;
    for (int end = 0; end < 2; end++) {
      const long point = end == 0 ? 0 : own->line.count - 1;
      const double distance = tp_drawing_distance(line, last, &own->line, point);
      if (distance >= nearest) continue;
      nearest = distance;
      other = tp_polyline_place(&own->line, point);
    }
  }
  char there[64];
  tp_place_text(there, sizeof there, (tp_place){"", other.line, other.column});
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(line, last),
                   "%s is open: from its end here to the nearest other end, at line %s, %.6g are "
                   "missing; close it in the drawing, or say drawing: {gap: …}, not less than that",
                   what, there + 1, nearest);
}

tp_status tp_role_check(const tp_drawing *chains, const tp_drawing_object *chain,
                        tp_drawing_role role, tp_message *message) {
  const char *what = role == TP_DRAWING_BLOCK  ? "the outline of the block"
                     : role == TP_DRAWING_HOLE ? "a hole"
                                               : "this outline";
  if (chain->problem != NULL) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_drawing_place(chain), "this %s %s", chain->kind,
                     chain->problem);
  }
  if (chain->line.count < 2) {
    return tp_refuse(message, TP_FAULT_RANGE, tp_drawing_place(chain),
                     "this %s has fewer than two points", chain->kind);
  }
  if (role == TP_DRAWING_BASE) {
    if (chain->closure != TP_DRAWING_CLOSED) return TP_OK;
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_drawing_place(chain),
                     "the base is a closed outline; it must be an open line from left to right");
  }
  return chain->closure == TP_DRAWING_OPEN ? fail_open(chains, chain, what, message) : TP_OK;
}

tp_status tp_role_check_only(const tp_drawing *chains, const tp_drawing_role *roles,
                             tp_drawing_role role, tp_message *message) {
  const tp_drawing_object *first = NULL;
  for (long k = 0; k < chains->count; k++) {
    const tp_drawing_object *own = chains->objects + k;
    if (roles[k] != role) continue;
    if (first == NULL) {
      first = own;
      continue;
    }
    char there[64];
    tp_place_text(there, sizeof there,
                  (tp_place){"", first->line.mark.line, first->line.mark.column});
    return tp_refuse(
        message, TP_FAULT_KEY, tp_drawing_place(own),
        role == TP_DRAWING_BLOCK
            ? "a second outline of the block, besides the one at line %s; put holes on "
              "the layer of holes, and other blocks on separate layers"
            : "a second line of the base, which does not meet the one at line %s; join "
              "them, or say drawing: {gap: …}",
        there + 1);
  }
  return TP_OK;
}

static bool same_point(const tp_polyline *line, long one, long other) {
  return fmpq_equal(line->x + one, line->x + other) && fmpq_equal(line->y + one, line->y + other);
}

bool tp_role_finish(tp_drawing_object *chain, tp_drawing_role role) {
  tp_polyline *line = &chain->line;
  if (role != TP_DRAWING_BASE) {
    chain->closure = TP_DRAWING_CLOSED;
    if (line->count > 2 && same_point(line, 0, line->count - 1)) tp_drawing_drop_point(chain);
    return true;
  }
  chain->closure = TP_DRAWING_OPEN;
  return line->count == 0 || fmpq_cmp(line->x, line->x + line->count - 1) <= 0 ||
         tp_drawing_reverse(chain);
}
