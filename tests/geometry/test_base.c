/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact of a block with its base against every pair of their edges, in whole numbers
 * (grid_contact.h). The contact of a mated base is also found a second time, by the search that any
 * profile needs. */

#include "base/contact.h"
#include "block/check_ring.h"
#include "geom/geom.h"
#include "grid_contact.h"
#include "suite.h"

#include <stdlib.h>

static random_numbers state;

/* What the facets of a contact restrain; each of its points ends and begins the facets that it
 * says.
 */
static void take_contact(grid_restraints *all, const tp_contact *contact, const grid_figure *f) {
  all->count = 0;
  bool steep = false;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *own = contact->facets + k;
    const grid_point from = grid_point_of(f, own->t0), to = grid_point_of(f, own->t1);
    const bool has_length = !grid_same(grid_point_of(f, own->q0), grid_point_of(f, own->q1));
    steep = steep || (has_length && (to.x <= from.x || labs(to.y - from.y) > to.x - from.x));
    if (own->t0 == own->t1) continue; /* a corner on a corner */
    grid_add(all, grid_point_of(f, own->q0), from, to);
    grid_add(all, grid_point_of(f, own->q1), from, to);
  }
  ck_assert_int_eq(contact->steep, steep);
  for (long k = 0; k < contact->point_count; k++) {
    const tp_contact_point *p = contact->points + k;
    const tp_facet *left = contact->facets + p->left, *right = contact->facets + p->right;
    if (p->left >= 0) ck_assert(grid_same(grid_point_of(f, left->q1), grid_point_of(f, p->point)));
    if (p->right >= 0)
      ck_assert(grid_same(grid_point_of(f, right->q0), grid_point_of(f, p->point)));
  }
}

static void check_equal(const grid_restraints *found, const grid_restraints *truth,
                        const char *what) {
  ck_assert_msg(found->count == truth->count, "%s: %ld, not %ld", what, found->count, truth->count);
  for (long k = 0; k < truth->count; k++)
    ck_assert_msg(grid_contains(found, truth->of[k]), "%s", what);
}

static void check_points(const tp_contact *contact, const grid_restraints *touching,
                         const grid_figure *f) {
  grid_restraints points = {0};
  for (long k = 0; k < contact->point_count; k++) {
    const grid_restraint own = {grid_point_of(f, contact->points[k].point), {0, 0}};
    ck_assert(!grid_contains(&points, own)); /* each once */
    points.of[points.count++] = own;
  }
  check_equal(&points, touching, "points");
}

static tp_status find(tp_contact *contact, tp_lattice *lattice, const tp_section *section,
                      const tp_base *base) {
  fmpq_t metre;
  tp_message message = {.text = ""};
  const tp_polyline *const chains[2] = {section->rings, &base->ring};
  fmpq_init(metre);
  fmpq_one(metre);
  ck_assert_int_eq(tp_lattice_init(lattice, chains, 2, metre, &message), TP_OK);
  fmpq_clear(metre);
  return tp_contact_init(contact, section, NULL, base, lattice, &message);
}

/* A block on a profile: refused where it overlaps the base or lies clear of it, else in contact as
 * its edges are. */
START_TEST(contact_is_that_of_all_pairs_of_edges) {
  enum { ROUNDS = 60000 };
  state = random_numbers_from(71);
  static grid_figure f;
  static grid_restraints truth, touching, found;
  long cut = 0, apart = 0, in_points = 0, on_facets = 0;
  for (int round = 0; round < ROUNDS; round++) {
    tp_polyline ring = {0};
    tp_scene scene = {0};
    tp_base base;
    tp_lattice lattice;
    tp_contact contact;
    tp_message message = {.text = ""};
    grid_draw_outline(&f, &state);
    grid_draw_profile(&scene.base.profile, &state);
    grid_set_ring(&ring, &f);
    const tp_section section = {.ring_count = 1, .rings = &ring};
    if (tp_base_init(&base, &scene, &section, &message) == TP_OK) {
      grid_take_base(&f, &base);
      grid_compare_edges(&truth, &touching, &f);
      const bool overlap = grid_overlaps(&f);
      const tp_status status = find(&contact, &lattice, &section, &base);
      ck_assert_msg((status == TP_OK) == (!overlap && touching.count > 0),
                    "round %d: status %d, overlap %d, %ld points", round, status, overlap,
                    touching.count);
      if (status == TP_OK) {
        take_contact(&found, &contact, &f);
        check_equal(&found, &truth, "restraints");
        check_points(&contact, &touching, &f);
        (*(contact.steepest >= 0 ? &on_facets : &in_points))++;
      } else {
        (*(overlap ? &cut : &apart))++;
      }
      tp_contact_clear(&contact);
      tp_lattice_clear(&lattice);
      tp_base_clear(&base);
    }
    tp_polyline_clear(&scene.base.profile);
    tp_polyline_clear(&ring);
  }
  ck_assert_int_gt(cut, 1000);
  ck_assert_int_gt(apart, 1000);
  ck_assert_int_gt(in_points, 1000);
  ck_assert_int_gt(on_facets, 1000);
}
END_TEST

/* A base that is the counterpart of the whole underside has the contact that the search for edges
 * that meet finds of it, and that all pairs of edges have. */
