/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rigid body of a scene: its outline against the area and the second moments that the solve
 * proves, its contacts, friction and loads against closed forms and the solve's moments. */

#include "body_stage.h"
#include "rigid_body/drive.h"
#include "rigid_body/history.h"
#include "suite.h"

#include <math.h>
#include <string.h>

#define SLAB                                                                                       \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\n"                                            \
  "block: {outline: [[0, 0], [1, 0], [1, 3], [0, 3]], thickness: 2, unit_weight_kn_m3: 25}\n"

static void close_to(double value, double expected, double share, const char *what) {
  ck_assert_msg(fabs(value - expected) <= share * fabs(expected), "%s: %.17g, not %.17g", what,
                value, expected);
}

/* The area to the left of a boundary: of each edge a half of p x q, of an arc also that of the
 * segment between it and its chord. */
static double area_of(const tp_boundary *b) {
  double area = 0;
  for (long k = 0; k < b->count; k++) {
    const tp_edge *e = b->edges + k;
    area += tp_xy_cross(e->from, e->to) / 2;
    if (!e->arc) continue;
    const tp_xy p = tp_xy_minus(e->from, e->centre), q = tp_xy_minus(e->to, e->centre);
    const double angle = atan2(tp_xy_cross(p, q), tp_xy_dot(p, q));
    area += e->radius * e->radius * (angle - sin(angle)) / 2;
  }
  return area;
}

static void check_closed(const tp_boundary *b) {
  for (long k = 0; k < b->count; k++) {
    const tp_edge *e = b->edges + k, *next = b->edges + (k + 1) % b->count;
    ck_assert(e->to.x == next->from.x && e->to.y == next->from.y);
    if (!e->arc) continue;
    const tp_xy p = tp_xy_minus(e->from, e->centre), q = tp_xy_minus(e->to, e->centre);
    close_to(hypot(p.x, p.y), e->radius, 1e-12, "the radius where an arc begins");
    close_to(hypot(q.x, q.y), e->radius, 1e-12, "the radius where an arc ends");
    ck_assert((tp_xy_cross(p, q) > 0) == !e->inwards);
  }
}

/* Area, mass and inertia as the solve has them. */
static void check_block(const char *text, double share) {
  body_stage s;
  body_stage_init(&s, text, TP_TOWARDS_LEFT);
  const tp_block_result *block = &s.solution->block;
  check_closed(&s.body.outline);
  check_closed(&s.body.base);
  close_to(area_of(&s.body.outline), block->area_m2.value, share, "area");
  const double unit_weight_kn_m3 = s.body.weighed ? 25.8 : 1; /* of mass where none is given */
  const double weight_n = 1000 * unit_weight_kn_m3 * block->area_m2.value * s.body.thickness_m;
  close_to(s.body.mass_kg * TP_GRAVITY_M_S2, weight_n, 1e-14, "weight");
  close_to(s.body.inertia_kg_m2 / s.body.mass_kg,
           (block->second_moment_xx_m4.value + block->second_moment_yy_m4.value) /
               block->area_m2.value,
           1e-13, "radius of gyration");
  close_to(s.body.origin.x, block->centroid_x_m.value, 1e-14, "x of the centroid");
  close_to(s.body.origin.y, block->centroid_y_m.value, 1e-14, "y of the centroid");
  body_stage_clear(&s);
}

START_TEST(slab_is_what_closed_forms_say) {
  body_stage s;
  body_stage_init(&s, SLAB, TP_TOWARDS_LEFT);
  const tp_rigid_body *b = &s.body;
  ck_assert_int_eq(b->outline.count, 4);
  close_to(b->mass_kg, 150000 / TP_GRAVITY_M_S2, 1e-15, "mass");
  close_to(b->inertia_kg_m2, b->mass_kg * 10 / 12, 1e-15, "inertia");
  close_to(b->extent_m, hypot(0.5, 1.5), 1e-15, "extent");
  ck_assert(b->weighed && b->thickness_m == 2 && !b->loads.given);
  ck_assert_int_eq(b->closed_count, 2);
  for (int k = 0; k < 2; k++) {
    const tp_closed_point *p = b->closed + k;
    ck_assert(p->at.x == k - 0.5 && p->at.y == -1.5 && p->share_m == 0.5);
    ck_assert(p->tangent.x == 1 && p->tangent.y == 0 && p->normal.x == 0 && p->normal.y == 1);
    ck_assert_int_eq(p->facet, 1);
    close_to(p->friction, 1 / sqrt(3), 1e-15, "friction");
  }
  ck_assert_int_eq(b->base.count, 4);
  const tp_edge *profile = b->base.edges; /* the rock is on the left, so it runs to the left */
  ck_assert(profile->number == 1 && profile->from.x == 0.5 && profile->to.x == -0.5);
  ck_assert(b->base.edges[1].number == 0 && b->base.edges[1].to.y < -1.5);
  body_stage_clear(&s);
}
END_TEST

