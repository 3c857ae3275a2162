/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key `limit`: the static limit as JSON (docs/limit.md). */

#include "report/limit.h"

#include "report/parts_json.h"

/* Where the limit lies, what moves there and what is as near. */
static void add_answer(tp_json *j, const tp_limit *l) {
  const bool nowhere = l->kind == TP_LIMIT_NOWHERE;
  tp_json_known(j, "critical_angle_deg", l->kind == TP_LIMIT_AT_ANGLE, l->critical_angle_deg);
  tp_json_string(j, "mechanism", nowhere ? "holds nowhere" : tp_mechanism_name(l->mechanism));
  tp_json_string(j, "tied_with", l->tie ? tp_mechanism_name(l->tied_with) : NULL);
  tp_json_tie(j, l->tie, l->tie_bits);
  tp_json_break(j);
  tp_json_known(j, "centre_x_m", l->has_centre, l->centre_x_m);
  tp_json_known(j, "centre_y_m", l->has_centre, l->centre_y_m);
  tp_json_truth(j, "base_beyond_toe", l->base_beyond_toe);
  tp_json_bounded(j, "friction_angle_deg", l->friction_angle_deg);
  tp_json_fos(j, "fos", l->fos);
}

static void add_facet(tp_json *j, const tp_limit *l) {
  if (!l->has_facet) return;
  tp_json_break(j);
  tp_json_array(j, "facet", TP_JSON_LINE);
  tp_json_point(j, NULL, l->facet_x0_m, l->facet_y0_m);
  tp_json_point(j, NULL, l->facet_x1_m, l->facet_y1_m);
  tp_json_close(j);
}

static void add_reactions(tp_json *j, const tp_limit *l) {
  tp_json_break(j);
  tp_json_array(j, "reactions", TP_JSON_LINE);
  for (size_t k = 0; k < l->reaction_count; k++) {
    const tp_reaction *r = l->reactions + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_bounded(j, "x_m", r->x_m);
    tp_json_bounded(j, "y_m", r->y_m);
    tp_json_bounded(j, "share_x", r->share_x);
    tp_json_bounded(j, "share_y", r->share_y);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static const char *from_where(const tp_limit *back) {
  switch (back->kind) {
  case TP_LIMIT_AT_ANGLE:
    return "angle";
  case TP_LIMIT_INTERLOCKED:
    return "every tilt";
  case TP_LIMIT_NOWHERE:
    return "nowhere";
  case TP_LIMIT_NOT_ASKED:
  case TP_LIMIT_UNDECIDED:
    break;
  }
  return "undecided";
}

/* The least tilt at which forces hold it; null where there is none, and why. */
static void add_holds_from(tp_json *j, const tp_limit *back) {
  const tp_bounded from = {.value = 0 - back->critical_angle_deg.value,
                           .error = back->critical_angle_deg.error};
  tp_json_string(j, "holds_from", from_where(back));
  tp_json_known(j, "holds_from_deg", back->kind == TP_LIMIT_AT_ANGLE, from);
  if (back->kind == TP_LIMIT_AT_ANGLE) return;
  tp_json_string(j, "holds_from_is",
                 back->kind == TP_LIMIT_UNDECIDED ? "undecided"
                 : back->kind == TP_LIMIT_NOWHERE ? "at no tilt"
                                                  : "however far it is tilted back");
}

void tp_json_limit(tp_json *j, const tp_case *c) {
  const tp_limit *l = &c->limit;
  if (l->kind == TP_LIMIT_NOT_ASKED) return;
  tp_json_object(j, "limit", TP_JSON_LINE);
  add_answer(j, l);
  tp_json_truth(j, "turns_up_dip", l->turns_up_dip);
  add_facet(j, l);
  add_reactions(j, l);
  tp_json_break(j);
  tp_json_object(j, "otherwise", TP_JSON_FLUSH);
  add_answer(j, &c->limit_otherwise);
  tp_json_close(j);
  add_holds_from(j, &c->limit_back);
  tp_json_truth(j, "base_matters", c->base_matters);
  tp_json_truth(j, "slides_sooner", c->slides_sooner);
  tp_json_close(j);
}
