/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Angles of a scene that look as if they stood in radians, or were a quotient.
 *
 * Friction of rock on rock lies above 2 degrees, clay seams included, and is below 1.57 in radians;
 * zero is an ideal and meant. A table or a joint at less than 1 degree is next to level, while all
 * tilts up to 57 degrees are below 1 in radians. A slope that a block slides on, a face and the end
 * of a tilt test are steeper than 1.571 degrees, which is a right angle in radians. An azimuth is
 * measured to a tenth of a degree at most: one below a full turn in radians with more digits is
 * likely in them. A scatter, a tolerance and a speed may be as small as they are. */

#include "scene/unit_cautions.h"

static const double degrees = 57.295779513082321; /* of a radian */

/* In thousandths of a degree. */
static const long of_friction = 2000, of_tilt = 1000, right_angle = 1571, full_turn = 6284;
static const long least_azimuth = 10; /* in radians half a degree: what is less is none either */

static tp_status add(tp_notes *notes, const tp_quantity *angle, const char *what,
                     tp_message *message) {
  const double given = fmpq_get_d(angle->value);
  return tp_notes_add(notes, message, TP_CAUTION, angle->place,
                      "%s of %.6g° is implausible; if it is in radians, write %.4g", what, given,
                      given * degrees);
}

/* Is its size above zero and below this number of thousandths? */
static bool is_below(const tp_quantity *angle, long thousandths) {
  fmpq_t size;
  fmpq_init(size);
  fmpq_abs(size, angle->value);
  fmpq_mul_si(size, size, 1000);
  const bool below = angle->given && !fmpq_is_zero(size) && fmpq_cmp_si(size, thousandths) < 0;
  fmpq_clear(size);
  return below;
}

/* Is it an azimuth as it is measured, to a tenth of a degree, or next to nothing? */
static bool is_azimuth(const tp_quantity *angle) {
  fmpq_t tenths;
  fmpq_init(tenths);
  fmpq_mul_si(tenths, angle->value, 10);
  const bool is = fmpz_is_one(fmpq_denref(tenths)) || is_below(angle, least_azimuth);
  fmpq_clear(tenths);
  return is;
}

/* An angle of a scene, and below how many thousandths of a degree it is implausible. */
typedef struct suspect {
  const tp_quantity *angle;
  long least;
  const char *what;
} suspect;

static tp_status check_all(tp_notes *notes, const suspect *all, size_t count, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    const bool azimuth = all[k].least == full_turn && is_azimuth(all[k].angle);
    if (!is_below(all[k].angle, all[k].least) || azimuth) continue;
    status = add(notes, all[k].angle, all[k].what, message);
  }
  return status;
}

#define CHECK_ALL(all) check_all(notes, all, sizeof(all) / sizeof(all)[0], message)

static const char a_friction_angle[] = "a friction angle", a_tilt[] = "a tilt", a_dip[] = "a dip",
                  an_azimuth[] = "an azimuth", a_direction[] = "a direction";

tp_status tp_scene_friction_caution(tp_notes *notes, const tp_quantity *angle,
                                    tp_message *message) {
  const suspect one[] = {{angle, of_friction, a_friction_angle}};
  return CHECK_ALL(one);
}

tp_status tp_scene_azimuth_caution(tp_notes *notes, const tp_quantity *azimuth,
                                   tp_message *message) {
  const suspect one[] = {{azimuth, full_turn, an_azimuth}};
  return CHECK_ALL(one);
}

/* By Patton's law the angle of the scene is the sum of a basic angle and that of the roughness. */
static void set_basic_angle(tp_quantity *basic, const tp_scene *scene) {
  const tp_friction_description *friction = &scene->friction;
  *basic = (tp_quantity){.given = scene->friction_angle_deg.given,
                         .place = scene->friction_angle_deg.place};
  fmpq_init(basic->value);
  fmpq_set(basic->value, scene->friction_angle_deg.value);
  if (!friction->load_dependent && friction->roughness_angle_deg.given) {
    fmpq_sub(basic->value, basic->value, friction->roughness_angle_deg.value);
  }
}

