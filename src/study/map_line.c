/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The map along one scalar of a scene: tilt against it. The scalar's range falls into pieces of one
 * regime each, between borders that are bisected; over each piece the limit is a curve, and beyond
 * it the regime is what happens. */

#include "study/map.h"
#include "study/mechanism_style.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 241, LOOKS_MAX = 1200 };

typedef struct line {
  tp_map *map;
  bool scalar_is_x;
  tp_chart_range scalar, tilt;
  size_t count;
  tp_look *looks; /* along the scalar; a border is two looks a double apart */
} line;

static double at(const line *l, size_t k) {
  return l->looks[k].values[0];
}

static void add(const line *l, tp_bounded scalar, tp_bounded tilt) {
  tp_chart_add_point(l->map->chart, l->scalar_is_x ? scalar : tilt, l->scalar_is_x ? tilt : scalar);
}

static double clamped(const line *l, double tilt) {
  return fmin(fmax(tilt, l->tilt.from), l->tilt.to);
}

static void place(const line *l, double scalar, double tilt) {
  add(l, tp_chart_exactly(scalar), tp_chart_exactly(clamped(l, tilt)));
}

/* Look at the points of the range, and at every border between two of them. */
static void scan(line *l) {
  tp_map *map = l->map;
  for (int k = 0; k < POINTS && map->status == TP_OK; k++) {
    double x = l->scalar.from + (l->scalar.to - l->scalar.from) * k / (POINTS - 1);
    if (k == POINTS - 1) x = l->scalar.to;
    const tp_look next = tp_map_look(map, &x);
    while (l->count > 0 && map->status == TP_OK && l->count + 3 < LOOKS_MAX) {
      tp_look low = l->looks[l->count - 1], high = next;
      if (low.regime == high.regime) break;
      tp_map_border(map, &low, &high);
      if (low.values[0] > at(l, l->count - 1)) l->looks[l->count++] = low;
      l->looks[l->count++] = high;
    }
    if (l->count == 0 || x > at(l, l->count - 1)) l->looks[l->count++] = next;
  }
}

/* The end of the piece of one regime that begins at a look: one past its last. */
static size_t piece_end(const line *l, size_t begin) {
  size_t end = begin + 1;
  while (end < l->count && l->looks[end].regime == l->looks[begin].regime) end++;
  return end;
}

/* Up to where it is certain to stand. */
static double stands_to(const line *l, const tp_look *look) {
  const tp_bounded end = look->has_onset ? look->onset_deg : look->limit_deg;
  return clamped(l, end.value);
}

/* How far a place keeps from the curves of moments, of sliding and of dynamics, and from the bounds
 * of its region, over the width of a name; in degrees. */
static double clearance(const line *l, double scalar, double tilt, bool below) {
  const double reach = 0.12 * (l->scalar.to - l->scalar.from);
  double least = fmin(tilt - l->tilt.from, l->tilt.to - tilt);
  for (size_t k = 0; k < l->count; k++) {
    const tp_look *look = l->looks + k;
    if (fabs(at(l, k) - scalar) > reach) continue;
    const double limit = clamped(l, look->limit_deg.value);
    least = fmin(least, below ? stands_to(l, look) - tilt : tilt - limit);
    if (look->has_toppling) least = fmin(least, fabs(look->toppling_deg.value - tilt));
    if (look->has_sliding) least = fmin(least, fabs(look->sliding_deg.value - tilt));
    if (look->has_dynamic) least = fmin(least, fabs(look->dynamic_deg - tilt));
  }
  return least;
}

/* A name where the piece leaves most room for it, if it leaves enough. */
static void add_name(const line *l, size_t begin, size_t end, bool below) {
  enum { HEIGHTS = 20 };
  const double middle = (at(l, begin) + at(l, end - 1)) / 2;
  const double high = l->tilt.to - l->tilt.from, wide = l->scalar.to - l->scalar.from;
  const char *name = below ? "stable" : tp_regime_name(l->looks[begin].regime);
  const double half_name =
      fmin(0.01 * (double)strlen(name) * wide, 0.5 * (at(l, end - 1) - at(l, begin)));
  double room = 0.03 * high, scalar = 0, tilt = 0;
  bool found = false;
  for (size_t k = begin; k < end; k++) {
    const double x = at(l, k);
    if (x - at(l, begin) < half_name || at(l, end - 1) - x < half_name) continue;
    for (int h = 1; h < HEIGHTS; h++) {
      const double y = l->tilt.from + high * h / HEIGHTS;
      /* where much is free, the middle is best */
      const double clear =
          fmin(clearance(l, x, y, below), 0.15 * high) - 0.1 * high * fabs(x - middle) / wide;
      if (clear <= room) continue;
      room = clear;
      scalar = x;
      tilt = y;
      found = true;
    }
  }
  if (!found || at(l, end - 1) - at(l, begin) < 0.15 * wide) return;
  tp_chart_add_label(l->map->chart, l->scalar_is_x ? scalar : tilt, l->scalar_is_x ? tilt : scalar,
                     TP_LABEL_CENTRE, name);
}

