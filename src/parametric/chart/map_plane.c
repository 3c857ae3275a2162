/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The map over two scalars of a scene: what begins to move first, or what it does at the
 * scene's tilt, and contour lines of the limit or of the factor of safety. */

#include "chart/mechanism_style.h"
#include "chart/trace.h"
#include "number/root.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CONTOURS = 10, SEARCH_LOOKS = 60, DIGITS_OF_GRID = 9 };

/* A number of a sample that has contours. */
typedef bool (*reader)(tp_bounded *value, const tp_map_sample *sample);

static bool read_limit(tp_bounded *value, const tp_map_sample *sample) {
  *value = sample->limit_deg;
  return sample->has_limit;
}

static bool read_onset(tp_bounded *value, const tp_map_sample *sample) {
  *value = sample->onset_deg;
  return sample->has_onset;
}

static bool read_fos(tp_bounded *value, const tp_map_sample *sample) {
  *value = sample->fos;
  return sample->has_fos;
}

typedef struct plane {
  tp_map *map;
  tp_map_sample *grid;
  tp_map_point *points;
  reader read;  /* of the present contour */
  double level; /* likewise */
} plane;

static double coordinate(const plane *p, const tp_chart_range *range, int k) {
  const int last = p->map->side - 1;
  return k == last ? range->to : range->from + (range->to - range->from) * k / last;
}

static int sample_count(const plane *p) {
  return p->map->side * p->map->side;
}

static bool scan(const plane *p) {
  bool any = false;
  for (int k = 0; k < sample_count(p) && p->map->status == TP_OK; k++) {
    const double values[2] = {coordinate(p, &p->map->options->x.range, k % p->map->side),
                              coordinate(p, &p->map->options->y.range, k / p->map->side)};
    p->grid[k] = tp_map_take_sample(p->map, values);
    any |= p->grid[k].regime != TP_REGIME_NONE;
  }
  return any;
}

static int regime_region(const void *context, const tp_map_sample *sample) {
  (void)context;
  return (int)sample->regime;
}

static tp_crossing middle_of(const tp_map_sample *low, const tp_map_sample *high) {
  const double half_x = (high->values[0] - low->values[0]) / 2;
  const double half_y = (high->values[1] - low->values[1]) / 2;
  const double x = low->values[0] + half_x, y = low->values[1] + half_y;
  return (tp_crossing){true, {x, y, half_x + 0x1p-52 * fabs(x), half_y + 0x1p-52 * fabs(y)}};
}

static tp_crossing cross_regimes(void *context, tp_map_sample low, tp_map_sample high) {
  const plane *p = context;
  tp_map_border(p->map, &low, &high);
  return middle_of(&low, &high);
}

static int contour_region(const void *context, const tp_map_sample *sample) {
  const plane *p = context;
  tp_bounded own;
  if (!p->read(&own, sample)) return 0;
  return own.value + own.error < p->level ? 1 : 2; /* on the level: always the same side */
}

/* 1 above the present level for certain, -1 below it; 0 else. */
static int side_of(const plane *p, const tp_map_sample *sample) {
  tp_bounded own;
  if (!p->read(&own, sample)) return 0;
  const double gap = own.value - p->level;
  return gap > own.error ? 1 : gap < -own.error ? -1 : 0;
}

static tp_map_sample between(const plane *p, const tp_map_sample *low, const tp_map_sample *high,
                             double share) {
  const double values[2] = {low->values[0] + share * (high->values[0] - low->values[0]),
                            low->values[1] + share * (high->values[1] - low->values[1])};
  return tp_map_take_sample(p->map, values);
}

/* The narrowest certain bracket about a share of an edge. About an end of it, where a level that a
 * line of the grid follows lies, it goes beyond. */
static tp_crossing bracket(const plane *p, const tp_map_sample *low, const tp_map_sample *high,
                           double share) {
  for (double h = p->map->bracket; h < 1 && p->map->status == TP_OK; h *= 16) {
    const tp_map_sample below = between(p, low, high, share - h),
                        above = between(p, low, high, share + h);
    if (side_of(p, &below) * side_of(p, &above) < 0) return middle_of(&below, &above);
  }
  return (tp_crossing){0};
}

typedef struct edge {
  const plane *p;
  const tp_map_sample *low, *high;
  bool open; /* the number is not known at this share of it: */
  double share;
} edge;

