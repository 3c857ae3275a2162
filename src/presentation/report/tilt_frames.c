/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The block at some moments of its test, side by side, as Figs. 12 and 13 of the paper show it: the
 * first, then by even parts of the way that it moves and turns. A direction a row. */

#include "common/host.h"
#include "output/translate.h"
#include "report/tilt_svg.h"
#include "report/tilt_turn.h"
#include "report/words.h"

#include <math.h>

size_t tp_tilt_frames_choose(size_t chosen[TP_TILT_FRAMES], const tp_tilt_view *view) {
  const size_t count = view->moments;
  if (count == 0) return 0;
  double all = 0;
  for (size_t k = 1; k < count; k++) all += tp_tilt_view_way(view, k);
  size_t found = 0;
  chosen[found++] = 0;
  double way = 0;
  for (size_t k = 1; k < count && found < TP_TILT_FRAMES; k++) {
    way += tp_tilt_view_way(view, k);
    if (way >= all * (double)found / (TP_TILT_FRAMES - 1) * (1 - 1e-9)) chosen[found++] = k;
  }
  return found;
}

static void tell(tp_text *t, tp_text *english, const tp_language *language, bool comma) {
  t->failed = t->failed || english->failed;
  if (english->data != NULL) tp_translate(t, language, comma, english->data);
  tp_text_drop(english);
}

void tp_tilt_frames_head(tp_text *t, const tp_tilt_test *test, const tp_tilt_case *own,
                         const tp_language *language, bool comma) {
  tp_text english = {0};
  tp_text_add(&english, "%s, %s: %s", tp_text_table(test, own),
              tp_tilt_engine_name(test->settings.engine), tp_tilt_end_name(own->end));
  tell(t, &english, language, comma);
}

void tp_tilt_frames_foot(tp_text *t, const tp_tilt_test *test, const tp_tilt_moment *m,
                         const tp_language *language, bool comma) {
  tp_text english = {0};
  tp_text_add(&english, "tilt %.2f°", m->angle_deg);
  if (test->settings.engine != TP_TILT_PATH) tp_text_add(&english, ", %.3g s", m->time_s);
  tell(t, &english, language, comma);
}

/* What the drawing is of, and in which language. */
typedef struct telling {
  const tp_tilt_test *test;
  const tp_language *language;
  bool comma;
} telling;

static void add_frame(tp_text *t, const tp_tilt_view *view, const tp_tilt_moment *m, double left,
                      double top, const telling *own_words) {
  const tp_tilt_case *own = view->own;
  const double turn = tp_tilt_view_turn(view, m->angle_deg);
  tp_text_add(t,
              "<svg x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" viewBox=\"%.2f %.2f %.2f "
              "%.2f\">\n<g transform=\"rotate(%.4f)\">\n<path fill=\"#d8d0c4\" stroke=\"#5b5346\" "
              "d=\"",
              left, top, view->width / 2, view->height / 2, view->left, view->top, view->width,
              view->height, turn);
  tp_tilt_svg_ring(t, view, own->base, own->base_count);
  tp_text_add(t, "\"/>\n<path fill=\"none\" stroke=\"#9aa4ad\" stroke-dasharray=\"4 3\" d=\"");
  tp_tilt_svg_ring(t, view, own->outline, own->outline_count);
  tp_text_add(t,
              "\"/>\n<path transform=\"translate(%.3f %.3f) rotate(%.4f)\" fill=\"#7aa6c2\" "
              "fill-opacity=\"0.85\" stroke=\"#1d3b4d\" stroke-width=\"1.5\" d=\"",
              view->scale * m->moved_x_m, -view->scale * m->moved_y_m, -m->turned_deg);
  tp_tilt_svg_ring(t, view, own->outline, own->outline_count);
  tp_text_add(t, "\"/>\n</g>\n</svg>\n");
  tp_text_add(t, "<text x=\"%.2f\" y=\"%.2f\">", left + 8, top + view->height / 2 + 14);
  tp_tilt_frames_foot(t, own_words->test, m, own_words->language, own_words->comma);
  tp_text_add(t, "</text>\n");
}

tp_status tp_report_tilt_frames(char **text, const tp_tilt_test *test) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, test);
  return tp_tilt_frames_svg(text, test, NULL, false);
}

tp_status tp_tilt_frames_svg(char **text, const tp_tilt_test *test, const tp_language *language,
                             bool comma) {
  const telling words = {test, language, comma};
  tp_text t = {0};
  double width = 0, height = 0;
  for (size_t c = 0; c < test->case_count; c++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + c);
    width = fmax(width, TP_TILT_FRAMES * view.width / 2);
    height += view.height / 2 + 44 + tp_turn_strip_of(&view).height;
  }
  tp_tilt_svg_begin(&t, width, height);
  double top = 0;
  for (size_t c = 0; c < test->case_count; c++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + c);
    size_t chosen[TP_TILT_FRAMES] = {0};
    const size_t count = tp_tilt_frames_choose(chosen, &view);
    tp_text_add(&t, "<text x=\"8\" y=\"%.2f\">", top + 16);
    tp_tilt_frames_head(&t, test, test->cases + c, language, comma);
    tp_text_add(&t, "</text>\n");
    for (size_t k = 0; k < count; k++) {
      add_frame(&t, &view, view.own->moments + chosen[k], (double)k * view.width / 2, top + 22,
                &words);
    }
    top += view.height / 2 + 44;
    const tp_turn_strip strip = tp_turn_strip_of(&view);
    tp_turn_strip_svg(&t, &strip, top, language, comma);
    top += strip.height;
  }
  tp_text_add(&t, "</svg>\n");
  return tp_text_finish(&t, text);
}
