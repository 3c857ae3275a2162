/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "keyed_scenes.h"

static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
#define TEXT_SQUARE "block: {outline: [[0, 0], [4, 0], [4, 6], [0, 6]], unit_weight_kn_m3: 25}\n"

static void set_square(tp_scene *scene) {
  DO(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
}

static void build_rings(tp_scene *scene, const double *n) {
  DO(tp_scene_set_outline(scene, tp_coordinates_of(n, 4), &message));
  DO(tp_scene_add_hole(scene, tp_coordinates_of(n + 8, 3), &message));
  DO(tp_scene_add_part(scene, tp_coordinates_of(n + 14, 3), E(n[20]), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(n[21]), &message));
  DO(tp_scene_set_thickness(scene, E(n[22]), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(n[23]), &message));
  DO(tp_scene_set_base_beyond(scene, E(n[24]), E(n[25]), &message));
}

static void build_slab(tp_scene *scene, const double *n) {
  DO(tp_scene_set_slab(scene, E(n[0]), E(n[1]), &message));
  DO(tp_scene_set_tilt_angle_deg(scene, E(n[2]), &message));
  DO(tp_scene_set_number(scene, "required_fos", E(n[3]), &message));
}

static void build_teeth(tp_scene *scene, const double *n) {
  DO(tp_scene_set_teeth(scene, (long)n[0], E(n[1]), E(n[2]), E(n[3]), TP_LEFT_END_VALLEY,
                        &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
}

static void build_teeth_over(tp_scene *scene, const double *n) {
  DO(tp_scene_set_teeth_over(scene, (long)n[0], E(n[1]), E(n[2]), E(n[3]), TP_LEFT_END_PEAK,
                             &message));
}

static void build_ellipse(tp_scene *scene, const double *n) {
  DO(tp_scene_set_ellipse(scene, E(n[0]), E(n[1]), E(n[2]), &message));
}

static void build_arcs(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_add_arc_through(scene, E(n[0]), E(n[1]), E(n[2]), E(n[3]), &message));
  DO(tp_scene_add_arc_bulge(scene, E(0), E(6), E(n[4]), &message));
}

static void build_chords(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_add_arc_bulge(scene, E(0), E(6), E(0.25), &message));
  DO(tp_scene_set_number(scene, "block.arc_tolerance", E(n[0]), &message));
}

static void build_corners(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(n[0]), &message));
  DO(tp_scene_add_rounded_vertex(scene, E(n[1]), E(n[2]), E(n[3]), &message));
}

static void build_loads(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_number(scene, "loads.seismic.horizontal", E(n[0]), &message));
  DO(tp_scene_set_number(scene, "loads.seismic.vertical", E(n[1]), &message));
  DO(tp_scene_set_water(scene, E(n[2]), E(n[3]), false, true, &message));
  DO(tp_scene_add_pressure(scene, E(n[4]), E(n[5]), E(n[6]), E(n[7]), E(n[8]), E(n[9]), &message));
  DO(tp_scene_add_surcharge(scene, E(n[10]), E(n[11]), E(n[12]), E(n[13]), E(n[14]), &message));
  DO(tp_scene_add_anchor(scene, E(n[15]), E(n[16]), E(n[17]), E(n[18]), false, &message));
  DO(tp_scene_set_number(scene, "loads.bond_kpa", E(n[19]), &message));
  DO(tp_scene_set_number(scene, "loads.cohesion_kpa", E(n[20]), &message));
}

static void build_level(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_water_level(scene, E(n[0]), E(n[1]), TP_WATER_ON_BOTH, TP_WATER_UPLIFT_FULL,
                              &message));
  DO(tp_scene_set_tension_crack_level(scene, E(n[2]), &message));
  DO(tp_scene_set_ice(scene, E(n[3]), E(n[4]), &message));
}

static void build_surface(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_water_surface(scene, tp_coordinates_of(n, 2), E(10), TP_WATER_ON_BOTH,
                                TP_WATER_UPLIFT_TRIANGULAR, &message));
  DO(tp_scene_set_tension_crack_height(scene, E(n[4]), E(n[5]), &message));
}