/* How far the number is above the present level at a share of an edge. */
static bool gap_at(double *gap, void *context, double share) {
  edge *e = context;
  const tp_map_sample found = between(e->p, e->low, e->high, share);
  tp_bounded own;
  if (e->p->map->status != TP_OK) return false;
  if (!e->p->read(&own, &found)) {
    e->open = true;
    e->share = share;
    return false;
  }
  *gap = own.value - e->p->level;
  return true;
}

/* Along an edge, then within a certain bracket. A number that jumps over the level does not cross
 * it. */
static tp_crossing cross_level(void *context, tp_map_sample low, tp_map_sample high) {
  const plane *p = context;
  tp_bounded first, last;
  if (!p->read(&first, &low) || !p->read(&last, &high)) return (tp_crossing){0};
  edge e = {.p = p, .low = &low, .high = &high};
  const tp_root_search search = {
      .value = gap_at, .context = &e, .flat = p->map->flat * fabs(p->level), .most = SEARCH_LOOKS};
  tp_root root;
  const bool found = tp_root_find(&root, &search, (tp_root_end){0, first.value - p->level},
                                  (tp_root_end){1, last.value - p->level});
  /* where the verdict changes, a factor of 1 is not known at the root itself, but to its sides */
  const bool at_root = found && root.flat;
  return at_root || e.open ? bracket(p, &low, &high, at_root ? root.low : e.share)
                           : (tp_crossing){0};
}

/* Are two points so near that their labels touch? */
static bool is_near(const plane *p, tp_map_point at, const tp_chart_label *label) {
  const tp_chart_range *x = &p->map->options->x.range, *y = &p->map->options->y.range;
  static const double of_width = 0.09, of_height = 0.05; /* "87.5" and a line, with room */
  return fabs(label->x - at.x) < of_width * (x->to - x->from) &&
         fabs(label->y - at.y) < of_height * (y->to - y->from);
}

/* The present level on its curve, where no other stands; a short curve has none. */
static void add_level(const plane *p, size_t count) {
  static const double shares[] = {0.5, 0.35, 0.65, 0.2, 0.8};
  const tp_chart *chart = p->map->chart;
  char text[32];
  snprintf(text, sizeof text, p->read == read_fos ? "%.4g" : "%.4g°", p->level);
  for (size_t k = 0; k < sizeof shares / sizeof shares[0] && count > (size_t)p->map->side / 6;
       k++) {
    const tp_map_point at = p->points[(size_t)((double)count * shares[k])];
    bool is_free = true;
    for (size_t j = 0; j < chart->label_count; j++) is_free &= !is_near(p, at, chart->labels + j);
    if (!is_free) continue;
    tp_chart_add_label(p->map->chart, at.x, at.y, TP_LABEL_BOXED, text);
    return;
  }
}

static void add_regions(tp_map *map, const tp_pieces *pieces) {
  for (int regime = TP_REGIME_STANDS; regime <= TP_REGIME_UNDECIDED; regime++) {
    bool any = false;
    for (size_t k = 0; k < pieces->patch_count; k++) {
      const tp_patch *patch = pieces->patches + k;
      if (patch->region != regime) continue;
      if (any) {
        tp_chart_add_break(map->chart);
      } else {
        tp_chart_add_guide(map->chart, tp_regime_region((tp_regime)regime));
        tp_chart_add_legend(map->chart, tp_regime_name((tp_regime)regime),
                            tp_regime_region((tp_regime)regime));
      }
      any = true;
      for (size_t j = 0; j < patch->count; j++) {
        tp_chart_add_corner(map->chart, patch->corners[j].x, patch->corners[j].y);
      }
    }
  }
}

/* The curves of a field: contours of the present level, or borders. */
static void add_curves(plane *p, const tp_map_field *field, tp_chart_style style,
                       const char *series, bool levels) {
  tp_pieces pieces = {0};
  tp_trace(&pieces, p->map, field, p->grid, p->map->side, p->map->side);
  free(p->points);
  p->points = calloc(pieces.count + 2, sizeof *p->points);
  if (pieces.failed || p->points == NULL) {
    p->map->status = tp_fail_memory(p->map->message, "the map");
  }
  int regions[2];
  size_t count = 0;
  while (p->points != NULL && p->map->status == TP_OK &&
         (count = tp_trace_next(p->points, regions, &pieces)) > 0) {
    char name[80];
    tp_map_border_name(name, sizeof name, (tp_regime)regions[0], (tp_regime)regions[1]);
    if (levels) snprintf(name, sizeof name, "%.15g", p->level);
    tp_map_begin(p->map, style, series, name);
    for (size_t k = 0; k < count; k++) {
      const tp_map_point *at = p->points + k;
      tp_chart_add_point(p->map->chart, (tp_bounded){.value = at->x, .error = at->x_error},
                         (tp_bounded){.value = at->y, .error = at->y_error});
    }
    if (levels) add_level(p, count);
  }
  if (!levels) add_regions(p->map, &pieces);
  tp_pieces_clear(&pieces);
}

