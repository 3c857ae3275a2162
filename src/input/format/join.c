/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ends sorted by x and compared within reach; each end may meet one other, and chains are followed
 * from end to end. */

#include "format/join.h"

#include "common/outside.h"
#include "format/twins.h"

#include <math.h>
#include <stdlib.h>

/* An end of a piece. */
typedef struct piece_end {
  const tp_drawing_object *piece;
  long number; /* of the piece among the open ones */
  bool last;
  long mate;  /* the end that it meets, by its number 2 * piece + last; -1: none */
  long meets; /* how many ends it meets */
} piece_end;

typedef struct joining {
  tp_drawing *chains;
  const fmpq *gap;
  tp_message *message;
  long count; /* open pieces, of which each has two ends */
  const tp_drawing_object **pieces;
  piece_end *ends;    /* 2 k and 2 k + 1 of piece k */
  piece_end **sorted; /* by x */
  bool *done;         /* pieces that are in a chain */
  long closed;        /* gaps */
  double widest;
  tp_place widest_place;
} joining;

static long point_of(const piece_end *end) {
  return end->last ? end->piece->line.count - 1 : 0;
}

static const fmpq *x_of(const piece_end *end) {
  return end->piece->line.x + point_of(end);
}

static const fmpq *y_of(const piece_end *end) {
  return end->piece->line.y + point_of(end);
}

static tp_place place_of(const piece_end *end) {
  return tp_polyline_place(&end->piece->line, point_of(end));
}

double tp_drawing_distance(const tp_polyline *one, long k, const tp_polyline *other, long j) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_sub(x, one->x + k, other->x + j);
  fmpq_sub(y, one->y + k, other->y + j);
  const double distance = hypot(fmpq_get_d(x), fmpq_get_d(y));
  fmpq_clear(x);
  fmpq_clear(y);
  return distance;
}

/* Each curve once. */
static tp_status leave_out_twins(joining *j) {
  tp_place place = {0};
  const long drawn = j->count;
  j->count = tp_drawing_drop_twins(j->pieces, drawn, &place);
  if (j->count == drawn) return TP_OK;
  return tp_notes_add(&j->chains->notes, j->message, TP_NOTE, place,
                      "pieces that are drawn twice count once, %ld in all", drawn - j->count);
}

/* ---- which ends meet ---------------------------------------------------------------------------
 */

static int compare_ends(const void *one, const void *other) {
  const piece_end *a = *(piece_end *const *)one, *b = *(piece_end *const *)other;
  const int order = fmpq_cmp(x_of(a), x_of(b));
  return order != 0 ? order : fmpq_cmp(y_of(a), y_of(b));
}

/* Up to how far apart two ends meet. */
static void set_reach(fmpq_t reach, const joining *j, const piece_end *a, const piece_end *b) {
  fmpq_add(reach, a->piece->uncertainty, b->piece->uncertainty);
  if (fmpq_cmp(reach, j->gap) < 0) fmpq_set(reach, j->gap);
}

static bool meet(const joining *j, const piece_end *a, const piece_end *b) {
  fmpq_t reach, x, y;
  fmpq_init(reach);
  fmpq_init(x);
  fmpq_init(y);
  set_reach(reach, j, a, b);
  fmpq_sub(x, x_of(a), x_of(b));
  fmpq_sub(y, y_of(a), y_of(b));
  fmpq_mul(x, x, x);
  fmpq_addmul(x, y, y);
  fmpq_mul(reach, reach, reach);
  const bool near = fmpq_cmp(x, reach) <= 0;
  fmpq_clear(reach);
  fmpq_clear(x);
  fmpq_clear(y);
  return near;
}

static void link_ends(joining *j, piece_end *a, piece_end *b) {
  a->mate = b - j->ends;
  b->mate = a - j->ends;
  a->meets++;
  b->meets++;
}

