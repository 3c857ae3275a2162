/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chooses the chain by its exact area or length, collects the chains nested in it as holes, and
 * takes the upper side of closed ground as a profile. */

#include "format/section_take.h"

#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>

void tp_section_wish_init(tp_section_wish *wish) {
  *wish = (tp_section_wish){.closed = true, .unit = ""};
  fmpq_init(wish->gap);
  fmpq_init(wish->factor);
  fmpq_one(wish->factor);
}

void tp_section_wish_clear(tp_section_wish *wish) {
  fmpq_clear(wish->gap);
  fmpq_clear(wish->factor);
}

/* Of a closed chain twice its area, of an open one the step from end to end along s. */
static void measure(fmpq_t size, const tp_section_chain *chain) {
  const tp_polyline *line = &chain->points;
  fmpq_t term;
  fmpq_zero(size);
  if (!chain->closed) {
    fmpq_sub(size, line->x + line->count - 1, line->x);
    fmpq_abs(size, size);
    return;
  }
  fmpq_init(term);
  for (long k = 0, last = line->count - 1; k < line->count; last = k++) {
    fmpq_sub(term, line->x + last, line->x + k);
    fmpq_addmul(size, term, line->y + k);
    fmpq_sub(term, line->y + last, line->y + k);
    fmpq_submul(size, term, line->x + k);
  }
  fmpq_abs(size, size);
  fmpq_clear(term);
}

static tp_status fail_several(const tp_mesh_section *section, long count,
                              const tp_section_wish *wish, tp_message *message) {
  double width[2];
  for (int k = 0; k < 2; k++) {
    fmpq_t w, h;
    fmpq_init(w);
    fmpq_init(h);
    tp_polyline_size(w, h, &section->chains[k].points);
    width[k] = fmpq_get_d(w);
    fmpq_clear(w);
    fmpq_clear(h);
  }
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, wish->place,
      "the plane cuts %ld %s where one is expected, the first two %.4g and %.4g %s wide; "
      "name one 'object' of the mesh, or say 'take: largest'",
      count, wish->closed ? "outlines" : "separate lines", width[0], width[1], wish->unit);
}

/* The largest, or -1 where none is of the kind. */
static long find_largest(const tp_mesh_section *section, const tp_section_wish *wish) {
  long largest = -1;
  fmpq_t size, most;
  fmpq_init(size);
  fmpq_init(most);
  for (long k = 0; k < section->count; k++) {
    if (wish->closed && !section->chains[k].closed) continue;
    measure(size, section->chains + k);
    if (largest >= 0 && fmpq_cmp(size, most) <= 0) continue;
    fmpq_swap(size, most);
    largest = k;
  }
  fmpq_clear(size);
  fmpq_clear(most);
  return largest;
}

/* What is taken of a section. */
typedef struct choice {
  long chosen;
  long *within;          /* of each chain: tp_section_nest */
  long beside, cavities; /* chains that lie elsewhere, and within the chosen one */
} choice;

/* What lies in a cavity is no part of the block, and nothing says where it goes. */
static tp_status check_cavities(const choice *c, const tp_polylines *holes,
                                const tp_mesh_section *section, const tp_section_wish *wish,
                                tp_message *message) {
  if (!wish->closed || c->cavities == 0) return TP_OK;
  if (holes == NULL) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, wish->place,
        "the plane cuts a cavity within this outline, and only the outline of the block "
        "may have holes; name one 'object' of the mesh");
  }
  for (long k = 0; k < section->count; k++) {
    if (c->within[k] <= 0) continue;
    return tp_refuse(message, TP_FAULT_GEOMETRY, wish->place,
                     "the plane cuts an outline that lies within a cavity of the solid, a loose "
                     "piece; name one 'object' of the mesh, or mend the mesh");
  }
  return TP_OK;
}

/* Rounding may have left nothing of one that is narrower than a billionth of the section. */
static bool has_area(const tp_section_chain *chain) {
  return chain->points.count >= 3;
}

/* The one, or where that is asked for the largest, with what lies within it. */
static tp_status choose(choice *c, const tp_mesh_section *section, const tp_polylines *holes,
                        const tp_section_wish *wish, tp_message *message) {
  c->chosen = find_largest(section, wish);
  c->within = calloc((size_t)section->count + 1, sizeof *c->within);
  if (c->within == NULL) return tp_fail_memory(message, "a section");
  if (section->chains[c->chosen].closed && !tp_section_nest(c->within, section, c->chosen)) {
    return tp_fail_memory(message, "a section");
  }
  for (long k = 0; k < section->count; k++) {
    if (k == c->chosen) continue;
    const bool nested = section->chains[c->chosen].closed && c->within[k] >= 0;
    if (!nested) c->beside++;
    if (nested && has_area(section->chains + k)) c->cavities++;
  }
  if (c->beside > 0 && !wish->largest) {
    return fail_several(section, section->count, wish, message);
  }
  return check_cavities(c, holes, section, wish, message);
}

/* Of the leftmost points, or with `right` the rightmost ones, the highest. */
static long uppermost(const tp_polyline *line, bool right) {
  long best = 0;
  for (long k = 1; k < line->count; k++) {
    const int side = fmpq_cmp(line->x + k, line->x + best);
    if ((right ? side > 0 : side < 0) || (side == 0 && fmpq_cmp(line->y + k, line->y + best) > 0)) {
      best = k;
    }
  }
  return best;
}

