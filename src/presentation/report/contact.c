/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Frame, base, contact ends, rest and snapping of a solution in words and numbers, followed by the
 * cautions on them; the same as JSON. */

#include "report/contact.h"

#include "report/earthquakes.h"
#include "report/joint.h"
#include "report/parts_json.h"
#include "report/supports.h"
#include "report/words.h"
#include "terms/names.h"

static void add_beyond(tp_page *p, const tp_contact_result *c) {
  const char *unit = p->solution->length_unit;
  char n[2][TP_NUMBER_SIZE];
  const bool left = c->beyond_left_m.value > 0, right = c->beyond_right_m.value > 0;
  const bool cut = c->left_end != TP_END_WHOLE || c->right_end != TP_END_WHOLE;
  tp_page_length(p, n[0], c->beyond_left_m, 6);
  tp_page_length(p, n[1], c->beyond_right_m, 6);
  if (!left && !right) {
    tp_text_add(&p->text, "ends with the %s on both sides", cut ? "contact" : "block");
  } else if (left && right) {
    tp_text_add(&p->text, "extends by %s %s on the left, %s %s on the right", n[0], unit, n[1],
                unit);
  } else {
    tp_text_add(&p->text, "ends with the %s on the %s, extends for %s %s on the %s",
                cut ? "contact" : "block", left ? "right" : "left", left ? n[0] : n[1], unit,
                left ? "left" : "right");
  }
}

static void add_corner_points(tp_page *p, const tp_contact_result *c) {
  if (c->corner_points == 0) return;
  tp_text_add(&p->text,
              ";\n         %zu of the points %s a corner on a corner, not counted as support:\n"
              "         neither has a face there that gives a normal",
              c->corner_points, c->corner_points == 1 ? "is" : "are");
}

/* Why it ends there, in words. */
static const char *end_words(tp_contact_end end, bool left) {
  switch (end) {
  case TP_END_WHOLE:
    return left ? "the left end of the underside" : "the right end of the underside";
  case TP_END_STATED:
    return "as given by 'between'";
  case TP_END_STEEP:
    return "where the block's side begins, steeper than 45°";
  case TP_END_OVERHANG:
    return "where the underside turns back over its base";
  case TP_END_PROFILE:
    return left ? "where it touches its base first" : "where it touches its base last";
  }
  return "";
}

bool tp_contact_is_cut_by_default(const tp_contact_result *c) {
  return c->left_end == TP_END_STEEP || c->left_end == TP_END_OVERHANG ||
         c->right_end == TP_END_STEEP || c->right_end == TP_END_OVERHANG;
}

static void add_ends(tp_page *p, const tp_contact_result *c) {
  char n[4][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "\nContact  from (%s, %s), %s,\n         to (%s, %s), %s;",
              tp_page_coordinate(p, n[0], c->left_end_x_m),
              tp_page_coordinate(p, n[1], c->left_end_y_m), end_words(c->left_end, true),
              tp_page_coordinate(p, n[2], c->right_end_x_m),
              tp_page_coordinate(p, n[3], c->right_end_y_m), end_words(c->right_end, false));
  if (tp_contact_is_cut_by_default(c)) {
    tp_text_add(&p->text,
                "\n         (default: the scene gives neither 'between' nor 'mated: whole' for\n"
                "         all of the underside)");
  }
}

static void add_cautions(tp_page *p, const tp_contact_result *c) {
  char n[TP_NUMBER_SIZE];
  if (c->steep) {
    tp_text_add(&p->text,
                "         Caution: its steepest facet lies at %s° from the mean plane.\n"
                "         Facets steeper than 45° hold a block by interlocking, provided the rock\n"
                "         of the base is strong enough.\n",
                tp_page_degrees(n, c->steepest_deg));
  }
  if (c->reaches_far) {
    const tp_bounded percent = {100 * c->share_of_height.value, 101 * c->share_of_height.error,
                                NULL};
    tp_text_add(&p->text,
                "         Caution: it extends over %s %% of the block's height; is all of that "
                "in\n         contact?\n",
                tp_text_fixed(n, percent, 0));
  }
}

