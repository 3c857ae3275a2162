/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mechanism map of any scene, along one or two of its numbers: what is asked, and what it is
 * asked of. */

#include "chart/axis_label.h"
#include "chart/map.h"
#include "chart/mechanism_style.h"
#include "common/host.h"
#include "common/options.h"
#include "common/outside.h"
#include "output/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LABEL_SIZE = 180 };

static bool is_tilt(const tp_chart_axis *axis) {
  return strcmp(axis->key, "tilt") == 0;
}

static tp_status check_axis(const tp_chart_axis *axis, tp_message *message) {
  const double from = axis->range.from, to = axis->range.to;
  if (!(from < to && isfinite(to - from))) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "%s goes from %g to %g; the range must rise, and end",
                     tp_quote_all(axis->key).text, from, to);
  }
  if (is_tilt(axis) && !(from >= 0 && to <= 90)) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "the tilt goes from %g to %g; it must lie between 0 and 90 degrees", from, to);
  }
  return TP_OK;
}

static bool has_tilt(const tp_scene *scene) {
  return scene->tilt_angle_deg.given || tp_scene_lies_in_place(scene);
}

static tp_status check_levels(const tp_chart_list *levels, tp_message *message) {
  if (levels->count > TP_CHART_LIST_MAX) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "there are %zu levels; %d are the most", levels->count,
                     (int)TP_CHART_LIST_MAX);
  }
  if (levels->count > 0) TP_REFUSE_NULL(message, levels->values);
  for (size_t k = 0; k < levels->count; k++) {
    const double own = levels->values[k];
    if (own > 0 && isfinite(own)) continue;
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "a contour is asked for at %g; levels are above 0", own);
  }
  return TP_OK;
}

/* Many blocks have no onset to be followed from level on. */
static tp_status check_blocks(const tp_chart_map_options *o, tp_message *message) {
  const tp_place place = {o->scene->path, 0, 0};
  if (is_tilt(&o->x) || is_tilt(&o->y)) {
    return tp_refuse(message, TP_FAULT_KEY, place,
                     "a map of many blocks is over two numbers of the scene, as --x "
                     "friction_angle_deg --y slope.dip_deg, or tilt.angle_deg for one of them");
  }
  if (!o->any_tilt) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "a map of many blocks is of what they do as they lie; drop any tilt");
}

static tp_status check_contours(const tp_chart_map_options *o, tp_message *message) {
  const tp_place place = {o->scene->path, 0, 0};
  const bool along_one = is_tilt(&o->x) || is_tilt(&o->y);
  if (tp_scene_block_count(o->scene) > 0) {
    const tp_status status = check_blocks(o, message);
    return status == TP_OK ? check_levels(&o->levels, message) : status;
  }
  if (along_one && (o->governing_fos || o->levels.count > 0)) {
    return tp_refuse(
        message, TP_FAULT_KEY, place,
        "a map against the tilt has no contours; give two numbers of the scene, of which "
        "one may be tilt.angle_deg");
  }
  if (o->governing_fos && o->any_tilt) {
    return tp_refuse(message, TP_FAULT_KEY, place,
                     "the factor of safety is that at the scene's tilt; drop any tilt");
  }
  if (o->governing_fos && !has_tilt(o->scene)) {
    return tp_refuse(
        message, TP_FAULT_KEY, place,
        "the factor of safety is that at a tilt; give the scene a 'tilt: {angle_deg: …}'");
  }
  return check_levels(&o->levels, message);
}

static tp_status check(const tp_chart_map_options *o, tp_message *message) {
  tp_status status = check_axis(&o->x, message);
  if (status == TP_OK) status = check_axis(&o->y, message);
  if (status == TP_OK && strcmp(o->x.key, o->y.key) == 0) {
    status = tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                       "both axes are %s; give a number of the scene for one of them",
                       tp_quote_all(o->x.key).text);
  }
  if (status == TP_OK) status = check_contours(o, message);
  return status;
}

