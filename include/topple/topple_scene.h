/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene: read from a file, or built in memory; and with other numbers. Included by topple.h.
 *
 *     const double outline[] = {0, 0, 50, 0, 50, 100, 0, 100};
 *     tp_scene *scene = NULL;
 *     tp_status status = tp_scene_new(&scene, "mm", &message);
 *     if (status == TP_OK) {
 *       status = tp_scene_set_outline(scene, tp_coordinates_of(outline, 4), &message);
 *     }
 *     if (status == TP_OK) {
 *       status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(30), &message);
 *     }
 *
 * What a call gives means what the key of its name means in a scene file (docs/scene.md), and is
 * checked by the same rules; what is not given is as in a file without the key. Calls come in any
 * order. A set call replaces what was set before, an add call adds one more; what is given is
 * copied. A call that fails leaves the scene as it was; its message begins with its name, and names
 * the argument. Errors that involve several calls, or geometry, are reported by the call that uses
 * the scene. A place in its messages and reports is the name of a call, with the number of the
 * point, or of what was added, from 1 on. A scene read from a file is not changed by these calls.
 *
 * Lengths are in the scene's length unit, angles in degrees, stresses in kPa or MPa, as names say.
 * Widths, heights, thicknesses and unit weights are above 0; depths, radii, stresses and forces not
 * below; angles of friction at least 0 and below 90. What is said of one call of a group, which no
 * empty line parts, is said of all. */

#ifndef TOPPLE_SCENE_H
#define TOPPLE_SCENE_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A scene. Opaque: it is made and changed by calls alone. */
typedef struct tp_scene tp_scene;

/* Read the scene in `path` (docs/scene.md), to be freed by tp_scene_free. Files that the scene
 * names are looked for beside it. A drawing (docs/drawing.md), by the ending of its name, is read
 * as the scene that names it and says nothing else. */
TP_MUST_USE tp_status tp_scene_read(tp_scene **scene, const char *path, tp_message *message);

/* The same with `count` settings "KEY=FORMULA" (tp_scene_with_settings). In place of a scene a
 * drawing or a mesh (docs/mesh.md) may be given: then `unit` is that of its lengths, mm, cm, m, km,
 * in or ft, or empty where the file says it, and settings may have any key that takes a number or a
 * word of letters, as tilt.towards=left. Of a scene `unit` is empty. */
TP_MUST_USE tp_status tp_scene_read_with(tp_scene **scene, const char *path, const char *unit,
                                         const char *const *settings, size_t count,
                                         tp_message *message);

/* The same from text in memory; `name` is what messages call it, and files that the scene names are
 * looked for beside a file of that name. */
TP_MUST_USE tp_status tp_scene_read_text(tp_scene **scene, const char *text, const char *name,
                                         tp_message *message);

/* A scene without a block, on a mated base, that tilts both ways, to be freed by tp_scene_free.
 * `length_unit` is mm, cm, m, km, in or ft. */
TP_MUST_USE tp_status tp_scene_new(tp_scene **scene, const char *length_unit, tp_message *message);

/* Free it with all that it holds; NULL is allowed. */
void tp_scene_free(tp_scene *scene);

/* An exact number: the text where there is one, a decimal or a fraction of decimals ("0.1", "1/3",
 * "-2.5e3"); else the double, taken as the binary number that it is, so that 0.1 is
 * 3602879701896397 / 2^55. Zero, or between 1e-308 and 1e308 in size. */
typedef struct tp_exact {
  double value;     /* finite */
  const char *text; /* or NULL; stays the caller's */
} tp_exact;

/* Of the double `value`, and of a `text`. */
tp_exact tp_exact_of(double value);
tp_exact tp_exact_text(const char *text);

/* `count` points x0, y0, x1, y1, ...: the texts where there are any, else the doubles. */
typedef struct tp_coordinates {
  size_t count;             /* of the points */
  const double *xy;         /* 2 count of them, an array of shape (count, 2) */
  const char *const *texts; /* likewise, each as in tp_exact; or NULL */
} tp_coordinates;