START_TEST(outlines_have_the_area_and_the_moments_of_the_solve) {
  check_block("topple: 1\nlength_unit: mm\nfriction_angle_deg: 30\nblock:\n  teeth: {count: 3, "
              "width: 30, height: 120, depth: 5, left_end: valley}\n  thickness: 20\n  "
              "unit_weight_kn_m3: 25.8\n",
              1e-14);
  check_block("topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock:\n  outline: [[0, 0], [2, "
              "0], [2, 3], [0, 3]]\n  rounded: {corners: [{at: left_end, radius: 0.3}, {at: [2, "
              "3], radius: 1}, {at: [0, 3], radius: 1}]}\n",
              1e-14);
  check_block("topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock:\n  outline: [[0, 0], [4, "
              "0], [4, 3], [3, 3], [1, 3], [0, 3]]\n  arcs: [{from: [4, 0], through: [4.5, 1.5]}, "
              "{from: [3, 3], bulge: -0.9}]\n",
              1e-14);
}
END_TEST

START_TEST(ellipse_is_arcs_within_a_ten_millionth) {
  static const double widths[] = {3, 4, 12};
  for (int k = 0; k < 3; k++) {
    char text[200];
    snprintf(text, sizeof text,
             "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {ellipse: {width: %g, "
             "height: 3, flat: 1}}\n",
             widths[k]);
    check_block(text, 1e-7);
    body_stage s;
    body_stage_init(&s, text, TP_TOWARDS_LEFT);
    const double a = widths[k] / 2, b = 1.5, up = s.body.outline.edges[0].from.y;
    const double centre = up + b * sqrt(1 - 0.25 / (a * a));
    double off = 0;
    for (long i = 1; i < s.body.outline.count; i++) {
      const tp_edge *e = s.body.outline.edges + i;
      for (int part = 0; part <= 8; part++) {
        const tp_xy p = tp_xy_minus(e->from, e->centre), q = tp_xy_minus(e->to, e->centre);
        const double turn = atan2(tp_xy_cross(p, q), tp_xy_dot(p, q)) * part / 8;
        const double x = e->centre.x + cos(turn) * p.x - sin(turn) * p.y;
        const double y = e->centre.y + sin(turn) * p.x + cos(turn) * p.y - centre;
        /* distance to first order: f over the size of its gradient */
        const double f = x * x / (a * a) + y * y / (b * b) - 1;
        off = fmax(off, fabs(f) / (2 * hypot(x / (a * a), y / (b * b))));
      }
    }
    ck_assert_msg(off < 1e-7 * widths[k], "width %g: off by %g", widths[k], off);
    body_stage_clear(&s);
  }
}
END_TEST

/* The arcs of an ellipse of 25000 to 1 once turned back near its tips, with radii below zero and
 * bulges as wide as the ellipse. They turn as it does and stay in the triangles of its chords and
 * tangents, which, stretched with it to a circle of 256 pieces, reach from cos(pi / 256) to
 * 1 / cos(pi / 256) of its radius. */
START_TEST(slender_ellipses_have_no_bulges) {
  static const double sizes[][2] = {{40, 1e6}, {1e6, 40}, {3e4, 3}, {1e9, 1}, {1, 1e12}};
  for (int k = 0; k < 5; k++) {
    char text[200];
    snprintf(text, sizeof text,
             "topple: 1\nlength_unit: mm\nfriction_angle_deg: 30\nblock: {ellipse: {width: %g, "
             "height: %g, flat: 0.5}}\n",
             sizes[k][0], sizes[k][1]);
    body_stage s;
    body_stage_init(&s, text, TP_TOWARDS_LEFT);
    const double a = sizes[k][0] / 2000, b = sizes[k][1] / 2000;
    const double up = s.body.outline.edges[0].from.y;
    const double centre = up + b * sqrt(1 - 0.00025 * 0.00025 / (a * a));
    long arcs = 0;
    for (long i = 1; i < s.body.outline.count; i++) {
      const tp_edge *e = s.body.outline.edges + i;
      const tp_xy from = e->from;
      close_to(hypot(from.x / a, (from.y - centre) / b), 1, 1e-4, "stretched radius");
      ck_assert(e->arc == (e->radius != 0) && !e->inwards);
      if (!e->arc) continue;
      arcs++;
      const tp_xy p = tp_xy_minus(from, e->centre), q = tp_xy_minus(e->to, e->centre);
      ck_assert_double_gt(e->radius, 0);
      ck_assert_double_gt(tp_xy_cross(p, q), 0);
    }
    if (k < 3) ck_assert_int_gt(arcs, 500); /* of the others most are straight in doubles */
    body_stage_clear(&s);
  }
}
END_TEST

