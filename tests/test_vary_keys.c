/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Every key of a scene in memory: the scene in which its number is another has, byte for byte, the
 * solution of one that is built anew with that number, and of the file that says the same, varied
 * by the same key and written anew. Not one key of the table is left out. */

#include "built_scene.h"

#include "scene/slot_table.h"
#include "scene/slots.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_NUMBERS = 26, TEXT_SIZE = 2000 };

/* A scene of numbers: built, and as text, in which @a is the first of them. */
typedef struct kind {
  void (*build)(tp_scene *scene, const double *n);
  const char *text;
  double numbers[MOST_NUMBERS];
} kind;

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

static void build_corners(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_add_rounded_end(scene, TP_UNDERSIDE_LEFT_END, E(n[0]), &message));
  DO(tp_scene_add_rounded_vertex(scene, E(n[1]), E(n[2]), E(n[3]), &message));
}

static void build_loads(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_seismic_horizontal(scene, E(n[0]), &message));
  DO(tp_scene_set_seismic_vertical(scene, E(n[1]), &message));
  DO(tp_scene_set_water(scene, E(n[2]), E(n[3]), false, true, &message));
  DO(tp_scene_add_pressure(scene, E(n[4]), E(n[5]), E(n[6]), E(n[7]), E(n[8]), E(n[9]), &message));
  DO(tp_scene_add_surcharge(scene, E(n[10]), E(n[11]), E(n[12]), E(n[13]), E(n[14]), &message));
  DO(tp_scene_add_anchor(scene, E(n[15]), E(n[16]), E(n[17]), E(n[18]), false, &message));
  DO(tp_scene_set_bond_kpa(scene, E(n[19]), &message));
  DO(tp_scene_set_cohesion_kpa(scene, E(n[20]), &message));
}

static void build_profile(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_base_profile(scene, tp_coordinates_of(n, 2), &message));
  DO(tp_scene_set_contact_within(scene, E(n[7]), &message));
  DO(tp_scene_set_friction_barton(scene, E(n[4]), E(n[5]), E(n[6]), &message));
}

