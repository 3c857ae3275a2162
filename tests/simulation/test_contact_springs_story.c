/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts on springs that run along a profile and past its end, and the story of block E as its
 * table is tilted. */

#include "springs_stage.h"
#include "suite.h"

#include <math.h>

/* ---- contacts that run along a profile
 * ---------------------------------------------------------------------------- */

/* Without friction a slab runs down a plane of many pieces, of all widths, as down one: no vertex
 * on the way pushes it, and its springs go from piece to piece. */
START_TEST(straight_profile_of_pieces_is_one_plane) {
  body_stage s;
  body_stage_init(&s,
                  SLAB("0", "1",
                       "[-20, 0], [-0.31, 0], [-0.3, 0], [-0.1, 0], [-0.0999, 0], [0.2, 0], [0.7, "
                       "0], [0.71, 0], [20, 0]"),
                  TP_TOWARDS_LEFT);
  spring_outcome o = springs_run_held(&s, 10, 0.8);
  const tp_tilt_moment *p = springs_moment(&o.history, 0.1), *q = springs_moment(&o.history, 0.75);
  const double acceleration = (p->speed_x_m_s - q->speed_x_m_s) / (q->time_s - p->time_s);
  const double truth = TP_GRAVITY_M_S2 * sin(radians(10));
  ck_assert_msg(fabs(acceleration / truth - 1) < 1e-6, "%.9g, not %.9g", acceleration, truth);
  ck_assert(q->moved_x_m < -0.4); /* past five vertices under either corner */
  ck_assert_msg(fabs(q->turned_deg) < 1e-5, "turned by %g", q->turned_deg);
  tp_history_clear(&o.history);
  body_stage_clear(&s);
}
END_TEST

/* The same slab, past the end of its base: the corner of the base takes over from that of the block
 * without a push, and all goes as before until the centroid comes to the end. Then it tips over
 * that, and leaves the base. */
START_TEST(slab_runs_past_the_end_and_leaves) {
  body_stage s;
  body_stage_init(&s, SLAB("0", "0.2", "[0, 0], [20, 0]"), TP_TOWARDS_LEFT);
  spring_outcome o = springs_run_held(&s, 10, 20);
  const double gravity = TP_GRAVITY_M_S2 * sin(radians(10));
  const tp_tilt_moment *q = springs_moment(&o.history, 0.7);
  ck_assert_uint_gt(o.history.moment_count, 5);
  for (const tp_tilt_moment *m = o.history.moments; m < q; m++) {
    ck_assert_msg(fabs(m->turned_deg) < 1e-3, "turned by %g at %g s", m->turned_deg, m->time_s);
    if (m->time_s > 0.1) {
      ck_assert_msg(fabs(-m->speed_x_m_s / (gravity * m->time_s) - 1) < 0.01, "%g at %g s",
                    m->speed_x_m_s, m->time_s);
    }
  }
  ck_assert_int_eq(o.end, TP_RUN_LEFT_BASE);
  const tp_tilt_event *last = o.history.events + o.history.event_count - 1;
  ck_assert_int_eq(last->what, TP_EVENT_LEAVES_BASE);
  tp_history_clear(&o.history);
  body_stage_clear(&s);
}
END_TEST

/* ---- the story of block E towards its valley
 * ------------------------------------------------------------------------ */

/* The tilt at which it happens first from a tilt on, in degrees. */
static double tilt_of(const tp_history *h, tp_tilt_event_kind kind, long facet, double from_deg) {
  for (size_t k = 0; k < h->event_count; k++) {
    const tp_tilt_event *e = h->events + k;
    if (e->what == kind && e->facet == facet && e->angle_deg >= from_deg) return e->angle_deg;
  }
  ck_abort_msg("no event %d at facet %ld from %g degrees on", (int)kind, facet, from_deg);
  return 0;
}

/* As section 4.5 of the paper tells it: the facet on the right opens first; at some 15 degrees (the
 * paper says 14.5) the block turns about the peak in the middle until the left facet takes up load;
 * at 27 the middle one slips (the paper: 26.7 and 27.5), and at the limit the left one too. */
START_TEST(ramp_tells_the_story_of_block_e) {
  body_stage s;
  body_stage_init(&s,
                  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 3, width: 30, height: 120, "
                  "depth: 5, left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\n"
                  "friction_angle_deg: 30\ntilt: {towards: left}\n",
                  TP_TOWARDS_LEFT);
  const double limit = s.solution->cases->limit.critical_angle_deg.value;
  const tp_drive drive = {.speed = radians(2), .final_angle = radians(40)};
  const tp_body_state start = {{0, 0}, 0, {0, 0}, 0};
  spring_outcome o = springs_run(&s, &drive, &start, 15, 0.8, 0);
  const tp_history *h = &o.history;
  const double opens = tilt_of(h, TP_EVENT_OPENS, 3, 0);
  const double turns = tilt_of(h, TP_EVENT_CLOSES, 1, 10);
  const double slips = tilt_of(h, TP_EVENT_SLIPS, 2, turns);
  const double collapses = tilt_of(h, TP_EVENT_COLLAPSES, 0, 0);
  ck_assert_msg(opens > 6 && opens < 8, "the right facet opens at %g degrees", opens);
  ck_assert_msg(turns > 14.5 && turns < 15.5, "the left one closes at %g degrees", turns);
  ck_assert_msg(slips > 26.5 && slips < 27.5, "the middle one slips at %g degrees", slips);
  ck_assert_msg(fabs(collapses - limit) < 0.05, "it collapses at %g degrees", collapses);
  double left[2] = {0, 0}; /* the share of the left facet before it turns, and at 25 degrees */
  const double weight = s.body.mass_kg * TP_GRAVITY_M_S2;
  for (size_t k = 0; k < h->reaction_count; k++) {
    const double angle = h->moments[h->reactions[k].moment].angle_deg;
    if (h->reactions[k].facet != 1) continue;
    if (angle < turns - 0.5) left[0] = h->reactions[k].normal_n / weight;
    if (angle < 25) left[1] = h->reactions[k].normal_n / weight;
  }
  ck_assert_msg(left[0] < 0.15 && left[1] > 0.3, "%g, then %g of the weight", left[0], left[1]);
  for (size_t k = 1; k < h->event_count; k++) {
    ck_assert(h->events[k].time_s >= h->events[k - 1].time_s);
  }
  tp_history_clear(&o.history);
  body_stage_clear(&s);
}
END_TEST

SUITE(contact_springs_story) {
  Suite *suite = suite_create("contact_springs_story");
  TCase *tests = tcase_create("story");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, straight_profile_of_pieces_is_one_plane);
  tcase_add_test(tests, slab_runs_past_the_end_and_leaves);
  tcase_add_test(tests, ramp_tells_the_story_of_block_e);
  suite_add_tcase(suite, tests);
  return suite;
}
