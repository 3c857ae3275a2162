/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The traced outline as a scene whose points move with one number along their normals, with the
 * origin in a comment, and as a report in text and JSON (docs/trace.md). */

#include "trace/trace.h"

#include "output/encode.h"
#include "output/json.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BAND = 2 }; /* standard deviations */

/* Decimals of a length: a twentieth of the deviation is seen. */
static int decimals_of(const tp_trace *trace) {
  const double seen = trace->deviation_px * trace->per_pixel / 20;
  return (int)fmax(0, fmin(12, ceil(-log10(seen))));
}

static const char *base_name(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash != NULL ? slash + 1 : path;
}

/* One coordinate: where it is, and how it moves. */
static void add_coordinate(tp_text *text, int decimals, double at, double move) {
  if (fabs(move) < 0.0005) {
    tp_text_add(text, "%.*f", decimals, at);
  } else {
    tp_text_add(text, "%.*f %c %.3f*outline_offset", decimals, at, move < 0 ? '-' : '+',
                fabs(move));
  }
}

static void add_point(tp_text *text, const tp_trace *trace, long k) {
  const int decimals = decimals_of(trace);
  const tp_trace_point d = trace->down, m = trace->moves[k];
  const tp_trace_point at = tp_trace_to_scene(trace, trace->ring.points[k]);
  tp_text_add(text, "[");
  add_coordinate(text, decimals, at.x, m.x * d.y - m.y * d.x);
  tp_text_add(text, ", ");
  add_coordinate(text, decimals, at.y, -(m.x * d.x + m.y * d.y));
  tp_text_add(text, "]");
}

static void add_points(tp_text *text, const tp_trace *trace) {
  for (long k = trace->ring.count - 1; k >= 0; k--) { /* counter-clockwise where y runs up */
    tp_text_add(text, "  - ");
    add_point(text, trace, k);
    tp_text_add(text, "\n");
  }
}

/* The contact: two vertices of the outline, which move with it. */
static void add_base(tp_text *text, const tp_trace *trace, const tp_trace_options *options) {
  tp_text_add(text, "base:\n"
                    "  mated: true               # the counterpart of its underside: NOT "
                    "conservative if there are gaps\n");
  if (!options->between_given) {
    tp_text_add(text, "  # between: [[x, y], [x, y]] # missing: the contact goes on to where "
                      "sides begin, steeper than 45°\n");
    return;
  }
  tp_text_add(text, "  between:                  # where the contact begins and ends\n");
  for (int k = 0; k < 2; k++) {
    tp_text_add(text, "  - ");
    add_point(text, trace, trace->between[k]);
    tp_text_add(text, "\n");
  }
}

/* What is known of the rock, and a comment for what is not: nothing is supposed of it. */
static void add_weight(tp_text *text, const tp_trace_rock *rock) {
  if (rock->unit_weight != NULL) {
    tp_text_add(text, "  unit_weight_kn_m3: %s\n", rock->unit_weight);
  } else {
    tp_text_add(text, "  # unit_weight_kn_m3: 26   # missing: forces and loads need it\n");
  }
  if (rock->thickness != NULL) {
    tp_text_add(text, "  thickness: %s\n", rock->thickness);
  } else {
    tp_text_add(text, "  # thickness: 1            # 1 m where it is not given\n");
  }
}

static void add_friction(tp_text *text, const tp_trace_rock *rock) {
  if (rock->friction != NULL) {
    tp_text_add(text, "friction_angle_deg: %s\n", rock->friction);
  } else {
    tp_text_add(text, "# friction_angle_deg: 30    # missing: sliding is not judged, and no design "
                      "factor is met\n");
  }
}

tp_status tp_trace_rock_text(char **text, const tp_trace_options *options) {
  tp_text own = {0};
  tp_text_add(&own,
              "topple: 1\nlength_unit: %s\nblock:\n"
              "  slab: {width: 1, height: 1}\n",
              options->unit);
  add_weight(&own, options->rock);
  add_friction(&own, options->rock);
  return tp_text_finish(&own, text);
}