static void build_between(tp_scene *scene, const double *n) {
  set_square(scene);
  DO(tp_scene_set_base_between(scene, tp_coordinates_of(n, 2), &message));
  DO(tp_scene_set_friction_patton(scene, E(n[4]), E(n[5]), &message));
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

#define HEAD "topple: 1\nlength_unit: m\n"

enum {
  RINGS,
  SLAB,
  TEETH,
  TEETH_OVER,
  ELLIPSE,
  ARCS,
  CORNERS,
  LOADS,
  PROFILE,
  BETWEEN,
  BOUNDS,
  SLOPE
};

static const kind kinds[] = {
    [RINGS] = {build_rings,
               HEAD "block:\n  outline: [[@a, @b], [@c, @d], [@e, @f], [@g, @h]]\n"
                    "  holes: [[[@i, @j], [@k, @l], [@m, @n]]]\n"
                    "  parts: [{outline: [[@o, @p], [@q, @r], [@s, @t]], unit_weight_kn_m3: @u}]\n"
                    "  unit_weight_kn_m3: @v\n  thickness: @w\nfriction_angle_deg: @x\n"
                    "base: {beyond: {left: @y, right: @z}}\n",
               {0, 0,   4,   0,   4,   6,   0, 6,  1,    4, 2,    4, 2,
                5, 2.5, 0.5, 3.5, 0.5, 3.5, 5, 20, 25.5, 2, 31.5, 1, 2}},
    [SLAB] = {build_slab,
              HEAD "block: {slab: {width: @a, height: @b}}\ntilt: {angle_deg: @c}\n",
              {1, 3, 10}},
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
    [PROFILE] = {build_profile,
                 HEAD TEXT_SQUARE "base: {profile: [[@a, @b], [@c, @d]]}\ncontact: {within: @h}\n"
                                  "friction: {law: barton, residual_angle_deg: @e, jrc: @f, "
                                  "jcs_mpa: @g}\n",
                 {-1, 0, 5, 0, 28, 8, 60, 0.25}},
    [BETWEEN] = {build_between,
                 HEAD TEXT_SQUARE "base: {between: [[@a, @b], [@c, @d]]}\nfriction: {law: patton, "
                                  "basic_angle_deg: @e, roughness_angle_deg: @f}\n",
                 {0, 0, 4, 0, 25, 10}},
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
};

/* A key of a kind, the letter of its number, and another one. */
static const struct {
  int kind;
  const char *key;
  char letter;
  double other;
} rows[] = {
    {RINGS, "block.outline.3.1", 'e', 3.75},
    {RINGS, "block.outline.4.2", 'h', 5.5},
    {RINGS, "block.holes.1.2.1", 'k', 2.25},
    {RINGS, "block.holes.1.3.2", 'n', 4.75},
    {RINGS, "block.parts.1.outline.1.1", 'o', 2.25},
    {RINGS, "block.parts.1.outline.3.2", 't', 3},
    {RINGS, "block.parts.1.unit_weight_kn_m3", 'u', 30},
    {RINGS, "block.unit_weight_kn_m3", 'v', 22},
    {RINGS, "block.thickness", 'w', 1.5},
    {RINGS, "friction_angle_deg", 'x', 20},
    {RINGS, "base.beyond.left", 'y', 0},
    {RINGS, "base.beyond.right", 'z', 0},
    {SLAB, "block.slab.width", 'a', 2},
    {SLAB, "block.slab.height", 'b', 2.5},
    {SLAB, "tilt.angle_deg", 'c', 12.5},
    {TEETH, "block.teeth.count", 'a', 5},
    {TEETH, "block.teeth.width", 'b', 1.25},
    {TEETH, "block.teeth.height", 'c', 5},
    {TEETH, "block.teeth.depth", 'd', 0.375},
    {TEETH_OVER, "block.teeth.count", 'a', 5},
    {TEETH_OVER, "block.teeth.block_width", 'b', 4},
    {TEETH_OVER, "block.teeth.mean_height", 'c', 6},
    {TEETH_OVER, "block.teeth.amplitude", 'd', 0.25},
    {ELLIPSE, "block.ellipse.width", 'a', 7},
    {ELLIPSE, "block.ellipse.height", 'b', 4},
    {ELLIPSE, "block.ellipse.flat", 'c', 1},
    {ARCS, "block.arcs.1.from.1", 'a', 3},
    {ARCS, "block.arcs.1.from.2", 'b', 5},
    {ARCS, "block.arcs.1.through.1", 'c', 1.5},
    {ARCS, "block.arcs.1.through.2", 'd', 7.5},
    {ARCS, "block.arcs.2.bulge", 'e', -0.125},
    {CORNERS, "block.rounded.corners.1.radius", 'a', 0.75},
    {CORNERS, "block.rounded.corners.2.radius", 'd', 0.5},
    {CORNERS, "block.rounded.corners.2.at.1", 'b', 0},
    {CORNERS, "block.rounded.corners.2.at.2", 'c', 5},
    {LOADS, "loads.seismic.horizontal", 'a', 0.125},
    {LOADS, "loads.seismic.vertical", 'b', -0.125},
    {LOADS, "loads.water.height", 'c', 2},
    {LOADS, "loads.water.unit_weight_kn_m3", 'd', 10},
    {LOADS, "loads.pressures.1.from.1", 'e', 4.5},
    {LOADS, "loads.pressures.1.from.2", 'f', 2},
    {LOADS, "loads.pressures.1.to.1", 'g', 3.5},
    {LOADS, "loads.pressures.1.to.2", 'h', 4},
    {LOADS, "loads.pressures.1.kpa.1", 'i', 4},
    {LOADS, "loads.pressures.1.kpa.2", 'j', 1},
    {LOADS, "loads.surcharges.1.from.1", 'k', 3.5},
    {LOADS, "loads.surcharges.1.from.2", 'l', 5},
    {LOADS, "loads.surcharges.1.to.1", 'm', 2},
    {LOADS, "loads.surcharges.1.to.2", 'n', 5},
    {LOADS, "loads.surcharges.1.kpa", 'o', 7},
    {LOADS, "loads.anchors.1.at.1", 'p', 0.5},
    {LOADS, "loads.anchors.1.at.2", 'q', 2},
    {LOADS, "loads.anchors.1.direction_deg", 'r', 210},
    {LOADS, "loads.anchors.1.force_kn", 's', 40},
    {LOADS, "loads.bond_kpa", 't', 1},
    {LOADS, "loads.cohesion_kpa", 'u', 4},
    {PROFILE, "contact.within", 'h', 0.125},
    {PROFILE, "base.profile.1.1", 'a', -0.5},
    {PROFILE, "base.profile.2.2", 'd', -1},
    {PROFILE, "friction.residual_angle_deg", 'e', 25},
    {PROFILE, "friction.jrc", 'f', 6},
    {PROFILE, "friction.jcs_mpa", 'g', 50},
    {BETWEEN, "base.between.1.1", 'a', 1},
    {BETWEEN, "base.between.2.1", 'c', 3},
    {BETWEEN, "friction.basic_angle_deg", 'e', 30},
    {BETWEEN, "friction.roughness_angle_deg", 'f', 5},
    {BOUNDS, "base.between.below", 'a', 7},
    {BOUNDS, "base.between.left_of", 'b', 3},
    {BOUNDS, "base.between.right_of", 'c', 0},
    {BOUNDS, "friction.residual_angle_deg", 'd', 30},
    {BOUNDS, "friction.tilt_test.angle_deg", 'e', 55},
    {BOUNDS, "friction.tilt_test.normal_stress_kpa", 'f', 4},
    {SLOPE, "frame.mean_plane.1.2", 'b', -0.125},
    {SLOPE, "frame.mean_plane.2.1", 'c', 5},
    {SLOPE, "friction.roughness_angle_deg", 'f', 8},
};
enum { ROWS = sizeof rows / sizeof rows[0] };

static tp_scene *build(const kind *of, const double *numbers) {
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_tilt_towards(scene, true, false, &message));
  of->build(scene, numbers);
  return scene;
}