/* The largest distance that may be closed anywhere. */
static void set_farthest(fmpq_t farthest, const joining *j) {
  fmpq_zero(farthest);
  for (long k = 0; k < j->count; k++) {
    if (fmpq_cmp(j->pieces[k]->uncertainty, farthest) > 0) {
      fmpq_set(farthest, j->pieces[k]->uncertainty);
    }
  }
  fmpq_mul_2exp(farthest, farthest, 1);
  if (fmpq_cmp(farthest, j->gap) < 0) fmpq_set(farthest, j->gap);
}

static void find_mates(joining *j) {
  fmpq_t farthest, difference;
  fmpq_init(farthest);
  fmpq_init(difference);
  set_farthest(farthest, j);
  const long count = 2 * j->count;
  for (long k = 0; k < count; k++) {
    for (long i = k + 1; i < count; i++) {
      fmpq_sub(difference, x_of(j->sorted[i]), x_of(j->sorted[k]));
      if (fmpq_cmp(difference, farthest) > 0 || j->sorted[k]->meets > 1) break;
      if (fmpq_is_zero(farthest) && !fmpq_equal(y_of(j->sorted[i]), y_of(j->sorted[k]))) break;
      if (meet(j, j->sorted[k], j->sorted[i])) link_ends(j, j->sorted[k], j->sorted[i]);
    }
  }
  fmpq_clear(farthest);
  fmpq_clear(difference);
}

static tp_status check_mates(const joining *j) {
  for (long k = 0; k < 2 * j->count; k++) {
    if (j->ends[k].meets < 2) continue;
    return tp_refuse(
        j->message, TP_FAULT_KEY, place_of(j->ends + k),
        "more than two ends of %s on layer '%s' meet here, so it is unclear which "
        "belong together; draw the outline as one polyline, or put on the layer nothing else",
        j->ends[k].piece->kind, tp_quote_all(j->ends[k].piece->layer).text);
  }
  return TP_OK;
}

/* ---- chains ------------------------------------------------------------------------------------
 */

/* Which of two ends that meet gives the point: one that stands in the file, of the first piece. */
static const piece_end *giver(const piece_end *a, const piece_end *b) {
  const bool computed = fmpq_cmp(a->piece->uncertainty, b->piece->uncertainty) > 0;
  const bool given = fmpq_cmp(a->piece->uncertainty, b->piece->uncertainty) < 0;
  if (computed != given) return computed ? b : a;
  return a->number <= b->number ? a : b;
}

static void note_gap(joining *j, const piece_end *a, const piece_end *b) {
  const double gap =
      tp_drawing_distance(&a->piece->line, point_of(a), &b->piece->line, point_of(b));
  if (gap == 0) return;
  if (j->closed++ == 0 || gap > j->widest) {
    j->widest = gap;
    j->widest_place = place_of(a);
  }
}

static void set_point(tp_drawing_object *object, long k, const piece_end *from) {
  fmpq_set(object->line.x + k, x_of(from));
  fmpq_set(object->line.y + k, y_of(from));
}

/* The piece from `entry` to its other end, behind the chain. `entry` meets the end that the chain
 * has, but for the first piece. */
static bool add_piece(joining *j, tp_drawing_object *chain, const piece_end *entry, bool first) {
  tp_drawing own;
  tp_drawing_init(&own, j->chains->path);
  tp_drawing_object *piece = tp_drawing_add(&own, "", "", "", entry->piece->line.mark);
  bool done = piece != NULL && tp_drawing_append(piece, entry->piece) &&
              (!entry->last || tp_drawing_reverse(piece));
  if (done && !first) {
    const piece_end *before = j->ends + entry->mate;
    note_gap(j, before, entry);
    set_point(piece, 0, giver(before, entry));
    tp_drawing_drop_point(chain);
    chain->pieces++;
  }
  const char *problem = chain->problem;
  done = done && tp_drawing_append(chain, piece);
  if (problem != NULL) chain->problem = problem;
  tp_drawing_clear(&own);
  return done;
}

static piece_end *other_end(joining *j, const piece_end *end) {
  return j->ends + ((end - j->ends) ^ 1);
}

