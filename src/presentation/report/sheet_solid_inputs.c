/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was given of a solid, on the first page of its sheet: body, what touches or the planes of a
 * wedge, friction, tilt and earthquake. */

#include "report/sheet_solid.h"

#include "number/shortest.h"

#include <math.h>

static void add_body(tp_solid_sheet *s) {
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  char n[4][TP_NUMBER_SIZE];
  tp_document_word(d, own->has_wedge ? "Wedge" : "Solid");
  tp_text_significant(n[3], own->volume_m3, 6);
  for (int k = 0; k < 3; k++) tp_text_significant(n[k], own->centroid_m[k], 6);
  tp_document_cell(d, "triangles: %zu; V = %s m³; centroid G (%s, %s, %s) m", own->triangles, n[3],
                   n[0], n[1], n[2]);
  tp_document_word(d, "Weight");
  if (own->has_weight) {
    tp_document_cell(d, "W = %s kN",
                     tp_text_significant(n[0], tp_text_over(own->weight_n, 1e3), 6));
  } else {
    tp_document_word(d, "not given: forces are not stated");
  }
}

static void add_parts(tp_solid_sheet *s) {
  tp_document *d = &s->document;
  for (size_t k = 0; k < s->solid->part_count; k++) {
    const tp_solid_part *own = s->solid->parts + k;
    char n[TP_NUMBER_SIZE], weight[TP_SHORTEST_SIZE];
    tp_text_significant(n, own->volume_m3, 6);
    tp_document_word(d, own->is_hole ? "Hole" : "Part");
    if (own->is_hole) {
      tp_document_cell(d, "V = %s m³", n);
    } else {
      tp_document_cell(d, "V = %s m³, of %s kN/m³", n, tp_shortest(weight, own->unit_weight_kn_m3));
    }
  }
}

static void add_side(tp_solid_sheet *s, const char *word, const tp_wedge_side *side, bool joint) {
  tp_document *d = &s->document;
  char n[4][TP_SHORTEST_SIZE];
  tp_shortest(n[0], side->dip_deg);
  tp_shortest(n[1], side->dip_direction_deg);
  tp_document_word(d, word);
  if (!joint) {
    tp_document_cell(d, "dip %s°, dip direction %s°", n[0], n[1]);
    return;
  }
  tp_document_cell(d, "dip %s°, dip direction %s°; φ = %s°, c = %s kPa", n[0], n[1],
                   tp_shortest(n[2], side->friction_angle_deg),
                   tp_shortest(n[3], side->cohesion_kpa));
}

static void add_wedge(tp_solid_sheet *s) {
  const tp_solid_wedge *w = &s->solid->wedge;
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  add_side(s, "Joint A", w->sides + TP_WEDGE_A, true);
  add_side(s, "Joint B", w->sides + TP_WEDGE_B, true);
  add_side(s, "Face", w->sides + TP_WEDGE_FACE, false);
  add_side(s, "Ground above", w->sides + TP_WEDGE_UPPER, false);
  if (w->has_crack) add_side(s, "Tension crack", w->sides + TP_WEDGE_CRACK, false);
  tp_document_word(d, "Water");
  if (w->has_water) {
    tp_document_cell(d, "joints full, mean pressure %s kPa",
                     tp_text_significant(n, w->water_kpa, 5));
  } else {
    tp_document_word(d, "none");
  }
}

static void add_bolts(tp_solid_sheet *s) {
  enum { MOST = 6 };
  const tp_solid_wedge *w = &s->solid->wedge;
  tp_document *d = &s->document;
  for (size_t k = 0; k < w->bolt_count && k < MOST; k++) {
    const tp_wedge_bolt *own = w->bolts + k;
    char n[TP_NUMBER_SIZE], azimuth[TP_SHORTEST_SIZE], dip[TP_SHORTEST_SIZE];
    tp_text_significant(n, tp_text_over(own->force_n, 1e3), 6);
    tp_shortest(azimuth, own->azimuth_deg);
    tp_shortest(dip, fabs(own->dip_deg));
    tp_document_word(d, "Bolt");
    tp_document_cell(d,
                     own->dip_deg < 0 ? "%s kN towards %s°, %s° above the horizontal"
                                      : "%s kN towards %s°, %s° below the horizontal",
                     n, azimuth, dip);
  }
  if (w->bolt_count <= MOST) return;
  tp_document_word(d, "Bolt");
  tp_document_cell(d, "and %zu more", w->bolt_count - MOST);
}