/* The scene's numbers on the axes, x first. */
static tp_status find_numbers(tp_map *map) {
  const tp_chart_axis *axes[2] = {&map->options->x, &map->options->y};
  const tp_scene *scene = map->options->scene;
  tp_status status = TP_OK;
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    if (is_tilt(axes[k])) continue;
    status =
        tp_scene_key_find(map->varied.keys + map->varied.count, scene, axes[k]->key, map->message);
    if (status == TP_OK) map->varied.count++;
  }
  double own = 0;
  if (status == TP_OK) status = tp_varied_check(&own, &map->varied, map->message);
  if (status == TP_OK && !map->of_many && !scene->friction_angle_deg.given) {
    status =
        tp_refuse(map->message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                  "a map of mechanisms takes friction; give the scene a 'friction_angle_deg: …'");
  }
  return status;
}

/* `label` holds the text as long as the axis is used. */
static tp_panel_axis axis_of(char label[LABEL_SIZE], const tp_map *map, const tp_chart_axis *from) {
  tp_panel_axis axis = {.label = label, .range = from->range};
  if (is_tilt(from) && tp_scene_lies_in_place(map->options->scene)) {
    snprintf(label, LABEL_SIZE, "Dip that it is steepened to (°)");
    axis.plain = true;
    return axis;
  }
  tp_axis_label(label, LABEL_SIZE, &axis.plain, is_tilt(from) ? "tilt.angle_deg" : from->key,
                map->options->scene);
  return axis;
}

/* A line of the legend, where the chart has such a series. */
typedef struct legend_entry {
  const char *series, *of, *text; /* of NULL: of anything */
  tp_chart_style style;
} legend_entry;

static void add_entries(tp_chart *chart, const legend_entry *entries, size_t count) {
  for (size_t e = 0; e < count; e++) {
    for (size_t k = 0; k < chart->series_count; k++) {
      const tp_chart_series *s = chart->series + k;
      if (s->drawn_only || s->count < 2 || strcmp(s->keys[0], entries[e].series) != 0) continue;
      if (entries[e].of != NULL && strcmp(s->keys[1], entries[e].of) != 0) continue;
      tp_chart_add_legend(chart, entries[e].text, entries[e].style);
      break;
    }
  }
}

static void add_legend_of_line(tp_chart *chart) {
  const legend_entry entries[] = {
      {"limit", "slides", "limit: slides", tp_line_slides},
      {"limit", "topples", "limit: topples", tp_line_topples},
      {"limit", "slides and topples", "limit: slides and topples", tp_line_both},
      {"limit", "tie", "limit: tie", tp_line_both},
      {"certain to stand", "", "certain to stand up to", tp_line_onset},
      {"certain to stand", "", "depends on history", tp_region_history},
      {"moment equilibrium", "", "moment equilibrium", tp_line_moments},
      {"Patton's sliding", "", "Patton's sliding", tp_line_sliding},
      {"sliding", "", "sliding along a facet", tp_line_sliding},
      {"motion", NULL, "between motions from rest", tp_line_dynamic},
  };
  add_entries(chart, entries, sizeof entries / sizeof entries[0]);
}

static void add_legend_of_plane(tp_chart *chart, bool of_many) {
  const legend_entry entries[] = {
      {"border", NULL, "border of mechanisms", tp_line_border},
      {"limit", NULL,
       of_many ? "upper bound of the critical angle" : "critical angle, limit analysis",
       tp_line_contour},
      {"certain to stand", NULL, "certain to stand up to, where that is less", tp_line_stands},
      {"governing_fos", NULL, "factor of safety that governs", tp_line_contour},
      {"governing_fos_at_most", NULL, "upper bound of the factor of safety", tp_line_contour},
  };
  add_entries(chart, entries, sizeof entries / sizeof entries[0]);
}

/* The chart must not be written over what it is computed from. */
static void add_sources(const tp_map *map) {
  const tp_scene *scene = map->options->scene;
  if (scene->file == NULL) return;
  for (size_t k = 0; k < tp_scene_source_count(scene); k++) {
    tp_chart_add_source(map->chart, tp_scene_source(scene, k));
  }
}

