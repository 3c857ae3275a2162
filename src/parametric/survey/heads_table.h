/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the head of a column of a survey means by a short name, a row each. To be reviewed without
 * knowing C.
 *
 *   ROW(kind, word, key)
 *
 * A head is read in small letters, with _ for blanks and hyphens, without the unit in brackets or
 * behind an _ at its end. KEY: a key of a scene; NAME, SCENE, CASE, OUTLINE: as survey.h tells;
 * PLANE: dip and dip direction in one field, PLANE_REVERSED: dip direction and dip; PASSED: a note
 * of the survey. */

#ifndef TP_SURVEY_HEADS_TABLE_H
#define TP_SURVEY_HEADS_TABLE_H

#define TP_SURVEY_HEADS(ROW)                                                                       \
  ROW(NAME, "name", "title")                                                                       \
  ROW(NAME, "block", "title")                                                                      \
  ROW(NAME, "id", "title")                                                                         \
  ROW(NAME, "title", "title")                                                                      \
  ROW(SCENE, "scene", "")                                                                          \
  ROW(SCENE, "template", "")                                                                       \
  ROW(CASE, "case", "")                                                                            \
  ROW(CASE, "load_case", "")                                                                       \
  ROW(OUTLINE, "outline", "")                                                                      \
  ROW(OUTLINE, "drawing", "")                                                                      \
  ROW(OUTLINE, "file", "")                                                                         \
  ROW(KEY, "width", "block.slab.width")                                                            \
  ROW(KEY, "height", "block.slab.height")                                                          \
  ROW(KEY, "thickness", "block.thickness")                                                         \
  ROW(KEY, "unit_weight", "block.unit_weight_kn_m3")                                               \
  ROW(KEY, "dip", "slope.dip_deg")                                                                 \
  ROW(KEY, "dip_direction", "slope.dip_direction_deg")                                             \
  ROW(PLANE, "dip/dip_direction", "slope.dip_deg")                                                 \
  ROW(PLANE, "dip/dipdirection", "slope.dip_deg")                                                  \
  ROW(PLANE, "dip/dip_dir", "slope.dip_deg")                                                       \
  ROW(PLANE, "dip/dipdir", "slope.dip_deg")                                                        \
  ROW(PLANE, "dip/direction", "slope.dip_deg")                                                     \
  ROW(PLANE, "dip/dir", "slope.dip_deg")                                                           \
  ROW(PLANE, "dip/azimuth", "slope.dip_deg")                                                       \
  ROW(PLANE_REVERSED, "dip_direction/dip", "slope.dip_deg")                                        \
  ROW(PLANE_REVERSED, "dipdirection/dip", "slope.dip_deg")                                         \
  ROW(PLANE_REVERSED, "dip_dir/dip", "slope.dip_deg")                                              \
  ROW(PLANE_REVERSED, "dipdir/dip", "slope.dip_deg")                                               \
  ROW(PLANE_REVERSED, "direction/dip", "slope.dip_deg")                                            \
  ROW(PLANE_REVERSED, "dir/dip", "slope.dip_deg")                                                  \
  ROW(PLANE_REVERSED, "azimuth/dip", "slope.dip_deg")                                              \
  ROW(KEY, "strike", "slope.strike_deg")                                                           \
  ROW(KEY, "towards", "slope.towards")                                                             \
  ROW(KEY, "tilt", "tilt.angle_deg")                                                               \
  ROW(KEY, "friction", "friction_angle_deg")                                                       \
  ROW(KEY, "friction_angle", "friction_angle_deg")                                                 \
  ROW(KEY, "phi", "friction_angle_deg")                                                            \
  ROW(KEY, "cohesion", "loads.cohesion_kpa")                                                       \
  ROW(KEY, "water", "loads.water.height")                                                          \
  ROW(KEY, "water_height", "loads.water.height")                                                   \
  ROW(KEY, "seismic", "loads.seismic.horizontal")                                                  \
  ROW(KEY, "seismic_coefficient", "loads.seismic.horizontal")                                      \
  ROW(KEY, "kh", "loads.seismic.horizontal")                                                       \
  ROW(KEY, "k_h", "loads.seismic.horizontal")                                                      \
  ROW(KEY, "kv", "loads.seismic.vertical")                                                         \
  ROW(KEY, "k_v", "loads.seismic.vertical")                                                        \
  ROW(KEY, "required_factor", "required_fos")                                                      \
  ROW(KEY, "unit", "length_unit")                                                                  \
  ROW(PASSED, "note", "")                                                                          \
  ROW(PASSED, "notes", "")                                                                         \
  ROW(PASSED, "remark", "")                                                                        \
  ROW(PASSED, "remarks", "")                                                                       \
  ROW(PASSED, "comment", "")                                                                       \
  ROW(PASSED, "comments", "")                                                                      \
  ROW(PASSED, "date", "")                                                                          \
  ROW(PASSED, "photo", "")                                                                         \
  ROW(PASSED, "surveyor", "")                                                                      \
  ROW(PASSED, "location", "")                                                                      \
  ROW(PASSED, "station", "")                                                                       \
  ROW(PASSED, "easting", "")                                                                       \
  ROW(PASSED, "northing", "")                                                                      \
  ROW(PASSED, "elevation", "")

/* Units of a head that are not those of the key, and by what a number is multiplied: X(unit of the
 * key, unit of the head, factor). */
#define TP_SURVEY_UNITS(X)                                                                         \
  X("kPa", "pa", "(1/1000)")                                                                       \
  X("kPa", "mpa", "(1000)")                                                                        \
  X("MPa", "kpa", "(1/1000)")                                                                      \
  X("kN", "n", "(1/1000)")                                                                         \
  X("kN", "mn", "(1000)")                                                                          \
  X("kN/m3", "mn/m3", "(1000)")                                                                    \
  X("kN/m3", "n/m3", "(1/1000)")

/* Lengths in metres: X(unit, exact). */
#define TP_SURVEY_LENGTHS(X)                                                                       \
  X("mm", "(1/1000)")                                                                              \
  X("cm", "(1/100)")                                                                               \
  X("m", "(1)")                                                                                    \
  X("km", "(1000)")                                                                                \
  X("in", "(254/10000)")                                                                           \
  X("ft", "(3048/10000)")

#endif
