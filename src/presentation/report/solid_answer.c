/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The answer of a solid in a few sentences, as its report begins and its figure is headed. */

#include "output/wrap.h"
#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

const tp_solid_band *tp_solid_band_that_governs(const tp_solid *solid) {
  return solid->bands + solid->governing;
}

static const char *against(tp_mechanism mechanism) {
  return mechanism == TP_SLIDES    ? "sliding"
         : mechanism == TP_TOPPLES ? "toppling"
                                   : "toppling and sliding";
}

static void add_place(tp_text *t, const tp_solid *solid) {
  if (solid->is_on_slope) {
    tp_text_add(t, "On its base, which dips %.6g° towards %.6g°,", solid->tilt_angle_deg,
                solid->tilt_azimuth_deg);
  } else if (solid->has_tilt_angle) {
    tp_text_add(t, "Tilted by %.6g°", solid->tilt_angle_deg);
    if (solid->has_tilt_azimuth) tp_text_add(t, " towards %.6g°", solid->tilt_azimuth_deg);
  } else {
    tp_text_add(t, "As it lies");
  }
  if (solid->has_seismic) tp_text_add(t, " and under its earthquake");
}

static void add_stance(tp_text *t, const tp_solid *solid, const tp_solid_stance *own) {
  char n[TP_NUMBER_SIZE];
  add_place(t, solid);
  tp_text_add(t, " it %s", tp_mechanism_name(own->verdict));
  if (own->has_fos) {
    tp_text_add(t, ": factor of safety %s against %s", tp_text_significant_down(n, own->fos, 4),
                against(own->fos_mechanism));
  }
  tp_text_add(t, ". ");
  if (own->has_acceleration) {
    tp_text_add(t, "The least horizontal acceleration that moves it is %s g, towards %.0f°. ",
                tp_text_significant(n, own->acceleration_g, 4),
                own->acceleration_azimuth_deg.value);
  }
}

static void add_of_band(tp_text *t, const tp_solid *solid) {
  const tp_solid_band *band = tp_solid_band_that_governs(solid);
  char n[TP_NUMBER_SIZE];
  if (band->has_stance) add_stance(t, solid, &band->stance);
  if (band->stands) {
    tp_text_add(t, "Tilted from level without shaking it %s at %s°, towards %.0f°.",
                tp_mechanism_name(band->mechanism), tp_text_significant(n, band->critical_deg, 5),
                band->least.azimuth_deg.value);
  } else if (!band->has_stance) {
    tp_text_add(t, "It does not stand.");
  }
  tp_text_add(t,
              solid->has_below
                  ? " So on the section %.6g %s over its lowest point, below which all is ground."
                  : " So by the least band, %.6g %s, which governs.",
              band->band, solid->length_unit);
}

static void add_of_ground(tp_text *t, const tp_solid *solid, const tp_solid_ground_band *own) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, " So by the least band over its ground, %.6g %s, which governs.", own->band,
              solid->length_unit);
  if (!own->has_smooth || own->normals_deg == 0) return;
  tp_text_add(t, " With the mean of all normals, between which nothing is wedged,");
  if (own->has_smooth_critical) {
    tp_text_add(t, " up to %s°:", tp_text_significant(n, own->smooth_critical_deg, 5));
  }
  tp_text_add(t, " it %s at its tilt.", tp_mechanism_name(own->smooth_verdict));
}

static void add_of_contacts(tp_text *t, const tp_solid *solid) {
  const tp_solid_contacts *own = &solid->contacts;
  char n[2][TP_NUMBER_SIZE];
  tp_text_add(t, own->verdict == TP_MAY_MOVE
                     ? "Forces within all cones of friction can hold it, but contacts that face "
                       "different ways can let go: it may move."
                 : own->verdict == TP_STANDS ? "Forces within all cones of friction hold it."
                 : own->has_motion ? "No forces of its contacts hold it: it certainly moves."
                                   : "Undecided.");
  if (own->has_fos) {
    tp_text_add(t, " Factor of safety %s: then it %s.", tp_text_significant_down(n[0], own->fos, 4),
                tp_mechanism_name(own->fos_mechanism));
  }
  if (own->has_critical) {
    tp_text_add(t, " Forces hold it up to a tilt of %s° towards %s°: then it %s.",
                tp_text_significant(n[0], own->critical_deg, 5),
                tp_text_fixed(n[1], own->critical_azimuth_deg, 1),
                tp_mechanism_name(own->critical.mechanism));
  }
  if (own->has_acceleration) {
    tp_text_add(t, " At its tilt they do up to a horizontal acceleration of %s g towards %s°.",
                tp_text_significant(n[0], own->acceleration_g, 4),
                tp_text_fixed(n[1], own->acceleration_azimuth_deg, 1));
  }
  if (solid->has_ground) {
    add_of_ground(t, solid, solid->ground.bands + solid->ground.governing);
  }
}

static void add_of_wedge(tp_text *t, const tp_solid_wedge *own, bool is_worst) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "The wedge %s. Sliding %s", tp_mechanism_name(own->verdict),
              tp_text_solid_wedge_way(own));
  if (own->has_fos)
    tp_text_add(t, ": factor of safety %s", tp_text_significant_down(n, own->fos, 4));
  if (own->has_azimuth) {
    tp_text_add(t, " with its earthquake towards %.0f°%s", own->azimuth_deg,
                is_worst ? ", the worst azimuth" : "");
  }
  tp_text_add(t, ".");
  if (own->has_acceleration) {
    tp_text_add(t, " The least horizontal acceleration that moves it is %s g, towards %.0f°.",
                tp_text_significant(n, own->acceleration_g, 4), own->acceleration_azimuth_deg);
  }
}

void tp_text_solid_answer(tp_text *t, const tp_solid *solid) {
  if (solid->has_wedge) {
    add_of_wedge(t, &solid->wedge, !solid->has_seismic_azimuth);
  } else if (solid->has_contacts) {
    add_of_contacts(t, solid);
  } else {
    add_of_band(t, solid);
  }
}

void tp_text_solid_answer_wrapped(tp_text *t, const tp_solid *solid) {
  tp_text answer = {0};
  tp_wrapping wrapping = {0};
  tp_text_solid_answer(&answer, solid);
  if (!answer.failed) tp_text_add_wrapped(t, answer.data, &wrapping);
  tp_text_add(t, "\n\n");
  t->failed = t->failed || answer.failed;
  tp_text_drop(&answer);
}
