/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is excluded is excluded of the true body and load, wherever contacts are
 * (solid_contacts/solid_exclusion.h).
 *
 * A box in a groove rests on two contacts at x = -3 and two at x = 3, 1 below its centroid. Normals
 * are (0, -+3, 4), so that N along each bears 4/5 N; with mu1 and mu2 it begins to slide along x at
 * the tangent (mu1 + mu2) / 2 / (4/5 - (mu2 - mu1) / 6), as the lower end bears more. A contact
 * without friction far away at x < 0 keeps it from moving back, and does nothing else. Listed
 * first, it is the origin of all moments: the centroid, once rounded to 2^-51 of the way from
 * there, and the load count with their exact values or their errors.
 */

#include "solid_contacts/solid_exclusion.h"
#include "suite.h"

#include <math.h>

enum { CONTACTS = 5, FAR_BITS = 8 };

static void set_contact(tp_friction_cone *cone, const double at[3], double shift,
                        const double normal[3], double mu) {
  fmpq_t part;
  fmpq_init(part);
  for (int k = 0; k < 3; k++) {
    tp_hold_double(cone->at + k, at[k]);
    if (k == 0) {
      tp_hold_double(part, shift);
      fmpq_add(cone->at + k, cone->at + k, part);
    }
    fmpq_div_2exp(cone->at + k, cone->at + k, FAR_BITS); /* the farthest is about one away */
    tp_hold_double(cone->normal + k, normal[k]);
  }
  fmpq_clear(part);
  tp_friction_cone_settle(cone, (tp_near){mu, mu * DBL_EPSILON});
}

/* Of a cube of the side 2, over its mass. */
static void set_inertia(fmpq inertia[6]) {
  for (int k = 0; k < 6; k++) {
    fmpq_init(inertia + k);
    if (k < 3) fmpq_set_si(inertia + k, 1, 3);
    fmpq_div_2exp(inertia + k, inertia + k, 2 * FAR_BITS);
  }
}

static bool is_excluded(double far, double shift, double mu1, double mu2, double tangent,
                        double error) {
  const double lower[2] = {mu1, mu2};
  tp_friction_cones cones;
  fmpq inertia[6];
  tp_solid_exclusion own = {.cones = &cones, .inertia = inertia, .divisor = 1, .most = 4000};
  ck_assert(tp_friction_cones_init(&cones, CONTACTS));
  set_contact(cones.cones, (double[]){-far, 0, 0}, shift, (double[]){1, 0, 0}, 0);
  for (int n = 0; n < CONTACTS - 1; n++) {
    const double side = n % 2 == 0 ? -1 : 1;
    set_contact(cones.cones + n + 1, (double[]){n < 2 ? -3 : 3, side, -1}, 0,
                (double[]){0, -3 * side, 4}, lower[n / 2]);
  }
  set_inertia(inertia);
  for (int k = 0; k < 2; k++) {
    tp_hold_load_init(own.loads + k);
    tp_hold_double(own.loads[k].exact, tangent);
    fmpq_set_si(own.loads[k].exact + 2, -1, 1);
    own.loads[k].error[0] = error;
    tp_hold_load_settle(own.loads + k);
  }
  ck_assert(tp_solid_exclusion_find(&own));
  for (int k = 0; k < 2; k++) tp_hold_load_clear(own.loads + k);
  for (int k = 0; k < 6; k++) fmpq_clear(inertia + k);
  tp_friction_cones_clear(&cones);
  return own.is_excluded;
}

static double onset(double mu1, double mu2) {
  return (mu1 + mu2) / 2 / (4.0 / 5 - (mu2 - mu1) / 6);
}

START_TEST(a_far_contact_moves_no_centroid) {
  const double far = ldexp(1, FAR_BITS), shifts[] = {0, 0.24, -0.24, 0.12, -0.12};
  const double mu[2][2] = {{0.1, 0.8}, {0.8, 0.1}};
  for (int m = 0; m < 2; m++) {
    const double truth = onset(mu[m][0], mu[m][1]);
    for (size_t k = 0; k < sizeof shifts / sizeof *shifts; k++) {
      ck_assert(is_excluded(far, shifts[k], mu[m][0], mu[m][1], 0.5 * truth, 0));
      ck_assert(!is_excluded(far, shifts[k], mu[m][0], mu[m][1], 1.001 * truth, 0));
      ck_assert(!is_excluded(far, shifts[k], mu[m][0], mu[m][1], 1.04 * truth, 0));
    }
  }
}
END_TEST

/* Loads within their errors are excluded all together. */
START_TEST(loads_count_with_their_errors) {
  const double truth = onset(0.3, 0.4);
  ck_assert(is_excluded(3, 0, 0.3, 0.4, 0.8 * truth, 0));
  ck_assert(is_excluded(3, 0, 0.3, 0.4, 0.8 * truth, 1e-12));
  ck_assert(!is_excluded(3, 0, 0.3, 0.4, 0.8 * truth, 0.21 * truth));
}
END_TEST

SUITE(solid_exclusion) {
  Suite *suite = suite_create("solid_exclusion");
  TCase *cases = tcase_create("solid_exclusion");
  tcase_add_test(cases, a_far_contact_moves_no_centroid);
  tcase_add_test(cases, loads_count_with_their_errors);
  suite_add_tcase(suite, cases);
  return suite;
}
