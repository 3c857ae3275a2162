/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Resting poses of a sheet, and what becomes of the block at all other shifts: two tables, as the
 * page for a terminal lists them. */

#include "report/sheet.h"

#include "report/poses.h"
#include "terms/names.h"

static void add_row(tp_sheet *s, size_t k) {
  const tp_poses_result *r = &s->solution->poses;
  const tp_resting_pose *pose = r->poses + k;
  const tp_page page = {.solution = s->solution};
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE + 4];
  if (r->has_given && r->given == k) tp_document_mark_row(d);
  tp_document_cell(d, "%zu", k + 1);
  tp_document_cell(d, "%s %%", tp_pose_percent(n, pose->share));
  tp_document_cell(d, "%s", tp_text_fixed(n, pose->rest.turned_deg, 3));
  tp_document_cell(d, "%s", tp_page_length(&page, n, pose->centroid_y_m, 5));
  tp_document_cell(d, "%s", tp_page_length(&page, n, pose->first_contact_x_m, 5));
  tp_document_cell(d, "%s", tp_page_length(&page, n, pose->last_contact_x_m, 5));
  for (size_t c = 0; c < s->solution->case_count; c++) {
    tp_document_told_cell(d, tp_pose_lets_go(n, pose, c));
  }
}

static void add_poses(tp_sheet *s) {
  const tp_solution *own = s->solution;
  tp_document *d = &s->document;
  const char *unit = own->length_unit;
  const size_t columns = 6 + own->case_count;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, columns, 0xff,
                    "Resting poses: share of the shifts, height of the centroid, contact, tilt at "
                    "which it begins to move");
  tp_document_cell(d, "Pose");
  tp_document_cell(d, "Share");
  tp_document_cell(d, "Turned (°)");
  tp_document_cell(d, "Height (%s)", unit);
  tp_document_cell(d, "From x (%s)", unit);
  tp_document_cell(d, "To x (%s)", unit);
  for (size_t c = 0; c < own->case_count; c++) {
    tp_document_word(d, own->cases[c].towards == TP_TOWARDS_LEFT ? "to the left" : "to the right");
  }
  for (size_t k = 0; k < own->poses.pose_count && k < TP_POSE_ROWS; k++) add_row(s, k);
}

static void add_other_shifts(tp_sheet *s) {
  tp_document *d = &s->document;
  bool any = false;
  for (int end = TP_ROLLS_OFF_LEFT; end <= TP_SETTLING_UNDECIDED; end++) {
    const tp_bounded share = tp_poses_share(&s->solution->poses, (tp_settling_end)end);
    char n[TP_NUMBER_SIZE];
    if (share.value == 0) continue;
    if (!any) tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "At all other shifts");
    any = true;
    tp_document_word(d, tp_settling_end_name((tp_settling_end)end));
    tp_document_cell(d, "%s %%", tp_pose_percent(n, share));
  }
}

static void add_first(tp_sheet *s, size_t c) {
  const tp_poses_result *r = &s->solution->poses;
  const size_t first = tp_poses_first_to_move(r, c);
  char n[TP_NUMBER_SIZE + 4];
  if (first == r->pose_count) return;
  const tp_pose_verdict *v = r->poses[first].verdicts + c;
  tp_document *d = &s->document;
  const char *mechanism = tp_document_say(d, tp_mechanism_name(v->first));
  const bool left = v->towards == TP_TOWARDS_LEFT;
  if (v->has_critical_angle) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    left ? "Towards the left pose %zu begins to move first: %s, %s."
                         : "Towards the right pose %zu begins to move first: %s, %s.",
                    first + 1, tp_pose_lets_go(n, r->poses + first, c), mechanism);
  } else {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    left ? "Towards the left pose %zu begins to move first: %s."
                         : "Towards the right pose %zu begins to move first: %s.",
                    first + 1, mechanism);
  }
}

void tp_sheet_add_poses(tp_sheet *s) {
  const tp_poses_result *r = &s->solution->poses;
  const tp_page page = {.solution = s->solution};
  const char *unit = s->solution->length_unit;
  tp_document *d = &s->document;
  char n[3][TP_NUMBER_SIZE];
  if (!r->known) return;
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Resting poses from all shifts along x, from %s to %s %s: %zu. None is missed "
                  "whose range of shifts exceeds %s %s.",
                  tp_page_length(&page, n[0], r->from_m, 5),
                  tp_page_length(&page, n[1], r->to_m, 5), unit, r->pose_count,
                  tp_page_length(&page, n[2], r->spacing_m, 3), unit);
  add_poses(s);
  if (r->pose_count > TP_POSE_ROWS) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH, "… and %zu more, less likely (--json lists them)",
                    r->pose_count - TP_POSE_ROWS);
  }
  add_other_shifts(s);
  if (r->has_given) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "All other results are for pose %zu, which the block reaches as given.",
                    r->given + 1);
  }
  for (size_t c = 0; c < s->solution->case_count; c++) add_first(s, c);
}
