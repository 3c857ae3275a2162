/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boulder of examples/boulder.yaml on springs: its foot has 46 facets, three of which bear it
 * in the end. What springs of a finite stiffness take off the tilt at which it begins to move is
 * bounded by another method that shares no code with them, the quasi-static path
 * (docs/tilt_path.md). */

#include "quasi_static/path.h"
#include "springs_stage.h"
#include "suite.h"

#include <math.h>

static const char boulder[] =
    "topple: 1\nlength_unit: m\nfriction_angle_deg: 35\ntilt: {towards: both}\nblock:\n  "
    "thickness: 2.5\n  unit_weight_kn_m3: 26\n  outline: ["
    "[-1.6, 0.087], [-1.517, 0.093], [-1.483, 0.093], [-1.41, 0.078], [-1.335, 0.053], "
    "[-1.28, 0.052], [-1.229, 0.079], [-1.156, 0.073], [-1.084, 0.013], [-1.026, 0.06], "
    "[-0.944, 0.053], [-0.887, 0.01], [-0.824, 0.025], [-0.736, 0.008], [-0.697, 0.032], "
    "[-0.605, -0.002], [-0.558, -0.02], [-0.498, 0.032], [-0.442, 0.029], [-0.354, -0.019], "
    "[-0.301, 0.017], [-0.214, 0.005], [-0.164, 0.004], [-0.086, 0.001], [-0.029, 0.011], "
    "[0.011, 0.003], [0.083, -0], [0.166, 0.022], [0.211, -0.02], [0.296, 0.022], "
    "[0.37, -0.018], [0.417, -0.001], [0.482, 0.028], [0.55, 0.001], [0.621, -0.008], "
    "[0.698, -0.003], [0.745, 0.034], [0.814, 0.013], [0.867, 0.044], [0.951, 0.066], "
    "[0.998, 0.07], [1.073, 0.071], [1.14, 0.083], [1.2, 0.07], [1.268, 0.05], [1.349, 0.095], "
    "[1.4, 0.094], [3.737, 1.082], [3.862, 1.23], [3.954, 1.391], [4.098, 1.549], "
    "[4.123, 1.707], [4.198, 1.863], [4.044, 2.013], [3.864, 2.152], [3.684, 2.291], "
    "[3.352, 2.431], [3.004, 2.54], [2.694, 2.654], [2.368, 2.764], [2.03, 2.863], "
    "[1.668, 2.923], [1.341, 2.975], [0.962, 3.004], [0.534, 3.044], [0.1, 3.07], "
    "[-0.34, 3.069], [-0.751, 3.039], [-1.142, 3.004], [-1.474, 2.924], [-1.795, 2.874], "
    "[-2.156, 2.75], [-2.448, 2.651], [-2.822, 2.567], [-3.095, 2.414], [-3.454, 2.307], "
    "[-3.706, 2.16], [-3.881, 2.014], [-3.957, 1.866], [-3.984, 1.707], [-3.866, 1.549], "
    "[-3.756, 1.393], [-3.655, 1.236], [-3.505, 1.086]"
    "]\nbase:\n  mated: true\n  between: [[-1.6, 0.087], [1.4, 0.094]]\n"
    "  beyond: {left: 0, right: 0}\n";

typedef struct side {
  tp_direction towards;
  double onset, limit; /* degrees */
} side;

static side side_init(body_stage *s, tp_direction towards) {
  body_stage_init(s, boulder, towards);
  for (size_t k = 0; k < s->solution->case_count; k++) {
    const tp_case *own = s->solution->cases + k;
    if (own->towards != towards) continue;
    return (side){towards, own->onset.critical_angle_deg.value,
                  own->limit.critical_angle_deg.value};
  }
  ck_abort_msg("no case");
}

static double path_softening(const tp_rigid_body *body, const tp_spring_settings *springs) {
  tp_path_settings path = tp_path_settings_default();
  tp_path_result result;
  tp_message message = {.text = ""};
  path.normal_pa_m = springs->normal_pa_m;
  path.shear_pa_m = springs->shear_pa_m;
  path.asks_softening = true;
  ck_assert_msg(tp_path_run(&result, body, &path, NULL, &message) == TP_OK, "%s", message.text);
  ck_assert(result.has_softening);
  return result.softening / radians(1);
}

/* Set down at a tilt; a minute is enough for it to come to rest. */
static tp_run_end end_at(const tp_rigid_body *body, double tilt_deg,
                         const tp_spring_settings *springs, double *way) {
  const tp_drive drive = {.angle = radians(tilt_deg)};
  const tp_run run = {.body = body, .drive = &drive, .longest_s = 60, .until_collapse = true};
  tp_body_state last;
  tp_message message = {.text = ""};
  const tp_run_end end = tp_springs_run(&last, &run, springs, &message);
  *way = hypot(last.moved.x, last.moved.y) + fabs(last.turned) * body->extent_m;
  return end;
}

/* It stands where even the path's softening leaves it a hundredth of a degree to its onset, and
 * begins to move a twentieth beyond its limit: with shear springs a
 * hundredth and a tenth as stiff as the normal ones. Softening goes to zero as the springs grow
 * stiff, and with it all that they can be off. */
START_TEST(what_springs_give_bounds_how_far_they_are_off) {
  static const tp_direction sides[] = {TP_TOWARDS_LEFT, TP_TOWARDS_RIGHT};
  static const double shear_gpa_m[] = {10, 100};
  for (int k = 0; k < 2; k++) {
    body_stage s;
    const side own = side_init(&s, sides[k]);
    for (int j = 0; j < 2; j++) {
      tp_spring_settings springs = paper_springs();
      springs.shear_pa_m = 1e9 * shear_gpa_m[j];
      const double softening = path_softening(&s.body, &springs);
      const double stands = own.onset - softening - 0.01, moves = own.limit + 0.05;
      double way;
      tp_run_end end = end_at(&s.body, stands, &springs, &way);
      ck_assert_msg(end == TP_RUN_STANDS,
                    "side %d, k_s = %g GPa/m: %d at %g degrees, softened by %g", k, shear_gpa_m[j],
                    (int)end, stands, softening);
      end = end_at(&s.body, moves, &springs, &way);
      ck_assert_msg(end == TP_RUN_MOVES, "side %d, k_s = %g GPa/m: %d at %g degrees", k,
                    shear_gpa_m[j], (int)end, moves);
    }
    body_stage_clear(&s);
  }
}
END_TEST

/* Half a degree below its onset the paper's springs give by more than a thousandth of its extent,
 * and hold it: no displacement is a collapse. */
START_TEST(what_gives_by_millimetres_stands) {
  body_stage s;
  const side own = side_init(&s, TP_TOWARDS_LEFT);
  const tp_spring_settings springs = paper_springs();
  double way;
  ck_assert_int_eq(end_at(&s.body, own.onset - 0.5, &springs, &way), TP_RUN_STANDS);
  ck_assert_msg(way > 1e-3 * s.body.extent_m, "it gives by %g m only", way);
  body_stage_clear(&s);
}
END_TEST

SUITE(contact_springs_rough) {
  Suite *suite = suite_create("contact_springs_rough");
  TCase *tests = tcase_create("rough");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, what_springs_give_bounds_how_far_they_are_off);
  tcase_add_test(tests, what_gives_by_millimetres_stands);
  suite_add_tcase(suite, tests);
  return suite;
}