/* `count` points of `xy`, an array of shape (count, 2) that stays the caller's: of doubles, and of
 * texts. */
tp_coordinates tp_coordinates_of(const double *xy, size_t count);
tp_coordinates tp_coordinates_text(const char *const *xy, size_t count);

/* A number by its key in a scene file (docs/scene.md), as "joint.closure" or
 * "loads.seismic.horizontal", in the unit and range of that key: of those that stand by themselves,
 * in no list and no form of the block, of the base or of a law of friction. It replaces what was
 * set before, also by a key that it excludes. What must be said besides is missed when the scene is
 * solved, as of a file. The three numbers that most scenes have can be set by a call of that name
 * too: thickness, unit weight and tilt angle. */
TP_MUST_USE tp_status tp_scene_set_number(tp_scene *scene, const char *key, tp_exact value,
                                          tp_message *message);

/* The title by which reports and figures are headed: any UTF-8. */
TP_MUST_USE tp_status tp_scene_set_title(tp_scene *scene, const char *title, tp_message *message);

/* The block: exactly one of outline, slab, teeth and ellipse; the last one set is taken. An
 * outline or a hole may run either way round, and may repeat its first point at the end. It has 3
 * points at least, and does not meet itself. A slab is a rectangle of `width` along the base and
 * `height` normal to it. */
TP_MUST_USE tp_status tp_scene_set_outline(tp_scene *scene, tp_coordinates outline,
                                           tp_message *message);
TP_MUST_USE tp_status tp_scene_set_slab(tp_scene *scene, tp_exact width, tp_exact height,
                                        tp_message *message);

/* With what the underside of a toothed block begins at its left. */
typedef enum tp_left_end { TP_LEFT_END_VALLEY, TP_LEFT_END_PEAK } tp_left_end;

/* `count` teeth of `width` each, `height` the smaller of their heights and `height` + `depth` the
 * larger: N, a, b, c of Fig. 5. At most 10 million. `left_end` is what the underside begins with.
 */
TP_MUST_USE tp_status tp_scene_set_teeth(tp_scene *scene, long count, tp_exact width,
                                         tp_exact height, tp_exact depth, tp_left_end left_end,
                                         tp_message *message);

/* The same by the block as a whole, dx, y, A of section 5.1: `count` teeth over `block_width`, the
 * wavelength 2 block_width / count; `amplitude` is below twice `mean_height`. */
TP_MUST_USE tp_status tp_scene_set_teeth_over(tp_scene *scene, long count, tp_exact block_width,
                                              tp_exact mean_height, tp_exact amplitude,
                                              tp_left_end left_end, tp_message *message);

/* A boulder: an ellipse of `width` along the base and `height` in full, cut off below where it is
 * `flat` wide, which is above 0 and below `width`; it rests on that. */
TP_MUST_USE tp_status tp_scene_set_ellipse(tp_scene *scene, tp_exact width, tp_exact height,
                                           tp_exact flat, tp_message *message);

/* A hole in the block, or a part of it with a different unit weight: rings as the outline is,
 * inside of it. */
TP_MUST_USE tp_status tp_scene_add_hole(tp_scene *scene, tp_coordinates outline,
                                        tp_message *message);
TP_MUST_USE tp_status tp_scene_add_part(tp_scene *scene, tp_coordinates outline,
                                        tp_exact unit_weight_kn_m3, tp_message *message);

/* The edge of the outline that begins in the vertex (from_x, from_y) is an arc: through the point
 * (through_x, through_y), or by its `bulge`, the tangent of a quarter of its angle, not 0 and
 * negative inwards. */
TP_MUST_USE tp_status tp_scene_add_arc_through(tp_scene *scene, tp_exact from_x, tp_exact from_y,
                                               tp_exact through_x, tp_exact through_y,
                                               tp_message *message);
