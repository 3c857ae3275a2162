/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The strip ends a little after the last moment at which the block turns. */

#include "report/tilt_turn.h"

#include "output/translate.h"

#include <math.h>

static const double margin = 8, heading = 18;

tp_turn_strip tp_turn_strip_of(const tp_tilt_view *view) {
  const tp_tilt_case *own = view->own;
  tp_turn_strip strip = {.own = own, .width = TP_TILT_FRAMES * view->width / 2};
  if (!own->has_peak_turn || own->moment_count == 0) return strip;
  strip.height = 110;
  strip.end_s = own->peak_turn_s;
  strip.most_deg = fabs(own->peak_turn_deg);
  if (own->has_balance_turn) strip.most_deg = fmax(strip.most_deg, own->balance_turn_deg);
  for (size_t k = 0; k < own->moment_count; k++) {
    if (own->moments[k].turning_rad_s != 0) strip.end_s = own->moments[k].time_s;
    if (own->end != TP_TILT_OVERTURNED) {
      strip.most_deg = fmax(strip.most_deg, fabs(own->moments[k].turned_deg));
    }
  }
  strip.end_s = fmin(1.05 * strip.end_s, own->ended_s);
  return strip;
}

double tp_turn_strip_x(const tp_turn_strip *s, double time_s) {
  return margin + (s->width - 2 * margin) * time_s / s->end_s;
}

double tp_turn_strip_y(const tp_turn_strip *s, double turned_deg) {
  const double half = (s->height - heading) / 2;
  const double share = fmin(1, fmax(-1, turned_deg / s->most_deg));
  return heading + half - 0.92 * half * share;
}

bool tp_turn_strip_balance(double *turned_deg, const tp_turn_strip *s) {
  *turned_deg = copysign(s->own->balance_turn_deg, s->own->peak_turn_deg);
  return s->own->has_balance_turn;
}

void tp_turn_strip_words(tp_text *t, const tp_turn_strip *s, const tp_language *language,
                         bool comma) {
  const tp_tilt_case *own = s->own;
  tp_text english = {0};
  tp_text_add(&english, "turn of the block up to %.3g s; its peak is %.4g°", s->end_s,
              fabs(own->peak_turn_deg));
  if (own->has_balance_turn) {
    tp_text_add(&english, ", %.3g %% of the balance angle (dashed)", 100 * own->peak_over_balance);
  }
  t->failed = t->failed || english.failed;
  if (english.data != NULL) tp_translate(t, language, comma, english.data);
  tp_text_drop(&english);
}

static void add_level(tp_text *t, const tp_turn_strip *s, double turned_deg, const char *style) {
  const double y = tp_turn_strip_y(s, turned_deg);
  tp_text_add(t, "<path fill=\"none\" %s d=\"M%.2f %.2fL%.2f %.2f\"/>\n", style,
              tp_turn_strip_x(s, 0), y, tp_turn_strip_x(s, s->end_s), y);
}

void tp_turn_strip_svg(tp_text *t, const tp_turn_strip *s, double top, const tp_language *language,
                       bool comma) {
  const tp_tilt_case *own = s->own;
  double balance = 0;
  if (s->height == 0) return;
  tp_text_add(t, "<g transform=\"translate(0 %.2f)\">\n<text x=\"%.0f\" y=\"12\">", top, margin);
  tp_turn_strip_words(t, s, language, comma);
  tp_text_add(t, "</text>\n");
  add_level(t, s, 0, "stroke=\"#9aa4ad\"");
  if (tp_turn_strip_balance(&balance, s)) {
    add_level(t, s, balance, "stroke=\"#b3261e\" stroke-dasharray=\"5 3\"");
  }
  tp_text_add(t, "<path fill=\"none\" stroke=\"#1b5fa8\" stroke-width=\"1.2\" d=\"");
  for (size_t k = 0; k < own->moment_count && own->moments[k].time_s <= s->end_s; k++) {
    tp_text_add(t, "%s%.2f %.2f", k == 0 ? "M" : "L", tp_turn_strip_x(s, own->moments[k].time_s),
                tp_turn_strip_y(s, own->moments[k].turned_deg));
  }
  tp_text_add(t, "\"/>\n<circle cx=\"%.2f\" cy=\"%.2f\" r=\"2.5\" fill=\"#b3261e\"/>\n</g>\n",
              tp_turn_strip_x(s, own->peak_turn_s), tp_turn_strip_y(s, own->peak_turn_deg));
}
