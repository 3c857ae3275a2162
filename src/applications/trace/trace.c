/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks of the request, traces from rough polygons of three sizes, the standard deviation as a
 * root of squares, and the scene written with outline, offset and deviation (docs/trace.md). */

#include "trace/trace.h"

#include "common/host.h"
#include "output/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS = 3 };

/* ---- what is asked -----------------------------------------------------------------------------
 */

static bool is_in_picture(const tp_trace_picture *picture, tp_trace_point p) {
  return p.x >= 0 && p.y >= 0 && p.x <= picture->width && p.y <= picture->height;
}

static tp_status check(const tp_trace_options *options, const tp_trace_picture *picture,
                       tp_message *message) {
  const tp_place place = {options->image, 0, 0};
  bool within =
      is_in_picture(picture, options->scale[0]) && is_in_picture(picture, options->scale[1]);
  for (int k = 0; k < 2; k++) {
    if (options->plumb_given) within = within && is_in_picture(picture, options->plumb[k]);
    if (options->between_given) within = within && is_in_picture(picture, options->between[k]);
  }
  for (long k = 0; k < options->rough.count; k++) {
    within = within && is_in_picture(picture, options->rough.points[k]);
  }
  for (long k = 0; k < options->outline.count; k++) {
    within = within && is_in_picture(picture, options->outline.points[k]);
  }
  if (within) return TP_OK;
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, place,
      "a point that is given lies outside of the picture, which is %d pixels wide and %d "
      "high; points are X,Y in pixels from its upper left corner",
      picture->width, picture->height);
}

/* Would a scene take what is said of the rock? Told before the picture is read. */
static tp_status check_rock(const tp_trace_options *options, tp_message *message) {
  char *text = NULL;
  tp_scene *scene = NULL;
  tp_message own = {.text = ""};
  tp_status status = tp_trace_rock_text(&text, options);
  if (status != TP_OK) return tp_fail_memory(message, "a scene");
  status = tp_scene_read_text(&scene, text, "options", &own);
  tp_scene_free(scene);
  free(text);
  if (status == TP_OK) return TP_OK;
  const char *after = strstr(own.text, ": "); /* the place, which is in no file of the user's */
  return tp_fail(message, status, (tp_place){NULL, 0, 0},
                 "no scene takes what the options say: %.400s",
                 after != NULL ? after + 2 : own.text);
}

/* The rough polygon, made larger about the mean of its points by a share. */
static bool grow_rough(tp_trace_ring *ring, const tp_trace_ring *rough, double share,
                       const tp_trace_picture *picture) {
  tp_trace_point middle = {0, 0};
  for (long k = 0; k < rough->count; k++) {
    middle.x += rough->points[k].x / (double)rough->count;
    middle.y += rough->points[k].y / (double)rough->count;
  }
  for (long k = 0; k < rough->count; k++) {
    const tp_trace_point p = rough->points[k];
    const double x = p.x + share * (p.x - middle.x), y = p.y + share * (p.y - middle.y);
    const tp_trace_point own = {fmin(fmax(x, 0), picture->width),
                                fmin(fmax(y, 0), picture->height)};
    if (!tp_trace_ring_add(ring, own)) return false;
  }
  return true;
}

/* ---- tracing -----------------------------------------------------------------------------------
 */

static tp_status trace_once(tp_refined *refined, tp_picture_region *region,
                            const tp_trace_picture *picture, const tp_trace_options *options,
                            double share, tp_message *message) {
  tp_trace_ring rough = {0};
  tp_status status = grow_rough(&rough, &options->rough, share, picture)
                         ? TP_OK
                         : tp_fail_memory(message, "an outline");
  if (status == TP_OK) status = tp_region_find(region, picture, &rough, options->image, message);
  if (status == TP_OK) status = tp_refine(refined, region, picture, message);
  tp_trace_ring_clear(&rough);
  tp_trace_ring_clear(&region->contour);
  return status;
}

/* By how much the outlines of larger rough polygons lie outside of this one, in the mean over it.
 */
