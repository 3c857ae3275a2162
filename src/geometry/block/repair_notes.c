/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Notes on vertices that a repair moved, with the largest distance, and advice that names the
 * setting under which a repair would succeed. */

#include "block/repair.h"
#include "number/ratio.h"

#include <math.h>
#include <stdio.h>

/* Moves that are told one by one; the count of all stands in the first note. */
enum { NOTES_SHOWN = 20 };

/* What pow, the quotient and the product may round off, some units of 2^-53, and room. */
static const double rounding = 1e-12;

/* Rounded up to two digits. */
static double at_most(double length) {
  const double unit = pow(10, floor(log10(length)) - 1);
  return ceil(length / unit * (1 + rounding)) * unit;
}

/* The vertices that are elsewhere than before, the first ones by name. */
static tp_status note_moves(const tp_polyline *ring, const tp_polyline *before, const char *name,
                            tp_notes *notes, tp_message *message) {
  tp_status status = TP_OK;
  long shown = 0;
  for (long i = 0; i < ring->count && shown < NOTES_SHOWN && status == TP_OK; i++) {
    const long k = ring->reversed ? ring->count - 1 - i : i;
    if (fmpq_equal(ring->x + k, before->x + k) && fmpq_equal(ring->y + k, before->y + k)) continue;
    char p[4][64];
    tp_ratio_text(p[0], sizeof p[0], before->x + k);
    tp_ratio_text(p[1], sizeof p[1], before->y + k);
    tp_ratio_text(p[2], sizeof p[2], ring->x + k);
    tp_ratio_text(p[3], sizeof p[3], ring->y + k);
    status = tp_notes_add(notes, message, TP_NOTE, tp_polyline_place(ring, k),
                          "repaired: vertex %ld of %s is moved from (%s, %s) to (%s, %s)",
                          tp_polyline_number(ring, k), name, p[0], p[1], p[2], p[3]);
    shown++;
  }
  return status;
}

static tp_status note_repair(const tp_polyline *ring, const tp_polyline *before,
                             const tp_repair *repair, const char *name, tp_notes *notes,
                             tp_message *message) {
  char digit[64];
  tp_ratio_text(digit, sizeof digit, repair->digit);
  const tp_status status = tp_notes_add(
      notes, message, TP_NOTE, tp_polyline_place(ring, -1),
      "repaired: edges of %s met by less than its last digit, %s; %ld %s moved, by "
      "%.2g at most%s",
      name, digit, repair->moved, repair->moved == 1 ? "vertex is" : "vertices are",
      at_most(repair->most), repair->moved > NOTES_SHOWN ? ", the first twenty below" : "");
  return status == TP_OK ? note_moves(ring, before, name, notes, message) : status;
}

tp_status tp_repair_with_notes(tp_polyline *ring, const char *name, tp_notes *notes,
                               tp_message *message) {
  tp_polyline before = {0};
  tp_repair repair;
  if (!tp_polyline_copy(&before, ring)) return tp_fail_memory(message, "the repair of an outline");
  tp_repair_init(&repair);
  tp_status status = tp_repair_ring(ring, &repair, message);
  if (status == TP_OK && repair.done && repair.moved > 0) {
    status = note_repair(ring, &before, &repair, name, notes, message);
  }
  tp_repair_clear(&repair);
  tp_polyline_clear(&before);
  return status;
}

tp_status tp_repair_advice(char *advice, size_t size, const tp_polyline *ring, bool repairable,
                           tp_message *message) {
  snprintf(advice, size, "reorder or move the vertices");
  if (!repairable) return TP_OK;
  tp_polyline copy = {0};
  tp_repair repair;
  if (!tp_polyline_copy(&copy, ring)) return tp_fail_memory(message, "the repair of an outline");
  tp_repair_init(&repair);
  const tp_status status = tp_repair_ring(&copy, &repair, message);
  if (status == TP_OK && repair.done) {
    char digit[64];
    tp_ratio_text(digit, sizeof digit, repair.digit);
    snprintf(advice, size,
             "by less than its last digit, %s: 'repair: true' in the block moves %ld %s by %.2g at "
             "most and says which, or move them yourself",
             digit, repair.moved, repair.moved == 1 ? "vertex" : "vertices", at_most(repair.most));
  }
  tp_repair_clear(&repair);
  tp_polyline_clear(&copy);
  return status;
}
