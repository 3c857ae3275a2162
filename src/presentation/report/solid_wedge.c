/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How safe a wedge is against sliding, as text. */

#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DIGITS = TP_SOLID_TILT_DIGITS };

static void add_number(tp_text *t, const char *label, tp_bounded number, const char *unit) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %-22s %s%s\n", label, tp_text_significant(n, number, DIGITS), unit);
}

static void add_wedge_factor(tp_text *t, tp_bounded factor) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %-22s %s\n", "factor of safety", tp_text_significant_down(n, factor, DIGITS));
}

const char *tp_text_solid_wedge_on(const char *slides_on) {
  return strcmp(slides_on, "a and b") == 0 ? "along the line of both joints"
         : strcmp(slides_on, "a") == 0     ? "on joint A, away from B"
         : strcmp(slides_on, "b") == 0     ? "on joint B, away from A"
                                           : "on neither joint: it is lifted off";
}

const char *tp_text_solid_wedge_way(const tp_solid_wedge *w) {
  if (strcmp(w->slides_on, "a and b") == 0 && w->driving_n.value < 0) {
    return "up the line of both joints";
  }
  return tp_text_solid_wedge_on(w->slides_on);
}

static void add_earthquake(tp_text *t, const tp_solid *s) {
  const tp_solid_wedge *w = &s->wedge;
  if (!s->has_seismic) return;
  tp_text_add(t, "  %-22s ", "earthquake");
  if (w->has_azimuth) {
    tp_text_add(t, "%.6g of the weight towards %.6g°%s%s", s->seismic_horizontal, w->azimuth_deg,
                s->has_seismic_azimuth ? "" : ", the worst azimuth",
                s->seismic_vertical != 0 ? ", " : "");
  }
  if (s->seismic_vertical != 0 || !w->has_azimuth) {
    tp_text_add(t, "%.6g of the weight upwards", s->seismic_vertical);
  }
  tp_text_add(t, "\n");
}

static void add_bolts(tp_text *t, const tp_solid_wedge *w) {
  for (size_t k = 0; k < w->bolt_count; k++) {
    const tp_wedge_bolt *own = w->bolts + k;
    char n[TP_NUMBER_SIZE];
    tp_text_add(t, "  %-22s %s N towards %.6g°, %.6g° %s the horizontal", "bolt",
                tp_text_significant(n, own->force_n, DIGITS), own->azimuth_deg, fabs(own->dip_deg),
                own->dip_deg < 0 ? "above" : "below");
    if (own->has_capacity) {
      tp_text_add(t, ", %s of its capacity", tp_text_significant_up(n, own->utilisation, 4));
    }
    tp_text_add(t, "\n");
  }
}

static void add_support(tp_text *t, const tp_solid *s) {
  const tp_solid_wedge *w = &s->wedge;
  char n[3][TP_NUMBER_SIZE];
  if (!w->has_support) return;
  const bool above = w->support_dip_deg.value < 0;
  const tp_bounded steepness = {fabs(w->support_dip_deg.value), w->support_dip_deg.error, NULL};
  tp_text_add(t,
              "  The least further active force that gives %.6g is %s N, towards %s°, %s° %s "
              "the horizontal.\n",
              s->required_fos, tp_text_significant(n[0], w->support_n, DIGITS),
              tp_text_fixed(n[1], w->support_azimuth_deg, 2), tp_text_fixed(n[2], steepness, 2),
              above ? "above" : "below");
}

static void add_found(tp_text *t, const char *label, const char *least, double azimuth_deg,
                      const char *slides_on) {
  tp_text_add(t, "  %-22s %s towards %.6g°, %s\n", label, least, azimuth_deg,
              tp_text_solid_wedge_on(slides_on));
}

/* The least of all azimuths, proven from both sides. */
static void add_of_all_azimuths(tp_text *t, const tp_solid *s) {
  const tp_solid_wedge *w = &s->wedge;
  char n[TP_NUMBER_SIZE];
  if (w->has_worst && s->has_seismic_azimuth) {
    add_found(t, "least of all azimuths", tp_text_significant_down(n, w->worst_fos, DIGITS),
              w->worst_azimuth_deg, w->worst_slides_on);
  }
  if (w->has_acceleration_ahead) {
    tp_text_add(t, "  %-22s ", "slides at");
    tp_text_add(t, "%s g towards %.6g°\n", tp_text_significant(n, w->acceleration_ahead_g, DIGITS),
                s->seismic_azimuth_deg);
  }
  if (w->has_acceleration) {
    char least[TP_NUMBER_SIZE + 4];
    snprintf(least, sizeof least, "%s g", tp_text_significant(n, w->acceleration_g, DIGITS));
    add_found(t, "least acceleration", least, w->acceleration_azimuth_deg,
              w->acceleration_slides_on);
  }
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
  add_earthquake(t, s);
  add_bolts(t, w);
  if (w->has_water) add_number(t, "mean water pressure", w->water_kpa, " kPa");
  add_number(t, "normal force on A", w->normal_n[0], " N");
  add_number(t, "normal force on B", w->normal_n[1], " N");
  add_number(t, "driving force", w->driving_n, " N");
  if (w->has_fos) add_wedge_factor(t, w->fos);
  add_of_all_azimuths(t, s);
  tp_text_add(t, "  %-22s %s\n", "verdict", tp_mechanism_name(w->verdict));
  tp_text_solid_required(t, s);
  add_support(t, s);
  tp_text_add(t, "  As Hoek and Bray have it: friction and cohesion act against the sliding alone, "
                 "no joint is in tension,\n  and the wedge does not turn.\n");
}