/* "0.002; 0.005": as many as page 1 has. */
static void add_band_list(tp_text *bands, const tp_document *d, size_t k, double band) {
  char n[TP_SHORTEST_SIZE];
  if (k < TP_SOLID_SHEET_BANDS) {
    tp_text_add(bands, "%s%s", k > 0 ? "; " : "", tp_shortest(n, band));
  }
  tp_document_set_decimals(d, bands);
}

static void add_ground(tp_solid_sheet *s) {
  const tp_solid_ground *own = &s->solid->ground;
  tp_document *d = &s->document;
  tp_text bands = {0};
  for (size_t k = 0; k < own->band_count; k++) add_band_list(&bands, d, k, own->bands[k].band);
  tp_document_cell(d,
                   "a mesh of the ground of %zu triangles; what is no farther from it than the "
                   "band touches: %s %s",
                   own->triangles, bands.data != NULL ? bands.data : "", s->solid->length_unit);
  d->failed = d->failed || bands.failed;
  tp_text_drop(&bands);
}

static void add_touching(tp_solid_sheet *s) {
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  tp_document_word(d, "Contact");
  if (own->has_ground) {
    add_ground(s);
    return;
  }
  if (own->has_contacts) {
    tp_document_cell(d, "points with normals and friction: %zu", own->contacts.contact_count);
    return;
  }
  if (own->has_below) {
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d,
                     "the section of a plane %s %s over the lowest point; what lies below is "
                     "ground",
                     tp_shortest(n, own->below), own->length_unit);
    return;
  }
  tp_text bands = {0};
  for (size_t k = 0; k < own->band_count; k++) add_band_list(&bands, d, k, own->bands[k].band);
  tp_document_cell(d,
                   "a plane; what lies no higher over the lowest point than the band touches: "
                   "%s %s",
                   bands.data != NULL ? bands.data : "", own->length_unit);
  d->failed = d->failed || bands.failed;
  tp_text_drop(&bands);
}

static void add_azimuth(tp_text *t, const tp_document *d, bool has, double azimuth_deg) {
  char n[TP_SHORTEST_SIZE];
  if (has) {
    tp_text_add(t, tp_document_say(d, " towards the azimuth %s°"), tp_shortest(n, azimuth_deg));
  } else {
    tp_text_add(t, "%s", tp_document_say(d, " towards the worst azimuth"));
  }
}

static void add_loads(tp_solid_sheet *s) {
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  tp_text tilt = {0};
  char n[TP_SHORTEST_SIZE];
  tp_document_word(d, own->is_on_slope ? "As it lies" : "Tilt");
  if (own->has_tilt_angle) {
    tp_text_add(&tilt, tp_document_say(d, own->is_on_slope ? "the base dips by %s°" : "α = %s°"),
                tp_shortest(n, own->tilt_angle_deg));
    add_azimuth(&tilt, d, own->has_tilt_azimuth, own->tilt_azimuth_deg);
    tp_document_set_decimals(d, &tilt);
    tp_document_take_cell(d, &tilt);
  } else {
    tp_document_word(d, "none: on its base as it is");
  }
}

static void add_quake(tp_solid_sheet *s) {
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  tp_text quake = {0};
  char n[TP_SHORTEST_SIZE];
  if (!own->has_seismic) return;
  tp_document_word(d, "Earthquake");
  tp_text_add(&quake, tp_document_say(d, "%s of the weight"),
              tp_shortest(n, own->seismic_horizontal));
  add_azimuth(&quake, d, own->has_seismic_azimuth, own->seismic_azimuth_deg);
  if (own->seismic_vertical != 0) {
    tp_text_add(&quake, tp_document_say(d, "; upwards %s of it"),
                tp_shortest(n, own->seismic_vertical));
  }
  tp_document_set_decimals(d, &quake);
  tp_document_take_cell(d, &quake);
}

static void add_friction(tp_solid_sheet *s) {
  tp_document *d = &s->document;
  char n[TP_SHORTEST_SIZE];
  tp_document_word(d, "Friction");
  if (s->solid->has_friction) {
    tp_document_cell(d, "φ = %s°", tp_shortest(n, s->solid->friction_angle_deg));
  } else {
    tp_document_word(d, s->solid->has_contacts ? "of each contact"
                                               : "not given: sliding is not "
                                                 "judged");
  }
}

void tp_solid_sheet_add_inputs(tp_solid_sheet *s) {
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Inputs");
  add_body(s);
  add_parts(s);
  if (s->solid->has_wedge) {
    add_wedge(s);
    add_bolts(s);
    add_quake(s);
  } else {
    add_touching(s);
    add_friction(s);
    add_loads(s);
    add_quake(s);
  }
  tp_sheet_add_settings(d, &s->solid->settings);
}
