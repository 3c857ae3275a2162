/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A row a key, in the order of docs/scene.md. Rules, and what is settled after them, are those of
 * the calls that build a scene. */

#include "scene_varying/slot_table.h"

#include "scene_building/build.h"

/* ---- what a scene has --------------------------------------------------------------------------
 */

static bool is_outline(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_VERTICES;
}

static bool is_slab(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_SLAB;
}

static bool is_ellipse(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_ELLIPSE;
}

static bool is_teeth(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_TEETH;
}

/* Over a width of the block; or tooth by tooth. */
static bool is_over(const tp_scene *scene) {
  return is_teeth(scene) && scene->block.teeth.block_width.given;
}

static bool is_counted(const tp_scene *scene) {
  return is_teeth(scene) && !scene->block.teeth.block_width.given;
}

static bool is_listed(const tp_scene *scene) {
  return scene->base.rule.made == TP_MADE_OF_POINTS;
}

static bool is_of_teeth(const tp_scene *scene) {
  return scene->base.rule.made == TP_MADE_OF_TEETH;
}

static bool is_self_affine(const tp_scene *scene) {
  return scene->base.rule.made == TP_MADE_SELF_AFFINE;
}

static bool is_barton(const tp_scene *scene) {
  return scene->friction.load_dependent;
}

static bool is_plain_angle(const tp_scene *scene) {
  return !scene->friction.load_dependent && !scene->friction.basic_angle_deg.given;
}

static bool is_half_sine_across(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_HALF_SINE;
}

static bool is_full_sine_across(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_FULL_SINE;
}

static bool is_half_sine_upright(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_VERTICAL].form == TP_SHAKING_HALF_SINE;
}

static bool is_full_sine_upright(const tp_scene *scene) {
  return scene->shaking[TP_SHAKING_VERTICAL].form == TP_SHAKING_FULL_SINE;
}

/* ---- what follows ------------------------------------------------------------------------------
 */

static tp_status settle_teeth(tp_scene *scene, void *holder, tp_message *message) {
  tp_teeth *teeth = &scene->block.teeth;
  (void)holder;
  if (!teeth->block_width.given) return TP_OK;
  fmpq_set(teeth->width, teeth->block_width.value);
  fmpq_set(teeth->height, teeth->mean_height.value);
  tp_teeth_over(teeth->width, teeth->height, teeth->depth, teeth->count);
  return tp_check_amplitude(teeth->height, scene->block.place, message);
}

static tp_status settle_ellipse(tp_scene *scene, void *holder, tp_message *message) {
  const tp_ellipse *ellipse = &scene->block.ellipse;
  (void)holder;
  return tp_check_flat(ellipse->flat.value, ellipse->width.value, scene->block.place, message);
}

static tp_status settle_friction(tp_scene *scene, void *holder, tp_message *message) {
  const tp_friction_description *law = &scene->friction;
  tp_quantity *angle = &scene->friction_angle_deg;
  (void)holder;
  if (law->basic_angle_deg.given) {
    fmpq_add(angle->value, law->basic_angle_deg.value, law->roughness_angle_deg.value);
    return tp_check_patton(angle->value, angle->place, message);
  }
  if (!law->test_angle_deg.given) return TP_OK;
  return tp_check_tilt_test(law->test_angle_deg.value, law->test_stress_kpa.value, angle->value,
                            law->jcs_mpa.value, angle->place, message);
}

static tp_status settle_facets(tp_scene *scene, void *holder, tp_message *message) {
  (void)scene;
  return tp_check_facet_range(holder, message);
}

static tp_status settle_plane(tp_scene *scene, void *holder, tp_message *message) {
  (void)holder;
  return tp_check_mean_plane(&scene->mean_plane, scene->frame_place, message);
}

static tp_status settle_outline(tp_scene *scene, void *holder, tp_message *message) {
  (void)holder;
  (void)message;
  tp_polyline_drop_closing_point(&scene->block.outline);
  return TP_OK;
}