static tp_status compare_runs(tp_trace *trace, const tp_trace_picture *picture,
                              const tp_trace_options *options, tp_message *message) {
  double squares = 0;
  const double area = tp_trace_ring_area(&trace->ring);
  const double length = tp_trace_ring_length(&trace->ring);
  for (int k = 1; k < RUNS; k++) {
    tp_refined refined = {0};
    tp_picture_region region;
    const tp_status status = trace_once(&refined, &region, picture, options, 0.04 * k, message);
    if (status != TP_OK) return status;
    const double away = (tp_trace_ring_area(&refined.ring) - area) / length;
    tp_trace_ring_clear(&refined.ring);
    squares += away * away / (RUNS - 1);
  }
  trace->runs_px = sqrt(squares);
  return TP_OK;
}

/* What the picture tells: the outline, and how well it tells it. */
static tp_status look_for(tp_trace *trace, const tp_trace_picture *picture,
                          const tp_trace_options *options, tp_message *message) {
  tp_refined refined = {0};
  tp_picture_region region;
  tp_status status = trace_once(&refined, &region, picture, options, 0, message);
  if (status != TP_OK) return status;
  trace->ring = refined.ring;
  trace->edge_px = refined.edge_px;
  trace->weak = refined.weak;
  trace->touching = region.touching;
  status = compare_runs(trace, picture, options, message);
  trace->deviation_px =
      sqrt(trace->edge_px * trace->edge_px + trace->runs_px * trace->runs_px + 1.0 / 12);
  return status;
}

/* Clicks stay as they are, unless a tolerance is given. */
static tp_status thin_out(tp_trace *trace, const tp_trace_options *options, tp_message *message) {
  const bool clicked = options->outline.count > 0;
  if (options->tolerance > 0) {
    trace->tolerance_px = options->tolerance / trace->per_pixel;
  } else if (!clicked) {
    trace->tolerance_px = sqrt(trace->edge_px * trace->edge_px + 1.0 / 12) / 2;
  }
  if (trace->tolerance_px > 0 && !tp_trace_simplify(&trace->ring, trace->tolerance_px)) {
    return tp_fail_memory(message, "an outline");
  }
  if (trace->ring.count >= 3 && fabs(tp_trace_ring_area(&trace->ring)) > 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){options->image, 0, 0},
                   clicked
                       ? "the outline that is given has no area"
                       : "the outline has no area left; a smaller --tolerance keeps more of its "
                         "points");
}

static tp_status find_outline(tp_trace *trace, const tp_trace_picture *picture,
                              const tp_trace_options *options, tp_message *message) {
  tp_status status = options->outline.count > 0 ? tp_trace_take_clicks(trace, options, message)
                                                : look_for(trace, picture, options, message);
  if (status != TP_OK) return status;
  tp_trace_place(trace, options);
  status = thin_out(trace, options, message);
  if (status != TP_OK) return status;
  trace->moves = calloc((size_t)trace->ring.count, sizeof *trace->moves);
  if (trace->moves == NULL) return tp_fail_memory(message, "an outline");
  tp_trace_moves(trace->moves, &trace->ring);
  tp_trace_place(trace, options);
  if (tp_trace_find_between(trace, options)) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){options->image, 0, 0},
                   "both ends of the contact are nearest to one point of the outline; take them "
                   "farther apart, or a smaller --tolerance, which keeps more of its points");
}

/* ---- results -----------------------------------------------------------------------------------
 */

/* Is it a scene whose block is one? */
static tp_status check_scene(const char *text, const tp_trace_options *options,
                             tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message own = {.text = ""};
  const tp_solve_options plain = tp_solve_options_default();
  tp_status status = tp_scene_read_text(&scene, text, "the scene", &own);
  if (status == TP_OK) status = tp_solve(&solution, scene, &plain, &own);
  tp_solution_free(solution);
  tp_scene_free(scene);
  if (status == TP_OK || status == TP_UNDECIDED) return TP_OK;
  return tp_fail(message, status, (tp_place){options->image, 0, 0},
                 "the outline makes no block (%.400s); %s%s", own.text,
                 options->outline.count > 0
                     ? "click it again, once round the block"
                     : "draw the rough polygon nearer to it, or give a larger --tolerance",
                 options->between_given ? ", or other ends of the contact by --between" : "");
}

