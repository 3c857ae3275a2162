/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Open chains of a section, where the mesh has holes or consists of pieces, joined end to end. */

#include "format/section_take.h"

#include <math.h>
#include <stdio.h>

enum { MOST_OPEN = 1000 };

/* Two ends of open chains. */
typedef struct meeting {
  long one, other;             /* chains; equal: it closes */
  bool one_first, other_first; /* the first point of it, else the last */
  double distance;             /* for the choice alone */
} meeting;

static long end_of(const tp_section_chain *chain, bool first) {
  return first ? 0 : chain->points.count - 1;
}

static double distance(const tp_section_chain *a, bool a_first, const tp_section_chain *b,
                       bool b_first) {
  const long p = end_of(a, a_first), q = end_of(b, b_first);
  return hypot(fmpq_get_d(a->points.x + p) - fmpq_get_d(b->points.x + q),
               fmpq_get_d(a->points.y + p) - fmpq_get_d(b->points.y + q));
}

static void consider(meeting *best, const tp_mesh_section *section, meeting own) {
  own.distance = distance(section->chains + own.one, own.one_first, section->chains + own.other,
                          own.other_first);
  if (best->one < 0 || own.distance < best->distance) *best = own;
}

/* The nearest ends; `one` is below zero where there are no two. */
static meeting find_nearest(const tp_mesh_section *section, bool closed) {
  meeting best = {.one = -1};
  for (long i = 0; i < section->count; i++) {
    if (section->chains[i].closed) continue;
    if (closed) consider(&best, section, (meeting){i, i, false, true, 0});
    for (long k = i + 1; k < section->count; k++) {
      for (int ends = 0; !section->chains[k].closed && ends < 4; ends++) {
        consider(&best, section, (meeting){i, k, ends % 2 == 0, ends / 2 == 0, 0});
      }
    }
  }
  return best;
}

/* Exactly: is it at most that far? */
static bool is_within(const tp_mesh_section *section, const meeting *own, const fmpq_t gap) {
  const tp_polyline *a = &section->chains[own->one].points;
  const tp_polyline *b = &section->chains[own->other].points;
  const long p = end_of(section->chains + own->one, own->one_first);
  const long q = end_of(section->chains + own->other, own->other_first);
  fmpq_t step, square;
  fmpq_init(step);
  fmpq_init(square);
  fmpq_sub(step, a->x + p, b->x + q);
  fmpq_mul(square, step, step);
  fmpq_sub(step, a->y + p, b->y + q);
  fmpq_addmul(square, step, step);
  fmpq_submul(square, gap, gap);
  const bool within = fmpq_sgn(square) <= 0;
  fmpq_clear(step);
  fmpq_clear(square);
  return within;
}

/* The second chain behind the first, which it leaves the list with. */
static bool join(tp_mesh_section *section, const meeting *own) {
  tp_section_chain *one = section->chains + own->one, *other = section->chains + own->other;
  if (one == other) {
    one->closed = true;
    return true;
  }
  if (own->one_first) tp_polyline_reverse(&one->points);
  if (!own->other_first) tp_polyline_reverse(&other->points);
  one->points.reversed = other->points.reversed = false;
  for (long k = 0; k < other->points.count; k++) {
    const tp_polyline *from = &other->points;
    if (!tp_polyline_append(&one->points, from->x + k, from->y + k, from->marks[k])) return false;
  }
  tp_polyline_clear(&other->points);
  *other = section->chains[--section->count];
  return true;
}

static tp_status fail_open(const tp_mesh_section *section, const tp_section_wish *wish,
                           const meeting *own, tp_message *message) {
  const tp_polyline *a = &section->chains[own->one].points;
  const tp_polyline *b = &section->chains[own->other].points;
  const long p = end_of(section->chains + own->one, own->one_first);
  const long q = end_of(section->chains + own->other, own->other_first);
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, wish->place,
      "the outline of the section is open from (%.6g, %.6g) to (%.6g, %.6g), over %.3g "
      "%s: the mesh has a hole there; fill it, or close gaps of a stated width by "
      "'gap: …'",
      fmpq_get_d(a->x + p), fmpq_get_d(a->y + p), fmpq_get_d(b->x + q), fmpq_get_d(b->y + q),
      own->distance, wish->unit);
}

/* What stays open is left out beside an outline that may be the largest. */
static bool may_stay_open(const tp_mesh_section *section, const tp_section_wish *wish) {
  bool closed = false;
  for (long k = 0; k < section->count; k++) closed = closed || section->chains[k].closed;
  return !wish->closed || (wish->largest && closed);
}

tp_status tp_section_join(tp_mesh_section *section, const tp_section_wish *wish, long *joined,
                          double *widest, tp_message *message) {
  long open = 0;
  for (long k = 0; k < section->count; k++) open += !section->chains[k].closed;
  if (open > MOST_OPEN) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, wish->place,
        "the section is in more than 1000 open pieces; join the faces of the mesh where "
        "they meet, and fill its holes");
  }
  for (;;) {
    const meeting nearest = find_nearest(section, wish->closed);
    if (nearest.one < 0) return TP_OK;
    if (!is_within(section, &nearest, wish->gap)) {
      return may_stay_open(section, wish) ? TP_OK : fail_open(section, wish, &nearest, message);
    }
    ++*joined;
    *widest = fmax(*widest, nearest.distance);
    if (!join(section, &nearest)) return tp_fail_memory(message, "a section");
  }
}
