/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of resting poses with share of the shifts, turn, height of the centroid, range of shifts
 * and critical angle in each direction, the least stable pose, and what happens at all other shifts
 * (docs/rest.md); the same as JSON. */

#include "report/poses.h"

#include "report/contact.h"
#include "report/parts_json.h"
#include "report/words.h"

#include <stdio.h>

/* Rows that a page shows; JSON has them all. */
enum { ROWS = 16 };

static const char *percent(char out[TP_NUMBER_SIZE], tp_bounded share) {
  const tp_bounded hundred = {.value = 100 * share.value,
                              .error = 101 * share.error + 1e-15 * 100 * share.value};
  return tp_text_fixed(out, hundred, 2);
}

/* At which tilt the block lets go. */
static const char *lets_go(char out[TP_NUMBER_SIZE + 4], const tp_resting_pose *pose, size_t c) {
  const tp_pose_verdict *v = pose->verdicts + c;
  if (pose->verdict_count == 0) return "unsolved";
  if (!v->has_first_angle) {
    return v->first == TP_MECHANISM_UNDECIDED                    ? "undecided"
           : v->first == TP_STANDS || v->first == TP_INTERLOCKED ? "never"
                                                                 : "any tilt";
  }
  char n[TP_NUMBER_SIZE];
  snprintf(out, TP_NUMBER_SIZE + 4, "%s°", tp_text_fixed(n, v->first_angle_deg, 3));
  return out;
}

/* `°` is two bytes wide in a field, and one column. */
static void add_angle(tp_page *p, const tp_resting_pose *pose, size_t c) {
  char n[TP_NUMBER_SIZE + 4];
  const char *text = lets_go(n, pose, c);
  tp_text_add(&p->text,
              pose->verdict_count > 0 && pose->verdicts[c].has_first_angle ? " %11s" : " %10s",
              text);
}

static void add_head(tp_page *p) {
  const tp_solution *s = p->solution;
  char unit[3][32];
  snprintf(unit[0], sizeof unit[0], "height (%s)", s->length_unit);
  snprintf(unit[1], sizeof unit[1], "from (%s)", s->length_unit);
  snprintf(unit[2], sizeof unit[2], "to (%s)", s->length_unit);
  tp_text_add(&p->text, "  Pose   share    turned %11s %9s %9s", unit[0], unit[1], unit[2]);
  for (size_t c = 0; c < s->case_count; c++) {
    tp_text_add(&p->text, " %10s", tp_text_direction(s->cases[c].towards));
  }
  tp_text_add(&p->text, "\n");
}

static void add_row(tp_page *p, size_t k) {
  const tp_poses_result *r = &p->solution->poses;
  const tp_resting_pose *pose = r->poses + k;
  char n[5][TP_NUMBER_SIZE];
  tp_text_add(
      &p->text, "%c %4zu %6s%% %8s° %11s %9s %9s", r->has_given && r->given == k ? '>' : ' ', k + 1,
      percent(n[0], pose->share), tp_text_fixed(n[1], pose->rest.turned_deg, 3),
      tp_page_length(p, n[2], pose->centroid_y_m, 5), tp_page_length(p, n[3], pose->first_x_m, 5),
      tp_page_length(p, n[4], pose->last_x_m, 5));
  for (size_t c = 0; c < p->solution->case_count; c++) add_angle(p, pose, c);
  tp_text_add(&p->text, "\n");
}

/* What becomes of the block elsewhere. */
static void add_rest_of_shifts(tp_page *p) {
  const tp_poses_result *r = &p->solution->poses;
  for (int end = TP_ROLLS_OFF_LEFT; end <= TP_SETTLING_UNDECIDED; end++) {
    tp_bounded share = {0};
    for (size_t k = 0; k < r->basin_count; k++) {
      if ((int)r->basins[k].end != end) continue;
      share.value += r->basins[k].share.value;
      share.error += r->basins[k].share.error + 1e-15;
    }
    if (share.value == 0) continue;
    char n[TP_NUMBER_SIZE];
    tp_text_add(&p->text, "       %6s%% %s\n", percent(n, share), tp_settling_end_name(end));
  }
}

/* The pose that lets go first; as many as there are where none is solved. */
static size_t least_of(const tp_poses_result *r, size_t c) {
  size_t k = 0;
  while (k < r->pose_count && !r->poses[k].verdicts[c].least) k++;
  return k;
}

static void add_least(tp_page *p) {
  const tp_poses_result *r = &p->solution->poses;
  for (size_t c = 0; c < p->solution->case_count; c++) {
    const size_t least = least_of(r, c);
    if (least == r->pose_count) continue;
    const tp_resting_pose *pose = r->poses + least;
    const tp_pose_verdict *v = pose->verdicts + c;
    char n[TP_NUMBER_SIZE + 4];
    tp_text_add(&p->text, "  %s the %s, pose %zu begins to move first: ",
                p->solution->frame.world ? "Towards" : "Tilted towards",
                tp_text_direction(v->towards), least + 1);
    if (v->has_first_angle) tp_text_add(&p->text, "%s, ", lets_go(n, pose, c));
    tp_text_add(&p->text, "%s.\n", tp_mechanism_name(v->first));
  }
}

