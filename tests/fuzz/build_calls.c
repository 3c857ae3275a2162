/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers are small and whole more often than not, so that points fall on corners and on each
 * other; the rest are fractions, sizes at the ends of what is taken and beyond, and what is none.
 */

#include "build_calls.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>

#define N(k) call->numbers[k]
#define P call->points
#define DEFINE(name, ...)                                                                          \
  static tp_status name(tp_scene *scene, const build_call *call, tp_message *message) {            \
    return tp_scene_##name(scene, __VA_ARGS__, message);                                           \
  }
#define DEFINE_BARE(name)                                                                          \
  static tp_status name(tp_scene *scene, const build_call *call, tp_message *message) {            \
    (void)call;                                                                                    \
    return tp_scene_##name(scene, message);                                                        \
  }

/* A number by its key. */
#define DEFINE_KEY(name, key)                                                                      \
  static tp_status name(tp_scene *scene, const build_call *call, tp_message *message) {            \
    return tp_scene_set_number(scene, key, N(0), message);                                         \
  }

DEFINE(set_outline, P)
DEFINE(set_slab, N(0), N(1))
DEFINE(set_teeth, call->count, N(0), N(1), N(2), (tp_left_end)call->choice)
DEFINE(set_teeth_over, call->count, N(0), N(1), N(2), (tp_left_end)call->choice)
DEFINE(set_ellipse, N(0), N(1), N(2))
DEFINE(add_hole, P)
DEFINE(add_part, P, N(0))
DEFINE(add_arc_through, N(0), N(1), N(2), N(3))
DEFINE(add_arc_bulge, N(0), N(1), N(2))
DEFINE(add_rounded_end, (tp_underside_end)call->choice, N(0))
DEFINE(add_rounded_vertex, N(0), N(1), N(2))
DEFINE(set_rounding_keeps_mass, call->choice != 0)
DEFINE(set_repair, call->choice != 0)
DEFINE(set_thickness, N(0))
DEFINE(set_unit_weight_kn_m3, N(0))
DEFINE(set_base_mated, call->choice != 0)
DEFINE(set_base_profile, P)
DEFINE(set_base_jrc_profile, call->count)
DEFINE(set_base_beyond, N(0), N(1))
DEFINE(set_base_between, P)
DEFINE(set_base_bound, (tp_base_bound)call->choice, N(0))
DEFINE(set_friction_angle_deg, N(0))
DEFINE(set_friction_patton, N(0), N(1))
DEFINE(set_friction_barton, N(0), N(1), N(2))
DEFINE(set_friction_barton_test, N(0), N(1), N(2), N(3))
DEFINE(set_friction_barton_roughness, N(0), N(1), N(2))
DEFINE(add_friction_facets, (size_t)call->count, (size_t)call->count, N(0))
DEFINE(add_friction_between, N(0), N(1), N(2))
DEFINE(set_tilt_towards, (call->choice & 1) != 0, (call->choice & 2) != 0)
DEFINE(set_tilt_angle_deg, N(0))
DEFINE_BARE(set_frame_base)
DEFINE_BARE(set_frame_world)
DEFINE(set_slope, N(0), (tp_direction)call->choice)
DEFINE(set_mean_plane, P)
DEFINE_KEY(set_seismic_horizontal, "loads.seismic.horizontal")
DEFINE_KEY(set_seismic_vertical, "loads.seismic.vertical")
DEFINE(set_water, N(0), N(1), (call->choice & 1) != 0, (call->choice & 2) != 0)
DEFINE(add_pressure, N(0), N(1), N(2), N(3), N(4), N(5))
DEFINE(add_surcharge, N(0), N(1), N(2), N(3), N(4))
DEFINE(add_anchor, N(0), N(1), N(2), N(3), (call->choice & 1) != 0)
DEFINE(add_bolt, N(0), N(1), N(2), N(3), (call->choice & 1) != 0)
DEFINE(add_support_pressure, N(0), N(1), N(2), N(3), N(4), N(5), (call->choice & 1) != 0)
DEFINE_KEY(set_bond_kpa, "loads.bond_kpa")
DEFINE_KEY(set_cohesion_kpa, "loads.cohesion_kpa")