/* A thousand kilometres away, the coordinates of the scene keep ten digits of the block; those of
 * the body all of them. */
START_TEST(block_far_off_is_the_same_block) {
  body_stage near_by, far_off;
  body_stage_init(&near_by,
                  "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {outline: [[0, 0], "
                  "[0.3, 0.1], [0.9, 0], [0.7, 2.3], [0.1, 2]]}\n",
                  TP_TOWARDS_LEFT);
  body_stage_init(&far_off,
                  "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {outline: [[1000000, "
                  "-1000000], [1000000.3, -999999.9], [1000000.9, -1000000], [1000000.7, "
                  "-999997.7], [1000000.1, -999998]]}\n",
                  TP_TOWARDS_LEFT);
  ck_assert_int_eq(near_by.body.closed_count, far_off.body.closed_count);
  for (long k = 0; k < near_by.body.outline.count; k++) {
    const tp_edge *one = near_by.body.outline.edges + k, *other = far_off.body.outline.edges + k;
    ck_assert(one->from.x == other->from.x && one->from.y == other->from.y);
  }
  for (long k = 0; k < near_by.body.closed_count; k++) {
    const tp_closed_point *one = near_by.body.closed + k, *other = far_off.body.closed + k;
    ck_assert(one->at.x == other->at.x && one->at.y == other->at.y);
    ck_assert(one->tangent.x == other->tangent.x && one->normal.x == other->normal.x);
  }
  ck_assert(near_by.body.inertia_kg_m2 == far_off.body.inertia_kg_m2);
  close_to(far_off.body.origin.x, 1000000 + near_by.body.origin.x, 1e-15, "origin");
  body_stage_clear(&near_by);
  body_stage_clear(&far_off);
}
END_TEST

#define LOADS(k, x, direction, first, last)                                                        \
  "loads:\n  seismic: {horizontal: " k ", vertical: 0.05}\n  water: {height: 1.2, uplift: true}\n" \
  "  anchors: [{at: " x ", direction_deg: " direction ", force_kn: 20}]\n"                         \
  "  pressures: [{from: " first ", to: " last ", kpa: [3, 7]}]\n"

/* The moments of all loads about the governing pivot, as the solve's account of loads has them, are
 * those of the body's loads about the same point. */
START_TEST(loads_turn_the_block_as_in_the_account) {
  static const char *const sides[2] = {"left", "right"};
  for (int side = 0; side < 2; side++) {
    char text[1000];
    snprintf(text, sizeof text, "%s%s%s}\n", SLAB,
             LOADS("0.1", "[0.25, 2]", "200", "[0, 3]", "[0, 1]"),
             "tilt: {angle_deg: 7, towards: ");
    char *end = strrchr(text, '}');
    snprintf(end, 20, "%s}\n", sides[side]);
    body_stage s;
    body_stage_init(&s, text, side == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT);
    ck_assert_uint_eq(s.solution->case_count, 1);
    const tp_case *own = s.solution->cases;
    ck_assert_uint_eq(own->load_count, 7);
    double moment = 0, size = 0;
    for (size_t k = 2; k < own->load_count; k++) { /* behind the weight's two components */
      moment += own->loads[k].moment_nm.value;
      size += fabs(own->loads[k].moment_nm.value);
    }
    const tp_drive drive = {.angle = 7 * acos(-1) / 180};
    tp_rigid_body *b = &s.body;
    const tp_body_force all = tp_drive_force(&drive, b, 0);
    b->loads.given = false;
    const tp_body_force weight = tp_drive_force(&drive, b, 0);
    const tp_pivot *pivot = own->pivots + own->toppling_pivot;
    const double x = b->origin.x - pivot->x_m.value, y = b->origin.y - pivot->y_m.value;
    const double turned = all.moment_nm + x * (all.y_n - weight.y_n) - y * (all.x_n - weight.x_n);
    const double overturning = side == 0 ? turned : -turned;
    ck_assert_msg(fabs(overturning - moment) < 1e-12 * size, "towards the %s: %.17g, not %.17g",
                  sides[side], overturning, moment);
    body_stage_clear(&s);
  }
}
END_TEST

