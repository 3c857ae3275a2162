/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of the sheet of many blocks: motions, forces, columns; blocks and contacts. */

#include "report/sheet_system.h"

#include "report/column_page.h"
#include "report/system_page.h"
#include "report/system_words.h"
#include "terms/names.h"

#include <math.h>

/* So many rows of a table; --json has all. */
enum { MOST_ROWS = 120 };

/* A coordinate in the scene's lengths. */
static void add_length(tp_document *d, const tp_block_system *s, double metres) {
  tp_document_cell(d, "%.*g", tp_text_system_digits(s), metres / s->metres_per_unit);
}

/* ---- the collapse ------------------------------------------------------------------------------
 */

void tp_system_sheet_add_motions(tp_system_sheet *s, const tp_system_case *c) {
  static const char *const heads[] = {"Block", "In the collapse", "Speed x", "Speed y",
                                      "Turns (rad/m)"};
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  size_t rows = 0;
  if (c->motion_count == 0) return;
  tp_text caption = {0};
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0x1c,
                    "How the blocks begin to move: velocities of their centroids, the fastest "
                    "corner of all having 1");
  tp_sheet_add_heads(d, heads, 5);
  for (size_t k = 0; k < c->motion_count; k++) {
    const tp_system_motion *m = c->motions + k;
    const bool rests = m->mechanism == TP_STANDS;
    if (own->blocks[k].ground || rows++ >= MOST_ROWS) continue;
    tp_document_outside_cell(d, own->blocks[k].name);
    tp_document_word(d, rests ? "at rest" : tp_mechanism_name(m->mechanism));
    for (int n = 0; n < 3 && rests; n++) tp_document_word(d, "–");
    if (rests) continue;
    tp_document_cell(d, "%.4f", m->velocity_x);
    tp_document_cell(d, "%.4f", m->velocity_y);
    tp_document_cell(d, "%.3g", m->turn_per_m);
  }
  tp_sheet_add_rest(d, rows, MOST_ROWS);
  tp_text_add(&caption, "The collapse is that %s.", tp_text_system_collapse(own, c));
  tp_document_tell(d, TP_PASSAGE_PARAGRAPH, 0, &caption);
  if (c->without_vertical) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "This is without the vertical part of the earthquake, the less safe here.");
  }
}

static void add_force_row(tp_document *d, const tp_block_system *s, const tp_system_case *c,
                          size_t k, bool wet) {
  const tp_system_force *f = c->forces + k;
  tp_document_outside_cell(d, s->blocks[s->contacts[k].first].name);
  tp_document_outside_cell(d, s->blocks[s->contacts[k].second].name);
  tp_document_word(d, tp_joint_state_name(f->state));
  if (c->has_forces) {
    tp_document_cell(d, "%.4g", tp_text_system_force_kn(f->normal_n_m, c));
    tp_document_cell(d, "%.4g", tp_text_system_force_kn(f->shear_n_m, c));
  } else {
    tp_document_word(d, "–");
    tp_document_word(d, "–");
  }
  add_length(d, s, f->x_m);
  add_length(d, s, f->y_m);
  if (wet) tp_document_cell(d, "%.4g", f->water_n_m.value / 1e3);
}

void tp_system_sheet_add_forces(tp_system_sheet *s, const tp_system_case *c) {
  static const char *const heads[] = {"Between", "and", "Joint", "N (kN/m)", "T (kN/m)"};
  const tp_block_system *own = s->system;
  const bool wet = c->has_forces && tp_system_case_is_wet(c);
  tp_document *d = &s->document;
  if (c->force_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, wet ? 8 : 7, wet ? 0xf8 : 0x78,
                    "Forces that hold the blocks just before it, one distribution of many");
  tp_sheet_add_heads(d, heads, 5);
  tp_document_cell(d, "at x (%s)", own->length_unit);
  tp_document_cell(d, "y (%s)", own->length_unit);
  if (wet) tp_document_word(d, "Water (kN/m)");
  for (size_t k = 0; k < c->force_count && k < MOST_ROWS; k++) add_force_row(d, own, c, k, wet);
  tp_sheet_add_rest(d, c->force_count, MOST_ROWS);
}

/* ---- columns -----------------------------------------------------------------------------------
 */

void tp_system_sheet_add_goodman_bray(tp_document *d, const tp_goodman_bray *own) {
  const tp_bounded factor = {own->fos, 0, NULL};
  char n[TP_NUMBER_SIZE];
  if (own->fos_is_least) {
    tp_document_cell(d, "above %s", tp_text_significant_down(n, factor, 4));
  } else {
    tp_document_cell(d, "%s", tp_text_fixed_down(n, factor, 5));
  }
}