void tp_page_add_poses(tp_page *p) {
  const tp_poses_result *r = &p->solution->poses;
  const char *unit = p->solution->length_unit;
  char n[3][TP_NUMBER_SIZE];
  if (!r->known) return;
  tp_text_add(&p->text,
              "\nResting poses from all shifts along x, from %s to %s %s: %zu.\n"
              "None is missed whose range of shifts exceeds %s %s.\n"
              "Share of shifts, centroid height, contact, tilt at which it begins to move:\n\n",
              tp_page_length(p, n[0], r->from_m, 5), tp_page_length(p, n[1], r->to_m, 5), unit,
              r->pose_count, tp_page_length(p, n[2], r->spacing_m, 3), unit);
  add_head(p);
  for (size_t k = 0; k < r->pose_count && k < ROWS; k++) add_row(p, k);
  if (r->pose_count > ROWS) {
    tp_text_add(&p->text, "  … and %zu more, less likely (--json lists them)\n",
                r->pose_count - ROWS);
  }
  add_rest_of_shifts(p);
  tp_text_add(&p->text, "\n");
  if (r->has_given) {
    tp_text_add(&p->text,
                "> All other results are for pose %zu, which the block reaches as given.\n",
                r->given + 1);
  }
  add_least(p);
}

static void json_verdict(tp_json *j, const tp_resting_pose *pose, size_t c) {
  const tp_pose_verdict *v = pose->verdicts + c;
  if (pose->verdict_count == 0) return;
  tp_json_string(j, "mechanism", tp_mechanism_name(v->mechanism));
  tp_json_string(j, "first", tp_mechanism_name(v->first));
  tp_json_known(j, "critical_angle_deg", v->has_first_angle, v->first_angle_deg);
  tp_json_known(j, "fos", v->fos.state == TP_FOS_NUMBER, v->fos.value);
}

static void json_pose(tp_json *j, const tp_resting_pose *pose, size_t c) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_bounded(j, "share", pose->share);
  tp_json_count(j, "basins", pose->basins);
  tp_json_count(j, "widest_basin", pose->widest);
  tp_json_bounded(j, "shift_m", pose->shift_m);
  tp_json_bounded(j, "centroid_y_m", pose->centroid_y_m);
  tp_json_break(j);
  tp_json_rest(j, &pose->rest);
  tp_json_break(j);
  tp_json_point(j, "first_contact", pose->first_x_m, pose->first_y_m);
  tp_json_point(j, "last_contact", pose->last_x_m, pose->last_y_m);
  tp_json_break(j);
  json_verdict(j, pose, c);
  tp_json_close(j);
}

static void json_basin(tp_json *j, const tp_basin *basin) {
  const bool rests = basin->end == TP_COMES_TO_REST;
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "end", tp_settling_end_name(basin->end));
  if (rests) {
    tp_json_count(j, "pose", basin->pose);
  } else {
    tp_json_null(j, "pose");
  }
  tp_json_bounded(j, "from_m", basin->from_m);
  tp_json_bounded(j, "to_m", basin->to_m);
  tp_json_bounded(j, "share", basin->share);
  tp_json_known(j, "turned_from_deg", rests, basin->turned_from_deg);
  tp_json_known(j, "turned_to_deg", rests, basin->turned_to_deg);
  tp_json_close(j);
}

static void json_index(tp_json *j, const char *key, bool known, size_t index) {
  if (known) {
    tp_json_count(j, key, index);
  } else {
    tp_json_null(j, key);
  }
}

void tp_json_poses(tp_json *j, const tp_poses_result *r, size_t c) {
  if (!r->known) return;
  tp_json_object(j, "poses", TP_JSON_BLOCK);
  tp_json_bounded(j, "from_m", r->from_m);
  tp_json_bounded(j, "to_m", r->to_m);
  tp_json_bounded(j, "spacing_m", r->spacing_m);
  tp_json_bounded(j, "border_m", r->border_m);
  tp_json_count(j, "settlings", r->settlings);
  json_index(j, "given", r->has_given, r->given);
  json_index(j, "least", least_of(r, c) < r->pose_count, least_of(r, c));
  tp_json_array(j, "poses", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->pose_count; k++) json_pose(j, r->poses + k, c);
  tp_json_close(j);
  tp_json_array(j, "basins", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->basin_count; k++) json_basin(j, r->basins + k);
  tp_json_close(j);
  tp_json_close(j);
}