static tp_status settle_hole(tp_scene *scene, void *holder, tp_message *message) {
  (void)scene;
  (void)message;
  tp_polyline_drop_closing_point(holder);
  return TP_OK;
}

static tp_status settle_part(tp_scene *scene, void *holder, tp_message *message) {
  tp_part *part = holder;
  (void)scene;
  (void)message;
  tp_polyline_drop_closing_point(&part->outline);
  return TP_OK;
}

/* The profile is another one. */
static tp_status settle_profile(tp_scene *scene, void *holder, tp_message *message) {
  (void)holder;
  return tp_build_profile(scene, message);
}

/* A surcharge is the same at both ends. */
static tp_status settle_surcharge(tp_scene *scene, void *holder, tp_message *message) {
  tp_line_load *load = holder;
  (void)scene;
  (void)message;
  fmpq_set(load->last_kpa.value, load->first_kpa.value);
  return TP_OK;
}

/* ---- the table ---------------------------------------------------------------------------------
 */

/* A quantity of the scene; of an item; a coordinate of either. */
#define OF_SCENE(key, member, rule, has, settle)                                                   \
  { key, TP_SLOT_QUANTITY, TP_LISTS, offsetof(tp_scene, member), TP_RULE_##rule, has, settle }
#define OF_ITEM(key, list, type, member, rule, settle)                                             \
  { key, TP_SLOT_QUANTITY, TP_LIST_##list, offsetof(type, member), TP_RULE_##rule, NULL, settle }
#define OF_FORM(key, member, rule, has, settle)                                                    \
  { key, TP_SLOT_NUMBER, TP_LISTS, offsetof(tp_scene, member), TP_RULE_##rule, has, settle }
#define POINTS(key, member, has, settle)                                                           \
  { key, TP_SLOT_POINT, TP_LISTS, offsetof(tp_scene, member), TP_RULE_ANY, has, settle }

/* Of the rule of a profile, whatever it is; of what it begins with. What it holds is checked where
 * the profile is made. */
#define OF_RULE(key, member, has)                                                                  \
  OF_SCENE("base.profile." key, base.rule.member, ANY, has, settle_profile)
#define OF_TEETH(key, member) OF_RULE("teeth." key, member, is_of_teeth)
#define OF_SELF_AFFINE(key, member) OF_RULE("self_affine." key, member, is_self_affine)

#define LOAD(key, list, member, rule, settle) OF_ITEM(key, list, tp_line_load, member, rule, settle)
#define ENDS(load, list)                                                                           \
  LOAD(load ".from.1", list, x0, ANY, NULL), LOAD(load ".from.2", list, y0, ANY, NULL),            \
      LOAD(load ".to.1", list, x1, ANY, NULL), LOAD(load ".to.2", list, y1, ANY, NULL)
#define ANCHOR(key, member, rule) OF_ITEM(key, ANCHORS, tp_anchor_description, member, rule, NULL)

#define FACETS(key, member, rule)                                                                  \
  OF_ITEM(key, FRICTIONS, tp_facet_friction_description, member, rule, settle_facets)

/* Of the tilt test; of the shaking along one axis. */
#define OF_TEST(member, rule) OF_SCENE("tilt_test." #member, tilt_test.member, rule, NULL, NULL)
#define TRACTION(key, member)                                                                      \
  OF_ITEM("tilt_test.tractions.#." key, TRACTIONS, tp_traction_description, member, ANY, NULL)
#define OF_PULSE(way, axis, member, rule, has)                                                     \
  OF_SCENE("shaking." way "." #member, shaking[axis].member, rule, has, NULL)

static const tp_slot_row rows[] = {
    POINTS("block.outline.#.#", block.outline, is_outline, settle_outline),
    OF_FORM("block.slab.width", block.teeth.width, ABOVE_ZERO, is_slab, NULL),
    OF_FORM("block.slab.height", block.teeth.height, ABOVE_ZERO, is_slab, NULL),
    {"block.teeth.count", TP_SLOT_TEETH, TP_LISTS, 0, TP_RULE_ANY, is_teeth, settle_teeth},
    OF_FORM("block.teeth.width", block.teeth.width, ABOVE_ZERO, is_counted, NULL),
    OF_FORM("block.teeth.height", block.teeth.height, ABOVE_ZERO, is_counted, NULL),
    OF_FORM("block.teeth.depth", block.teeth.depth, NOT_NEGATIVE, is_counted, NULL),
    OF_SCENE("block.teeth.block_width", block.teeth.block_width, ABOVE_ZERO, is_over, settle_teeth),
    OF_SCENE("block.teeth.mean_height", block.teeth.mean_height, ABOVE_ZERO, is_over, settle_teeth),
    OF_FORM("block.teeth.amplitude", block.teeth.depth, NOT_NEGATIVE, is_over, settle_teeth),
    OF_SCENE("block.ellipse.width", block.ellipse.width, ABOVE_ZERO, is_ellipse, settle_ellipse),
    OF_SCENE("block.ellipse.height", block.ellipse.height, ABOVE_ZERO, is_ellipse, NULL),
    OF_SCENE("block.ellipse.flat", block.ellipse.flat, ABOVE_ZERO, is_ellipse, settle_ellipse),
    {"block.holes.#.#.#", TP_SLOT_POINT, TP_LIST_HOLES, 0, TP_RULE_ANY, NULL, settle_hole},
    {"block.parts.#.outline.#.#", TP_SLOT_POINT, TP_LIST_PARTS, offsetof(tp_part, outline),
     TP_RULE_ANY, NULL, settle_part},
    OF_ITEM("block.parts.#.unit_weight_kn_m3", PARTS, tp_part, unit_weight_kn_m3, UNIT_WEIGHT,
            NULL),
    OF_ITEM("block.arcs.#.from.1", ARCS, tp_arc_description, x, ANY, NULL),
    OF_ITEM("block.arcs.#.from.2", ARCS, tp_arc_description, y, ANY, NULL),
    OF_ITEM("block.arcs.#.through.1", ARCS, tp_arc_description, through_x, ANY, NULL),
    OF_ITEM("block.arcs.#.through.2", ARCS, tp_arc_description, through_y, ANY, NULL),
    OF_ITEM("block.arcs.#.bulge", ARCS, tp_arc_description, bulge, BULGE, NULL),
    OF_ITEM("block.rounded.corners.#.at.1", CORNERS, tp_corner_description, x, ANY, NULL),
    OF_ITEM("block.rounded.corners.#.at.2", CORNERS, tp_corner_description, y, ANY, NULL),
    OF_ITEM("block.rounded.corners.#.radius", CORNERS, tp_corner_description, radius, NOT_NEGATIVE,
            NULL),
    OF_SCENE("block.thickness", block.thickness, ABOVE_ZERO, NULL, NULL),
    OF_SCENE("block.unit_weight_kn_m3", block.unit_weight_kn_m3, UNIT_WEIGHT, NULL, NULL),
    POINTS("base.profile.#.#", base.profile, is_listed, NULL),
    OF_TEETH("count", count),
    OF_TEETH("wavelength", wavelength),
    OF_TEETH("amplitude", amplitude),
    OF_TEETH("skew", skew),
    OF_TEETH("scatter.wavelength", scatter[0]),
    OF_TEETH("scatter.amplitude", scatter[1]),
    OF_TEETH("scatter.skew", scatter[2]),
    OF_TEETH("start.1", start_x),
    OF_TEETH("start.2", start_y),
    OF_TEETH("seed", seed),
    OF_SELF_AFFINE("length", length),
    OF_SELF_AFFINE("step", step),
    OF_SELF_AFFINE("hurst", hurst),
    OF_SELF_AFFINE("rms_height", roughness[TP_ROUGHNESS_RMS_HEIGHT]),
    OF_SELF_AFFINE("z2", roughness[TP_ROUGHNESS_Z2]),
    OF_SELF_AFFINE("jrc", roughness[TP_ROUGHNESS_JRC]),
    OF_SELF_AFFINE("shortest", shortest),
    OF_SELF_AFFINE("longest", longest),
    OF_SELF_AFFINE("start.1", start_x),
    OF_SELF_AFFINE("start.2", start_y),
    OF_SELF_AFFINE("seed", seed),
    OF_RULE("jrc_profile", standard, NULL),
    POINTS("base.profile.measured.#.#", base.rule.measured, NULL, settle_profile),
    OF_RULE("noise.deviation", deviation, NULL),
    OF_RULE("noise.seed", noise_seed, NULL),
    OF_RULE("scaled.rms_height", scaled[TP_ROUGHNESS_RMS_HEIGHT], NULL),
    OF_RULE("scaled.z2", scaled[TP_ROUGHNESS_Z2], NULL),
    OF_RULE("scaled.jrc", scaled[TP_ROUGHNESS_JRC], NULL),
    OF_RULE("worn.cut", worn[TP_WEAR_CUT], NULL),
    OF_RULE("worn.rounded", worn[TP_WEAR_ROUNDED], NULL),
    OF_RULE("worn.abraded", worn[TP_WEAR_ABRADED], NULL),
    POINTS("base.between.#.#", base.between, NULL, NULL),
    OF_SCENE("base.between.below", base.below, ANY, NULL, NULL),
    OF_SCENE("base.between.left_of", base.left_of, ANY, NULL, NULL),
    OF_SCENE("base.between.right_of", base.right_of, ANY, NULL, NULL),
    OF_SCENE("base.beyond.left", base.beyond_left, BEYOND, NULL, NULL),
    OF_SCENE("base.beyond.right", base.beyond_right, BEYOND, NULL, NULL),
    OF_SCENE("contact.within", base.within, ABOVE_ZERO, NULL, NULL),
    OF_SCENE("contact.width", friction.contact_width, ABOVE_ZERO, NULL, NULL),
    OF_SCENE("joint.shift", base.shift, ANY, NULL, NULL),
    OF_SCENE("joint.matching", base.matching, SHARE, NULL, NULL),
    OF_SCENE("joint.closure", base.closure, ABOVE_ZERO, NULL, NULL),
    OF_SCENE("friction_angle_deg", friction_angle_deg, ANGLE_BELOW_90, is_plain_angle, NULL),
    OF_SCENE("friction.basic_angle_deg", friction.basic_angle_deg, ANGLE_BELOW_90, NULL,
             settle_friction),
    OF_SCENE("friction.roughness_angle_deg", friction.roughness_angle_deg, ANGLE_BELOW_90, NULL,
             settle_friction),
    OF_SCENE("friction.residual_angle_deg", friction_angle_deg, ANGLE_BELOW_90, is_barton,
             settle_friction),
    OF_SCENE("friction.jrc", friction.jrc, JRC, NULL, NULL),
    OF_SCENE("friction.jcs_mpa", friction.jcs_mpa, ABOVE_ZERO, NULL, settle_friction),
    OF_SCENE("friction.tilt_test.angle_deg", friction.test_angle_deg, ANGLE_BELOW_90, NULL,
             settle_friction),
    OF_SCENE("friction.tilt_test.normal_stress_kpa", friction.test_stress_kpa, ABOVE_ZERO, NULL,
             settle_friction),
    FACETS("friction.facets.#.x.1", x0, ANY),
    FACETS("friction.facets.#.x.2", x1, ANY),
    FACETS("friction.facets.#.angle_deg", angle_deg, ANGLE_BELOW_90),
    OF_SCENE("tilt.angle_deg", tilt_angle_deg, ANGLE_TO_90, NULL, NULL),
    POINTS("frame.mean_plane.#.#", mean_plane, NULL, settle_plane),
    OF_SCENE("loads.seismic.horizontal", loads.horizontal, ANY, NULL, NULL),
    OF_SCENE("loads.seismic.vertical", loads.vertical, ANY, NULL, NULL),
    OF_SCENE("loads.water.height", loads.water.height, NOT_NEGATIVE, NULL, NULL),
    OF_SCENE("loads.water.unit_weight_kn_m3", loads.water.unit_weight_kn_m3, NOT_NEGATIVE, NULL,
             NULL),
    OF_SCENE("loads.bond_kpa", loads.bond_kpa, NOT_NEGATIVE, NULL, NULL),
    OF_SCENE("loads.cohesion_kpa", loads.cohesion_kpa, NOT_NEGATIVE, NULL, NULL),
    ENDS("loads.pressures.#", PRESSURES),
    LOAD("loads.pressures.#.kpa.1", PRESSURES, first_kpa, NOT_NEGATIVE, NULL),
    LOAD("loads.pressures.#.kpa.2", PRESSURES, last_kpa, NOT_NEGATIVE, NULL),
    ENDS("loads.surcharges.#", SURCHARGES),
    LOAD("loads.surcharges.#.kpa", SURCHARGES, first_kpa, NOT_NEGATIVE, settle_surcharge),
    ANCHOR("loads.anchors.#.at.1", x, ANY),
    ANCHOR("loads.anchors.#.at.2", y, ANY),
    ANCHOR("loads.anchors.#.direction_deg", direction_deg, ANY),
    ANCHOR("loads.anchors.#.force_kn", force_kn, NOT_NEGATIVE),
    OF_TEST(speed_deg_min, ABOVE_ZERO),
    OF_TEST(until_deg, ANGLE_TO_90),
    OF_TEST(tolerance_deg, ABOVE_ZERO),
    OF_TEST(duration_s, ABOVE_ZERO),
    OF_TEST(normal_stiffness_gpa_m, ABOVE_ZERO),
    OF_TEST(shear_stiffness_gpa_m, ABOVE_ZERO),
    OF_TEST(damping, SHARE),
    OF_TEST(rounding, ABOVE_ZERO),
    OF_TEST(time_step_s, ABOVE_ZERO),
    OF_TEST(restitution, SHARE),
    TRACTION("normal_kpa.1", first_kpa),
    TRACTION("normal_kpa.2", last_kpa),
    TRACTION("shear_kpa", shear_kpa),
    OF_PULSE("horizontal.half_sine", 0, peak_g, ANY, is_half_sine_across),
    OF_PULSE("horizontal.half_sine", 0, frequency_hz, ABOVE_ZERO, is_half_sine_across),
    OF_PULSE("horizontal.full_sine", 0, peak_g, ANY, is_full_sine_across),
    OF_PULSE("horizontal.full_sine", 0, frequency_hz, ABOVE_ZERO, is_full_sine_across),
    OF_PULSE("horizontal.record", 0, scale, ANY, NULL),
    OF_PULSE("vertical.half_sine", 1, peak_g, ANY, is_half_sine_upright),
    OF_PULSE("vertical.half_sine", 1, frequency_hz, ABOVE_ZERO, is_half_sine_upright),
    OF_PULSE("vertical.full_sine", 1, peak_g, ANY, is_full_sine_upright),
    OF_PULSE("vertical.full_sine", 1, frequency_hz, ABOVE_ZERO, is_full_sine_upright),
    OF_PULSE("vertical.record", 1, scale, ANY, NULL)};

_Static_assert(sizeof rows / sizeof rows[0] == TP_SLOT_ROWS, "a row a key");
const tp_slot_row *const tp_slot_rows = rows;