/* The scene's, and the tilt that regions are told at, where that is one throughout the map. */
static void set_title(tp_map *map) {
  const char *own = map->options->scene->title;
  tp_text text = {0};
  if (own != NULL) tp_text_add(&text, "%s", own);
  if (map->has_tilt && !map->tilts_differ) {
    if (tp_scene_lies_in_place(map->options->scene)) {
      tp_text_add(&text, "%s%.6g°", own != NULL ? ", as it lies, at " : "As it lies, at ",
                  map->tilt_deg);
    } else {
      tp_text_add(&text, "%s%.6g°", own != NULL ? ", at a tilt of " : "At a tilt of ",
                  map->tilt_deg);
    }
  }
  map->chart->failed |= text.failed;
  if (text.data != NULL && !text.failed) tp_chart_set_title(map->chart, text.data);
  tp_text_drop(&text);
}

static void draw(tp_map *map) {
  const tp_chart_map_options *o = map->options;
  const bool along_one = is_tilt(&o->x) || is_tilt(&o->y);
  map->chart = tp_chart_new("map", (const char *const[]){"series", "of", NULL},
                            is_tilt(&o->x) ? "tilt_deg" : o->x.key,
                            is_tilt(&o->y) ? "tilt_deg" : o->y.key, (const char *const[]){NULL});
  if (map->chart == NULL) {
    map->status = tp_fail_memory(map->message, "the chart");
    return;
  }
  map->varied.options.motion_ranges = along_one;
  add_sources(map);
  map->chart->panel_width_mm = 72;
  map->chart->panel_height_mm = 62;
  char labels[2][LABEL_SIZE];
  const tp_panel_axis x = axis_of(labels[0], map, &o->x), y = axis_of(labels[1], map, &o->y);
  tp_chart_add_panel(map->chart, NULL, x, y);
  map->at_tilt = !along_one && !o->any_tilt && (map->of_many || has_tilt(o->scene));
  map->varied.options.strength_reduction = o->governing_fos;
  if (along_one) {
    tp_map_draw_line(map, is_tilt(&o->y));
  } else {
    tp_map_draw_plane(map);
  }
  set_title(map);
  if (map->status != TP_OK || map->chart->failed) return;
  if (along_one) {
    add_legend_of_line(map->chart);
  } else {
    add_legend_of_plane(map->chart, map->of_many);
  }
}

/* Of an edge of the grid 2^-64 is left between regimes of one block, within the last digit of all
 * numbers but those near 0, where doubles go on to 1e-308. */
static void set_closeness(tp_map *map) {
  enum { SIDE = 49, HALVINGS = 64, SIDE_OF_MANY = 25, HALVINGS_OF_MANY = 20 };
  map->of_many = tp_scene_block_count(map->options->scene) > 0;
  map->side = map->of_many ? SIDE_OF_MANY : SIDE;
  map->border_steps = map->of_many ? HALVINGS_OF_MANY : HALVINGS;
  map->flat = map->of_many ? 1e-6 : 1e-11;
  map->bracket = map->of_many ? 0x1p-20 : 0x1p-36;
}

TP_OPTIONS_END(tp_chart_map_options, levels);

void tp_chart_map_options_init(tp_chart_map_options *options, size_t size) {
  const tp_chart_map_options defaults = {.size = sizeof defaults, .y = {"tilt", {0, 90}}};
  tp_options_fill(options, size, &defaults);
}

tp_status tp_chart_map(tp_chart **chart, const tp_chart_map_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, options);
  tp_chart_map_options taken = tp_chart_map_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  TP_REFUSE_NULL(message, options->scene);
  TP_REFUSE_NULL(message, options->x.key);
  TP_REFUSE_NULL(message, options->y.key);
  tp_message own = {.text = ""};
  tp_map map = {.options = options, .varied = {.scene = options->scene}, .message = &own};
  map.varied.options = tp_solve_options_default();
  map.varied.options.digits = 15;
  map.varied.options.strength_reduction = false;
  set_closeness(&map);
  map.status = check(options, &own);
  if (map.status == TP_OK) map.status = find_numbers(&map);
  if (map.status == TP_OK) draw(&map);
  if (map.status == TP_OK) return tp_chart_finish(map.chart, chart, message);
  tp_chart_free(map.chart);
  if (message != NULL) *message = own;
  return map.status;
}
