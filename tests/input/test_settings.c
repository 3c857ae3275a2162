/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers set by formulas: the scene is that in whose file the formulas stand, and its solution
 * tells what was set and still holds. */

#include "scene/unit.h"
#include "varied_scene.h"

#include <stdlib.h>
#include <string.h>

static tp_scene *set(const tp_scene *scene, const char *const *settings, size_t count) {
  tp_scene *made = NULL;
  DO(tp_scene_with_settings(&made, scene, settings, count, &message));
  return made;
}

/* The report of a solution of the scene without the key `set`; `told` is that. */
static char *solved_but_for(tp_scene *scene, char *told, size_t size) {
  char *json = solved(scene), *begin = strstr(json, "  \"set\": ");
  char *end = begin != NULL ? strstr(begin, "}],\n") : NULL;
  told[0] = '\0';
  if (end == NULL) return json;
  end += 4;
  snprintf(told, size, "%.*s", (int)(end - begin), begin);
  memmove(begin, end, strlen(end) + 1);
  return json;
}

static void expect_told(tp_scene *scene, const char *text, const char *told) {
  char own[1000];
  expect_equal(solved_but_for(scene, own, sizeof own), solved(read_text(text)));
  ck_assert_str_eq(own, told);
}

#define SET(items) "  \"set\": [\n" items "],\n"
#define ITEM(key, text, unit, value)                                                               \
  "    {\"key\": \"" key "\", \"formula\": \"" text "\", \"unit\": " unit                          \
  ", \"value\": {\"value\": " value ", \"error\": 0}}"

/* A formula stands in the file: it follows parameters that are set beside it, or later. */
START_TEST(formulas_follow) {
  static const char *const two[] = {"b=2*a+1", "a=2+2"}, *const later[] = {"a=5"};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  tp_scene *once = set(scene, two, 2), *again = set(once, later, 1);
  tp_scene_free(scene);
  expect_told(once, HEAD PARAMETERS("4", "9", "1") RING REST,
              SET(ITEM("b", "2*a+1", "\"m\"", "9") ",\n" ITEM("a", "2+2", "\"m\"", "4")));
  tp_scene *plain = with(again, "a", E(6));
  expect_told(again, HEAD PARAMETERS("5", "11", "1") RING REST,
              SET(ITEM("b", "2*a+1", "\"m\"", "11") ",\n" ITEM("a", "5", "\"m\"", "5")));
  expect_told(plain, HEAD PARAMETERS("6", "13", "1") RING REST,
              SET(ITEM("b", "2*a+1", "\"m\"", "13")));
}
END_TEST

/* In memory formulas are of numbers alone; what a later call puts there is not told. */
START_TEST(built) {
  static const char *const three[] = {"tilt.angle_deg=25/2", "block.outline.2.1=4",
                                      "block.outline.3.1=2*2"};
  tp_scene *scene = slab(3), *made = set(scene, three, 3), *anew = slab(4);
  tp_scene_free(scene);
  DO(tp_scene_set_tilt_angle_deg(anew, E(12.5), &message));
  tp_scene *other = with(made, "tilt.angle_deg", E(12));
  char told[1000];
  expect_equal(solved_but_for(made, told, sizeof told), solved(anew));
  ck_assert_str_eq(told, SET(ITEM("tilt.angle_deg", "25/2", "null", "12.5") ",\n" ITEM(
                             "block.outline.2.1", "4", "\"m\"",
                             "4") ",\n" ITEM("block.outline.3.1", "2*2", "\"m\"", "4")));
  anew = slab(4);
  DO(tp_scene_set_tilt_angle_deg(anew, E(12), &message));
  expect_equal(solved_but_for(other, told, sizeof told), solved(anew));
  ck_assert_str_eq(told, SET(ITEM("block.outline.2.1", "4", "\"m\"",
                                  "4") ",\n" ITEM("block.outline.3.1", "2*2", "\"m\"", "4")));
}
END_TEST

/* In CSV what was set comes first; a scene in which it was not has an empty field. */
START_TEST(columns) {
  static const char *const two[] = {"friction_angle_deg=31", "block.outline.2.1=3+1/3"};
  tp_scene *scene = slab(3), *made = set(scene, two, 2);
  tp_solution *solutions[2] = {NULL, NULL};
  const tp_solve_options options = tp_solve_options_default();
  DO(tp_solve(solutions, scene, &options, &message));
  DO(tp_solve(solutions + 1, made, &options, &message));
  char *text = NULL;
  const tp_solution *const all[] = {solutions[0], solutions[1]};
  ck_assert_int_eq(tp_report_csv(&text, all, 2), TP_OK);
  static const char head[] = "friction_angle_deg,block.outline.2.1_m,scene,towards,tilt_deg,";
  ck_assert_msg(strncmp(text, head, strlen(head)) == 0, "%s", text);
  ck_assert_ptr_nonnull(strstr(text, "\n,,,left,10,0,"));
  ck_assert_ptr_nonnull(strstr(text, "\n31,3.3333333333333335,,left,10,0,"));
  free(text);
  for (int k = 0; k < 2; k++) tp_solution_free(solutions[k]);
  tp_scene_free(made);
  tp_scene_free(scene);
}
END_TEST