static void build_support(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_add_bolt(scene, E(n[0]), E(n[1]), E(n[2]), E(n[3]), true, &message));
  DO(tp_scene_set_bolt_capacity_kn(scene, 1, E(n[4]), &message));
  DO(tp_scene_set_bolt_length(scene, 1, E(n[5]), &message));
  DO(tp_scene_set_bolt_spacing(scene, 1, E(n[6]), &message));
  DO(tp_scene_set_bolt_rows(scene, 1, (long)n[7], E(n[8]), E(n[9]), &message));
  DO(tp_scene_add_support_pressure(scene, E(n[10]), E(n[11]), E(n[12]), E(n[13]), E(n[14]),
                                   E(n[15]), true, &message));
}

static void build_profile(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(n, 2), &message));
  DO(tp_scene_set_number(scene, "contact.within", E(n[7]), &message));
  DO(tp_scene_set_number(scene, "contact.width", E(n[8]), &message));
  DO(tp_scene_set_friction_barton(scene, E(n[4]), E(n[5]), E(n[6]), &message));
}

static void build_between(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_base_between(scene, tp_coordinates_of(n, 2), &message));
  DO(tp_scene_set_friction_patton(scene, E(n[4]), E(n[5]), &message));
}

static void build_joint(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_number(scene, "joint.shift", E(n[0]), &message));
  DO(tp_scene_set_number(scene, "joint.closure", E(n[1]), &message));
}

static void build_matching(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_joint_matching(scene, E(n[0]), true, &message));
  DO(tp_scene_set_number(scene, "joint.closure", E(n[1]), &message));
}

static void build_bounds(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_base_bound(scene, TP_BASE_BELOW, E(n[0]), &message));
  DO(tp_scene_set_base_bound(scene, TP_BASE_LEFT_OF, E(n[1]), &message));
  DO(tp_scene_set_base_bound(scene, TP_BASE_RIGHT_OF, E(n[2]), &message));
  DO(tp_scene_set_friction_barton_test(scene, E(n[3]), E(n[4]), E(n[5]), E(n[6]), &message));
}

static void build_slope(tp_scene *scene, const double *n) {
  static const double slope[] = {0, 0, 4, 1, 3, 5, -1, 4};
  DO(tp_scene_set_outline(scene, tp_coordinates_of(slope, 4), &message));
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_set_mean_plane(scene, tp_coordinates_of(n, 2), &message));
  DO(tp_scene_set_friction_barton_roughness(scene, E(n[4]), E(n[5]), E(n[6]), &message));
}

static void build_dip(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_slope(scene, E(n[0]), TP_TOWARDS_RIGHT, &message));
  DO(tp_scene_set_number(scene, "slope.dip_direction_deg", E(n[1]), &message));
}

static void build_facets(tp_scene *scene, const double *n) {
  static const double feet[] = {0, 0, 1, 0, 2, 0, 4, 0, 4, 6, 0, 6};
  DO(tp_scene_set_outline(scene, tp_coordinates_of(feet, 6), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(n[0]), &message));
  DO(tp_scene_add_friction_facets(scene, 3, 3, E(n[1]), &message));
  DO(tp_scene_add_friction_between(scene, E(n[2]), E(n[3]), E(n[4]), &message));
}

#define HEAD "topple: 1\nlength_unit: m\n"

enum {
  RINGS,
  SLAB,
  TEETH,
  TEETH_OVER,
  ELLIPSE,
  ARCS,
  CHORDS,
  CORNERS,
  LOADS,
  LEVEL,
  SURFACE,
  SUPPORT,
  PROFILE,
  BETWEEN,
  JOINT,
  MATCHING,
  BOUNDS,
  SLOPE,
  DIP,
  FACETS
};