START_TEST(mated_contact_is_found_by_the_search_too) {
  enum { ROUNDS = 20000 };
  state = random_numbers_from(72);
  static grid_figure f;
  static grid_restraints truth, touching, found, searched;
  for (int round = 0; round < ROUNDS; round++) {
    tp_polyline ring = {0};
    tp_scene scene = {.base = {.mated = true, .whole = true}};
    tp_base base;
    tp_lattice lattice[2];
    tp_contact contact[2];
    tp_message message = {.text = ""};
    fmpq_init(scene.base.beyond_left.value);
    fmpq_init(scene.base.beyond_right.value);
    fmpq_set_si(scene.base.beyond_left.value, draw_below(&state, 3), 1);
    fmpq_set_si(scene.base.beyond_right.value, draw_below(&state, 3), 1);
    grid_draw_outline(&f, &state);
    grid_set_ring(&ring, &f);
    const tp_section section = {.ring_count = 1, .rings = &ring};
    ck_assert_int_eq(tp_base_init(&base, &scene, &section, &message), TP_OK);
    ck_assert(base.mated);
    grid_take_base(&f, &base);
    grid_compare_edges(&truth, &touching, &f);
    ck_assert_int_eq(find(contact, lattice, &section, &base), TP_OK);
    base.mated = false;
    ck_assert_int_eq(find(contact + 1, lattice + 1, &section, &base), TP_OK);
    take_contact(&found, contact, &f);
    take_contact(&searched, contact + 1, &f);
    check_equal(&found, &truth, "mated");
    check_equal(&searched, &truth, "searched");
    check_points(contact, &touching, &f);
    ck_assert_int_eq(contact[0].facet_count, contact[1].facet_count);
    ck_assert_int_eq(contact[0].point_count, contact[1].point_count);
    for (long k = 0; k < contact[0].point_count; k++) {
      const tp_contact_point *one = contact[0].points + k, *other = contact[1].points + k;
      ck_assert(grid_same(grid_point_of(&f, one->point), grid_point_of(&f, other->point)));
      ck_assert_int_eq(one->kind, other->kind);
    }
    for (int k = 0; k < 2; k++) {
      tp_contact_clear(contact + k);
      tp_lattice_clear(lattice + k);
    }
    tp_base_clear(&base);
    tp_polyline_clear(&ring);
    fmpq_clear(scene.base.beyond_left.value);
    fmpq_clear(scene.base.beyond_right.value);
  }
}
END_TEST

static bool append(tp_polyline *line, long x, long y) {
  fmpq_t exact_x, exact_y;
  fmpq_init(exact_x);
  fmpq_init(exact_y);
  fmpq_set_si(exact_x, x, 7);
  fmpq_set_si(exact_y, y, 3);
  const bool done = tp_polyline_append(line, exact_x, exact_y, (tp_mark){0, 0});
  fmpq_clear(exact_x);
  fmpq_clear(exact_y);
  return done;
}

/* Mostly to the right, with upright steps, also several in a row, and now and then back; closed by
 * two corners, not always below all of it. */
static void draw_ground(tp_polyline *ring) {
  const long count = 2 + (long)(draw(&state) % 5);
  long x = 0, y = 0;
  for (long k = 0; k < count; k++) {
    ck_assert(append(ring, x, y));
    const long turn = (long)(draw(&state) % 16), rise = 1 + (long)(draw(&state) % 3);
    x += turn == 0 ? -1 : turn < 8 ? 0 : 1;
    y += draw(&state) % 2 == 0 ? rise : -rise;
  }
  const long floor = draw(&state) % 8 == 0 ? (long)(draw(&state) % 5) - 2 : -40;
  fmpq_t last;
  fmpq_init(last);
  fmpq_mul_si(last, ring->x + count - 1, 7);
  ck_assert(append(ring, fmpz_get_si(fmpq_numref(last)), floor) && append(ring, 0, floor));
  fmpq_clear(last);
}

/* Guards the check of the rock under a profile, which trusts the order of its points: whether the
 * ring is simple is what CGAL's sweep says, and what is not is refused. */
START_TEST(rock_under_a_profile_is_simple_where_the_sweep_says_so) {
  enum { ROUNDS = 20000 };
  long found[2] = {0};
  state = random_numbers_from(16);
  for (int round = 0; round < ROUNDS; round++) {
    tp_polyline ring = {0};
    const tp_polyline *const chains[1] = {&ring};
    tp_lattice lattice;
    tp_message message = {.text = ""};
    fmpq_t metre;
    draw_ground(&ring);
    fmpq_init(metre);
    fmpq_one(metre);
    ck_assert_int_eq(tp_lattice_init(&lattice, chains, 1, metre, &message), TP_OK);
    const size_t start[2] = {0, (size_t)ring.count};
    const tp_geom_rings rings = {1, start, lattice.u, lattice.v, lattice.x, lattice.y, true};
    bool simple = false;
    ck_assert_int_eq(tp_geom_is_simple(&simple, &rings, 0), TP_GEOM_OK);
    const tp_status status = tp_check_ring(&ring, &lattice, 0, false, "the rock", &message);
    ck_assert_msg((status == TP_OK) == simple, "round %d: %s", round, message.text);
    found[simple]++;
    fmpq_clear(metre);
    tp_lattice_clear(&lattice);
    tp_polyline_clear(&ring);
  }
  ck_assert_int_gt(found[0], ROUNDS / 10);
  ck_assert_int_gt(found[1], ROUNDS / 10);
}
END_TEST

SUITE(base) {
  Suite *suite = suite_create("base");
  TCase *cases = tcase_create("base");
  tcase_set_timeout(cases, 300);
  tcase_add_test(cases, contact_is_that_of_all_pairs_of_edges);
  tcase_add_test(cases, mated_contact_is_found_by_the_search_too);
  tcase_add_test(cases, rock_under_a_profile_is_simple_where_the_sweep_says_so);
  suite_add_tcase(suite, cases);
  return suite;
}
