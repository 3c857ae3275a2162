/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key `limit`: the static limit as JSON (docs/limit.md). */

#include "report/limit.h"

#include "output/json.h"
#include "report/parts_json.h"
#include "report/words.h"

static void add_point(tp_text *t, tp_bounded x, tp_bounded y) {
  tp_text_add(t, "{");
  tp_json_number(t, "x_m", x);
  tp_text_add(t, ", ");
  tp_json_number(t, "y_m", y);
  tp_text_add(t, "}");
}

static void add_answer(tp_text *t, const tp_limit *l) {
  if (l->kind == TP_LIMIT_AT_ANGLE) {
    tp_json_number(t, "critical_angle_deg", l->critical_angle_deg);
  } else {
    tp_text_add(t, "\"critical_angle_deg\": null");
  }
  const bool nowhere = l->kind == TP_LIMIT_NOWHERE;
  tp_text_add(t, ", \"mechanism\": \"%s\", \"tied_with\": ",
              nowhere ? "holds nowhere" : tp_text_mechanism(l->mechanism));
  if (l->tie) {
    tp_text_add(t, "\"%s\"", tp_text_mechanism(l->tied_with));
    tp_json_tie(t, l->tie, l->tie_bits);
  } else {
    tp_text_add(t, "null");
  }
  tp_text_add(t, ",\n        ");
  if (l->has_centre) {
    tp_json_number(t, "centre_x_m", l->centre_x_m);
    tp_text_add(t, ", ");
    tp_json_number(t, "centre_y_m", l->centre_y_m);
  } else {
    tp_text_add(t, "\"centre_x_m\": null, \"centre_y_m\": null");
  }
  tp_text_add(t, ", \"base_beyond_toe\": %s, ", tp_json_truth(l->base_beyond_toe));
  tp_json_number(t, "friction_angle_deg", l->friction_angle_deg);
  tp_text_add(t, ", ");
  tp_json_fos(t, "fos", l->fos);
}

static void add_reactions(tp_text *t, const tp_limit *l) {
  tp_text_add(t, ",\n        \"reactions\": [");
  for (size_t k = 0; k < l->reaction_count; k++) {
    const tp_reaction *r = l->reactions + k;
    tp_text_add(t, "%s{", k > 0 ? ", " : "");
    tp_json_number(t, "x_m", r->x_m);
    tp_text_add(t, ", ");
    tp_json_number(t, "y_m", r->y_m);
    tp_text_add(t, ", ");
    tp_json_number(t, "share_x", r->share_x);
    tp_text_add(t, ", ");
    tp_json_number(t, "share_y", r->share_y);
    tp_text_add(t, "}");
  }
  tp_text_add(t, "]");
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
static void add_holds_from(tp_text *t, const tp_limit *back) {
  tp_text_add(t, "\"holds_from\": \"%s\", ", from_where(back));
  if (back->kind != TP_LIMIT_AT_ANGLE) {
    const bool nowhere = back->kind == TP_LIMIT_NOWHERE;
    tp_text_add(t, "\"holds_from_deg\": null, \"holds_from_is\": \"%s\"",
                back->kind == TP_LIMIT_UNDECIDED ? "undecided"
                : nowhere                        ? "at no tilt"
                                                 : "however far it is tilted back");
    return;
  }
  const tp_bounded from = {.value = 0 - back->critical_angle_deg.value,
                           .error = back->critical_angle_deg.error};
  tp_json_number(t, "holds_from_deg", from);
}

void tp_json_limit(tp_text *t, const tp_case *c) {
  const tp_limit *l = &c->limit;
  if (l->kind == TP_LIMIT_NOT_ASKED) return;
  tp_text_add(t, "      \"limit\": {");
  add_answer(t, l);
  tp_text_add(t, ", \"turns_up_dip\": %s", tp_json_truth(l->turns_up_dip));
  if (l->has_facet) {
    tp_text_add(t, ",\n        \"facet\": [");
    add_point(t, l->facet_x0_m, l->facet_y0_m);
    tp_text_add(t, ", ");
    add_point(t, l->facet_x1_m, l->facet_y1_m);
    tp_text_add(t, "]");
  }
  add_reactions(t, l);
  tp_text_add(t, ",\n        \"otherwise\": {");
  add_answer(t, &c->limit_otherwise);
  tp_text_add(t, "}, ");
  add_holds_from(t, &c->limit_back);
  tp_text_add(t, ", \"base_matters\": %s, \"slides_sooner\": %s},\n",
              tp_json_truth(c->base_matters), tp_json_truth(c->slides_sooner));
}