TP_MUST_USE tp_status tp_scene_add_arc_bulge(tp_scene *scene, tp_exact from_x, tp_exact from_y,
                                             tp_exact bulge, tp_message *message);

/* An end of the underside. */
typedef enum tp_underside_end { TP_UNDERSIDE_LEFT_END, TP_UNDERSIDE_RIGHT_END } tp_underside_end;

/* A corner of the outline, rounded by a circle of `radius`: at an end of the underside, or at the
 * convex vertex (x, y). */
TP_MUST_USE tp_status tp_scene_add_rounded_end(tp_scene *scene, tp_underside_end at,
                                               tp_exact radius, tp_message *message);
TP_MUST_USE tp_status tp_scene_add_rounded_vertex(tp_scene *scene, tp_exact x, tp_exact y,
                                                  tp_exact radius, tp_message *message);

/* How corners are rounded: where `keeps_mass`, by the model of Appendix B, in which the axis moves
 * and the mass is kept; else, and unless set, their tips are taken off. */
TP_MUST_USE tp_status tp_scene_set_rounding_keeps_mass(tp_scene *scene, bool keeps_mass,
                                                       tp_message *message);

/* Where `repair`, vertices are moved where rings meet themselves by less than a last digit, and a
 * note says so; unless set such rings are refused. */
TP_MUST_USE tp_status tp_scene_set_repair(tp_scene *scene, bool repair, tp_message *message);

/* Many blocks instead of one on its base (docs/blocks_in_contact.md): each by its `outline`, as
 * above, where it lies; some are `ground`, which is fixed. `name` has up to 60 bytes; NULL: its
 * number. Of the calls for one block and its base those of unit weight, of one angle of friction,
 * of tilt, frame and slope, and of loads mean the same of all blocks; water by its height, its
 * crack or its ice, and all calls for a block's form, base and tests are refused as the scene is
 * used. */
TP_MUST_USE tp_status tp_scene_add_block(tp_scene *scene, tp_coordinates outline, const char *name,
                                         bool ground, tp_message *message);

/* More of the block added as the `number`th, from 1 on: its own unit weight, where it is not that
 * of all; a hole in it; a part of it with a different unit weight. */
TP_MUST_USE tp_status tp_scene_set_block_unit_weight_kn_m3(tp_scene *scene, size_t number,
                                                           tp_exact unit_weight_kn_m3,
                                                           tp_message *message);
TP_MUST_USE tp_status tp_scene_add_block_hole(tp_scene *scene, size_t number,
                                              tp_coordinates outline, tp_message *message);
TP_MUST_USE tp_status tp_scene_add_block_part(tp_scene *scene, size_t number,
                                              tp_coordinates outline, tp_exact unit_weight_kn_m3,
                                              tp_message *message);

/* All contacts between the `first` and the `second` block, by their numbers, have strength of their
 * own: by the calls below, of the joint added as the `number`th. What these do not set is the
 * scene's: its friction angle, "loads.cohesion_kpa" and "loads.bond_kpa". */
TP_MUST_USE tp_status tp_scene_add_joint(tp_scene *scene, size_t first, size_t second,
                                         tp_message *message);
TP_MUST_USE tp_status tp_scene_set_joint_friction_angle_deg(tp_scene *scene, size_t number,
                                                            tp_exact angle_deg,
                                                            tp_message *message);
TP_MUST_USE tp_status tp_scene_set_joint_cohesion_kpa(tp_scene *scene, size_t number,
                                                      tp_exact cohesion_kpa, tp_message *message);
/* Its tensile strength. */
TP_MUST_USE tp_status tp_scene_set_joint_tension_kpa(tp_scene *scene, size_t number,
                                                     tp_exact tension_kpa, tp_message *message);

/* The thickness of the block, normal to the section; 1 m unless set. */
TP_MUST_USE tp_status tp_scene_set_thickness(tp_scene *scene, tp_exact thickness,
                                             tp_message *message);

