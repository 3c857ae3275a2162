/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of a solid on contacts, with forces and motions. */

#include "report/sheet_solid.h"

#include "number/shortest.h"
#include "report/solid_page.h"
#include "terms/names.h"

/* So many rows of a table; --json has all. */
enum { MOST_ROWS = 60, WAY_ROWS = 24 };

/* ---- contacts ----------------------------------------------------------------------------------
 */

static void add_contact_table(tp_solid_sheet *s) {
  static const char *const heads[] = {
      "Point", "At x", "y", "z", "Normal x", "y", "z", "φ (°)", "Normal force", "Shear force"};
  const tp_solid_contacts *own = &s->solid->contacts;
  const bool held = tp_solid_is_held(own);
  const size_t columns = held ? 10 : 8;
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, columns, 0x3ff,
                    held ? "Contacts, with one of the systems of forces that hold it, across and "
                           "along each, in shares of its weight"
                         : "Contacts");
  tp_sheet_add_heads(d, heads, columns);
  for (size_t k = 0; k < own->contact_count && k < MOST_ROWS; k++) {
    const tp_solid_contact *c = own->contacts + k;
    tp_document_cell(d, "%zu", k + 1);
    for (int i = 0; i < 3; i++) tp_document_cell(d, "%.6g", c->at[i]);
    for (int i = 0; i < 3; i++) tp_document_cell(d, "%.5f", c->normal[i]);
    tp_document_cell(d, "%.5g", c->friction_angle_deg);
    if (!held) continue;
    const tp_contact_shares shares = tp_solid_contact_shares(c);
    tp_document_cell(d, "%.4f", shares.across);
    tp_document_cell(d, "%.4f", shares.along);
  }
  tp_sheet_add_rest(d, own->contact_count, MOST_ROWS);
}

static void add_motion(tp_solid_sheet *s, const tp_solid_motion *motion, const char *format) {
  tp_text t = {0}, told = {0};
  tp_text_solid_motion(&told, motion);
  tp_text_add(&t, format, told.data != NULL ? told.data : "");
  t.failed = t.failed || told.failed;
  tp_text_drop(&told);
  tp_document_tell(&s->document, TP_PASSAGE_PARAGRAPH, 0, &t);
}

static void add_ways(tp_solid_sheet *s) {
  static const char *const heads[] = {"Azimuth (°)", "Held up to (°)", "Motion", "Acceleration (g)",
                                      "Motion"};
  const tp_solid_contacts *own = &s->solid->contacts;
  const size_t step = (own->way_count + WAY_ROWS - 1) / WAY_ROWS;
  tp_document *d = &s->document;
  if (own->way_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0xb,
                    "Towards each azimuth: the tilt from level, and the horizontal acceleration at "
                    "its tilt, up to which forces hold it");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  for (size_t k = 0; k < own->way_count; k += step) {
    const tp_solid_way *way = own->ways + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, way->azimuth_deg));
    tp_sheet_add_number_if(d, way->has_critical, way->critical_deg, 6);
    tp_document_word(d, tp_mechanism_name(way->mechanism));
    tp_sheet_add_number_if(d, way->has_acceleration, way->acceleration_g, 6);
    tp_document_word(d,
                     way->has_acceleration ? tp_mechanism_name(way->acceleration_mechanism) : "–");
  }
}

static void add_ground_bands(tp_solid_sheet *s) {
  static const char *const heads[] = {
      "Contacts", "Widest gap (m)", "Normals differ by (°)", "Held up to (°)",
      "FoS",      "Verdict",        "With their mean (°)",   "FoS",
      "Verdict"};
  const tp_solid_ground *own = &s->solid->ground;
  tp_document *d = &s->document;
  if (!s->solid->has_ground) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 10, 0x1bf,
                    "On its ground: what is no farther from it than the band touches");
  tp_document_cell(d, "Band (%s)", s->solid->length_unit);
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  for (size_t k = 0; k < own->band_count; k++) {
    const tp_solid_ground_band *b = own->bands + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, b->band));
    tp_document_cell(d, "%zu", b->contacts);
    tp_document_cell(d, "%.3g", b->widest_m);
    tp_document_cell(d, "%.4g", b->normals_deg);
    tp_sheet_add_number_if(d, b->has_critical, b->critical_deg, 6);
    tp_sheet_add_factor_if(d, b->has_fos, b->fos, 6);
    tp_document_word(d, tp_mechanism_name(b->verdict));
    tp_sheet_add_number_if(d, b->has_smooth_critical, b->smooth_critical_deg, 6);
    tp_sheet_add_number_if(d, b->has_smooth_fos, b->smooth_fos, 6);
    tp_document_word(d, b->has_smooth ? tp_mechanism_name(b->smooth_verdict) : "–");
  }
}

static void add_factors(tp_solid_sheet *s) {
  const tp_solid_safety *own = tp_solid_safety_of(s->solid);
  tp_document *d = &s->document;
  if (own->fos.state == TP_FOS_NO_OVERTURNING) return;
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "The factor of safety is the lesser of two: what tan φ of all contacts may be "
                  "divided by, and what the part of the weight along the base and the earthquake "
                  "may be multiplied by, until a motion can begin.");
  if (s->solid->contacts.is_in_section) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "All normals and loads are across one axis, with contacts to both sides: motions "
        "within that section are decided.");
  } else if (own->fos.state == TP_FOS_UNDECIDED) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "Up to where forces hold it is an upper bound of the factor: a motion can begin "
        "before, between contacts that face different ways.");
  }
}

void tp_solid_sheet_add_contacts(tp_solid_sheet *s) {
  const tp_solid_contacts *own = &s->solid->contacts;
  tp_document *d = &s->document;
  if (!s->solid->has_contacts) return;
  tp_document_heading(d, 2, "Account, on its contacts");
  if (own->has_motion) {
    add_motion(s, &own->motion, "It certainly moves, for no forces hold it: it %s.");
  }
  if (own->has_critical) add_motion(s, &own->critical, "At the limit tilt it %s.");
  add_factors(s);
  add_ground_bands(s);
  add_contact_table(s);
  add_ways(s);
}
