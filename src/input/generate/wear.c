/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Wear of asperities, in rationals; what is new is rounded to decimals at its end. A corner that is
 * rounded becomes four chords of the parabola that touches its edges at the share s of them from
 * the corner: its middle lies lower by s (2 y - y0 - y1) / 4. */

#include "generate/generate.h"
#include "generate/ticks.h"

/* A chain that grows, and the decimals of its new points. */
typedef struct worn {
  tp_polyline line;
  fmpq_t unit;
  bool room;
} worn;

/* A point that repeats the one before it is none. */
static void add(worn *w, const fmpq *x, const fmpq *y, tp_mark mark) {
  const long last = w->line.count - 1;
  if (last >= 0 && fmpq_equal(w->line.x + last, x) && fmpq_equal(w->line.y + last, y)) return;
  if (w->room) w->room = tp_polyline_append(&w->line, x, y, mark);
}

/* Of a new point; x stays within [low, high] when it is rounded. */
static void add_rounded(worn *w, fmpq_t x, fmpq_t y, const fmpq *low, const fmpq *high,
                        tp_mark mark) {
  tp_ticks_round(x, w->unit);
  tp_ticks_round(y, w->unit);
  if (fmpq_cmp(x, low) < 0) fmpq_set(x, low);
  if (fmpq_cmp(x, high) > 0) fmpq_set(x, high);
  add(w, x, y, mark);
}

static const fmpq *extreme(const tp_polyline *line, bool highest) {
  const fmpq *y = line->y;
  for (long k = 1; k < line->count; k++) {
    const int side = fmpq_cmp(line->y + k, y);
    if (highest ? side > 0 : side < 0) y = line->y + k;
  }
  return y;
}

static void find_mean(fmpq_t mean, const tp_polyline *line) {
  fmpq_zero(mean);
  for (long k = 0; k < line->count; k++) fmpq_add(mean, mean, line->y + k);
  fmpq_div_fmpz(mean, mean, (fmpz_t){line->count});
}

void tp_wear_most(fmpq_t most, const tp_polyline *line, tp_wear wear) {
  if (wear == TP_WEAR_ABRADED) {
    find_mean(most, line);
  } else {
    fmpq_set(most, extreme(line, false));
  }
  fmpq_sub(most, extreme(line, true), most);
}

/* Where the edge from one point to the next meets the level: strictly between them. */
static void add_crossing(worn *w, const tp_polyline *line, long k, const fmpq_t level) {
  fmpq_t x, part;
  fmpq_init(x);
  fmpq_init(part);
  fmpq_sub(part, level, line->y + k);
  fmpq_sub(x, line->y + k + 1, line->y + k);
  fmpq_div(part, part, x);
  fmpq_sub(x, line->x + k + 1, line->x + k);
  fmpq_mul(x, x, part);
  fmpq_add(x, x, line->x + k);
  tp_ticks_round(x, w->unit);
  if (fmpq_cmp(x, line->x + k) < 0) fmpq_set(x, line->x + k);
  if (fmpq_cmp(x, line->x + k + 1) > 0) fmpq_set(x, line->x + k + 1);
  add(w, x, level, line->marks[k]);
  fmpq_clear(x);
  fmpq_clear(part);
}

static void cut(worn *w, const tp_polyline *line, const fmpq_t depth) {
  fmpq_t level;
  fmpq_init(level);
  fmpq_sub(level, extreme(line, true), depth);
  for (long k = 0; k < line->count; k++) {
    const int side = fmpq_cmp(line->y + k, level);
    const bool end = k == 0 || k == line->count - 1;
    if (side <= 0 || end) add(w, line->x + k, side > 0 ? level : line->y + k, line->marks[k]);
    if (k + 1 < line->count && side * fmpq_cmp(line->y + k + 1, level) < 0) {
      add_crossing(w, line, k, level);
    }
  }
  fmpq_clear(level);
}

