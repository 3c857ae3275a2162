/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A section of a solid as a scene of a block: written, read again without its base to know its
 * lowest point, and with it solved, for a head that says how far the section is off. */

#include "common/host.h"
#include "common/message.h"
#include "evaluation/case_numbers.h"
#include "number/shortest.h"
#include "output/encode.h"
#include "report/results.h"
#include "report/section_above.h"
#include "scene/scene.h"
#include "solid/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct section {
  const tp_solid *solid;
  const tp_solid_band *band;
  double azimuth_deg;
  const char *length_unit; /* of the mesh */
  bool y_is_up;
  tp_section_above above; /* of a rock that a plane cuts */
  tp_message *message;
} section;

static tp_status refuse(const section *x, const char *why) {
  return tp_refuse(x->message, TP_FAULT_KEY, (tp_place){x->solid->file, 0, 0}, "%s", why);
}

static bool find_unit(section *x) {
  static const char *const names[] = {"mm", "cm", "m", "km", "in", "ft"};
  fmpq_t metres;
  fmpq_init(metres);
  for (size_t k = 0; k < sizeof names / sizeof names[0] && x->length_unit == NULL; k++) {
    const char *name = names[k];
    if (tp_unit_find(metres, &name) && tp_surface_nearest(metres) == x->solid->metres_per_unit) {
      x->length_unit = name;
    }
  }
  fmpq_clear(metres);
  return x->length_unit != NULL;
}