/* What the outline can be traced again by: the picture and what was said of it. */
static void add_origin(tp_text *text, const tp_trace_picture *picture,
                       const tp_trace_options *options) {
  tp_text_add(text, "# Traced by topple trace in ");
  tp_encode_plain(text, base_name(options->image));
  tp_text_add(text, ", SHA-256\n# ");
  for (int k = 0; k < TP_SHA256_SIZE; k++) tp_text_add(text, "%02x", picture->hash[k]);
  const bool clicked = options->outline.count > 0;
  const tp_trace_ring *given = clicked ? &options->outline : &options->rough;
  tp_text_add(text, clicked ? "\n# --outline=" : "\n# --around=");
  for (long k = 0; k < given->count; k++) {
    tp_text_add(text, "%s%.10g,%.10g", k == 0 ? "" : ",", given->points[k].x, given->points[k].y);
  }
  const tp_trace_point *s = options->scale, *p = options->plumb, *b = options->between;
  tp_text_add(text, "\n# --scale=%.10g,%.10g,%.10g,%.10g,%.10g --unit=%s", s[0].x, s[0].y, s[1].x,
              s[1].y, options->length, options->unit);
  if (options->plumb_given) {
    tp_text_add(text, " --plumb=%.10g,%.10g,%.10g,%.10g", p[0].x, p[0].y, p[1].x, p[1].y);
  }
  if (options->between_given) {
    tp_text_add(text, " --between=%.10g,%.10g,%.10g,%.10g", b[0].x, b[0].y, b[1].x, b[1].y);
  }
  if (options->tolerance > 0) tp_text_add(text, " --tolerance=%.10g", options->tolerance);
  tp_text_add(text, "\n");
}

/* Does the line miss what was given as an end of the contact by more than its band? */
static bool misses(const tp_trace *trace, const tp_trace_options *options) {
  return options->between_given && trace->missed_px > BAND * trace->deviation_px;
}

tp_status tp_trace_scene_text(char **text, const tp_trace *trace, const tp_trace_picture *picture,
                              const tp_trace_options *options) {
  tp_text own = {0};
  const double deviation = trace->deviation_px * trace->per_pixel;
  char title[600];
  snprintf(title, sizeof title, "Traced in %.500s", base_name(options->image));
  TP_OUTSIDE const char *own_title = options->rock->title;
  add_origin(&own, picture, options);
  tp_text_add(&own, "# x runs to the right and y up, %s.\n",
              options->plumb_given ? "along the plumb line of the picture"
                                   : "as the picture is held: no plumb line was given");
  tp_text_add(&own,
              "# outline_offset moves the outline outwards as a whole; the standard deviation "
              "with which\n# %s is %.3g %s, so that a study that takes it for normal says\n"
              "#   vary: {outline_offset: {normal: {mean: 0, deviation: %.3g}}}\n"
              "# That is no more than the precision in the picture: two hands that draw one block "
              "may\n# differ by much more.\n",
              options->outline.count > 0 ? "a click is exact to its pixel" : "its edge is found",
              deviation, options->unit, deviation);
  if (misses(trace, options)) {
    tp_text_add(
        &own,
        "# Caution: the outline misses an end of the contact that was given by %.1f pixels, "
        "more\n# than its band.\n",
        trace->missed_px);
  }
  tp_text_add(&own, "topple: 1\ntitle: ");
  tp_encode_json(&own, own_title != NULL ? own_title : title);
  tp_text_add(&own,
              "\nlength_unit: %s\nframe: world\nparameters: {outline_offset: 0}\nblock:\n"
              "  outline:\n",
              options->unit);
  add_points(&own, trace);
  add_weight(&own, options->rock);
  add_base(&own, trace, options);
  add_friction(&own, options->rock);
  return tp_text_finish(&own, text);
}

/* What the scene does not say, as no picture shows it. */
static void add_missing(tp_text *text, const tp_trace_options *options) {
  const tp_trace_rock *rock = options->rock;
  if (!options->between_given) {
    tp_text_add(text,
                "Missing  where the contact ends (--between): it is taken to go on to where the\n"
                "         sides begin, steeper than 45°, which may be above the ground\n");
  }
  if (rock->friction == NULL) {
    tp_text_add(text, "Missing  a friction angle (--friction): sliding is not judged without it\n");
  }
  if (rock->unit_weight == NULL) {
    tp_text_add(text, "Missing  a unit weight (--unit-weight): forces and loads need it\n");
  }
}

/* ---- report ------------------------------------------------------------------------------------
 */

static void add_cautions(tp_text *text, const tp_trace *trace, const tp_trace_options *options) {
  const tp_trace_point a = options->scale[0], b = options->scale[1];
  const double bar = hypot(b.x - a.x, b.y - a.y);
  if (!options->plumb_given) {
    tp_text_add(text, "Caution  no plumb line is given: down is taken to be that of the picture\n");
  }
  if (misses(trace, options)) {
    tp_text_add(text,
                "Caution  the outline misses an end of the contact that was given by %.1f pixels,\n"
                "         more than its band of %.1f: where the block stands it was not found;\n"
                "         click its outline by --outline\n",
                trace->missed_px, BAND * trace->deviation_px);
  }
  if (trace->touching > 0.02) {
    tp_text_add(text, "Caution  %.0f %% of the outline lies on the rough polygon: draw it wider\n",
                100 * trace->touching);
  }
  if (trace->runs_px > 2 * trace->edge_px + 1) {
    tp_text_add(
        text, "Caution  a rough polygon a little larger finds another outline: draw it nearer to\n"
              "         the block, as a polygon\n");
  }
  if (trace->weak > 0.2) {
    tp_text_add(text,
                "Caution  along %.0f %% of the outline the colours hardly change: look at the\n"
                "         figure there\n",
                100 * trace->weak);
  }
  if (bar < 0.2 * sqrt(fabs(tp_trace_ring_area(&trace->ring)))) {
    tp_text_add(text,
                "Caution  the scale is short, %.0f pixels: each by which it is off makes all\n"
                "         lengths wrong by %.2g %%\n",
                bar, 100 / bar);
  }
}

