/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Over samples that are alike, strip for strip, the ends of the strips are curves; where two
 * samples a double apart are not alike, the tilts at which their motions differ are an upright
 * border. */

#include "chart/map_strips.h"

#include "chart/map_names.h"
#include "chart/mechanism_style.h"

#include <math.h>

/* Upright borders that are shorter than this share of the map's height are where a strip begins
 * with no height. */
static const double least_share = 0x1p-10;

static void strip_part(double *low, double *high, const tp_map_line *l, const tp_map_sample *sample,
                       size_t strip) {
  const double from = tp_line_moves_from(l, sample);
  *low = fmax(from, tp_line_clamped(l, sample->strips[strip].from_deg.value));
  *high = fmax(from, tp_line_clamped(l, sample->strips[strip].to_deg.value));
}

static void limit_part(double *low, double *high, const tp_map_line *l, const tp_map_sample *sample,
                       size_t strip) {
  (void)strip;
  *low = tp_line_moves_from(l, sample);
  *high = l->tilt.to;
}

static void stable_part(double *low, double *high, const tp_map_line *l,
                        const tp_map_sample *sample, size_t strip) {
  (void)strip;
  *low = l->tilt.from;
  *high = tp_line_stands_to(l, sample);
}

static void add_region(const tp_map_line *l, const tp_line_region *r, tp_chart_style style) {
  double low = 0, high = 0;
  tp_chart_add_guide(l->map->chart, style);
  for (size_t k = r->begin; k < r->end; k++) {
    r->part(&low, &high, l, l->samples + k, r->strip);
    tp_line_add_corner(l, tp_line_at(l, k), low);
  }
  for (size_t k = r->end; k-- > r->begin;) {
    r->part(&low, &high, l, l->samples + k, r->strip);
    tp_line_add_corner(l, tp_line_at(l, k), high);
  }
}

/* Is any of it beyond the limit, and within the map? */
static bool is_seen(const tp_map_line *l, const tp_line_region *r) {
  for (size_t k = r->begin; k < r->end; k++) {
    double low = 0, high = 0;
    r->part(&low, &high, l, l->samples + k, r->strip);
    if (high > low) return true;
  }
  return false;
}

/* The regions of one sort: of some motions, or, without strips, of a regime. */
typedef struct sort {
  unsigned motions; /* 0: of the regime */
  tp_regime regime;
} sort;

static void add_sort(const tp_map_line *l, const sort *of, const char *name, tp_chart_style style) {
  tp_line_name at = {false};
  bool any = false;
  for (size_t k = 0, end; k < l->count; k = end) {
    const tp_map_sample *sample = l->samples + k;
    end = tp_line_end(l, k);
    if (end - k < 2 || sample->regime == TP_REGIME_NONE) continue;
    for (size_t s = 0; s < (sample->has_strips ? sample->strip_count : 1); s++) {
      const tp_line_region r = {k, end, sample->has_strips ? strip_part : limit_part, s};
      const bool is_of = sample->has_strips ? sample->strips[s].motions == of->motions
                                            : of->motions == 0 && sample->regime == of->regime;
      if (!is_of || (sample->has_strips && of->motions == 0) || !is_seen(l, &r)) continue;
      any = true;
      add_region(l, &r, style);
      tp_line_find_name(&at, l, name, &r);
    }
  }
  if (any && !tp_line_add_name(l, name, &at)) tp_chart_add_legend(l->map->chart, name, style);
}

void tp_line_add_regions(const tp_map_line *l) {
  enum { MOST = 1U << TP_MECHANISM_UNDECIDED };
  for (unsigned motions = 1; motions < MOST; motions++) {
    char name[TP_MOTIONS_NAME_SIZE];
    tp_motions_name(name, motions);
    add_sort(l, &(sort){motions, TP_REGIME_NONE}, name, tp_motions_region(motions));
  }
  for (int k = TP_REGIME_SLIDES; k <= TP_REGIME_UNDECIDED; k++) {
    const tp_regime regime = (tp_regime)k;
    add_sort(l, &(sort){0, regime}, tp_regime_name(regime), tp_regime_region(regime));
  }
  tp_line_name at = {false};
  for (size_t k = 0, end = 0; k<l->count; k = end> k ? end : k + 1) { /* whatever the regime */
    end = k;
    while (end < l->count && (l->samples[end].has_limit || l->samples[end].has_onset)) end++;
    if (end > k + 1) tp_line_find_name(&at, l, "stable", &(tp_line_region){k, end, stable_part, 0});
  }
  (void)tp_line_add_name(l, "stable", &at);
}

static void begin_border(const tp_map_line *l, unsigned one, unsigned other) {
  char both[TP_MOTIONS_BORDER_SIZE];
  tp_motions_border_name(both, one, other);
  tp_map_begin(l->map, tp_line_dynamic, "motion", both);
}

/* From one strip to the next, upwards, over samples that are alike. */
static void add_curves(const tp_map_line *l, size_t begin, size_t end) {
  const tp_map_sample *first = l->samples + begin;
  for (size_t s = 0; s + 1 < first->strip_count; s++) {
    begin_border(l, first->strips[s].motions, first->strips[s + 1].motions);
    for (size_t k = begin; k < end; k++) {
      tp_line_add(l, tp_chart_exactly(tp_line_at(l, k)), l->samples[k].strips[s].to_deg);
    }
  }
}

static unsigned motions_at(const tp_map_sample *sample, double tilt) {
  for (size_t s = 0; s < sample->strip_count; s++) {
    const tp_strip *own = sample->strips + s;
    if (own->from_deg.value <= tilt && tilt <= own->to_deg.value) return own->motions;
  }
  return 0;
}

/* Of all ends of strips of both samples the next above a tilt. */
static tp_bounded next_end(const tp_map_sample *const samples[2], double tilt) {
  tp_bounded next = {.value = 90};
  for (int side = 0; side < 2; side++) {
    for (size_t s = 0; s < samples[side]->strip_count; s++) {
      const tp_strip *own = samples[side]->strips + s;
      const tp_bounded ends[2] = {own->from_deg, own->to_deg};
      for (int e = 0; e < 2; e++) {
        if (ends[e].value > tilt && ends[e].value < next.value) next = ends[e];
      }
    }
  }
  return next;
}

/* Where no motion can begin on one side, the onset jumps. */
static void add_upright(const tp_map_line *l, const tp_map_sample *low, const tp_map_sample *high) {
  const tp_map_sample *const samples[2] = {low, high};
  const double least = least_share * (l->tilt.to - l->tilt.from);
  tp_bounded from = {0}, to = {0};
  for (; from.value < 90; from = to) {
    to = next_end(samples, from.value);
    const double middle = (from.value + to.value) / 2;
    const unsigned one = motions_at(low, middle), other = motions_at(high, middle);
    if (one == other || to.value - from.value < least) continue;
    begin_border(l, one, other);
    tp_line_add(l, tp_line_root(low, high), from);
    tp_line_add(l, tp_line_root(low, high), to);
  }
}

void tp_line_add_motions(const tp_map_line *l) {
  for (size_t k = 0, end; k < l->count; k = end) {
    end = tp_line_end(l, k);
    if (l->samples[k].has_strips && end > k + 1) add_curves(l, k, end);
    if (end == l->count || !l->samples[k].has_strips || !l->samples[end].has_strips) continue;
    add_upright(l, l->samples + end - 1, l->samples + end);
  }
}