static tp_status set_title(tp_scene *scene, const build_call *call, tp_message *message) {
  static const char *const titles[] = {"Built", "\xff\x1b[1m", NULL, "\"]}"};
  return tp_scene_set_title(scene, titles[call->choice & 3], message);
}

static tp_status set_base_teeth(tp_scene *scene, const build_call *call, tp_message *message) {
  tp_base_teeth_options o = tp_base_teeth_options_default();
  o.count = call->count;
  o.left_end = (tp_left_end)call->choice;
  o.wavelength = N(0);
  o.amplitude = N(1);
  o.skew = N(2);
  o.amplitude_scatter = N(3);
  o.start_x = N(4);
  o.start_y = N(5);
  o.seed = 1;
  return tp_scene_set_base_teeth(scene, &o, message);
}

static tp_status set_base_self_affine(tp_scene *scene, const build_call *call,
                                      tp_message *message) {
  tp_base_self_affine_options o = tp_base_self_affine_options_default();
  o.length = N(0);
  o.step = N(1);
  o.hurst = N(2);
  o.by = (tp_roughness_by)call->choice;
  o.roughness = N(3);
  o.start_x = N(4);
  o.start_y = N(5);
  o.seed = call->count;
  return tp_scene_set_base_self_affine(scene, &o, message);
}