/* The unit weight of the block; without it weights are shares, and loads besides it are bad input.
 */
TP_MUST_USE tp_status tp_scene_set_unit_weight_kn_m3(tp_scene *scene, tp_exact unit_weight_kn_m3,
                                                     tp_message *message);

/* The base: mated with the underside, of which the contact is all, from its leftmost to its
 * rightmost vertex, where `whole`; or a profile, points from left to right. The last one set is
 * taken, and drops what narrowed or widened the one before it. */
TP_MUST_USE tp_status tp_scene_set_base_mated(tp_scene *scene, bool whole, tp_message *message);
TP_MUST_USE tp_status tp_scene_set_base_profile(tp_scene *scene, tp_coordinates profile,
                                                tp_message *message);

/* Print in this unit what is of its kind: lengths in mm, cm, m, km, in or ft; forces in N, kN, MN,
 * kgf, tf, lbf or kip; moments in "N m", "kN m", "MN m", "tf m", "lbf ft" or "kip ft"; stresses in
 * Pa, kPa, MPa, kgf/cm2, psi, psf or ksf. Unless set, reports print lengths in the length unit, and
 * forces, moments and stresses in N, N m and Pa or thousands of these. Fields and JSON stay SI. */
TP_MUST_USE tp_status tp_scene_set_result_unit(tp_scene *scene, const char *name,
                                               tp_message *message);

/* Where `rests`, set the block down on the profile that was set, where its coordinates put it,
 * until it rests (docs/rest.md); else, and unless set, it lies as they say. */
TP_MUST_USE tp_status tp_scene_set_base_rest(tp_scene *scene, bool rests, tp_message *message);

/* Where `all`, set the block down likewise, and list all its resting poses besides, each with the
 * starting positions from which it comes to it; else, and unless set, it lies as they say. */
TP_MUST_USE tp_status tp_scene_set_base_poses(tp_scene *scene, bool all, tp_message *message);

/* The block is shifted along the mated base that it fits, to the right or `leftwards`, and set down
 * there until it rests (docs/rest.md), by the least at which no more than `matching` of its
 * underside, in [0, 1], is closed: gaps up to the number `joint.closure`. It takes the place of
 * `joint.shift`, which gives the shift itself, to the right above 0. */
TP_MUST_USE tp_status tp_scene_set_joint_matching(tp_scene *scene, tp_exact matching,
                                                  bool leftwards, tp_message *message);

/* The profile of the base, given, read or generated (docs/generate.md), as CSV of x, y with all of
 * its digits: into `text`, which the caller frees; and into the file `path`, which appears whole or
 * not at all. TP_SYSTEM_FAILED where it cannot be written; a mated base has none. */
TP_MUST_USE tp_status tp_scene_profile_csv(char **text, const tp_scene *scene, tp_message *message);
TP_MUST_USE tp_status tp_scene_write_profile(const char *path, const tp_scene *scene,
                                             tp_message *message);

/* By how much a mated base extends past the contact, to the `left` and to the `right`: not below 0,
 * and 0 unless set. */
TP_MUST_USE tp_status tp_scene_set_base_beyond(tp_scene *scene, tp_exact left, tp_exact right,
                                               tp_message *message);

/* A mated base whose contact ends in two vertices, the left one first. */
TP_MUST_USE tp_status tp_scene_set_base_between(tp_scene *scene, tp_coordinates two_vertices,
                                                tp_message *message);

/* On which side of a coordinate: below a y, left or right of an x. */
typedef enum tp_base_bound { TP_BASE_BELOW, TP_BASE_LEFT_OF, TP_BASE_RIGHT_OF } tp_base_bound;

/* A mated base whose vertices all lie on that side of `value`. */
TP_MUST_USE tp_status tp_scene_set_base_bound(tp_scene *scene, tp_base_bound bound, tp_exact value,
                                              tp_message *message);