static void add_regions(const line *l) {
  for (size_t k = 0, end; k < l->count; k = end) {
    end = piece_end(l, k);
    if (!tp_look_has_limit(l->looks + k) || end - k < 2) continue;
    tp_chart_add_guide(l->map->chart, tp_regime_region(l->looks[k].regime));
    for (size_t j = k; j < end; j++) place(l, at(l, j), l->looks[j].limit_deg.value);
    for (size_t j = end; j-- > k;) place(l, at(l, j), l->tilt.to);
    add_name(l, k, end, false);
  }
  for (size_t k = 0, end = 0; k<l->count; k = end> k ? end : k + 1) { /* whatever the regime */
    end = k;
    while (end < l->count && tp_look_has_limit(l->looks + end)) end++;
    if (end > k + 1) add_name(l, k, end, true);
  }
}

/* One past the last of the looks from `begin` on that leave history a window. */
static size_t window_end(const line *l, size_t begin) {
  size_t end = begin;
  while (end < l->count && l->looks[end].has_onset) end++;
  return end;
}

/* From where a motion can begin up to the limit, or, where forces hold at every tilt, to the top.
 */
static void add_windows(const line *l) {
  for (size_t k = 0, end; k < l->count; k = end + 1) {
    end = window_end(l, k);
    if (end < k + 2) continue;
    tp_chart_add_guide(l->map->chart, tp_region_history);
    for (size_t j = k; j < end; j++) place(l, at(l, j), l->looks[j].onset_deg.value);
    for (size_t j = end; j-- > k;) {
      const tp_look *look = l->looks + j;
      place(l, at(l, j), tp_look_has_limit(look) ? look->limit_deg.value : l->tilt.to);
    }
  }
}

static void add_limits(const line *l) {
  for (size_t k = 0, end; k < l->count; k = end) {
    end = piece_end(l, k);
    if (!tp_look_has_limit(l->looks + k)) continue;
    tp_map_begin(l->map, tp_regime_line(l->looks[k].regime), "limit",
                 tp_regime_name(l->looks[k].regime));
    for (size_t j = k; j < end; j++) add(l, tp_chart_exactly(at(l, j)), l->looks[j].limit_deg);
  }
}

/* From the limit up; what the two looks beside it have no limit for, from the bottom. */
static void add_borders(const line *l) {
  for (size_t k = 0; k + 1 < l->count; k++) {
    const tp_look *low = l->looks + k, *high = low + 1;
    if (low->regime == high->regime) continue;
    const double half = (high->values[0] - low->values[0]) / 2;
    const tp_bounded root = {.value = low->values[0] + half,
                             .error = half + fabs(low->values[0]) * 0x1p-52};
    const tp_look *limited = tp_look_has_limit(low) ? low : high;
    const bool both = tp_look_has_limit(low) && tp_look_has_limit(high);
    char name[80];
    tp_map_border_name(name, sizeof name, low->regime, high->regime);
    tp_map_begin(l->map, tp_line_border, "border", name);
    add(l, root, both ? limited->limit_deg : tp_chart_exactly(l->tilt.from));
    add(l, root, tp_chart_exactly(l->tilt.to));
  }
}

static bool read_onset(tp_bounded *value, const tp_look *look) {
  *value = look->onset_deg;
  return look->has_onset;
}

typedef bool (*reader)(tp_bounded *value, const tp_look *look);

static bool read_toppling(tp_bounded *value, const tp_look *look) {
  *value = look->toppling_deg;
  return look->has_toppling;
}

static bool read_sliding(tp_bounded *value, const tp_look *look) {
  *value = look->sliding_deg;
  return look->has_sliding;
}

static bool read_dynamic(tp_bounded *value, const tp_look *look) {
  *value = (tp_bounded){.value = look->dynamic_deg, .error = 0x1p-40 * look->dynamic_deg};
  return look->has_dynamic;
}

/* In as many pieces as it takes: it ends where it is not known, and where the pivot changes. */
static void add_curve(const line *l, const char *series, tp_chart_style style, reader read) {
  bool begun = false;
  for (size_t k = 0; k < l->count; k++) {
    tp_bounded value = {0};
    const bool known = read(&value, l->looks + k);
    const bool same = k > 0 && l->looks[k].governing == l->looks[k - 1].governing;
    if (known && (!begun || (read == read_toppling && !same))) {
      tp_map_begin(l->map, style, series, "");
    }
    begun = known;
    if (known) add(l, tp_chart_exactly(at(l, k)), value);
  }
}

void tp_map_draw_line(tp_map *map, bool scalar_is_x) {
  const tp_chart_axis *x = &map->options->x, *y = &map->options->y;
  line l = {.map = map,
            .scalar_is_x = scalar_is_x,
            .scalar = scalar_is_x ? x->range : y->range,
            .tilt = scalar_is_x ? y->range : x->range,
            .looks = calloc(LOOKS_MAX, sizeof *l.looks)};
  if (l.looks == NULL) {
    map->status = tp_fail_memory(map->message, "the map");
    return;
  }
  scan(&l);
  bool any = false;
  for (size_t k = 0; k < l.count; k++) any |= l.looks[k].regime != TP_REGIME_NONE;
  if (map->status == TP_OK && any) {
    add_regions(&l);
    add_windows(&l);
    add_limits(&l);
    add_borders(&l);
    add_curve(&l, "certain to stand", tp_line_onset, read_onset);
    add_curve(&l, "moment equilibrium", tp_line_moments, read_toppling);
    add_curve(&l, "Patton's sliding", tp_line_patton, read_sliding);
    add_curve(&l, "slides and topples from rest", tp_line_dynamic, read_dynamic);
  } else if (map->status == TP_OK) {
    map->status = tp_map_no_answer(map);
  }
  free(l.looks);
}