#define BARTON "friction: {law: barton, residual_angle_deg: $0, jcs_mpa: "
static const build_kind kinds[] = {
    {set_title, SLOT_TITLE, "title: of a file", 4, {0}},
    {set_outline, SLOT_SHAPE, "outline: $p", 0, {0}},
    {set_slab, SLOT_SHAPE, "slab: {width: $0, height: $1}", 0, {0}},
    {set_teeth,
     SLOT_SHAPE,
     "teeth: {count: $c, width: $0, height: $1, depth: $2, left_end: $e}",
     2,
     {"valley", "peak"}},
    {set_teeth_over,
     SLOT_SHAPE,
     "teeth: {block_width: $0, mean_height: $1, amplitude: $2, wavelength: 2*($0)/$c, left_end: "
     "$e}",
     2,
     {"valley", "peak"}},
    {set_ellipse, SLOT_SHAPE, "ellipse: {width: $0, height: $1, flat: $2}", 0, {0}},
    {add_hole, SLOT_HOLES, "$p", 0, {0}},
    {add_part, SLOT_PARTS, "{outline: $p, unit_weight_kn_m3: $0}", 0, {0}},
    {add_arc_through, SLOT_ARCS, "{from: [$0, $1], through: [$2, $3]}", 0, {0}},
    {add_arc_bulge, SLOT_ARCS, "{from: [$0, $1], bulge: $2}", 0, {0}},
    {add_rounded_end, SLOT_CORNERS, "{at: $e, radius: $0}", 2, {"left_end", "right_end"}},
    {add_rounded_vertex, SLOT_CORNERS, "{at: [$0, $1], radius: $2}", 0, {0}},
    {set_rounding_keeps_mass, SLOT_MODEL, "model: $e, ", -2, {"exact", "paper"}},
    {set_repair, SLOT_REPAIR, "repair: $y", -2, {0}},
    {set_thickness, SLOT_THICKNESS, "thickness: $0", 0, {0}},
    {set_unit_weight_kn_m3, SLOT_UNIT_WEIGHT, "unit_weight_kn_m3: $0", 0, {0}},
    {set_base_mated, SLOT_BASE, "mated: $e", -2, {"true", "whole"}},
    {set_base_profile, SLOT_BASE, "profile: $p", 0, {0}},
    {set_base_teeth,
     SLOT_BASE,
     "profile: {teeth: {count: $c, wavelength: $0, amplitude: $1, skew: $2, left_end: $e, scatter: "
     "{amplitude: $3}, start: [$4, $5], seed: 1}}",
     2,
     {"valley", "peak"}},
    {set_base_self_affine,
     SLOT_BASE,
     "profile: {self_affine: {length: $0, step: $1, hurst: $2, $e: $3, start: [$4, $5], seed: $c}}",
     3,
     {"rms_height", "z2", "jrc"}},
    {set_base_jrc_profile, SLOT_BASE, "profile: {jrc_profile: $c}", 0, {0}},
    {set_base_beyond, SLOT_BEYOND, "beyond: {left: $0, right: $1}", 0, {0}},
    {set_base_between, SLOT_BETWEEN, "between: $p", 0, {0}},
    {set_base_bound, SLOT_BOUND, "$e: $0", 3, {"below", "left_of", "right_of"}},
    {set_friction_angle_deg, SLOT_FRICTION, "friction_angle_deg: $0", 0, {0}},
    {set_friction_patton,
     SLOT_FRICTION,
     "friction: {law: patton, basic_angle_deg: $0, roughness_angle_deg: $1",
     0,
     {0}},
    {set_friction_barton, SLOT_FRICTION, BARTON "$2, jrc: $1", 0, {0}},
    {set_friction_barton_test,
     SLOT_FRICTION,
     BARTON "$3, tilt_test: {angle_deg: $1, normal_stress_kpa: $2}",
     0,
     {0}},
    {set_friction_barton_roughness, SLOT_FRICTION, BARTON "$2, roughness_angle_deg: $1", 0, {0}},
    {set_tilt_towards, SLOT_TOWARDS, "towards: $e", -4, {"none", "left", "right", "both"}},
    {set_tilt_angle_deg, SLOT_ANGLE, "angle_deg: $0", 0, {0}},
    {set_frame_base, SLOT_FRAME, "frame: base", 0, {0}},
    {set_frame_world, SLOT_FRAME, "frame: world", 0, {0}},
    {set_slope, SLOT_FRAME, "slope: {dip_deg: $0, towards: $e}", -2, {"left", "right"}},
    {set_mean_plane, SLOT_FRAME, "frame: {mean_plane: $p}", 0, {0}},
    {set_seismic_horizontal, SLOT_HORIZONTAL, "horizontal: $0", 0, {0}},
    {set_seismic_vertical, SLOT_VERTICAL, "vertical: $0", 0, {0}},
    {set_water,
     SLOT_WATER,
     "water: {height: $0, unit_weight_kn_m3: $1, stays_level: $y, uplift: $z}",
     -4,
     {0}},
    {add_pressure, SLOT_PRESSURES, "{from: [$0, $1], to: [$2, $3], kpa: [$4, $5]}", 0, {0}},
    {add_surcharge, SLOT_SURCHARGES, "{from: [$0, $1], to: [$2, $3], kpa: $4}", 0, {0}},
    {add_anchor,
     SLOT_ANCHORS,
     "{at: [$0, $1], direction_deg: $2, force_kn: $3, passive: $y}",
     -2,
     {0}},
    {add_bolt, SLOT_ANCHORS, "{at: [$0, $1], dip_deg: $2, force_kn: $3, passive: $y}", -2, {0}},
    {add_support_pressure,
     SLOT_SUPPORTS,
     "{from: [$0, $1], to: [$2, $3], kpa: [$4, $5], passive: $y}",
     -2,
     {0}},
    {set_bond_kpa, SLOT_BOND, "bond_kpa: $0", 0, {0}},
    {set_cohesion_kpa, SLOT_COHESION, "cohesion_kpa: $0", 0, {0}},
    {add_friction_facets, SLOT_FACETS, "{facet: $c, angle_deg: $0}", 0, {0}},
    {add_friction_between, SLOT_FACETS, "{x: [$0, $1], angle_deg: $2}", 0, {0}},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static tp_exact draw_number(fuzz_bytes *b) {
  static const double doubles[] = {0.1,  -1,     NAN,    INFINITY, 1e308, 1e-308, 0x1p-1074,
                                   -0.0, 1. / 3, -1e300, 1e12,     1e-12, 89.5,   45,
                                   30,   90,     100,    0.5,      -2.5,  1e9};
  static const char *const texts[] = {"1/3",        "-2/7",
                                      "0.1",        "1e300",
                                      "1e-300",     "",
                                      "x",          "1,5",
                                      "1/0",        "1e400",
                                      "100/3",      " 1",
                                      "0x4",        "1e",
                                      "-.5",        "+2",
                                      "2.",         "1/3/3",
                                      NULL,         "-0",
                                      "3.0e+0/4.5", "12345678901234567890123456789"};
  enum { DOUBLES = sizeof doubles / sizeof doubles[0], TEXTS = sizeof texts / sizeof texts[0] };
  const unsigned drawn = fuzz_pick(b, 256);
  if (drawn < 256 - DOUBLES - TEXTS) return tp_exact_of(drawn % 10);
  if (drawn < 256 - TEXTS) return tp_exact_of(doubles[drawn + DOUBLES + TEXTS - 256]);
  return tp_exact_text(texts[drawn + TEXTS - 256]);
}

/* A simple outline: a chain below from left to right, and back above it. */
static size_t draw_columns(double *xy, fuzz_bytes *b) {
  const unsigned below = 2 + fuzz_pick(b, 3);
  for (unsigned k = 0; k < 2 * below; k++) {
    const unsigned column = k < below ? k : 2 * below - 1 - k;
    xy[2 * k] = 2 * column;
    xy[2 * k + 1] = k < below ? fuzz_pick(b, 4) : 5 + fuzz_pick(b, 5);
  }
  return 2 * below;
}

static void draw_points(build_call *call, fuzz_bytes *b) {
  const unsigned form = fuzz_pick(b, 16);
  const size_t count = form < 6 ? 0 : form < 9 ? 2 : fuzz_pick(b, BUILD_POINTS + 1);
  for (size_t k = 0; k < 2 * count; k++) {
    const tp_exact drawn = draw_number(b);
    call->xy[k] = drawn.value;
    call->texts[k] = drawn.text != NULL ? drawn.text : "4";
  }
  if (form < 6) {
    call->points = tp_coordinates_of(call->xy, draw_columns(call->xy, b));
  } else if (form == 15) {
    call->points = tp_coordinates_of(NULL, count);
  } else if (form == 14) {
    call->points = tp_coordinates_text(call->texts, fuzz_pick(b, 2) != 0 ? SIZE_MAX : 200000000);
  } else if (form >= 12) {
    call->points = tp_coordinates_text(call->texts, count);
  } else {
    call->points = tp_coordinates_of(call->xy, count);
  }
}

void build_draw(build_call *call, fuzz_bytes *b) {
  static const long counts[] = {0, -1, LONG_MAX, LONG_MIN, 20000000};
  enum { HOSTILE = sizeof counts / sizeof counts[0] };
  *call = (build_call){.kind = kinds + fuzz_pick(b, KINDS)};
  for (int k = 0; k < BUILD_NUMBERS; k++) call->numbers[k] = draw_number(b);
  const unsigned count = fuzz_pick(b, 64);
  call->count = count < HOSTILE ? counts[count] : count % 12 + 1;
  const int choices = call->kind->choices;
  const unsigned choice = fuzz_pick(b, 64);
  call->choice = choices == 0 ? 0 : (int)choice % (choices < 0 ? -choices : choices);
  if (choices > 0 && choice == 63) call->choice = -1;
  if (choices > 0 && choice == 62) call->choice = choices;
  draw_points(call, b);
}

void build_draw_first(build_call calls[BUILD_FIRST], fuzz_bytes *b) {
  for (int k = 0; k < KINDS; k++) {
    if (kinds[k].run == set_outline) calls[0] = (build_call){.kind = kinds + k};
    if (kinds[k].run == set_unit_weight_kn_m3) calls[1] = (build_call){.kind = kinds + k};
  }
  calls[0].points = tp_coordinates_of(calls[0].xy, draw_columns(calls[0].xy, b));
  calls[1].numbers[0] = tp_exact_of(25);
}