/* Friction of the contact, of which the last one set is taken: by one angle, `angle_deg` in [0,
 * 90). */
TP_MUST_USE tp_status tp_scene_set_friction_angle_deg(tp_scene *scene, tp_exact angle_deg,
                                                      tp_message *message);

/* By Patton's law, phi_b + i (Eq. 6): both not below 0, their sum below 90. */
TP_MUST_USE tp_status tp_scene_set_friction_patton(tp_scene *scene, tp_exact basic_angle_deg,
                                                   tp_exact roughness_angle_deg,
                                                   tp_message *message);

/* By Barton's law, phi_r + JRC log10(JCS / stress) (Eq. 8): `residual_angle_deg` in [0, 90), `jrc`
 * in [0, 100], `jcs_mpa` above 0. */
TP_MUST_USE tp_status tp_scene_set_friction_barton(tp_scene *scene, tp_exact residual_angle_deg,
                                                   tp_exact jrc, tp_exact jcs_mpa,
                                                   tp_message *message);

/* The same with the JRC of a tilt test (Eq. 9): the angle at which it slid, in [0, 90), and the
 * normal stress on level ground, above 0. */
TP_MUST_USE tp_status tp_scene_set_friction_barton_test(tp_scene *scene,
                                                        tp_exact residual_angle_deg,
                                                        tp_exact test_angle_deg,
                                                        tp_exact test_normal_stress_kpa,
                                                        tp_exact jcs_mpa, tp_message *message);

/* The same with the JRC of a roughness angle i in [0, 90) (Eq. 10). */
TP_MUST_USE tp_status tp_scene_set_friction_barton_roughness(tp_scene *scene,
                                                             tp_exact residual_angle_deg,
                                                             tp_exact roughness_angle_deg,
                                                             tp_exact jcs_mpa, tp_message *message);

/* A different friction angle, `angle_deg` in [0, 90), for facets of the base: from the one with
 * the number `first` to `last`, counted from 1 from left to right, along the profile or, of a mated
 * base, along the underside that it is mated with. All other facets have that of the contact, which
 * is one angle or Patton's law. No facet is given two. */
TP_MUST_USE tp_status tp_scene_add_friction_facets(tp_scene *scene, size_t first, size_t last,
                                                   tp_exact angle_deg, tp_message *message);

/* The same for all facets between two abscissas, x0 below x1, each wholly; an upright facet lies
 * between them from x0 to before x1. Not in the frame of the world. */
TP_MUST_USE tp_status tp_scene_add_friction_between(tp_scene *scene, tp_exact x0, tp_exact x1,
                                                    tp_exact angle_deg, tp_message *message);

/* The directions of tilt that are solved: `left`, `right`, or both, as it is unless set. */
TP_MUST_USE tp_status tp_scene_set_tilt_towards(tp_scene *scene, bool left, bool right,
                                                tp_message *message);

/* Is the friction angle that was set an apparent one, measured on the rough joint, or the basic one
 * of a smooth surface? Of an apparent one the sole of a mated outline is levelled into its mean
 * plane, so that its facets do not add to it; unless set it is taken for the basic one. */
TP_MUST_USE tp_status tp_scene_set_friction_is_apparent(tp_scene *scene, bool apparent,
                                                        tp_message *message);

/* The tilt that the block lies at, in [0, 90]; unless set there is none, and no factor of safety.
 */
TP_MUST_USE tp_status tp_scene_set_tilt_angle_deg(tp_scene *scene, tp_exact angle_deg,
                                                  tp_message *message);

/* What x and y lie along: the mean plane of the base and its normal; or the horizontal and the
 * vertical, with the mean plane fitted to the contact, or through `two_points`, the left one first.
 */
TP_MUST_USE tp_status tp_scene_set_frame_base(tp_scene *scene, tp_message *message);
TP_MUST_USE tp_status tp_scene_set_frame_world(tp_scene *scene, tp_message *message);
TP_MUST_USE tp_status tp_scene_set_mean_plane(tp_scene *scene, tp_coordinates two_points,
                                              tp_message *message);