static tp_scene *read(const kind *of, const double *numbers) {
  char text[TEXT_SIZE];
  size_t length = 0;
  for (const char *at = of->text; *at != '\0'; at++) {
    if (*at == '@') {
      const double number = numbers[*++at - 'a'];
      length += (size_t)snprintf(text + length, sizeof text - length, "%.17g", number);
    } else {
      text[length++] = *at;
    }
  }
  text[length] = '\0';
  /* both say where it tilts to: one of them as part of the text */
  const char *tilt = strstr(text, "tilt: {");
  if (tilt == NULL) {
    strcat(text, "tilt: {towards: left}\n");
  } else {
    const size_t at = (size_t)(tilt - text) + strlen("tilt: {");
    memmove(text + at + strlen("towards: left, "), text + at, strlen(text + at) + 1);
    memcpy(text + at, "towards: left, ", strlen("towards: left, "));
  }
  tp_scene *scene = NULL;
  DO(tp_scene_read_text(&scene, text, "scene in memory", &message));
  return scene;
}

/* What the scene says: its report, or why there is none. */
static char *say(const tp_scene *scene) {
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  if (tp_solve(&solution, scene, &options, &message) != TP_OK) return strdup(message.text);
  tp_solution_free(solution);
  return solve(scene, 9);
}

/* Says that it was not solved at a place, and what is wrong behind it. */
static void drop_place(char *said) {
  char *wrong = *said != '{' ? strstr(said, ": ") : NULL;
  if (wrong != NULL) memmove(said, wrong, strlen(wrong) + 1);
}

/* The number is there, exactly, and the scene says what the one written anew says. */
static void expect_varied(const tp_scene *scene, const char *key, double number, char *anew,
                          bool same_places) {
  tp_scene *varied = NULL;
  tp_bounded held = {0};
  char *before = say(scene);
  DO(tp_scene_with(&varied, scene, key, E(number), &message));
  DO(tp_scene_number(&held, varied, key, &message));
  ck_assert_msg(held.value == number && held.error == 0, "%s: %.17g", key, held.value);
  char *own = say(varied);
  tp_scene_free(varied);
  expect_equal(before, say(scene));
  if (!same_places) {
    drop_place(own);
    drop_place(anew);
  }
  ck_assert_msg(strcmp(own, anew) == 0, "%s\nvaried: %s\nanew: %s", key, own, anew);
  free(own);
  free(anew);
}

START_TEST(every_key) {
  const kind *of = kinds + rows[_i].kind;
  const char *key = rows[_i].key;
  double numbers[MOST_NUMBERS];
  memcpy(numbers, of->numbers, sizeof numbers);
  numbers[rows[_i].letter - 'a'] = rows[_i].other;
  tp_scene *scene = build(of, of->numbers), *anew = build(of, numbers);
  tp_bounded held = {0};
  DO(tp_scene_number(&held, scene, key, &message));
  ck_assert_msg(held.value == of->numbers[rows[_i].letter - 'a'], "%s: %.17g", key, held.value);
  expect_varied(scene, key, rows[_i].other, say(anew), true);
  if (of->text != NULL) {
    tp_scene *file = read(of, of->numbers), *file_anew = read(of, numbers);
    expect_varied(file, key, rows[_i].other, say(file_anew), true);
    expect_varied(file, key, rows[_i].other, say(anew), false);
    tp_scene_free(file);
    tp_scene_free(file_anew);
  }
  tp_scene_free(scene);
  tp_scene_free(anew);
}
END_TEST

START_TEST(whole_table) {
  bool seen[TP_SLOT_ROWS] = {false};
  for (size_t k = 0; k < ROWS; k++) {
    tp_scene *scene = build(kinds + rows[k].kind, kinds[rows[k].kind].numbers);
    tp_slot slot;
    DO(tp_slot_find(&slot, scene, rows[k].key, &message));
    seen[slot.row - tp_slot_rows] = true;
    tp_scene_free(scene);
  }
  for (size_t k = 0; k < TP_SLOT_ROWS; k++) {
    ck_assert_msg(seen[k], "no test varies %s", tp_slot_rows[k].key);
  }
}
END_TEST

int main(void) {
  Suite *suite = suite_create("vary_keys");
  TCase *tests = tcase_create("keys");
  tcase_set_timeout(tests, 0);
  tcase_add_loop_test(tests, every_key, 0, ROWS);
  tcase_add_test(tests, whole_table);
  suite_add_tcase(suite, tests);
  return run_suite(suite);
}