static tp_status write_all(const char *scene, const char *bytes, size_t length,
                           const tp_trace_options *options, tp_message *message) {
  const char *const read[] = {options->image, options->outline_file};
  const tp_file_sources sources = {options->outline_file != NULL ? 2 : 1, read};
  tp_status status = TP_OK;
  if (options->figure != NULL) {
    status = tp_file_write(options->figure, bytes, length, sources, message);
  }
  if (status == TP_OK && options->scene != NULL) {
    status = tp_file_write(options->scene, scene, strlen(scene), sources, message);
  }
  return status;
}

static tp_status tell(char **report, const tp_trace *trace, const tp_trace_picture *picture,
                      const tp_trace_options *options, tp_message *message) {
  char *scene = NULL, *bytes = NULL, *own = NULL;
  size_t length = 0;
  tp_status status = tp_trace_scene_text(&scene, trace, picture, options);
  if (status == TP_OK) status = check_scene(scene, options, message);
  if (status == TP_OK && options->figure != NULL) {
    status = tp_trace_draw(&bytes, &length, trace, picture, options, message);
  }
  if (status == TP_OK && (options->scene != NULL || options->json)) {
    status = tp_trace_report(&own, trace, options);
  }
  if (status == TP_OK) status = write_all(scene, bytes, length, options, message);
  if (status == TP_OK) {
    *report = own != NULL ? own : scene;
    if (own == NULL) scene = NULL;
    own = NULL;
  }
  free(scene);
  free(bytes);
  free(own);
  return status;
}

static tp_status run(char **report, const tp_trace_options *options, tp_message *message) {
  tp_trace_picture picture;
  tp_trace trace = {.origin = {0, 0}};
  tp_status status = check_rock(options, message);
  if (status != TP_OK) return status;
  status = tp_picture_read(&picture, options->image, message);
  if (status == TP_OK) status = check(options, &picture, message);
  if (status == TP_OK) status = find_outline(&trace, &picture, options, message);
  if (status == TP_OK) status = tell(report, &trace, &picture, options, message);
  tp_trace_ring_clear(&trace.ring);
  free(trace.moves);
  tp_picture_clear(&picture);
  return status;
}

tp_status tp_trace_run(char **report, const char *image, const double *around, size_t corners,
                       const double *outline, size_t clicks, const char *outline_file,
                       const double scale[5], const double *plumb, const double *between,
                       double tolerance, const char *unit, const char *const rock[4],
                       const char *scene, const char *figure, bool json, tp_message *message) {
  TP_GUARD_HOST;
  const tp_trace_rock known = {rock[0], rock[1], rock[2], rock[3]};
  tp_trace_options options = {.image = image,
                              .outline_file = outline_file,
                              .scale = {{scale[0], scale[1]}, {scale[2], scale[3]}},
                              .length = scale[4],
                              .unit = unit,
                              .plumb_given = plumb != NULL,
                              .between_given = between != NULL,
                              .tolerance = tolerance,
                              .rock = &known,
                              .scene = scene,
                              .figure = figure,
                              .json = json};
  for (int k = 0; k < 2; k++) {
    if (plumb != NULL) options.plumb[k] = (tp_trace_point){plumb[2 * k], plumb[2 * k + 1]};
    if (between != NULL) options.between[k] = (tp_trace_point){between[2 * k], between[2 * k + 1]};
  }
  tp_status status = TP_OK;
  for (size_t k = 0; k < corners && status == TP_OK; k++) {
    const tp_trace_point corner = {around[2 * k], around[2 * k + 1]};
    if (!tp_trace_ring_add(&options.rough, corner)) status = tp_fail_memory(message, "an outline");
  }
  for (size_t k = 0; k < clicks && status == TP_OK; k++) {
    const tp_trace_point own = {outline[2 * k], outline[2 * k + 1]};
    if (!tp_trace_ring_add(&options.outline, own)) status = tp_fail_memory(message, "an outline");
  }
  if (status == TP_OK) status = tp_trace_read_clicks(&options, message);
  if (status == TP_OK) status = run(report, &options, message);
  tp_trace_ring_clear(&options.rough);
  tp_trace_ring_clear(&options.outline);
  return status;
}