/* A slope that the base lies on: x and y run along its plane and normal to it, as without a frame,
 * and it dips by `dip_deg`, in [0, 90], towards the left or the right. The tilt, where one is set,
 * is added to the dip. */
TP_MUST_USE tp_status tp_scene_set_slope(tp_scene *scene, tp_exact dip_deg, tp_direction towards,
                                         tp_message *message);

/* Which way the horizontal part of an earthquake acts on a block on a slope or in the frame of the
 * world: both ways, and the worse one governs, unless it is restricted to one. */
typedef enum tp_seismic_direction {
  TP_SEISMIC_BOTH,
  TP_SEISMIC_DOWN_DIP,
  TP_SEISMIC_UP_DIP
} tp_seismic_direction;

/* Says which of them; up-dip and both ways are for a block on a slope or in the frame of
 * the world. */
TP_MUST_USE tp_status tp_scene_set_seismic_direction(tp_scene *scene,
                                                     tp_seismic_direction direction,
                                                     tp_message *message);

/* Loads, which a block with a unit weight can bear (docs/loads.md); those of one number have keys,
 * as "loads.seismic.horizontal" and "loads.cohesion_kpa".
 *
 * Water behind the block, of `unit_weight_kn_m3` (9.81 in most scenes), to `height` over the up-dip
 * end of the contact: along the face, or vertical whatever the tilt where `stays_level`; where
 * `uplift` below the block too, falling to nothing at the toe. Neither number is below 0. */
TP_MUST_USE tp_status tp_scene_set_water(tp_scene *scene, tp_exact height,
                                         tp_exact unit_weight_kn_m3, bool stays_level, bool uplift,
                                         tp_message *message);

/* Which faces of a block water wets: those between the ends of its base joint and its top, up-dip
 * of it or down-dip. Behind is taken, with a caution, where that is left open. */
typedef enum tp_water_faces {
  TP_WATER_FACES_UNSTATED,
  TP_WATER_BEHIND,
  TP_WATER_IN_FRONT,
  TP_WATER_ON_BOTH
} tp_water_faces;

/* How it lifts the block: not at all; by a pressure that falls linearly to nothing at an end that
 * it does not wet; or by the one of its level at both ends, which is taken where that is left open.
 */
typedef enum tp_water_uplift {
  TP_WATER_UPLIFT_UNSTATED,
  TP_WATER_UPLIFT_NONE,
  TP_WATER_UPLIFT_TRIANGULAR,
  TP_WATER_UPLIFT_FULL
} tp_water_uplift;

/* Water up to a level, or below a surface of `points` from left to right, presses on the faces that
 * it wets (docs/loads.md). The level is an elevation: y in the frame of the world, else over the
 * up-dip end of the base joint. The unit weight is not below 0. */
TP_MUST_USE tp_status tp_scene_set_water_level(tp_scene *scene, tp_exact level,
                                               tp_exact unit_weight_kn_m3, tp_water_faces faces,
                                               tp_water_uplift uplift, tp_message *message);
TP_MUST_USE tp_status tp_scene_set_water_surface(tp_scene *scene, tp_coordinates points,
                                                 tp_exact unit_weight_kn_m3, tp_water_faces faces,
                                                 tp_water_uplift uplift, tp_message *message);

/* A crack behind the block, filled to a level; or to a `height` over its foot, normal to the mean
 * plane, which lies at a `distance` up-dip of the base joint. It may stand alone: water of 9.81
 * kN/m3, with full uplift; or beside a level or a surface in front, set before. */
