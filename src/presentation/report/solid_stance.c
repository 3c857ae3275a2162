/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a solid does at the tilt of its scene, a line for each band. */

#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <stdio.h>

enum { TILT = TP_SOLID_TILT_DIGITS };

static void add_azimuth(tp_text *t, bool has, double azimuth) {
  if (has) {
    tp_text_add(t, "towards the azimuth %.6g°", azimuth);
  } else {
    tp_text_add(t, "towards the worst azimuth");
  }
}

void tp_text_solid_loads(tp_text *t, const tp_solid *s) {
  if (s->is_on_slope) {
    tp_text_add(t, "\nOn its base, which dips %.6g° ", s->tilt_angle_deg);
    add_azimuth(t, true, s->tilt_azimuth_deg);
  } else if (s->has_tilt_angle) {
    tp_text_add(t, "\nTilted by %.6g° ", s->tilt_angle_deg);
    add_azimuth(t, s->has_tilt_azimuth, s->tilt_azimuth_deg);
  } else {
    tp_text_add(t, "\nOn its base as it is");
  }
  if (s->has_seismic) {
    tp_text_add(t, ", earthquake %.6g of the weight ", s->seismic_horizontal);
    add_azimuth(t, s->has_seismic_azimuth, s->seismic_azimuth_deg);
    if (s->seismic_vertical != 0) tp_text_add(t, ", %.6g upwards", s->seismic_vertical);
  }
  tp_text_add(t, "\n");
}

/* Where it is no number, its bounds. */
static void add_no_factor(tp_text *t, const tp_solid_safety *own) {
  if (own->fos.state == TP_FOS_NO_OVERTURNING) return;
  tp_text_add(t, "  factor of safety ");
  tp_text_solid_factor(t, own, TILT);
}

static void add_stance(tp_text *t, const tp_solid_band *b) {
  const tp_solid_stance *own = &b->stance;
  char n[4][TP_NUMBER_SIZE];
  tp_text_add(t, "  %10.6g", b->band);
  if (!b->has_stance) {
    tp_text_add(t, "  does not stand: a point or a line touches\n");
    return;
  }
  tp_text_add(t, "  %-10s", tp_mechanism_name(own->verdict));
  if (own->has_fos) {
    tp_text_add(t, " %10s %-8s", tp_text_significant_down(n[0], own->fos, TILT),
                tp_mechanism_name(own->fos_mechanism));
  } else if (own->has_acceleration) {
    tp_text_add(t, " %10s %-8s", "-", "");
  }
  if (own->has_acceleration) {
    tp_text_add(t, " %11s g %9s°  %s", tp_text_significant(n[2], own->acceleration_g, TILT),
                tp_text_fixed(n[3], own->acceleration_azimuth_deg, 3),
                tp_mechanism_name(own->acceleration_mechanism));
  }
  if (!own->has_fos) add_no_factor(t, &own->safety);
  if (own->safety.states[own->safety.governing].is_static) {
    tp_text_add(t, "  (without the earthquake)");
  }
  tp_text_add(t, "\n");
}

const char *tp_text_solid_band(char text[TP_SOLID_BAND_SIZE], const tp_solid *solid) {
  snprintf(text, TP_SOLID_BAND_SIZE, "%s (%s)", tp_text_solid_band_word(solid), solid->length_unit);
  return text;
}

void tp_text_solid_required(tp_text *t, const tp_solid *s) {
  const char *where = s->band_count == 0 || s->has_below ? "" : " in the least band";
  if (!s->has_required_fos) return;
  switch (tp_solid_meets(s, s->required_fos)) {
  case TP_DESIGN_MET:
    tp_text_add(t, "  The required factor of safety %.6g is met%s.\n", s->required_fos, where);
    break;
  case TP_DESIGN_NOT_MET:
    tp_text_add(t, "  The required factor of safety %.6g is not met%s.\n", s->required_fos, where);
    break;
  case TP_DESIGN_OPEN:
    tp_text_add(t, "  Whether the required factor of safety %.6g is met is undecided.\n",
                s->required_fos);
  }
}

void tp_text_solid_stances(tp_text *t, const tp_solid *s) {
  char band[TP_SOLID_BAND_SIZE];
  bool any = false, shaken = false;
  if (!s->of_scene || s->has_contacts || s->has_wedge) return;
  tp_text_solid_loads(t, s);
  for (size_t k = 0; k < s->band_count; k++) {
    any = any || (s->bands[k].has_stance && s->bands[k].stance.has_fos);
    shaken = shaken || (s->bands[k].has_stance && s->bands[k].stance.has_acceleration);
  }
  tp_text_add(t, "  %10s", tp_text_solid_band(band, s));
  if (any || shaken) {
    tp_text_add(t, "  %-10s %10s %-8s%s", "", any ? "factor" : "", any ? "against" : "",
                shaken ? " acceleration    azimuth" : "");
  }
  tp_text_add(t, "\n");
  for (size_t k = 0; k < s->band_count; k++) add_stance(t, s->bands + k);
  if (any) {
    tp_text_add(t,
                "  The factor is the least of those on driving loads, the part of the weight along "
                "the base and the\n  earthquake, until it topples about an edge or slides, and by "
                "strength reduction.\n");
  }
  if (shaken) {
    tp_text_add(t,
                "  The acceleration is the least horizontal one of all azimuths that moves it at "
                "this tilt,\n  if it lasts.\n");
  }
  tp_text_solid_required(t, s);
}
