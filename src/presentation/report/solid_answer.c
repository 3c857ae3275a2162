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

static void add_factor(tp_text *t, const tp_solid_safety *own) {
  tp_text_solid_factor(t, own, 4);
  if (own->has_factor && own->factor.mechanism != TP_MECHANISM_UNDECIDED) {
    tp_text_add(t, " against %s", against(own->factor.mechanism));
  }
  if (own->states[own->governing].is_static) tp_text_add(t, ", without the earthquake");
  if (own->states[own->governing].has_mean_normals) {
    tp_text_add(t, ", with the mean of all normals");
  }
}

/* Does anything drive it, or can anything move it? */
static bool has_factor(const tp_solid_safety *own) {
  return own->fos.state != TP_FOS_NO_OVERTURNING;
}

static void add_stance(tp_text *t, const tp_solid *solid, const tp_solid_stance *own) {
  char n[TP_NUMBER_SIZE];
  add_place(t, solid);
  tp_text_add(t, " it %s", tp_mechanism_name(own->verdict));
  if (has_factor(&own->safety)) {
    tp_text_add(t, ": factor of safety ");
    add_factor(t, &own->safety);
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

const char *tp_text_solid_held(const tp_solid_contacts *own) {
  if (own->has_motion) return "No forces of its contacts hold it: it certainly moves.";
  switch (own->verdict == TP_MECHANISM_UNDECIDED ? TP_SOLID_COLLAPSES
                                                 : own->safety.states->motion) {
  case TP_SOLID_STANDS:
    return "It stands: no motion can begin.";
  case TP_SOLID_CAN_MOVE:
    return "Forces of its contacts can hold it, but a motion can begin, proven: it may move.";
  case TP_SOLID_OPEN:
    return "Forces of its contacts can hold it; whether a motion can begin is not decided.";
  case TP_SOLID_COLLAPSES:
    break;
  }
  return "Undecided.";
}

static void add_of_contacts(tp_text *t, const tp_solid *solid) {
  const tp_solid_contacts *own = &solid->contacts;
  char n[2][TP_NUMBER_SIZE];
  const tp_solid_safety *safety = tp_solid_safety_of(solid);
  tp_text_add(t, "%s", tp_text_solid_held(own));
  if (has_factor(safety)) {
    tp_text_add(t, " Factor of safety ");
    add_factor(t, safety);
    tp_text_add(t, ".");
  }
  if (own->has_certain) {
    const tp_bounded least = {.value = own->certain_to_stand_deg};
    tp_text_add(t, " No motion can begin up to a tilt of %s°, and perhaps beyond.",
                tp_text_significant_down(n[0], least, 5));
  }
  if (own->has_onset) {
    tp_text_add(t, " A motion can begin from a tilt of %s° on.",
                tp_text_significant(n[0], own->onset_deg, 5));
  }
  if (own->has_critical) {
    tp_text_add(t, " Forces hold it up to a tilt of %s° towards %s°: then it %s.",
                tp_text_significant(n[0], own->critical_deg, 5),
                tp_text_fixed(n[1], own->critical_azimuth_deg, 1),
                tp_mechanism_name(own->critical.mechanism));
  }
  if (own->has_acceleration && own->safety.motion != TP_SOLID_CAN_MOVE) {
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

/* With an earthquake that holds it back, the state without governs. */
static void add_static(tp_text *t, const tp_solid_safety *own) {
  if (!own->states[own->governing].is_static) return;
  tp_text_add(t, " Without its earthquake the factor of safety is ");
  tp_text_solid_factor(t, own, 4);
  tp_text_add(t, ", and governs.");
}

static void add_required(tp_text *t, const tp_solid *solid) {
  if (!solid->has_required_fos) return;
  const tp_design met = tp_solid_meets(solid, solid->required_fos);
  tp_text_add(t,
              met == TP_DESIGN_OPEN  ? " Whether the required factor of safety %.6g is met is "
                                       "undecided."
              : met == TP_DESIGN_MET ? " The required factor of safety %.6g is met."
                                     : " The required factor of safety %.6g is not met.",
              solid->required_fos);
}

void tp_text_solid_answer(tp_text *t, const tp_solid *solid) {
  if (solid->has_wedge) {
    add_of_wedge(t, &solid->wedge, !solid->has_seismic_azimuth);
    add_static(t, &solid->wedge.safety);
  } else if (solid->has_contacts) {
    add_of_contacts(t, solid);
  } else {
    add_of_band(t, solid);
  }
  if (solid->of_scene) add_required(t, solid);
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