/* The contours are a round number of degrees apart. */
static double contour_step(double range) {
  const double rough = range / CONTOURS, decade = pow(10, floor(log10(rough)));
  const double steps[] = {1, 2, 5, 10};
  for (int k = 0; k < 4; k++) {
    if (steps[k] * decade >= rough) return steps[k] * decade;
  }
  return 10 * decade;
}

typedef struct contours {
  reader read;
  tp_chart_style style;
  const char *series;
} contours;

static void add_contour(plane *p, const contours *of, double level) {
  const tp_map_field field = {p, contour_region, cross_level};
  p->read = of->read;
  p->level = level;
  if (level != 0) add_curves(p, &field, of->style, of->series, true);
}

/* Where no levels are asked for: of angles, round numbers. */
static void add_round_levels(plane *p, const contours *of) {
  double low = INFINITY, high = -INFINITY;
  tp_bounded own;
  for (int k = 0; k < sample_count(p); k++) {
    if (!of->read(&own, p->grid + k)) continue;
    low = fmin(low, own.value);
    high = fmax(high, own.value);
  }
  if (!(high > low)) return;
  const double step = contour_step(high - low);
  for (double k = floor(low / step) + 1; k * step < high && p->map->status == TP_OK; k++) {
    add_contour(p, of, k * step);
  }
}

static void add_contours(plane *p, contours of) {
  const tp_chart_list *asked = &p->map->options->levels;
  static const double usual[] = {1, 1.1, 1.3, 1.5, 2};
  const bool factors = of.read == read_fos;
  const tp_chart_list own = {factors ? sizeof usual / sizeof usual[0] : 0, usual};
  const tp_chart_list *levels = asked->count > 0 ? asked : &own;
  if (levels->count == 0) add_round_levels(p, &of);
  for (size_t k = 0; k < levels->count && p->map->status == TP_OK; k++) {
    add_contour(p, &of, levels->values[k]);
  }
}

/* A border is a matter of the verdict alone, of which its error is not: doubles tell it, or few
 * digits. */
static void add_borders(plane *p) {
  tp_map *map = p->map;
  const tp_map_field field = {p, regime_region, cross_regimes};
  map->varied.options.strength_reduction = false;
  map->varied.options.digits = DIGITS_OF_GRID;
  if (!map->of_many) {
    map->status = tp_keyed_filter_new(&map->filter, map->varied.scene, map->varied.keys,
                                      map->varied.count, false, map->message);
  }
  if (map->status == TP_OK) add_curves(p, &field, tp_line_border, "border", false);
  tp_keyed_filter_free(map->filter);
  map->filter = NULL;
}

void tp_map_draw_plane(tp_map *map) {
  plane p = {.map = map, .grid = calloc((size_t)map->side * (size_t)map->side, sizeof *p.grid)};
  if (p.grid == NULL) {
    map->status = tp_fail_memory(map->message, "the map");
    return;
  }
  tp_solve_options *solve = &map->varied.options;
  const int digits = solve->digits;
  solve->pivots = TP_PIVOTS_GOVERNING;
  solve->digits = DIGITS_OF_GRID;
  const bool any = scan(&p);
  solve->digits = digits;
  if (map->status == TP_OK && !any) map->status = tp_map_no_answer(map);
  if (map->status == TP_OK && map->options->governing_fos) {
    const char *series = map->of_many ? "governing_fos_at_most" : "governing_fos";
    add_contours(&p, (contours){read_fos, tp_line_contour, series});
  } else if (map->status == TP_OK) {
    add_contours(&p, (contours){read_limit, tp_line_contour, "limit"});
    add_contours(&p, (contours){read_onset, tp_line_stands, "certain to stand"});
  }
  if (map->status == TP_OK) add_borders(&p);
  free(p.points);
  free(p.grid);
}