static const keyed_scene kinds[] = {
    [RINGS] = {build_rings,
               HEAD "block:\n  outline: [[@a, @b], [@c, @d], [@e, @f], [@g, @h]]\n"
                    "  holes: [[[@i, @j], [@k, @l], [@m, @n]]]\n"
                    "  parts: [{outline: [[@o, @p], [@q, @r], [@s, @t]], unit_weight_kn_m3: @u}]\n"
                    "  unit_weight_kn_m3: @v\n  thickness: @w\nfriction_angle_deg: @x\n"
                    "base: {beyond: {left: @y, right: @z}}\n",
               {0, 0,   4,   0,   4,   6,   0, 6,  1,    4, 2,    4, 2,
                5, 2.5, 0.5, 3.5, 0.5, 3.5, 5, 20, 25.5, 2, 31.5, 1, 2}},
    [SLAB] = {build_slab,
              HEAD
              "block: {slab: {width: @a, height: @b}}\ntilt: {angle_deg: @c}\nrequired_fos: @d\n",
              {1, 3, 10, 1.5}},
    [TEETH] = {build_teeth,
               HEAD "friction_angle_deg: 30\nblock:\n  teeth: {count: @a, width: @b, height: @c, "
                    "depth: @d, left_end: valley}\n",
               {3, 1, 4, 0.25}},
    [TEETH_OVER] = {build_teeth_over, NULL, {4, 3, 7, 0.5}},
    [ELLIPSE] = {build_ellipse,
                 HEAD "block: {ellipse: {width: @a, height: @b, flat: @c}}\n",
                 {8, 3, 0.5}},
    [ARCS] = {build_arcs,
              HEAD "block:\n  outline: [[0, 0], [4, 0], [4, 6], [0, 6]]\n  unit_weight_kn_m3: 25\n"
                   "  arcs: [{from: [@a, @b], through: [@c, @d]}, {from: [0, 6], bulge: @e}]\n",
              {4, 6, 2, 7, -0.25}},
    [CHORDS] = {build_chords,
                HEAD "block:\n  outline: [[0, 0], [4, 0], [4, 6], [0, 6]]\n"
                     "  unit_weight_kn_m3: 25\n  arcs: [{from: [0, 6], bulge: 0.25}]\n"
                     "  arc_tolerance: @a\n",
                {0.125}},
    [CORNERS] = {build_corners,
                 HEAD "block:\n  outline: [[0, 0], [4, 0], [4, 6], [0, 6]]\n"
                      "  unit_weight_kn_m3: 25\n  rounded: {corners: [{at: left_end, radius: @a}, "
                      "{at: [@b, @c], radius: @d}]}\n",
                 {0.5, 4, 6, 1}},
    [LOADS] = {build_loads,
               HEAD TEXT_SQUARE
               "friction_angle_deg: 30\nloads:\n  seismic: {horizontal: @a, vertical: @b}\n"
               "  water: {height: @c, unit_weight_kn_m3: @d, uplift: true}\n"
               "  pressures: [{from: [@e, @f], to: [@g, @h], kpa: [@i, @j]}]\n"
               "  surcharges: [{from: [@k, @l], to: [@m, @n], kpa: @o}]\n"
               "  anchors: [{at: [@p, @q], direction_deg: @r, force_kn: @s}]\n"
               "  bond_kpa: @t\n  cohesion_kpa: @u\n",
               {0.0625, 0.125, 1, 9.75, 4, 1, 4, 5, 2, 3, 3, 6, 1, 6, 5, 0, 3, 200, 30, 2, 8}},
    [LEVEL] = {build_level,
               HEAD TEXT_SQUARE
               "friction_angle_deg: 30\nloads:\n  water: {level: @a, unit_weight_kn_m3: @b, faces: "
               "both, uplift: full, tension_crack: {level: @c}, ice_kpa: @d, ice_thickness: @e}\n",
               {1, 9.75, 3, 40, 0.5}},
    [SURFACE] = {build_surface,
                 HEAD TEXT_SQUARE
                 "friction_angle_deg: 30\nloads:\n  water: {surface: [[@a, @b], [@c, @d]], "
                 "unit_weight_kn_m3: 10, faces: both, uplift: triangular, tension_crack: {height: "
                 "@e, distance: @f}}\n",
                 {-1, 1, 6, 2, 3, 0.5}},
    [SUPPORT] =
        {build_support,
         HEAD TEXT_SQUARE
         "friction_angle_deg: 30\nloads:\n"
         "  anchors: [{at: [@a, @b], dip_deg: @c, force_kn: @d, capacity_kn: @e, length: @f, "
         "spacing: @g, rows: @h, row_step: [@i, @j], passive: true}]\n"
         "  support_pressures: [{from: [@k, @l], to: [@m, @n], kpa: [@o, @p]}]\n",
         {0, 5, 10, 50, 90, 7, 1.5, 2, 0.25, -1, 0, 4, 0, 1, 3, 2}},
    [PROFILE] = {build_profile,
                 HEAD TEXT_SQUARE
                 "base: {profile: [[@a, @b], [@c, @d]]}\ncontact: {within: @h, width: @i}\n"
                 "friction: {law: barton, residual_angle_deg: @e, jrc: @f, "
                 "jcs_mpa: @g}\n",
                 {-1, 0, 5, 0, 28, 8, 60, 0.25, 2}},
    [BETWEEN] = {build_between,
                 HEAD TEXT_SQUARE "base: {between: [[@a, @b], [@c, @d]]}\nfriction: {law: patton, "
                                  "basic_angle_deg: @e, roughness_angle_deg: @f}\n",
                 {0, 0, 4, 0, 25, 10}},
    [JOINT] = {build_joint, HEAD TEXT_SQUARE "joint: {shift: @a, closure: @b}\n", {0.5, 0.25}},
    [MATCHING] = {build_matching,
                  HEAD TEXT_SQUARE "joint: {matching: @a, closure: @b, towards: left}\n",
                  {0.75, 0.5}},
    [BOUNDS] = {build_bounds,
                HEAD TEXT_SQUARE
                "base: {between: {below: @a, left_of: @b, right_of: @c}}\nfriction: {law: barton, "
                "residual_angle_deg: @d, tilt_test: {angle_deg: @e, normal_stress_kpa: @f}, "
                "jcs_mpa: @g}\n",
                {1, 5, -1, 28, 50, 2.5, 60}},
    [SLOPE] = {build_slope,
               HEAD "block: {outline: [[0, 0], [4, 1], [3, 5], [-1, 4]], unit_weight_kn_m3: 25}\n"
                    "frame: {mean_plane: [[@a, @b], [@c, @d]]}\nfriction: {law: barton, "
                    "residual_angle_deg: @e, roughness_angle_deg: @f, jcs_mpa: @g}\n",
               {0, 0, 4, 1, 28, 10, 60}},
    [DIP] = {build_dip,
             HEAD TEXT_SQUARE "friction_angle_deg: 30\nslope: {dip_deg: @a, towards: right, "
                              "dip_direction_deg: @b}\n",
             {12.5, 135}},
    [FACETS] = {build_facets,
                HEAD "block: {outline: [[0, 0], [1, 0], [2, 0], [4, 0], [4, 6], [0, 6]]}\n"
                     "friction_angle_deg: @a\nfriction: {facets: [{facet: 3, angle_deg: @b}, "
                     "{x: [@c, @d], angle_deg: @e}]}\n",
                {30, 20, 0, 2, 25}},
};

