/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How safe a wedge is against sliding, as text. */

#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <string.h>

enum { DIGITS = TP_SOLID_TILT_DIGITS };

static void add_number(tp_text *t, const char *label, tp_bounded number, const char *unit) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %-22s %s%s\n", label, tp_text_significant(n, number, DIGITS), unit);
}

const char *tp_text_solid_wedge_way(const tp_solid_wedge *w) {
  if (strcmp(w->slides_on, "a and b") == 0 && w->driving_n.value < 0) {
    return "up the line of both joints";
  }
  return strcmp(w->slides_on, "a and b") == 0 ? "along the line of both joints"
         : strcmp(w->slides_on, "a") == 0     ? "down joint A, away from B"
         : strcmp(w->slides_on, "b") == 0     ? "down joint B, away from A"
                                              : "on neither joint: the water lifts it";
}

void tp_text_solid_wedge(tp_text *t, const tp_solid *s) {
  const tp_solid_wedge *w = &s->wedge;
  if (!s->has_wedge) return;
  tp_text_add(t, "\nSliding between two joints, %s\n", tp_text_solid_wedge_way(w));
  add_number(t, "plunge of that line", w->plunge_deg, "°");
  add_number(t, "towards", w->trend_deg, "°");
  add_number(t, "area of A", w->areas_m2[0], " m²");
  add_number(t, "area of B", w->areas_m2[1], " m²");
  if (w->has_crack) add_number(t, "area of the crack", w->crack_area_m2, " m²");
  if (s->has_seismic) {
    tp_text_add(t, "  %-22s %.6g of the weight towards %.6g°, %.6g upwards\n", "earthquake",
                s->seismic_horizontal, s->seismic_azimuth_deg, s->seismic_vertical);
  }
  if (w->has_water) add_number(t, "mean water pressure", w->water_kpa, " kPa");
  add_number(t, "normal force on A", w->normal_n[0], " N");
  add_number(t, "normal force on B", w->normal_n[1], " N");
  add_number(t, "driving force", w->driving_n, " N");
  if (w->has_fos) add_number(t, "factor of safety", w->fos, "");
  tp_text_add(t, "  %-22s %s\n", "verdict", tp_mechanism_name(w->verdict));
  tp_text_solid_required(t, s);
  tp_text_add(t, "  As Hoek and Bray have it: friction and cohesion act against the sliding alone, "
                 "no joint is in tension,\n  and the wedge does not turn.\n");
}