static void add_frame(tp_page *p) {
  const tp_frame_result *f = &p->solution->frame;
  char n[2][TP_NUMBER_SIZE];
  if (f->slope) {
    tp_text_add(&p->text, "Slope    dips by %s°", tp_text_fixed(n[0], f->dip_deg, 3));
    if (f->dips) tp_text_add(&p->text, " towards the %s", tp_direction_name(f->dips_towards));
    if (f->has_dip_direction) {
      tp_text_add(&p->text, ", azimuth %s°", tp_text_fixed(n[1], f->dip_direction_deg, 1));
    }
    tp_text_add(&p->text, ";\n         x runs along it and y normal to it%s\n",
                f->level ? ", forces are told\n         along the horizontal and the vertical"
                         : "");
  } else if (f->world) {
    tp_text_add(&p->text, "Frame    world: the block as it lies. The mean plane, %s,\n         ",
                f->fitted ? "fitted to the contact" : "as given in the scene");
    if (f->dips) {
      tp_text_add(&p->text, "dips by %s° towards the %s", tp_text_fixed(n[0], f->dip_deg, 3),
                  tp_direction_name(f->dips_towards));
    } else {
      tp_text_add(&p->text, "is level");
    }
    if (f->dips && f->has_dip_direction) {
      tp_text_add(&p->text, ",\n         azimuth %s°",
                  tp_text_fixed(n[1], f->dip_direction_deg, 1));
    }
    tp_text_add(&p->text,
                ";\n         x is horizontal and y vertical, as in the scene, forces are told\n"
                "         along the %s\n",
                f->level ? "horizontal and the vertical" : "plane and normal to it");
  } else if (f->inclined) {
    tp_text_add(&p->text,
                "Frame    Caution: the mean line of the contact is inclined to x by %s°, and the\n"
                "         scene does not give 'frame'. x is taken along the mean plane of the base,"
                "\n         level at a tilt of 0: say 'frame: base'. If y runs upwards and the "
                "block\n         lies on a slope as drawn, say 'frame: world'.\n",
                tp_text_fixed(n[0], f->inclination_deg, 3));
  }
}

/* Where a block that was set down on its profile came to rest. */
static void add_rest(tp_page *p) {
  const tp_rest_result *r = &p->solution->rest;
  const char *unit = p->solution->length_unit;
  char n[3][TP_NUMBER_SIZE];
  if (!r->known) return;
  tp_text_add(&p->text, "Rest     set down on its profile, it ");
  if (r->turns == 0) {
    tp_text_add(&p->text, "rests without turning;");
  } else {
    tp_text_add(&p->text, "turned by %s° in %zu turn%s;", tp_text_fixed(n[0], r->turned_deg, 3),
                r->turns, r->turns == 1 ? "" : "s");
  }
  tp_text_add(&p->text,
              "\n         its centroid moved by (%s, %s) %s. Its weight passes\n         %s %s "
              "right of the "
              "first",
              tp_page_length(p, n[0], r->moved_x_m, 5), tp_page_length(p, n[1], r->moved_y_m, 5),
              unit, tp_page_length(p, n[2], r->margin_left_m, 5), unit);
  tp_text_add(&p->text, " and %s %s left of the last\n         of %zu points of contact\n",
              tp_page_length(p, n[0], r->margin_right_m, 5), unit, r->contacts);
  if (r->margin_left_m.value < 0 || r->margin_right_m.value < 0) {
    tp_text_add(&p->text,
                "         Caution: the weight passes beside the contacts; the block is wedged "
                "between them\n");
  }
}