static void add_column_facts(tp_document *d, const tp_system_case *c) {
  const tp_goodman_bray *own = &c->goodman_bray;
  double ratio = 0;
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Limit equilibrium by Goodman and Bray (1976)");
  tp_document_word(d, "Factor of safety");
  if (own->has_fos) {
    tp_system_sheet_add_goodman_bray(d, own);
  } else {
    tp_document_word(d, "none: no greater friction is enough");
  }
  if (own->has_friction_angle) {
    tp_document_word(d, "At a friction angle of");
    tp_document_cell(d, "%.3f°", own->friction_angle_deg);
  }
  if (tp_goodman_bray_cost(&ratio, c)) {
    tp_document_word(d, "Friction asked for, over what forces need that act where it is best");
    tp_document_cell(d, "%.4g", ratio);
  }
  if (own->column_count > 0) {
    tp_text zones = {0};
    tp_text_goodman_bray_zones(&zones, own, d->language);
    tp_document_word(d, "Zones, columns from the toe up");
    tp_document_take_cell(d, &zones);
  }
  if (!own->has_support) return;
  tp_document_word(d, "Support at the toe, horizontal");
  if (own->support_n_m > 0) {
    tp_document_cell(d, "%.5g kN/m", own->support_n_m / 1e3);
  } else {
    tp_document_word(d, "none needed");
  }
}

void tp_system_sheet_add_columns(tp_system_sheet *s, const tp_system_case *c) {
  static const char *const heads[] = {"Column",    "State",   "Against toppling", "Against sliding",
                                      "Passed on", "Base, N", "Base, T"};
  const tp_goodman_bray *own = &c->goodman_bray;
  tp_document *d = &s->document;
  bool all_hold = true;
  if (!own->applies) return;
  add_column_facts(d, c);
  if (!own->has_forces || own->column_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 7, 0x7c,
                    "Columns from the toe up, at the friction that there is: forces in kN/m");
  tp_sheet_add_heads(d, heads, 7);
  for (size_t k = 0; k < own->column_count; k++) {
    const tp_goodman_bray_column *column = own->columns + k;
    const double forces[] = {column->toppling_n_m, column->sliding_n_m, column->push_n_m,
                             column->base_normal_n_m, column->base_shear_n_m};
    all_hold = all_hold && column->base_holds;
    if (k >= MOST_ROWS) continue;
    tp_document_outside_cell(d, s->system->blocks[column->block].name);
    tp_document_word(d, tp_column_state_name(column->state));
    for (size_t n = 0; n < 5; n++) tp_document_cell(d, "%.1f", forces[n] / 1e3);
  }
  tp_sheet_add_rest(d, own->column_count, MOST_ROWS);
  if (all_hold) return;
  tp_document_add(d, TP_PASSAGE_CAUTION,
                  "Caution: under some columns the base would have to pull, or slip up the slope: "
                  "there the method's forces cannot be.");
}

/* ---- blocks and contacts -----------------------------------------------------------------------
 */

void tp_system_sheet_add_blocks(tp_system_sheet *s) {
  static const char *const heads[] = {"Block",   "",        "Area (m²)",
                                      "x_G (m)", "y_G (m)", "Weight (kN/m)"};
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  tp_document_heading(d, 2, "Blocks and contacts");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 6, 0x3c, "Blocks, with their centroids");
  tp_sheet_add_heads(d, heads, 6);
  for (size_t k = 0; k < own->block_count && k < MOST_ROWS; k++) {
    const tp_system_block *block = own->blocks + k;
    tp_document_outside_cell(d, block->name);
    tp_document_word(d, block->ground ? "ground" : "free");
    tp_sheet_add_number(d, block->area_m2, 6);
    tp_sheet_add_number(d, block->centroid_x_m, 6);
    tp_sheet_add_number(d, block->centroid_y_m, 6);
    if (block->has_weight) {
      tp_sheet_add_number(d, tp_text_over(block->weight_n_m, 1e3), 6);
    } else {
      tp_document_word(d, "–");
    }
  }
  tp_sheet_add_rest(d, own->block_count, MOST_ROWS);
}

void tp_system_sheet_add_contacts(tp_system_sheet *s) {
  static const char *const heads[] = {"Between", "and"};
  static const char *const strength[] = {"φ (°)", "c (kPa)", "σ (kPa)"};
  const tp_block_system *own = s->system;
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 9, 0x1fc,
                    "Contacts, with their ends and the strength of their joints");
  tp_sheet_add_heads(d, heads, 2);
  tp_document_cell(d, "from x (%s)", own->length_unit);
  tp_document_cell(d, "y (%s)", own->length_unit);
  tp_document_cell(d, "to x (%s)", own->length_unit);
  tp_document_cell(d, "y (%s)", own->length_unit);
  tp_sheet_add_heads(d, strength, 3);
  for (size_t k = 0; k < own->contact_count && k < MOST_ROWS; k++) {
    const tp_system_contact *c = own->contacts + k;
    tp_document_outside_cell(d, own->blocks[c->first].name);
    tp_document_outside_cell(d, own->blocks[c->second].name);
    add_length(d, own, c->from_x_m.value);
    add_length(d, own, c->from_y_m.value);
    add_length(d, own, c->to_x_m.value);
    add_length(d, own, c->to_y_m.value);
    tp_sheet_add_number(d, c->friction_angle_deg, 5);
    tp_sheet_add_number(d, c->cohesion_kpa, 5);
    tp_sheet_add_number(d, c->tension_kpa, 5);
  }
  tp_sheet_add_rest(d, own->contact_count, MOST_ROWS);
}