/* A table that goes down to the right is the mirror image of one that goes down to the left, and a
 * base that is shaken moves the block the other way. */
START_TEST(table_drives_the_block) {
  body_stage s;
  body_stage_init(&s, SLAB, TP_TOWARDS_LEFT);
  const tp_drive drive = {.angle = 0.1, .speed = 0.05, .final_angle = 0.3};
  ck_assert(tp_drive_angle(&drive, 2) == 0.1 + 0.05 * 2);
  ck_assert(tp_drive_angle(&drive, 100) == 0.3);
  close_to(tp_drive_next_kink(&drive, 0), 4, 1e-15, "the table stops");
  ck_assert(isinf(tp_drive_next_kink(&drive, 5)));
  const double weight = s.body.mass_kg * TP_GRAVITY_M_S2;
  for (int side = 0; side < 2; side++) {
    s.body.towards = side == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    const tp_body_force f = tp_drive_force(&drive, &s.body, 2);
    close_to(f.x_n, (side == 0 ? -1 : 1) * weight * sin(0.2), 1e-15, "along the base");
    close_to(f.y_n, -weight * cos(0.2), 1e-15, "across it");
    ck_assert(f.moment_nm == 0);
  }
  body_stage_clear(&s);
}
END_TEST

static void steady(double *horizontal_m_s2, double *vertical_m_s2, const tp_base_motion *motion,
                   double time_s) {
  const double *size = motion->data;
  *horizontal_m_s2 = size[0] * time_s;
  *vertical_m_s2 = size[1] * time_s;
}

static double never(const tp_base_motion *motion, double time_s) {
  (void)motion;
  return time_s < 3 ? 3 : INFINITY;
}

/* In the frame of the world what the block feels is gravity less the acceleration of its base. */
START_TEST(shaking_is_felt_as_gravity_the_other_way) {
  body_stage s;
  body_stage_init(&s, SLAB, TP_TOWARDS_LEFT);
  const double size[2] = {1.5, -0.7};
  const tp_base_motion motion = {size, steady, never};
  const tp_drive drive = {.angle = 0.4, .shaking = &motion};
  ck_assert(tp_drive_next_kink(&drive, 1) == 3 && isinf(tp_drive_next_kink(&drive, 3)));
  for (int side = 0; side < 2; side++) {
    s.body.towards = side == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    const tp_body_force f = tp_drive_force(&drive, &s.body, 2);
    /* of the base's axes over the world's: counter-clockwise where the left side goes down */
    const double turned = side == 0 ? 0.4 : -0.4;
    const double horizontal = cos(turned) * f.x_n - sin(turned) * f.y_n;
    const double vertical = sin(turned) * f.x_n + cos(turned) * f.y_n;
    close_to(horizontal, -s.body.mass_kg * 3, 1e-14, "horizontal");
    close_to(vertical, -s.body.mass_kg * (TP_GRAVITY_M_S2 - 1.4), 1e-14, "vertical");
  }
  body_stage_clear(&s);
}
END_TEST

START_TEST(facets_have_their_own_friction) {
  body_stage s;
  body_stage_init(
      &s,
      "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nfriction: {facets: [{facet: 2, "
      "angle_deg: 10}]}\nblock: {teeth: {count: 3, width: 2, height: 8, depth: 1, "
      "left_end: valley}}\nbase: {mated: true, beyond: {left: 2, right: 0}}\n",
      TP_TOWARDS_LEFT);
  const double right = acos(0) / 90;
  for (long k = 0; k < s.body.base.count; k++) {
    const tp_edge *edge = s.body.base.edges + k;
    /* the second facet of the underside is the third of a base that goes on to the left */
    const double degrees = edge->number == 3 ? 10 : 30;
    close_to(s.body.friction[k], tan(degrees * right), 1e-15, "friction of the base");
  }
  /* the base that goes on to the left rises: the block's corner can press into it */
  ck_assert_int_eq(s.body.closed_count, 7);
  for (long k = 0; k < 7; k++) {
    const tp_closed_point *p = s.body.closed + k;
    ck_assert_int_eq(p->facet, k == 0 ? 1 : 2 + (k - 1) / 2);
    close_to(p->friction, tan((p->facet == 3 ? 10 : 30) * right), 1e-15, "friction of a contact");
    ck_assert(k > 0 || p->share_m == 0);
    if (k > 0) close_to(p->share_m, sqrt(5) / 2, 1e-15, "share");
  }
  body_stage_clear(&s);
}
END_TEST