const keyed_row keyed_rows[KEYED_ROWS] = {
    {kinds + RINGS, "block.outline.3.1", 'e', 3.75},
    {kinds + RINGS, "block.outline.4.2", 'h', 5.5},
    {kinds + RINGS, "block.holes.1.2.1", 'k', 2.25},
    {kinds + RINGS, "block.holes.1.3.2", 'n', 4.75},
    {kinds + RINGS, "block.parts.1.outline.1.1", 'o', 2.25},
    {kinds + RINGS, "block.parts.1.outline.3.2", 't', 3},
    {kinds + RINGS, "block.parts.1.unit_weight_kn_m3", 'u', 30},
    {kinds + RINGS, "block.unit_weight_kn_m3", 'v', 22},
    {kinds + RINGS, "block.thickness", 'w', 1.5},
    {kinds + RINGS, "friction_angle_deg", 'x', 20},
    {kinds + RINGS, "base.beyond.left", 'y', 0},
    {kinds + RINGS, "base.beyond.right", 'z', 0},
    {kinds + SLAB, "block.slab.width", 'a', 2},
    {kinds + SLAB, "block.slab.height", 'b', 2.5},
    {kinds + SLAB, "tilt.angle_deg", 'c', 12.5},
    {kinds + SLAB, "required_fos", 'd', 1.25},
    {kinds + TEETH, "block.teeth.count", 'a', 5},
    {kinds + TEETH, "block.teeth.width", 'b', 1.25},
    {kinds + TEETH, "block.teeth.height", 'c', 5},
    {kinds + TEETH, "block.teeth.depth", 'd', 0.375},
    {kinds + TEETH_OVER, "block.teeth.count", 'a', 5},
    {kinds + TEETH_OVER, "block.teeth.block_width", 'b', 4},
    {kinds + TEETH_OVER, "block.teeth.mean_height", 'c', 6},
    {kinds + TEETH_OVER, "block.teeth.amplitude", 'd', 0.25},
    {kinds + ELLIPSE, "block.ellipse.width", 'a', 7},
    {kinds + ELLIPSE, "block.ellipse.height", 'b', 4},
    {kinds + ELLIPSE, "block.ellipse.flat", 'c', 1},
    {kinds + ARCS, "block.arcs.1.from.1", 'a', 3},
    {kinds + ARCS, "block.arcs.1.from.2", 'b', 5},
    {kinds + ARCS, "block.arcs.1.through.1", 'c', 1.5},
    {kinds + ARCS, "block.arcs.1.through.2", 'd', 7.5},
    {kinds + ARCS, "block.arcs.2.bulge", 'e', -0.125},
    {kinds + CHORDS, "block.arc_tolerance", 'a', 0.0625},
    {kinds + CORNERS, "block.rounded.corners.1.radius", 'a', 0.75},
    {kinds + CORNERS, "block.rounded.corners.2.radius", 'd', 0.5},
    {kinds + CORNERS, "block.rounded.corners.2.at.1", 'b', 0},
    {kinds + CORNERS, "block.rounded.corners.2.at.2", 'c', 5},
    {kinds + LOADS, "loads.seismic.horizontal", 'a', 0.125},
    {kinds + LOADS, "loads.seismic.vertical", 'b', -0.125},
    {kinds + LOADS, "loads.water.height", 'c', 2},
    {kinds + LOADS, "loads.water.unit_weight_kn_m3", 'd', 10},
    {kinds + LOADS, "loads.pressures.1.from.1", 'e', 4.5},
    {kinds + LOADS, "loads.pressures.1.from.2", 'f', 2},
    {kinds + LOADS, "loads.pressures.1.to.1", 'g', 3.5},
    {kinds + LOADS, "loads.pressures.1.to.2", 'h', 4},
    {kinds + LOADS, "loads.pressures.1.kpa.1", 'i', 4},
    {kinds + LOADS, "loads.pressures.1.kpa.2", 'j', 1},
    {kinds + LOADS, "loads.surcharges.1.from.1", 'k', 3.5},
    {kinds + LOADS, "loads.surcharges.1.from.2", 'l', 5},
    {kinds + LOADS, "loads.surcharges.1.to.1", 'm', 2},
    {kinds + LOADS, "loads.surcharges.1.to.2", 'n', 5},
    {kinds + LOADS, "loads.surcharges.1.kpa", 'o', 7},
    {kinds + LOADS, "loads.anchors.1.at.1", 'p', 0.5},
    {kinds + LOADS, "loads.anchors.1.at.2", 'q', 2},
    {kinds + LOADS, "loads.anchors.1.direction_deg", 'r', 210},
    {kinds + LOADS, "loads.anchors.1.force_kn", 's', 40},
    {kinds + LOADS, "loads.bond_kpa", 't', 1},
    {kinds + LOADS, "loads.cohesion_kpa", 'u', 4},
    {kinds + LEVEL, "loads.water.level", 'a', 1.5},
    {kinds + LEVEL, "loads.water.tension_crack.level", 'c', 3.5},
    {kinds + LEVEL, "loads.water.ice_kpa", 'd', 50},
    {kinds + LEVEL, "loads.water.ice_thickness", 'e', 0.25},
    {kinds + SURFACE, "loads.water.surface.1.2", 'b', 1.5},
    {kinds + SURFACE, "loads.water.tension_crack.height", 'e', 2.5},
    {kinds + SURFACE, "loads.water.tension_crack.distance", 'f', 0.25},
    {kinds + SUPPORT, "loads.anchors.1.at.1", 'a', 0.5},
    {kinds + SUPPORT, "loads.anchors.1.at.2", 'b', 4},
    {kinds + SUPPORT, "loads.anchors.1.dip_deg", 'c', 20},
    {kinds + SUPPORT, "loads.anchors.1.force_kn", 'd', 40},
    {kinds + SUPPORT, "loads.anchors.1.capacity_kn", 'e', 80},
    {kinds + SUPPORT, "loads.anchors.1.length", 'f', 6},
    {kinds + SUPPORT, "loads.anchors.1.spacing", 'g', 2},
    {kinds + SUPPORT, "loads.anchors.1.rows", 'h', 3},
    {kinds + SUPPORT, "loads.anchors.1.row_step.1", 'i', 0.5},
    {kinds + SUPPORT, "loads.anchors.1.row_step.2", 'j', -0.5},
    {kinds + SUPPORT, "loads.support_pressures.1.from.1", 'k', 0.5},
    {kinds + SUPPORT, "loads.support_pressures.1.from.2", 'l', 3},
    {kinds + SUPPORT, "loads.support_pressures.1.to.1", 'm', 0.5},
    {kinds + SUPPORT, "loads.support_pressures.1.to.2", 'n', 2},
    {kinds + SUPPORT, "loads.support_pressures.1.kpa.1", 'o', 4},
    {kinds + SUPPORT, "loads.support_pressures.1.kpa.2", 'p', 1},
    {kinds + PROFILE, "base.profile.1.1", 'a', -0.5},
    {kinds + PROFILE, "base.profile.2.2", 'd', -1},
    {kinds + PROFILE, "friction.residual_angle_deg", 'e', 25},
    {kinds + PROFILE, "friction.jrc", 'f', 6},
    {kinds + PROFILE, "friction.jcs_mpa", 'g', 50},
    {kinds + PROFILE, "contact.within", 'h', 0.125},
    {kinds + PROFILE, "contact.width", 'i', 3},
    {kinds + BETWEEN, "base.between.1.1", 'a', 1},
    {kinds + BETWEEN, "base.between.2.1", 'c', 3},
    {kinds + BETWEEN, "friction.basic_angle_deg", 'e', 30},
    {kinds + BETWEEN, "friction.roughness_angle_deg", 'f', 5},
    {kinds + JOINT, "joint.shift", 'a', -0.25},
    {kinds + JOINT, "joint.closure", 'b', 0.5},
    {kinds + MATCHING, "joint.matching", 'a', 0.875},
    {kinds + BOUNDS, "base.between.below", 'a', 7},
    {kinds + BOUNDS, "base.between.left_of", 'b', 3},
    {kinds + BOUNDS, "base.between.right_of", 'c', 0},
    {kinds + BOUNDS, "friction.residual_angle_deg", 'd', 30},
    {kinds + BOUNDS, "friction.tilt_test.angle_deg", 'e', 55},
    {kinds + BOUNDS, "friction.tilt_test.normal_stress_kpa", 'f', 4},
    {kinds + SLOPE, "frame.mean_plane.1.2", 'b', -0.125},
    {kinds + SLOPE, "frame.mean_plane.2.1", 'c', 5},
    {kinds + SLOPE, "friction.roughness_angle_deg", 'f', 8},
    {kinds + DIP, "slope.dip_deg", 'a', 20},
    {kinds + DIP, "slope.dip_direction_deg", 'b', 90},
    {kinds + FACETS, "friction.facets.1.angle_deg", 'b', 10},
    {kinds + FACETS, "friction.facets.2.x.1", 'c', 1},
    {kinds + FACETS, "friction.facets.2.x.2", 'd', 1},
    {kinds + FACETS, "friction.facets.2.angle_deg", 'e', 35},
};
