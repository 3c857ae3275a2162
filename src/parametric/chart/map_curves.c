/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The map along one scalar of a scene: tilt against it. The scalar's range falls into pieces of one
 * regime each, between borders that are bisected; over each piece the limit is a curve, and beyond
 * it the regime is what happens. */

#include "chart/map_strips.h"
#include "chart/mechanism_style.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 241, SAMPLES_MAX = 1200 };

/* Look at the points of the range, and at every border between two of them. */
static void scan(tp_map_line *l) {
  tp_map *map = l->map;
  for (int k = 0; k < POINTS && map->status == TP_OK; k++) {
    double x = l->scalar.from + (l->scalar.to - l->scalar.from) * k / (POINTS - 1);
    if (k == POINTS - 1) x = l->scalar.to;
    const tp_map_sample next = tp_map_take_sample(map, &x);
    while (l->count > 0 && map->status == TP_OK && l->count + 3 < SAMPLES_MAX) {
      tp_map_sample low = l->samples[l->count - 1], high = next;
      if (tp_map_sample_is_like(&low, &high)) break;
      tp_map_border(map, &low, &high);
      if (low.values[0] > tp_line_at(l, l->count - 1)) l->samples[l->count++] = low;
      l->samples[l->count++] = high;
    }
    if (l->count == 0 || x > tp_line_at(l, l->count - 1)) l->samples[l->count++] = next;
  }
}

/* The end of the piece of one regime that begins at a sample: one past its last. */
static size_t piece_end(const tp_map_line *l, size_t begin) {
  size_t end = begin + 1;
  while (end < l->count && l->samples[end].regime == l->samples[begin].regime) end++;
  return end;
}

/* One past the last of the samples from `begin` on that leave history a window. */
static size_t window_end(const tp_map_line *l, size_t begin) {
  size_t end = begin;
  while (end < l->count && l->samples[end].has_onset) end++;
  return end;
}

/* From where a motion can begin up to the limit, or, where forces hold at every tilt, to the top.
 */
static void add_windows(const tp_map_line *l) {
  for (size_t k = 0, end; k < l->count; k = end + 1) {
    end = window_end(l, k);
    if (end < k + 2) continue;
    tp_chart_add_guide(l->map->chart, tp_region_history);
    for (size_t j = k; j < end; j++)
      tp_line_add_corner(l, tp_line_at(l, j), l->samples[j].onset_deg.value);
    for (size_t j = end; j-- > k;) {
      const tp_map_sample *sample = l->samples + j;
      tp_line_add_corner(l, tp_line_at(l, j),
                         sample->has_limit ? sample->limit_deg.value : l->tilt.to);
    }
  }
}

static void add_limits(const tp_map_line *l) {
  for (size_t k = 0, end; k < l->count; k = end) {
    end = piece_end(l, k);
    if (!l->samples[k].has_limit) continue;
    tp_map_begin(l->map, tp_regime_line(l->samples[k].regime), "limit",
                 tp_regime_name(l->samples[k].regime));
    for (size_t j = k; j < end; j++)
      tp_line_add(l, tp_chart_exactly(tp_line_at(l, j)), l->samples[j].limit_deg);
  }
}

/* Where the limit's mechanism changes: a point on its curve, as what begins beyond is another
 * question, which strips answer; without strips on both sides, up to the top. Where one side has no
 * limit, from that of the other on; without any limit, all of the height. */
static void add_border(const tp_map_line *l, const tp_map_sample *low, const tp_map_sample *high) {
  const tp_bounded root = tp_line_root(low, high);
  const bool one = low->has_limit, other = high->has_limit;
  const bool strips = low->has_strips && high->has_strips;
  char name[80];
  tp_map_border_name(name, sizeof name, low->regime, high->regime);
  tp_map_begin(l->map, tp_line_border, "border", name);
  tp_line_add(l, root,
              one     ? low->limit_deg
              : other ? high->limit_deg
                      : tp_chart_exactly(l->tilt.from));
  if (!(one && other && strips)) tp_line_add(l, root, tp_chart_exactly(l->tilt.to));
}

static void add_borders(const tp_map_line *l) {
  for (size_t k = 0; k + 1 < l->count; k++) {
    if (l->samples[k].regime != l->samples[k + 1].regime) {
      add_border(l, l->samples + k, l->samples + k + 1);
    }
  }
}

static bool read_onset(tp_bounded *value, const tp_map_sample *sample) {
  *value = sample->onset_deg;
  return sample->has_onset;
}

typedef bool (*reader)(tp_bounded *value, const tp_map_sample *sample);

static bool read_toppling(tp_bounded *value, const tp_map_sample *sample) {
  *value = sample->toppling_deg;
  return sample->has_toppling;
}

static bool read_sliding(tp_bounded *value, const tp_map_sample *sample) {
  *value = sample->sliding_deg;
  return sample->has_sliding;
}

/* In as many pieces as it takes: it ends where it is not known, and where the pivot changes. */
static void add_curve(const tp_map_line *l, const char *series, tp_chart_style style, reader read) {
  bool begun = false;
  for (size_t k = 0; k < l->count; k++) {
    tp_bounded value = {0};
    const bool known = read(&value, l->samples + k);
    const bool same = k > 0 && l->samples[k].governing == l->samples[k - 1].governing;
    if (known && (!begun || (read == read_toppling && !same))) {
      tp_map_begin(l->map, style, series, "");
    }
    begun = known;
    if (known) tp_line_add(l, tp_chart_exactly(tp_line_at(l, k)), value);
  }
}

void tp_map_draw_line(tp_map *map, bool scalar_is_x) {
  const tp_chart_axis *x = &map->options->x, *y = &map->options->y;
  tp_map_line l = {.map = map,
                   .scalar_is_x = scalar_is_x,
                   .scalar = scalar_is_x ? x->range : y->range,
                   .tilt = scalar_is_x ? y->range : x->range,
                   .samples = calloc(SAMPLES_MAX, sizeof *l.samples)};
  if (l.samples == NULL) {
    map->status = tp_fail_memory(map->message, "the map");
    return;
  }
  scan(&l);
  bool any = false;
  for (size_t k = 0; k < l.count; k++) any |= l.samples[k].regime != TP_REGIME_NONE;
  if (map->status == TP_OK && any) {
    tp_line_add_regions(&l);
    add_windows(&l);
    add_limits(&l);
    add_borders(&l);
    add_curve(&l, "certain to stand", tp_line_onset, read_onset);
    add_curve(&l, "moment equilibrium", tp_line_moments, read_toppling);
    add_curve(&l, map->patton ? "Patton's sliding" : "sliding", tp_line_sliding, read_sliding);
    tp_line_add_motions(&l);
  } else if (map->status == TP_OK) {
    map->status = tp_map_no_answer(map);
  }
  free(l.samples);
}