static tp_status check(section *x) {
  const double *up = x->solid->up;
  const bool z_is_up = up[0] == 0 && up[1] == 0 && up[2] > 0;
  x->y_is_up = up[0] == 0 && up[2] == 0 && up[1] > 0;
  if (!isfinite(x->azimuth_deg) || fabs(x->azimuth_deg) > 360) {
    return refuse(x, "the azimuth of a section lies between -360 and 360");
  }
  if (x->solid->band_count == 0) {
    return refuse(x, "a section stands on a plane, and this rock does not");
  }
  if (x->solid->part_count > 0) {
    return refuse(x, "a section has no holes or parts of a solid; leave them out");
  }
  if (x->solid->is_on_slope || !(z_is_up || x->y_is_up)) {
    return refuse(x, "a section is cut upright, of a mesh that has z or y upwards as it lies");
  }
  return find_unit(x) ? TP_OK
                      : refuse(x, "a section is cut of a mesh whose lengths are in mm, cm, m, km, "
                                  "in or ft, and not by a scale");
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

/* In lengths of the mesh, on the map: of a mesh with y upwards that is x and -z. */
static void add_point(tp_text *t, const section *x) {
  char n[2][TP_SHORTEST_SIZE];
  const tp_bounded *c = x->solid->centroid_m;
  const double east = c[0].value / x->solid->metres_per_unit;
  const double north = (x->y_is_up ? 0 - c[2].value : c[1].value) / x->solid->metres_per_unit;
  tp_text_add(t, "[%s, %s]", tp_shortest(n[0], east), tp_shortest(n[1], north));
}

/* The outline itself, where a plane cuts the rock. */
static void add_above(tp_text *t, const section *x) {
  char n[2][TP_SHORTEST_SIZE];
  tp_text_add(t, "topple: 1\nlength_unit: %s\nblock:\n  outline:\n", x->length_unit);
  for (long k = 0; k < x->above.count; k++) {
    tp_text_add(t, "    - [%s, %s]\n", tp_shortest(n[0], x->above.x[k]),
                tp_shortest(n[1], x->above.y[k]));
  }
}

/* The line of the cut, from the first corner on it to the last: what touches may be several pieces.
 */
static void add_level(tp_text *t, const section *x) {
  const tp_section_above *own = &x->above;
  const double level = own->y[0];
  double left = own->x[0], right = left;
  char n[3][TP_SHORTEST_SIZE];
  for (long k = 1; k < own->count; k++) {
    if (own->y[k] != level) continue;
    left = fmin(left, own->x[k]);
    right = fmax(right, own->x[k]);
  }
  tp_shortest(n[0], left);
  tp_shortest(n[1], right);
  tp_shortest(n[2], level);
  tp_text_add(t, "base: {profile: [[%s, %s], [%s, %s]]}\n", n[0], n[2], n[1], n[2]);
}

static void add_mesh(tp_text *t, const section *x) {
  char n[TP_SHORTEST_SIZE];
  tp_text_add(t, "topple: 1\nlength_unit: %s\nsection: {at: ", x->length_unit);
  add_point(t, x);
  tp_text_add(t, ", azimuth_deg: %s", tp_shortest(n, x->azimuth_deg));
  tp_text_add(t, "%s}\nblock:\n  outline:\n    mesh: ", x->y_is_up ? ", up: y" : "");
  tp_encode_json(t, x->solid->file);
  tp_text_add(t, "\n    unit: %s\n    take: largest\n", x->length_unit);
  if (x->solid->object != NULL) {
    tp_text_add(t, "    object: ");
    tp_encode_json(t, x->solid->object);
    tp_text_add(t, "\n");
  }
}

static void add_scene(tp_text *t, const section *x, const double *below) {
  char n[TP_SHORTEST_SIZE];
  if (x->above.count > 0) {
    add_above(t, x);
  } else {
    add_mesh(t, x);
  }
  if (x->above.count > 0) {
    add_level(t, x);
  } else if (below != NULL) {
    tp_text_add(t, "base: {mated: true, between: {below: %s}, beyond: {left: 0, right: 0}}\n",
                tp_shortest(n, *below));
  }
  if (x->solid->has_friction) {
    tp_text_add(t, "friction_angle_deg: %s\n", tp_shortest(n, x->solid->friction_angle_deg));
  }
}

static tp_status read_scene(tp_scene **scene, const section *x, const double *below) {
  tp_text t = {0};
  char *text = NULL;
  add_scene(&t, x, below);
  tp_status status = tp_text_finish(&t, &text);
  if (status == TP_OK) status = tp_scene_read_text(scene, text, "section.yaml", x->message);
  free(text);
  return status;
}

/* At the height of the plane, below the centroid of what it cuts off. */
static tp_status cut_section(double *below, section *x, const tp_polyline *outline) {
  const tp_bounded *centroid = x->solid->centroid_m + (x->y_is_up ? 1 : 2);
  *below = (centroid->value - x->band->height_m.value) / x->solid->metres_per_unit;
  if (!tp_section_above_init(&x->above, outline, *below)) {
    return tp_fail_memory(x->message, "the section of a solid");
  }
  return x->above.count > 2 ? TP_OK
                            : refuse(x, "the plane that cuts the rock leaves nothing of this "
                                        "section: cut it at another azimuth");
}

/* As high over the lowest point of the section as the band, a hair more for its rounding. */
static tp_status find_below(double *below, section *x) {
  static const double hair = 1e-9;
  tp_scene *scene = NULL;
  const tp_status status = read_scene(&scene, x, NULL);
  if (status != TP_OK) return status;
  const tp_polyline *outline = &scene->block.outline;
  const fmpq *lowest = outline->y, *highest = outline->y;
  for (long k = 1; k < outline->count; k++) {
    if (fmpq_cmp(outline->y + k, lowest) < 0) lowest = outline->y + k;
    if (fmpq_cmp(outline->y + k, highest) > 0) highest = outline->y + k;
  }
  const double low = fmpq_get_d(lowest), tall = fmpq_get_d(highest) - low;
  if (x->solid->has_below) {
    const tp_status cut = cut_section(below, x, outline);
    tp_scene_free(scene);
    return cut;
  }
  fmpq_t metres;
  const char *unit = x->solid->length_unit;
  fmpq_init(metres);
  const double own = tp_unit_find(metres, &unit) ? fmpq_get_d(metres) : 1;
  fmpq_clear(metres);
  *below = low + x->band->band * own / x->solid->metres_per_unit + hair * tall;
  tp_scene_free(scene);
  return TP_OK;
}

/* ---- how far it is off -------------------------------------------------------------------------
 */

/* The tilt at which the solid topples towards an azimuth, in degrees. */
static double solid_deg(const section *x, double azimuth_deg) {
  static const double radian = 3.14159265358979323846 / 180;
  const tp_solid_band *band = x->band;
  const double east = sin(radian * azimuth_deg), north = cos(radian * azimuth_deg);
  double most = 0;
  for (size_t k = 0; k < band->corner_count; k++) {
    const tp_solid_corner *p = band->support + k;
    const tp_solid_corner *q = band->support + (k + 1) % band->corner_count;
    const double n[2] = {q->north_m - p->north_m, p->east_m - q->east_m};
    const double arm = n[0] * p->east_m + n[1] * p->north_m;
    if (arm > 0) most = fmax(most, (n[0] * east + n[1] * north) / arm);
  }
  return band->stands && most > 0 ? atan2(1, band->height_m.value * most) / radian : NAN;
}

static void add_side(tp_text *t, const section *x, const tp_case *own) {
  static const double least = 5e-4; /* of what is printed */
  const bool right = own->towards == TP_TOWARDS_RIGHT;
  const double azimuth = fmod(x->azimuth_deg + (right ? 360 : 540), 360);
  const double solid = solid_deg(x, azimuth);
  tp_bounded number;
  const bool topples = tp_case_moments_deg(&number, own) == TP_CASE_NUMBER;
  tp_text_add(t, "# Towards %.6g°, to the %s, ", azimuth, right ? "right" : "left");
  if (topples) {
    tp_text_add(t, "the section topples at %.3f°", number.value);
  } else {
    tp_text_add(t, "the section topples at no tilt");
  }
  if (isnan(solid)) {
    tp_text_add(t, "; the rock does not stand.\n");
    return;
  }
  tp_text_add(t, ", the rock at %.3f°", solid);
  const double more = topples ? number.value - solid : 0;
  if (fabs(more) >= least) {
    tp_text_add(t, ": the section is %s by %.3f°", more > 0 ? "unsafe" : "safe", fabs(more));
  }
  tp_text_add(t, ".\n");
}

static tp_status add_head(tp_text *t, const section *x, double below) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = read_scene(&scene, x, &below);
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, x->message);
  if (status == TP_OK) {
    tp_text_add(
        t,
        x->solid->has_below
            ? "# A section of a solid through its centroid at the azimuth %.6g°, made by topple "
              "solid --section.\n# A plane %.6g %s over its lowest point cuts the solid; this is "
              "what lies above.\n"
            : "# A section of a solid through its centroid at the azimuth %.6g°, made by topple "
              "solid --section.\n# What lies no higher than %.6g %s over its lowest point touches "
              "the base.\n",
        x->azimuth_deg, x->band->band, x->solid->length_unit);
    for (size_t k = 0; k < solution->case_count; k++) add_side(t, x, solution->cases + k);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
  if (status != TP_BAD_INPUT && status != TP_NO_ANSWER) return status;
  return refuse(x,
                "within the band nothing of this section touches but a point: give a larger band");
}

tp_status tp_report_solid_section(char **text, const tp_solid *solid, double azimuth_deg,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, solid);
  section x = {.solid = solid,
               .band = tp_solid_band_that_governs(solid),
               .azimuth_deg = azimuth_deg,
               .message = message};
  tp_text t = {0};
  double below = 0;
  tp_status status = check(&x);
  if (status == TP_OK) status = find_below(&below, &x);
  if (status == TP_OK) status = add_head(&t, &x, below);
  if (status == TP_OK) add_scene(&t, &x, &below);
  tp_section_above_clear(&x.above);
  if (status != TP_OK) {
    tp_text_drop(&t);
    return status;
  }
  return tp_text_finish(&t, text);
}