/* The upper side of solid ground: clockwise from its leftmost to its rightmost point. */
static tp_status take_upper(tp_polyline *line, tp_section_chain *chain, tp_message *message) {
  tp_polyline *own = &chain->points;
  if (!tp_polyline_orient_by_area(own)) return TP_OK;
  const long last = uppermost(own, true);
  line->file = own->file;
  line->mark = own->mark;
  for (long k = uppermost(own, false);; k = k > 0 ? k - 1 : own->count - 1) {
    if (!tp_polyline_append(line, own->x + k, own->y + k, own->marks[k])) {
      return tp_fail_memory(message, "a section");
    }
    if (k == last) return TP_OK;
  }
}

static tp_status take(tp_polyline *line, tp_section_chain *chain, const tp_section_wish *wish,
                      tp_message *message) {
  if (!wish->closed && chain->closed) return take_upper(line, chain, message);
  *line = chain->points;
  chain->points = (tp_polyline){0};
  if (!wish->closed && fmpq_cmp(line->x, line->x + line->count - 1) > 0) tp_polyline_reverse(line);
  line->reversed = false;
  return TP_OK;
}

static tp_status note(const tp_polyline *line, const tp_mesh_section *section,
                      const tp_section_wish *wish, const choice *c, const fmpq_t resolution,
                      long joined, double widest, tp_notes *notes, tp_message *message) {
  char rounding[160] = ", all of them exact", step[100], gaps[100] = "";
  fmpq_t width, height;
  fmpq_init(width);
  fmpq_init(height);
  tp_polyline_size(width, height, line);
  tp_ratio_text(step, sizeof step, resolution);
  if (!fmpq_is_zero(resolution)) {
    snprintf(rounding, sizeof rounding, ", rounded to %s %s", step, wish->unit);
  }
  if (joined > 0) {
    snprintf(gaps, sizeof gaps, "; %ld %s closed, the widest of %.3g %s", joined,
             joined == 1 ? "gap was" : "gaps were", widest, wish->unit);
  }
  tp_status status =
      tp_notes_add(notes, message, TP_NOTE, wish->place,
                   "the section of this mesh has %ld points, %.6g wide and %.6g %s high%s%s",
                   line->count, fmpq_get_d(width), fmpq_get_d(height), wish->unit, rounding, gaps);
  if (status == TP_OK && c->beside > 0) {
    status = tp_notes_add(notes, message, TP_CAUTION, wish->place,
                          "of %ld %s that the plane cuts the largest is taken; the others are left "
                          "out, with their weight",
                          c->beside + 1, wish->closed ? "outlines" : "separate lines");
  }
  if (status == TP_OK && c->cavities > 0 && wish->closed) {
    status = tp_notes_add(notes, message, TP_NOTE, wish->place,
                          "%ld %s within the outline: cavities, which the block has for holes",
                          c->cavities, c->cavities == 1 ? "outline lies" : "outlines lie");
  }
  if (status == TP_OK && section->flipped > 0) {
    status = tp_notes_add(
        notes, message, TP_NOTE, wish->place,
        "in %ld of the edges that the plane cuts a face runs against its neighbour; the "
        "section is the same as if it did not",
        section->flipped);
  }
  fmpq_clear(width);
  fmpq_clear(height);
  return status;
}

/* Each cavity that was found. */
static tp_status take_holes(tp_polylines *holes, tp_mesh_section *section, const choice *c,
                            tp_message *message) {
  if (holes == NULL || c->cavities == 0) return TP_OK;
  holes->lines = calloc((size_t)c->cavities, sizeof *holes->lines);
  if (holes->lines == NULL) return tp_fail_memory(message, "a section");
  for (long k = 0; k < section->count; k++) {
    if (c->within[k] < 0 || !has_area(section->chains + k)) continue;
    holes->lines[holes->count] = section->chains[k].points;
    holes->lines[holes->count++].reversed = false;
    section->chains[k].points = (tp_polyline){0};
  }
  return TP_OK;
}

static tp_status take_chosen(tp_polyline *line, tp_polylines *holes, tp_mesh_section *section,
                             const choice *c, const tp_section_wish *wish, tp_message *message) {
  tp_status status = take(line, section->chains + c->chosen, wish, message);
  if (status == TP_OK && line->count < (wish->closed ? 3 : 2)) {
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, wish->place,
                  "what the plane cuts of this mesh is narrower than a billionth of its height; "
                  "turn the plane");
  }
  return status == TP_OK && wish->closed ? take_holes(holes, section, c, message) : status;
}

tp_status tp_section_take(tp_polyline *line, tp_polylines *holes, tp_mesh_section *section,
                          const tp_section_wish *wish, tp_notes *notes, tp_message *message) {
  choice c = {.chosen = -1};
  long joined = 0;
  double widest = 0;
  fmpq_t resolution;
  *line = (tp_polyline){0};
  if (section->count == 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, wish->place,
                     "the plane of the section does not cut this mesh, which lies to the %s of it, "
                     "seen along the section; shift the plane",
                     section->is_left ? "left" : "right");
  }
  fmpq_init(resolution);
  tp_section_round(section, wish->factor, resolution);
  tp_status status = tp_section_join(section, wish, &joined, &widest, message);
  if (status == TP_OK) status = choose(&c, section, holes, wish, message);
  if (status == TP_OK) status = take_chosen(line, holes, section, &c, wish, message);
  if (status == TP_OK) {
    status = note(line, section, wish, &c, resolution, joined, widest, notes, message);
  }
  fmpq_clear(resolution);
  free(c.within);
  if (status != TP_OK) {
    tp_polyline_clear(line);
    if (holes != NULL) tp_polylines_clear(holes);
  }
  return status;
}