TP_MUST_USE tp_status tp_scene_set_tension_crack_level(tp_scene *scene, tp_exact level,
                                                       tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tension_crack_height(tp_scene *scene, tp_exact height,
                                                        tp_exact distance, tp_message *message);

/* Ice on such water, set before: its pressure and its thickness, neither below 0. */
TP_MUST_USE tp_status tp_scene_set_ice(tp_scene *scene, tp_exact ice_kpa, tp_exact ice_thickness,
                                       tp_message *message);

/* A pressure normal to a line on one edge of the outline, which runs counter-clockwise from (x0,
 * y0) to (x1, y1): `first_kpa` and `last_kpa` at its ends, not below 0, linear between them. */
TP_MUST_USE tp_status tp_scene_add_pressure(tp_scene *scene, tp_exact x0, tp_exact y0, tp_exact x1,
                                            tp_exact y1, tp_exact first_kpa, tp_exact last_kpa,
                                            tp_message *message);

/* A surcharge on such a line: `kpa` of its length, straight down whatever the tilt. */
TP_MUST_USE tp_status tp_scene_add_surcharge(tp_scene *scene, tp_exact x0, tp_exact y0, tp_exact x1,
                                             tp_exact y1, tp_exact kpa, tp_message *message);

/* An anchor at the point (x, y) of the block, of `force_kn` not below 0 on its whole thickness.
 * `direction_deg` is that of its pull on the block, from x towards y. Where `passive` it counts as
 * resistance; else it is subtracted from the overturning moment. */
TP_MUST_USE tp_status tp_scene_add_anchor(tp_scene *scene, tp_exact x, tp_exact y,
                                          tp_exact direction_deg, tp_exact force_kn, bool passive,
                                          tp_message *message);

/* Bolts at the point (x, y) of the block, each of `force_kn`, that pull towards the up-dip side and
 * below the horizontal by `dip_deg` in [-90, 90]: on a slope as it dips, in the world's frame as
 * the mean plane does, on a table as it stands level. They are anchors too, and `passive` counts as
 * of these. */
TP_MUST_USE tp_status tp_scene_add_bolt(tp_scene *scene, tp_exact x, tp_exact y, tp_exact dip_deg,
                                        tp_exact force_kn, bool passive, tp_message *message);

/* More of the anchor or bolt added as the `number`th, from 1 on. The side that a bolt with a dip
 * runs to, where it is not plain which side is up-dip. */
TP_MUST_USE tp_status tp_scene_set_bolt_towards(tp_scene *scene, size_t number,
                                                tp_direction towards, tp_message *message);
/* Its length, above 0, with which it must reach the rock behind the block. */
TP_MUST_USE tp_status tp_scene_set_bolt_length(tp_scene *scene, size_t number, tp_exact length,
                                               tp_message *message);
/* What one of them can bear, above 0 and not below its force. */
TP_MUST_USE tp_status tp_scene_set_bolt_capacity_kn(tp_scene *scene, size_t number,
                                                    tp_exact capacity_kn, tp_message *message);
/* The distance of bolts along the slope, out of the section, above 0: each row bears the force over
 * the spacing on a length; without it, one bolt holds the whole thickness. */
TP_MUST_USE tp_status tp_scene_set_bolt_spacing(tp_scene *scene, size_t number, tp_exact spacing,
                                                tp_message *message);
/* How many rows there are, 1 to 1000, each (dx, dy) from the one before. */
TP_MUST_USE tp_status tp_scene_set_bolt_rows(tp_scene *scene, size_t number, long rows, tp_exact dx,
                                             tp_exact dy, tp_message *message);

/* A pressure of a lining or a wall on a line of the outline, as tp_scene_add_pressure takes it.
 * Where `passive` it counts as resistance; else it is taken from what overturns. */
TP_MUST_USE tp_status tp_scene_add_support_pressure(tp_scene *scene, tp_exact x0, tp_exact y0,
                                                    tp_exact x1, tp_exact y1, tp_exact first_kpa,
                                                    tp_exact last_kpa, bool passive,
                                                    tp_message *message);

/* Loads on many blocks. A bolt from the point (x, y) to its far end (to_x, to_y), which holds in
 * the block that it lies in; a force on them from outside, which `direction_deg` is of, from x
 * towards y. Forces are per metre of thickness, those of bolts of one bolt, on a metre or on its
 * spacing. */
TP_MUST_USE tp_status tp_scene_add_bolt_to(tp_scene *scene, tp_exact x, tp_exact y, tp_exact to_x,
                                           tp_exact to_y, tp_exact force_kn, bool passive,
                                           tp_message *message);
TP_MUST_USE tp_status tp_scene_add_force(tp_scene *scene, tp_exact x, tp_exact y,
                                         tp_exact direction_deg, tp_exact force_kn,
                                         tp_message *message);

/* The block, by its number, in which the far end of the anchor or bolt added as the `number`th
 * holds; without it, the one that it lies in. */
TP_MUST_USE tp_status tp_scene_set_bolt_into(tp_scene *scene, size_t number, size_t block,
                                             tp_message *message);

/* Loads that act where their points lie. */
typedef enum tp_placed_load {
  TP_PLACED_PRESSURE,
  TP_PLACED_SURCHARGE,
  TP_PLACED_SUPPORT_PRESSURE,
  TP_PLACED_BOLT, /* or anchor */
  TP_PLACED_FORCE
} tp_placed_load;

/* The block, by its number, that the load added as the `number`th of its kind acts on; without it,
 * those that it lies on. */
TP_MUST_USE tp_status tp_scene_set_load_block(tp_scene *scene, tp_placed_load load, size_t number,
                                              size_t block, tp_message *message);

/* Ask for the force that is needed at the point (x, y) of a block, by its number. Its direction and
 * the factor of safety that it is for have keys, "support.direction_deg" and "support.fos". */
TP_MUST_USE tp_status tp_scene_set_support(tp_scene *scene, size_t block, tp_exact x, tp_exact y,
                                           tp_message *message);

/* The numbers of a scene have keys: the way to them in a scene file, as in friction_angle_deg,
 * block.outline.3.1 (x of the third point) or block.rounded.corners.1.radius, with entries of lists
 * counted from 1; or, of a file, the name of a parameter. A scene built in memory has the keys of
 * what its calls were given (docs/scene_in_memory.md). Calls of this group only read `scene`:
 * threads may make them with one scene at the same time.
 *
 * What a key holds; and all of its digits, as a decimal or a fraction that tp_exact_text takes:
 * `*text` is allocated with malloc and is the caller's to free. */
TP_MUST_USE tp_status tp_scene_number(tp_bounded *number, const tp_scene *scene, const char *key,
                                      tp_message *message);
TP_MUST_USE tp_status tp_scene_number_text(char **text, const tp_scene *scene, const char *key,
                                           tp_message *message);

/* Another scene, in which the number of a key is `value`, exactly, and all else is as in `scene`:
 * what a file says by parameters follows them. The rules are those of the file, or of the call that
 * the number was given by; long chains of points are shared, not copied. Neither scene needs the
 * other: they are changed, and freed, each by itself. */
TP_MUST_USE tp_status tp_scene_with(tp_scene **varied, const tp_scene *scene, const char *key,
                                    tp_exact value, tp_message *message);
/* The same with `count` numbers at once, each of a different key. */
TP_MUST_USE tp_status tp_scene_with_numbers(tp_scene **varied, const tp_scene *scene,
                                            const char *const *keys, const tp_exact *values,
                                            size_t count, tp_message *message);

/* The same by `count` settings "KEY=FORMULA", as `topple solve --set` takes them: each number is
 * what its formula says as if it stood there in the file, in the parameters as all settings leave
 * them. Without parameters, in memory, formulas are of numbers alone, as "3*2". The
 * solution lists what was set (tp_solution.settings). */
TP_MUST_USE tp_status tp_scene_with_settings(tp_scene **varied, const tp_scene *scene,
                                             const char *const *settings, size_t count,
                                             tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
