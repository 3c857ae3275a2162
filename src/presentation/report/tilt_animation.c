/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The test as an SVG that moves, over and over, by declarative animation that needs no script: the
 * table turns, and on it the block. A motion takes as long as it took, or is slowed down or
 * hastened to between 2 and 12 seconds, and the drawing says by how much. */

#include "common/host.h"
#include "report/tilt_course.h"
#include "report/words.h"

#include <math.h>

/* Nine tenths of the time it moves; then it stands still. */
static void add_times(tp_text *t, const tp_tilt_course *c) {
  const tp_tilt_case *own = c->view->own;
  tp_text_add(t, " dur=\"%.3fs\" repeatCount=\"indefinite\" keyTimes=\"", c->seconds / 0.9);
  double last = 0;
  for (size_t k = 0; k < own->moment_count; k++) {
    const double span = c->to - c->from;
    const double share =
        span > 0 ? 0.9 * (tp_tilt_course_at(c, own->moments + k) - c->from) / span : 0;
    last = fmin(0.9, fmax(last, share));
    tp_text_add(t, "%s%.6f", k > 0 ? ";" : "", k == 0 ? 0 : last);
  }
  tp_text_add(t, ";1\"/>\n");
}

static void add_value(tp_text *t, const tp_tilt_course *c, const tp_tilt_moment *m, int what) {
  const double scale = c->view->scale;
  if (what == 0) tp_text_add(t, "%.4f", tp_tilt_view_turn(c->view, m->angle_deg));
  if (what == 1) tp_text_add(t, "%.3f %.3f", scale * m->moved_x_m, -scale * m->moved_y_m);
  if (what == 2) tp_text_add(t, "%.4f", -m->turned_deg);
}

/* 0: the turn of the table, 1: the displacement of the block, 2: its turn. */
static void add_motion(tp_text *t, const tp_tilt_course *c, int what) {
  const tp_tilt_case *own = c->view->own;
  if (own->moment_count < 2) return;
  tp_text_add(t,
              "<animateTransform attributeName=\"transform\" additive=\"sum\" type=\"%s\" "
              "values=\"",
              what == 1 ? "translate" : "rotate");
  for (size_t k = 0; k < own->moment_count; k++) {
    if (k > 0) tp_text_add(t, ";");
    add_value(t, c, own->moments + k, what);
  }
  tp_text_add(t, ";");
  add_value(t, c, own->moments + own->moment_count - 1, what);
  tp_text_add(t, "\"");
  add_times(t, c);
}

static void add_case(tp_text *t, const tp_tilt_test *test, const tp_tilt_view *view, double left) {
  const tp_tilt_case *own = view->own;
  const tp_tilt_course c = tp_tilt_course_of(view, test->settings.engine != TP_TILT_PATH);
  tp_text_add(t, "<text x=\"%.2f\" y=\"18\">%s: %s", left + 8, tp_text_table(test, own),
              tp_tilt_end_name(own->end));
  if (c.timed && c.to > c.from) {
    tp_text_add(t, " (%.3g times real time)", (c.to - c.from) / c.seconds);
  }
  tp_text_add(t, "</text>\n");
  tp_text_add(t,
              "<svg x=\"%.2f\" y=\"26\" width=\"%.2f\" height=\"%.2f\" viewBox=\"%.2f %.2f %.2f "
              "%.2f\">\n<g>\n",
              left, view->width, view->height, view->left, view->top, view->width, view->height);
  add_motion(t, &c, 0);
  tp_text_add(t, "<path fill=\"#d8d0c4\" stroke=\"#5b5346\" d=\"");
  tp_tilt_svg_ring(t, view, own->base, own->base_count);
  tp_text_add(t, "\"/>\n<g>\n");
  add_motion(t, &c, 1);
  tp_text_add(t, "<g>\n");
  add_motion(t, &c, 2);
  tp_text_add(t, "<path fill=\"#7aa6c2\" stroke=\"#1d3b4d\" stroke-width=\"1.5\" d=\"");
  tp_tilt_svg_ring(t, view, own->outline, own->outline_count);
  tp_text_add(t, "\"/>\n</g>\n</g>\n</g>\n</svg>\n");
}

tp_status tp_report_tilt_animation(char **text, const tp_tilt_test *test) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, test);
  tp_text t = {0};
  double width = 0, height = 0;
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + k);
    width += view.width;
    height = fmax(height, view.height + 26);
  }
  tp_tilt_svg_begin(&t, width, height);
  double left = 0;
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + k);
    add_case(&t, test, &view, left);
    left += view.width;
  }
  tp_text_add(&t, "</svg>\n");
  return tp_text_finish(&t, text);
}