/* Of every kind of key that a scene can have; a parameter is what it stands alone for. */
START_TEST(units) {
  static const char *const lengths[] = {"block.outline.3.1",
                                        "block.holes.1.2.2",
                                        "joint.closure",
                                        "block.parts.1.outline.2.1",
                                        "block.arcs.1.from.2",
                                        "block.rounded.corners.1.radius",
                                        "block.teeth.depth",
                                        "base.profile.7.2",
                                        "base.profile.teeth.start.1",
                                        "base.profile.self_affine.rms_height",
                                        "joint.shift",
                                        "base.profile.noise.deviation",
                                        "base.beyond.left",
                                        "contact.within",
                                        "frame.mean_plane.1.2",
                                        "loads.water.height",
                                        "loads.anchors.1.at.1",
                                        "loads.pressures.1.from.2",
                                        "friction.facets.1.x.2"};
  static const char *const others[] = {"friction_angle_deg",
                                       "friction.jrc",
                                       "friction.jcs_mpa",
                                       "friction.facets.1.angle_deg",
                                       "friction.facets.1.facet",
                                       "tilt.angle_deg",
                                       "block.teeth.count",
                                       "joint.matching",
                                       "block.unit_weight_kn_m3",
                                       "block.arcs.1.bulge",
                                       "base.profile.self_affine.hurst",
                                       "loads.bond_kpa",
                                       "base.profile.self_affine.z2",
                                       "base.profile.noise.seed",
                                       "base.profile.teeth.scatter.wavelength",
                                       "base.profile.scaled.jrc",
                                       "loads.seismic.horizontal",
                                       "loads.pressures.1.kpa.2",
                                       "loads.surcharges.1.kpa",
                                       "loads.anchors.1.force_kn",
                                       "loads.anchors.1.direction_deg"};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST);
  for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++) {
    const char *unit = tp_scene_unit(scene, lengths[k]);
    ck_assert_msg(unit != NULL && strcmp(unit, "m") == 0, "%s", lengths[k]);
  }
  for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
    ck_assert_msg(tp_scene_unit(scene, others[k]) == NULL, "%s", others[k]);
  }
  ck_assert_str_eq(tp_scene_unit(scene, "parameters.c"), "m");
  tp_scene_free(scene);
  scene = read_text(HEAD "parameters: {a: 3, p: 2*a, q: 20}\nblock: {slab: {width: a, height: p}}\n"
                         "friction_angle_deg: q\ntilt: {angle_deg: a}\n");
  ck_assert_ptr_null(tp_scene_unit(scene, "a")); /* a width and a tilt */
  ck_assert_ptr_null(tp_scene_unit(scene, "q"));
  ck_assert_str_eq(tp_scene_unit(scene, "p"), "m");
  tp_scene_free(scene);
}
END_TEST

static void refuse(const tp_scene *scene, const char *const *settings, size_t count,
                   const char *why) {
  tp_scene *made = NULL;
  ck_assert_int_eq(tp_scene_with_settings(&made, scene, settings, count, &message), TP_BAD_INPUT);
  ck_assert_msg(strstr(message.text, why) != NULL, "'%s'", message.text);
  ck_assert_ptr_null(made);
}

/* What is wrong is told by the setting, or where it is the key, by the place of what is there. */
START_TEST(refused) {
  static const char *const cases[][2] = {
      {"a=", "a=: a number"},
      {"a=x", "a=x: unknown name 'x'; define it under 'parameters'"},
      {"a=1/0", "a=1/0: division by zero"},
      {"a=3=4", "a=3=4: '=4' does not continue a number"},
      {"a=1e400", "a=1e400: "},
      {"tilt.angle_deg=91", "tilt.angle_deg=91: angle_deg must lie in [0°, 90°]"},
      {"tilt.angle=91", "scene in memory:6:7: there is no 'angle' here; did you mean 'angle_deg'?"},
      {"tilt.towards=1", "scene in memory:6:17: this is not a number of the scene"}};
  static const char *const twice[] = {"a=1", "parameters.a=2"};
  tp_scene *scene = read_text(HEAD PARAMETERS("3", "6", "1") RING REST), *in_memory = slab(3);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    refuse(scene, &cases[k][0], 1, cases[k][1]);
  }
  refuse(scene, twice, 2, "'parameters.a' is set twice; leave out one of them");
  refuse(in_memory, &cases[5][0], 1, "angle_deg must lie in [0°, 90°]");
  static const char *const unknown = "tilt.angle_deg=a";
  refuse(in_memory, &unknown, 1, "tilt.angle_deg=a: unknown name 'a'");
  tp_scene_free(scene);
  tp_scene_free(in_memory);
}
END_TEST

SUITE(settings) {
  Suite *suite = suite_create("settings");
  TCase *tests = tcase_create("settings");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, formulas_follow);
  tcase_add_test(tests, built);
  tcase_add_test(tests, columns);
  tcase_add_test(tests, units);
  tcase_add_test(tests, refused);
  suite_add_tcase(suite, tests);
  return suite;
}