START_TEST(block_moves_and_turns) {
  body_stage s;
  body_stage_init(&s, SLAB, TP_TOWARDS_LEFT);
  const tp_body_state state = {{1, 2}, acos(0), {0.5, -0.5}, 3};
  const tp_xy at = tp_rigid_body_place(&state, (tp_xy){0.5, 1.5});
  const tp_xy speed = tp_rigid_body_velocity(&state, (tp_xy){0.5, 1.5});
  close_to(at.x, 1 - 1.5, 1e-15, "x");
  close_to(at.y, 2 + 0.5, 1e-15, "y");
  close_to(speed.x, 0.5 - 3 * 0.5, 1e-15, "speed along x");
  close_to(speed.y, -0.5 - 3 * 1.5, 1e-15, "speed along y");
  close_to(tp_rigid_body_kinetic_energy(&s.body, &state),
           s.body.mass_kg * (0.5 + 9 * 10 / 12.0) / 2, 1e-15, "kinetic energy");
  body_stage_clear(&s);
}
END_TEST

START_TEST(history_keeps_what_is_appended) {
  enum { MANY = 100 };
  tp_history h = {0};
  for (int k = 0; k < MANY; k++) {
    ck_assert(tp_history_event(&h, (tp_tilt_event){.what = TP_EVENT_SLIPS, .facet = k}));
    ck_assert(tp_history_moment(&h, (tp_tilt_moment){.time_s = k}));
    ck_assert(tp_history_reaction(&h, k, k, -k));
  }
  ck_assert_uint_eq(h.event_count, MANY);
  for (int k = 0; k < MANY; k++) {
    ck_assert(h.events[k].facet == k && h.moments[k].time_s == k);
    ck_assert_uint_eq(h.reactions[k].moment, (size_t)k);
    ck_assert(h.reactions[k].normal_n == k && h.reactions[k].shear_n == -k);
  }
  tp_history_clear(&h);
  ck_assert(h.events == NULL && h.moment_count == 0);
}
END_TEST

START_TEST(what_is_not_simulated_is_refused_in_its_place) {
  static const char *const cases[][2] = {
      {"topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [1, 0], [1, 3]]}\n",
       "give 'friction_angle_deg'"},
      {SLAB "loads: {cohesion_kpa: 3}\n", "scene:5:23: a simulation has no cohesion"},
      {SLAB "loads: {bond_kpa: 3}\n", "leave 'bond_kpa' out"},
      {"topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 25}\n"
       "friction: {law: barton, residual_angle_deg: 25, jrc: 5, jcs_mpa: 20}\n",
       "depends on the normal stress"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_message message = {.text = ""};
    ck_assert_int_eq(body_stage_refused(cases[k][0], &message), TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, cases[k][1]) != NULL, "%s", message.text);
  }
}
END_TEST

SUITE(rigid_body) {
  Suite *suite = suite_create("rigid_body");
  TCase *tests = tcase_create("body");
  tcase_add_test(tests, slab_is_what_closed_forms_say);
  tcase_add_test(tests, outlines_have_the_area_and_the_moments_of_the_solve);
  tcase_add_test(tests, ellipse_is_arcs_within_a_ten_millionth);
  tcase_add_test(tests, slender_ellipses_have_no_bulges);
  tcase_add_test(tests, block_far_off_is_the_same_block);
  tcase_add_test(tests, loads_turn_the_block_as_in_the_account);
  tcase_add_test(tests, table_drives_the_block);
  tcase_add_test(tests, shaking_is_felt_as_gravity_the_other_way);
  tcase_add_test(tests, facets_have_their_own_friction);
  tcase_add_test(tests, block_moves_and_turns);
  tcase_add_test(tests, history_keeps_what_is_appended);
  tcase_add_test(tests, what_is_not_simulated_is_refused_in_its_place);
  suite_add_tcase(suite, tests);
  return suite;
}