static tp_status check_friction(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_friction_description *friction = &scene->friction;
  tp_quantity basic;
  set_basic_angle(&basic, scene);
  const suspect all[] = {{&basic, of_friction, a_friction_angle},
                         {&friction->test_angle_deg, of_friction, a_tilt},
                         {&friction->roughness_angle_deg, of_tilt, "a roughness angle"}};
  tp_status status = CHECK_ALL(all);
  fmpq_clear(basic.value);
  for (long k = 0; k < friction->facet_count && status == TP_OK; k++) {
    status = tp_scene_friction_caution(notes, &friction->facets[k].angle_deg, message);
  }
  return status;
}

static tp_status check_place(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const suspect all[] = {{&scene->tilt_angle_deg, of_tilt, a_tilt},
                         {&scene->tilt_azimuth_deg, full_turn, an_azimuth},
                         {&scene->slope.dip_deg, right_angle, a_dip},
                         {&scene->slope.dip_direction_deg, full_turn, an_azimuth},
                         {&scene->slope.strike_deg, full_turn, an_azimuth},
                         {&scene->tilt_test.until_deg, right_angle, a_tilt},
                         {&scene->loads.azimuth_deg, full_turn, an_azimuth}};
  return CHECK_ALL(all);
}

static tp_status check_pulls(tp_notes *notes, const tp_anchor_description *pulls, long count,
                             tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    const suspect all[] = {{&pulls[k].dip_deg, of_tilt, a_dip},
                           {&pulls[k].direction_deg, full_turn, a_direction},
                           {&pulls[k].azimuth_deg, full_turn, an_azimuth}};
    status = CHECK_ALL(all);
  }
  return status;
}

static tp_status check_many(tp_notes *notes, const tp_block_list *many, tp_message *message) {
  const tp_columns_description *columns = &many->columns;
  const tp_jointed_slope *slope = &many->slope;
  const suspect all[] = {{&many->support.direction_deg, full_turn, a_direction},
                         {&columns->face_dip_deg, right_angle, a_dip},
                         {&columns->upper_dip_deg, of_tilt, a_dip},
                         {&columns->base_dip_deg, right_angle, a_dip},
                         {&slope->face_dip_deg, right_angle, a_dip},
                         {&slope->upper_dip_deg, of_tilt, a_dip},
                         {&slope->base.dip_deg, of_tilt, a_dip},
                         {&slope->tread_dip_deg, of_tilt, a_dip}};
  tp_status status = CHECK_ALL(all);
  for (long k = 0; k < slope->set_count && status == TP_OK; k++) {
    const suspect set[] = {{&slope->sets[k].dip_deg, of_tilt, a_dip}};
    status = CHECK_ALL(set);
  }
  return status;
}

static tp_status check_wedge(tp_notes *notes, const tp_wedge_description *wedge,
                             tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < TP_WEDGE_PLANES && status == TP_OK; k++) {
    const long least = k == TP_WEDGE_UPPER ? of_tilt : right_angle;
    const suspect all[] = {{&wedge->planes[k].dip_deg, least, a_dip},
                           {&wedge->planes[k].dip_direction_deg, full_turn, an_azimuth}};
    status = CHECK_ALL(all);
  }
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    status = tp_scene_friction_caution(notes, &wedge->friction_deg[k], message);
  }
  return status;
}

static tp_status check_solid(tp_notes *notes, const tp_solid_description *solid,
                             tp_message *message) {
  const suspect all[] = {{&solid->dip_deg, right_angle, a_dip},
                         {&solid->dip_direction_deg, full_turn, an_azimuth}};
  tp_status status = CHECK_ALL(all);
  for (long k = 0; k < solid->contact_count && status == TP_OK; k++) {
    status = tp_scene_friction_caution(notes, &solid->contacts[k].friction_angle_deg, message);
  }
  return status == TP_OK ? check_wedge(notes, &solid->wedge, message) : status;
}

tp_status tp_scene_angle_cautions(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  tp_status status = check_friction(notes, scene, message);
  if (status == TP_OK) status = check_place(notes, scene, message);
  if (status == TP_OK) status = check_pulls(notes, loads->anchors, loads->anchor_count, message);
  if (status == TP_OK) status = check_pulls(notes, loads->forces, loads->force_count, message);
  if (status == TP_OK) status = check_many(notes, &scene->many, message);
  return status == TP_OK ? check_solid(notes, &scene->solid, message) : status;
}
