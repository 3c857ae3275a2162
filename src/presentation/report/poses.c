/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of resting poses with share of the shifts, turn, height of the centroid, range of shifts
 * and critical angle in each direction, the least stable pose, and what happens at all other shifts
 * (docs/rest.md); the same as JSON. */

#include "report/poses.h"

#include "report/contact.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdio.h>

const char *tp_pose_percent(char out[TP_NUMBER_SIZE], tp_bounded share) {
  const tp_bounded hundred = {.value = 100 * share.value,
                              .error = 101 * share.error + 1e-15 * 100 * share.value};
  return tp_text_fixed(out, hundred, 2);
}

const char *tp_pose_lets_go(char out[TP_NUMBER_SIZE + 4], const tp_resting_pose *pose, size_t c) {
  const tp_pose_verdict *v = pose->verdicts + c;
  if (pose->verdict_count == 0) return "unsolved";
  if (!v->has_critical_angle) {
    return v->first == TP_MECHANISM_UNDECIDED                    ? "undecided"
           : v->first == TP_STANDS || v->first == TP_INTERLOCKED ? "never"
                                                                 : "any tilt";
  }
  char n[TP_NUMBER_SIZE];
  snprintf(out, TP_NUMBER_SIZE + 4, "%s°", tp_text_fixed(n, v->critical_angle_deg, 3));
  return out;
}

/* `°` is two bytes wide in a field, and one column. */
static void add_angle(tp_page *p, const tp_resting_pose *pose, size_t c) {
  char n[TP_NUMBER_SIZE + 4];
  const char *text = tp_pose_lets_go(n, pose, c);
  tp_text_add(&p->text,
              pose->verdict_count > 0 && pose->verdicts[c].has_critical_angle ? " %11s" : " %10s",
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
    tp_text_add(&p->text, " %10s", tp_direction_name(s->cases[c].towards));
  }
  tp_text_add(&p->text, "\n");
}

static void add_row(tp_page *p, size_t k) {
  const tp_poses_result *r = &p->solution->poses;
  const tp_resting_pose *pose = r->poses + k;
  char n[5][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "%c %4zu %6s%% %8s° %11s %9s %9s",
              r->has_given && r->given == k ? '>' : ' ', k + 1, tp_pose_percent(n[0], pose->share),
              tp_text_fixed(n[1], pose->rest.turned_deg, 3),
              tp_page_length(p, n[2], pose->centroid_y_m, 5),
              tp_page_length(p, n[3], pose->first_contact_x_m, 5),
              tp_page_length(p, n[4], pose->last_contact_x_m, 5));
  for (size_t c = 0; c < p->solution->case_count; c++) add_angle(p, pose, c);
  tp_text_add(&p->text, "\n");
}

tp_bounded tp_poses_share(const tp_poses_result *r, tp_settling_end end) {
  tp_bounded share = {0};
  for (size_t k = 0; k < r->basin_count; k++) {
    if (r->basins[k].end != end) continue;
    share.value += r->basins[k].share.value;
    share.error += r->basins[k].share.error + 1e-15;
  }
  return share;
}

/* What becomes of the block elsewhere. */
static void add_rest_of_shifts(tp_page *p) {
  for (int end = TP_ROLLS_OFF_LEFT; end <= TP_SETTLING_UNDECIDED; end++) {
    const tp_bounded share = tp_poses_share(&p->solution->poses, (tp_settling_end)end);
    char n[TP_NUMBER_SIZE];
    if (share.value == 0) continue;
    tp_text_add(&p->text, "       %6s%% %s\n", tp_pose_percent(n, share),
                tp_settling_end_name(end));
  }
}

/* The pose that begins to move first; as many as there are where none is solved. */
size_t tp_poses_first_to_move(const tp_poses_result *r, size_t c) {
  size_t k = 0;
  while (k < r->pose_count && !r->poses[k].verdicts[c].least) k++;
  return k;
}

static void add_least(tp_page *p) {
  const tp_poses_result *r = &p->solution->poses;
  for (size_t c = 0; c < p->solution->case_count; c++) {
    const size_t least = tp_poses_first_to_move(r, c);
    if (least == r->pose_count) continue;
    const tp_resting_pose *pose = r->poses + least;
    const tp_pose_verdict *v = pose->verdicts + c;
    char n[TP_NUMBER_SIZE + 4];
    tp_text_add(&p->text, "  %s the %s, pose %zu begins to move first: ",
                p->solution->frame.world ? "Towards" : "Tilted towards",
                tp_direction_name(v->towards), least + 1);
    if (v->has_critical_angle) tp_text_add(&p->text, "%s, ", tp_pose_lets_go(n, pose, c));
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
  for (size_t k = 0; k < r->pose_count && k < TP_POSE_ROWS; k++) add_row(p, k);
  if (r->pose_count > TP_POSE_ROWS) {
    tp_text_add(&p->text, "  … and %zu more, less likely (--json lists them)\n",
                r->pose_count - TP_POSE_ROWS);
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