/* What was levelled of its sole. */
static void add_smoothed(tp_page *p) {
  const tp_smoothed_result *r = &p->solution->smoothed;
  const char *unit = p->solution->length_unit;
  char n[2][TP_NUMBER_SIZE];
  if (!r->known) return;
  if (r->apparent) {
    tp_text_add(&p->text, "Sole     levelled, as the friction angle is apparent: %zu facet%s",
                r->facets, r->facets == 1 ? "" : "s");
  } else {
    tp_text_add(&p->text, "Sole     smoothed: %zu facet%s shorter than %s %s levelled", r->facets,
                r->facets == 1 ? "" : "s", tp_page_length(p, n[0], r->wavelength_m, 5), unit);
  }
  tp_text_add(
      &p->text, " in %zu stretch%s;\n         the farthest vertex lay %s %s from its line\n",
      r->stretches, r->stretches == 1 ? "" : "es", tp_page_length(p, n[1], r->farthest_m, 5), unit);
}

/* What was moved to its contact. */
static void add_within(tp_page *p) {
  const tp_within_result *r = &p->solution->within;
  const char *unit = p->solution->length_unit;
  char n[2][TP_NUMBER_SIZE];
  if (!r->known) return;
  tp_text_add(&p->text, "Within   what lies within %s %s of its contact touches: ",
              tp_page_length(p, n[0], r->within_m, 5), unit);
  if (r->moved + r->taken == 0) {
    tp_text_add(&p->text, "nothing\n         had to be moved;");
  } else {
    tp_text_add(&p->text,
                "%zu vert%s\n         moved onto the base, %zu point%s of the profile taken into "
                "the\n         block, by %s %s at most;",
                r->moved, r->moved == 1 ? "ex" : "ices", r->taken, r->taken == 1 ? "" : "s",
                tp_page_length(p, n[0], r->farthest_m, 5), unit);
  }
  tp_text_add(&p->text, " largest overlap removed %s %s,\n         largest gap left %s %s\n",
              tp_page_length(p, n[0], r->overlap_removed_m, 5), unit,
              tp_page_length(p, n[1], r->gap_left_m, 5), unit);
}

void tp_page_add_contact(tp_page *p) {
  const tp_solution *s = p->solution;
  const tp_contact_result *c = &s->contact;
  char n[2][TP_NUMBER_SIZE];
  tp_page_add_joint(p);
  add_rest(p);
  add_within(p);
  add_smoothed(p);
  add_frame(p);
  tp_page_add_earthquakes(p);
  tp_page_add_supports(p);
  tp_text_add(&p->text, "Base     ");
  if (c->mated || c->shifted) {
    tp_text_add(&p->text, c->mated
                              ? "mated; it "
                              : "the counterpart of the underside before the shift; it\n         ");
    add_beyond(p, c);
    if (!c->beyond_stated) {
      tp_text_add(&p->text, "\n         (default: the scene does not give 'beyond')");
    }
  } else {
    tp_text_add(&p->text, "a separate profile, which ends where the scene ends it");
  }
  add_ends(p, c);
  tp_text_add(&p->text, "\n         %zu facet%s", c->facets, c->facets == 1 ? "" : "s");
  if (c->points > 0) {
    tp_text_add(&p->text, " and %zu contact%s in a point", c->points, c->points == 1 ? "" : "s");
  }
  tp_text_add(&p->text, ",%s%s %s long, %s %s along the mean plane",
              c->points > 0 ? "\n         " : " ", tp_page_length(p, n[0], c->length_m, 6),
              s->length_unit, tp_page_length(p, n[1], c->nominal_length_m, 6), s->length_unit);
  if (c->has_contact_ratio) {
    tp_text_add(&p->text, ",\n         contact ratio %s, the share of the underside",
                tp_text_significant(n[0], c->contact_ratio, 5));
  }
  if (s->block.has_weight && c->facets > 0) {
    tp_text_add(&p->text, ";\n         weight per area ");
    tp_page_add_stress(p, c->weight_per_contact_area_pa);
    if (c->nominal_length_m.value > 0) {
      tp_text_add(&p->text, ", per area of the mean plane ");
      tp_page_add_stress(p, c->weight_per_nominal_area_pa);
    }
  }
  add_corner_points(p, c);
  tp_text_add(&p->text, "\n");
  add_cautions(p, c);
}