/* A number of no proven bound, to as many digits as a picture can tell. */
static void add_number(tp_json *json, const char *key, double value) {
  tp_json_significant(json, key, value, 9);
}

/* In metres, whatever the unit of the scene. */
static tp_status report_json(char **text, const tp_trace *trace, const tp_trace_options *options) {
  const tp_trace_point a = options->scale[0], b = options->scale[1], down = trace->down;
  tp_json json = {0};
  fmpq_t unit;
  fmpq_init(unit);
  const char *name = options->unit;
  const double metres = tp_unit_find(unit, &name) ? fmpq_get_d(unit) : 0;
  fmpq_clear(unit);
  const double scale = trace->per_pixel * metres;
  tp_json_report(&json);
  tp_json_string(&json, "image", options->image);
  tp_json_string(&json, "length_unit", options->unit);
  tp_json_break(&json);
  tp_json_integer(&json, "points", trace->ring.count);
  add_number(&json, "area_m2", fabs(tp_trace_ring_area(&trace->ring)) * scale * scale);
  add_number(&json, "m_per_px", scale);
  add_number(&json, "tolerance_m", trace->tolerance_px * scale);
  tp_json_break(&json);
  add_number(&json, "deviation_m", trace->deviation_px * scale);
  add_number(&json, "deviation_px", trace->deviation_px);
  add_number(&json, "edge_px", trace->edge_px);
  add_number(&json, "runs_px", trace->runs_px);
  tp_json_break(&json);
  add_number(&json, "scale_px", hypot(b.x - a.x, b.y - a.y));
  tp_json_truth(&json, "plumb_given", options->plumb_given);
  add_number(&json, "plumb_deg", atan2(down.x, down.y) * 180 / acos(-1));
  if (options->between_given) {
    add_number(&json, "between_px", trace->between_px);
    add_number(&json, "missed_px", trace->missed_px);
  }
  tp_json_truth(&json, "outline_given", options->outline.count > 0);
  add_number(&json, "weak_share", trace->weak);
  add_number(&json, "touching_share", trace->touching);
  tp_json_close(&json);
  return tp_json_finish(&json, text);
}

/* How well the picture tells the outline, which is not how well it is known. */
static void add_band(tp_text *text, const tp_trace *trace, const tp_trace_options *options) {
  const double share = 200 * trace->deviation_px * tp_trace_ring_length(&trace->ring) /
                       fabs(tp_trace_ring_area(&trace->ring));
  tp_text_add(text, "Band     standard deviation %.3g %s, %.2f pixels: ",
              trace->per_pixel * trace->deviation_px, options->unit, trace->deviation_px);
  if (options->outline.count > 0) {
    tp_text_add(text, "a place within a pixel;\n         two of them are %.2g %% of the area\n",
                share);
  } else {
    tp_text_add(text,
                "%.2f across its edge,\n"
                "         %.2f from one rough polygon to another, 0.29 within a pixel; two of\n"
                "         them are %.2g %% of the area\n",
                trace->edge_px, trace->runs_px, share);
  }
  tp_text_add(text,
              "         It is the precision in the picture alone: where two hands would draw\n"
              "         the block, and what hides it, are not in it\n");
}

tp_status tp_trace_report(char **text, const tp_trace *trace, const tp_trace_options *options) {
  tp_text own = {0};
  const double scale = trace->per_pixel;
  const double area = fabs(tp_trace_ring_area(&trace->ring)) * scale * scale;
  if (options->json) return report_json(text, trace, options);
  tp_text_add(&own, "Outline  %ld points, area %.5g %s², one pixel is %.3g %s\n", trace->ring.count,
              area, options->unit, scale, options->unit);
  add_band(&own, trace, options);
  if (options->between_given) {
    tp_text_add(
        &own, "Contact  ends in vertices of the outline %.1f pixels or less from what was given\n",
        ceil(10 * trace->between_px) / 10);
  }
  add_missing(&own, options);
  add_cautions(&own, trace, options);
  return tp_text_finish(&own, text);
}