/* How far the corner stands above the line of its neighbours, twice; the share of the edges. */
static bool find_share(fmpq_t share, const tp_polyline *line, long k, const fmpq_t depth) {
  fmpq_t above;
  fmpq_init(above);
  fmpq_mul_2exp(above, line->y + k, 1);
  fmpq_sub(above, above, line->y + k - 1);
  fmpq_sub(above, above, line->y + k + 1);
  const bool lowers = fmpq_sgn(above) > 0;
  if (lowers) {
    fmpq_mul_2exp(share, depth, 2);
    fmpq_div(share, share, above);
    fmpq_set_si(above, 1, 2);
    if (fmpq_cmp(share, above) > 0) fmpq_set(share, above);
  }
  fmpq_clear(above);
  return lowers;
}

/* from + (to - from) share */
static void between(fmpq_t at, const fmpq *from, const fmpq *to, const fmpq_t share) {
  fmpq_sub(at, to, from);
  fmpq_mul(at, at, share);
  fmpq_add(at, at, from);
}

/* The point of the parabola at the quarter `part` between its ends, along one axis. */
static void on_parabola(fmpq_t at, const fmpq *values, long k, const fmpq_t share, int part) {
  enum { QUARTERS = 4 };
  const int rest = QUARTERS - part;
  fmpq_t end;
  fmpq_init(end);
  between(at, values + k, values + k - 1, share);
  fmpq_mul_si(at, at, rest * rest);
  between(end, values + k, values + k + 1, share);
  fmpq_mul_si(end, end, part * part);
  fmpq_add(at, at, end);
  fmpq_mul_si(end, values + k, 2 * rest * part);
  fmpq_add(at, at, end);
  fmpq_div_2exp(at, at, 4);
  fmpq_clear(end);
}

/* Corners that point upwards: the chain turns to the right. */
static void round_corners(worn *w, const tp_polyline *line, const fmpq_t depth) {
  fmpq_t share, x, y;
  fmpq_init(share);
  fmpq_init(x);
  fmpq_init(y);
  for (long k = 0; k < line->count && w->room; k++) {
    const bool end = k == 0 || k == line->count - 1;
    if (end || tp_polyline_turn(line, k - 1, k, k + 1) >= 0 || !find_share(share, line, k, depth)) {
      add(w, line->x + k, line->y + k, line->marks[k]);
      continue;
    }
    for (int part = 0; part <= 4; part++) {
      on_parabola(x, line->x, k, share, part);
      on_parabola(y, line->y, k, share, part);
      add_rounded(w, x, y, w->line.x + w->line.count - 1, line->x + k + 1, line->marks[k]);
    }
  }
  fmpq_clear(share);
  fmpq_clear(x);
  fmpq_clear(y);
}

static void abrade(worn *w, const tp_polyline *line, const fmpq_t depth) {
  fmpq_t mean, kept, y;
  fmpq_init(mean);
  fmpq_init(kept);
  fmpq_init(y);
  find_mean(mean, line);
  fmpq_sub(y, extreme(line, true), mean);
  fmpq_sub(kept, y, depth);
  fmpq_div(kept, kept, y);
  for (long k = 0; k < line->count; k++) {
    if (fmpq_cmp(line->y + k, mean) <= 0) {
      add(w, line->x + k, line->y + k, line->marks[k]);
      continue;
    }
    between(y, mean, line->y + k, kept);
    tp_ticks_round(y, w->unit);
    add(w, line->x + k, y, line->marks[k]);
  }
  fmpq_clear(mean);
  fmpq_clear(kept);
  fmpq_clear(y);
}

bool tp_wear_off(tp_polyline *line, tp_wear wear, const fmpq_t depth) {
  worn w = {.line = {.file = line->file, .mark = line->mark}, .room = true};
  fmpq_init(w.unit);
  tp_ticks_millionth(w.unit, depth);
  switch (wear) {
  case TP_WEAR_CUT:
    cut(&w, line, depth);
    break;
  case TP_WEAR_ROUNDED:
    round_corners(&w, line, depth);
    break;
  case TP_WEAR_ABRADED:
    abrade(&w, line, depth);
    break;
  }
  fmpq_clear(w.unit);
  if (w.room) {
    tp_polyline_clear(line);
    *line = w.line;
  } else {
    tp_polyline_clear(&w.line);
  }
  return w.room;
}