/* From an end through all that follows, until nothing does or it comes round. */
static tp_status add_chain(joining *j, const piece_end *start) {
  const tp_drawing_object *model = start->piece;
  tp_drawing_object *chain =
      tp_drawing_add(j->chains, model->kind, model->layer, model->name, model->line.mark);
  bool done = chain != NULL;
  const piece_end *entry = start, *exit = start;
  while (done && !j->done[entry->number]) {
    j->done[entry->number] = true;
    done = add_piece(j, chain, entry, entry == start);
    exit = other_end(j, entry);
    if (exit->mate < 0) break;
    entry = j->ends + exit->mate;
  }
  if (!done) return tp_fail_memory(j->message, "a drawing");
  chain->closure = TP_DRAWING_OPEN;
  if (exit->mate >= 0) { /* round: the last point is the first one */
    note_gap(j, exit, start);
    set_point(chain, 0, giver(exit, start));
    tp_drawing_drop_point(chain);
    chain->closure = TP_DRAWING_CLOSED;
  }
  return TP_OK;
}

static tp_status add_chains(joining *j) {
  tp_status status = TP_OK;
  for (int round = 0; round < 2; round++) { /* from free ends first, then what goes round */
    for (long k = 0; k < 2 * j->count && status == TP_OK; k++) {
      const piece_end *end = j->ends + k;
      if (!j->done[end->number] && (round == 1 || end->mate < 0)) status = add_chain(j, end);
    }
  }
  if (status != TP_OK || j->closed == 0) return status;
  return tp_notes_add(&j->chains->notes, j->message, TP_NOTE, j->widest_place,
                      "gaps between pieces were closed, %ld in all; the widest, of %.3g in the "
                      "drawing, is here",
                      j->closed, j->widest);
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

/* A copy of what needs no joining. */
static bool keep(tp_drawing *chains, const tp_drawing_object *object) {
  tp_drawing_object *own =
      tp_drawing_add(chains, object->kind, object->layer, object->name, object->line.mark);
  if (own == NULL || !tp_drawing_append(own, object)) return false;
  own->ring_of = object->ring_of;
  return true;
}

static tp_status split(joining *j, const tp_drawing_pieces *pieces) {
  for (long k = 0; k < pieces->count; k++) {
    const tp_drawing_object *object = pieces->drawing->objects + pieces->items[k];
    if (object->closure == TP_DRAWING_OPEN && object->line.count > 1) {
      j->pieces[j->count++] = object;
    } else if (!keep(j->chains, object)) {
      return tp_fail_memory(j->message, "a drawing");
    }
  }
  return TP_OK;
}

static void set_ends(joining *j) {
  for (long k = 0; k < 2 * j->count; k++) {
    j->ends[k] =
        (piece_end){.piece = j->pieces[k / 2], .number = k / 2, .last = k % 2 == 1, .mate = -1};
    j->sorted[k] = j->ends + k;
  }
  qsort(j->sorted, 2 * (size_t)j->count, sizeof *j->sorted, compare_ends);
}

tp_status tp_drawing_join(tp_drawing *chains, const tp_drawing_pieces *pieces, const fmpq_t gap,
                          tp_message *message) {
  const size_t count = (size_t)pieces->count + 1;
  joining j = {.chains = chains,
               .gap = gap,
               .message = message,
               .pieces = calloc(count, sizeof *j.pieces),
               .ends = calloc(2 * count, sizeof *j.ends),
               .sorted = calloc(2 * count, sizeof *j.sorted),
               .done = calloc(count, sizeof *j.done)};
  tp_status status = j.pieces != NULL && j.ends != NULL && j.sorted != NULL && j.done != NULL
                         ? split(&j, pieces)
                         : tp_fail_memory(message, "a drawing");
  if (status == TP_OK) status = leave_out_twins(&j);
  if (status == TP_OK) {
    set_ends(&j);
    find_mates(&j);
    status = check_mates(&j);
  }
  if (status == TP_OK) status = add_chains(&j);
  free(j.pieces);
  free(j.ends);
  free(j.sorted);
  free(j.done);
  return status;
}
