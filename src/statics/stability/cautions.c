/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cautions that need the geometry of the problem: water on an inclined face, contact in one point,
 * vertices that nearly touch the profile, one-sided earthquakes, anchors that pull off the base. */

#include "stability/cautions.h"

#include "base/closeness.h"
#include "common/notes.h"
#include "evaluation/normal_stress.h"
#include "evaluation/rest_result.h"
#include "output/text.h"
#include "scene/anchor.h"
#include "stability/earthquakes.h"
#include "stability/water_cautions.h"

#include <math.h>
#include <stdio.h>

/* How the side of the block that water wets differs from a face normal to the base. */
typedef struct side {
  bool out, back; /* it leans out over the water somewhere, or back from it */
} side;

/* Up the outline from the up-dip end of the joint, a vertex, as far as the water reaches. */
static side wetted_side(const tp_problem *problem, long heel, bool left) {
  const tp_lattice *l = &problem->lattice;
  const tp_scene *scene = problem->scene;
  const long count = l->start[1];
  side found = {false, false};
  fmpq_t level, height;
  fmpq_init(level);
  fmpq_init(height);
  fmpq_mul(level, scene->loads.water.height.value, scene->metres_per_unit);
  fmpq_div(level, level, l->step_m);
  fmpq_add_fmpz(level, level, l->y + heel);
  for (long k = heel, seen = 0; seen < count; seen++) {
    const long next = left ? (k + 1) % count : (k + count - 1) % count;
    fmpq_set_fmpz(height, l->y + k);
    if (fmpq_cmp(height, level) >= 0) break;
    const int out = fmpz_cmp(l->x + next, l->x + k);
    found.out = found.out || (left ? out > 0 : out < 0);
    found.back = found.back || (left ? out < 0 : out > 0);
    k = next;
  }
  fmpq_clear(level);
  fmpq_clear(height);
  return found;
}

/* Water is put on a face normal to the base; its push along the base is the same on any side of the
 * same height, but not the one normal to it. */
static tp_status note_water(tp_notes *notes, const tp_problem *problem, bool left,
                            tp_message *message) {
  const tp_contact *contact = &problem->contact;
  const tp_water_description *water = &problem->scene->loads.water;
  if (water->lifts_alone) return tp_earthquake_note_water(notes, water, message);
  const long end = problem->joint.vertex[left ? 1 : 0];
  const tp_contact_point *heel = contact->points + (left ? contact->point_count - 1 : 0);
  const tp_lattice *l = &problem->lattice;
  const char *towards = left ? "left" : "right";
  const char *stance = problem->placement.world != NULL ? "as it lies," : "tilted";
  const long facet = left ? heel->left : heel->right;
  if (facet >= 0 && end == tp_contact_extreme(contact, !left).point) {
    const tp_facet *f = contact->facets + facet;
    if (fmpz_equal(l->x + f->t0, l->x + f->t1)) {
      const tp_status status = tp_notes_add(
          notes, message, TP_CAUTION, water->place,
          "%s towards the %s, the contact ends up-dip in an upright facet: the water is taken "
          "to stand above the upper end of that facet, and none behind it",
          stance, towards);
      if (status != TP_OK) return status;
    }
  }
  if (end < 0) return TP_OK; /* inside an edge, which goes on under the water */
  const side wetted = wetted_side(problem, end, left);
  if (!wetted.out && !wetted.back) return TP_OK;
  return tp_notes_add(
      notes, message, TP_CAUTION, water->place,
      "%s towards the %s, the water is put on a face normal to the base, but "
      "the side of the block that it wets leans %s: its %s push there is neglected, "
      "which is %s; give it as 'pressures' on the edges that it wets",
      stance, towards, wetted.out ? "out over it" : "back from it",
      wetted.out ? "upwards" : "downwards", wetted.out ? "unconservative" : "conservative");
}

static bool is_one_point(const tp_contact *contact, const tp_lattice *l) {
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (!tp_lattice_same_point(l, f->q0, f->q1) ||
        !tp_lattice_same_point(l, f->q0, contact->facets->q0)) {
      return false;
    }
  }
  return true;
}

/* Vertices of straight edges that nearly touch a profile. */
static tp_status note_near(tp_notes *notes, const tp_problem *problem, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const tp_block_description *block = &scene->block;
  if (scene->base.mated || problem->placement.jointed != NULL ||
      problem->placement.snapped != NULL || block->form == TP_OUTLINE_ELLIPSE ||
      block->arc_count > 0 || problem->corners.count > 0) {
    return TP_OK;
  }
  tp_closeness near;
  tp_near_miss miss;
  char gap[200], more[100] = "";
  tp_closeness_init(&near, &problem->section, &problem->base, &problem->lattice);
  if (!tp_near_miss_find(&miss, &near, false)) return tp_fail_memory(message, "the contact");
  if (miss.count == 0) return TP_OK;
  tp_near_miss_text(gap, sizeof gap, &miss, &near);
  if (miss.count > 1) {
    snprintf(more, sizeof more, ", the largest of %ld such gaps", miss.count);
  }
  const tp_polyline *line = miss.pair.of_base ? &problem->base.ring : problem->section.rings;
  return tp_notes_add(notes, message, TP_CAUTION, tp_polyline_place(line, miss.pair.vertex),
                      "%s%s, and does not touch: contact is exact; if it should, say %s'contact: "
                      "{within: …}'",
                      gap, more, problem->placement.rested == NULL ? "'place: rest', or " : "");
}

/* An earthquake shakes both ways, and one direction of tilt looks at one of them. */
static tp_status note_one_side(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  if (!tp_earthquake_is_one_sided(scene)) return TP_OK;
  return tp_notes_add(
      notes, message, TP_CAUTION, scene->loads.seismic_place,
      "the earthquake is considered down-dip only, but it shakes both ways: say "
      "'frame: world' for a block on a slope, solve with 'horizontal' below 0 too, or "
      "say 'direction: down_dip' where this is meant");
}

/* The pull away from the base, in the frame of its mean plane: to a side between along it and along
 * it the other way. */
static bool pulls_off(const fmpq_t direction_deg) {
  enum { TURN = 360 };
  fmpz_t turns;
  fmpq_t rest;
  fmpz_init(turns);
  fmpq_init(rest);
  fmpq_set_si(rest, 1, TURN);
  fmpq_mul(rest, rest, direction_deg);
  fmpz_fdiv_q(turns, fmpq_numref(rest), fmpq_denref(rest));
  fmpq_sub_fmpz(rest, rest, turns); /* of a turn */
  fmpq_mul_2exp(rest, rest, 1);
  const bool off = fmpq_sgn(rest) > 0 && fmpq_cmp_si(rest, 1) < 0;
  fmpz_clear(turns);
  fmpq_clear(rest);
  return off;
}

static tp_status note_anchors(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  tp_status status = TP_OK;
  for (long k = 0; k < loads->anchor_count && status == TP_OK; k++) {
    const tp_anchor_description *a = loads->anchors + k;
    fmpq_t direction;
    fmpq_init(direction);
    tp_anchor_direction(direction, scene, a);
    const bool off = fmpq_sgn(tp_anchor_bolt_force(a)->value) > 0 && pulls_off(direction);
    fmpq_clear(direction);
    if (!off) continue;
    status = a->direction_deg.given
                 ? tp_notes_add(notes, message, TP_CAUTION, a->direction_deg.place,
                                "this anchor pulls the block off its base: 'direction_deg' is that "
                                "of the pull on the block, from x towards y; into the base it is "
                                "below 0")
                 : tp_notes_add(notes, message, TP_CAUTION,
                                a->dip_deg.given ? a->dip_deg.place : a->direction_deg.place,
                                "this bolt pulls the block off its base: 'dip_deg' is above 0 "
                                "downwards; into the rock below it is steeper than this");
  }
  return status;
}

/* Levelled along x, a sole that dips off it comes to lie flatter, or steeper. */
static tp_status note_levelled(tp_notes *notes, const tp_problem *problem, tp_message *message) {
  const tp_smoothed *own = problem->placement.smoothed;
  if (own == NULL || !own->inclined) return TP_OK;
  const tp_scene *scene = &own->scene;
  const double degree = acos(-1) / 180, off = fabs(atan(fmpq_get_d(own->incline))) / degree;
  return tp_notes_add(
      notes, message, TP_CAUTION, own->all ? scene->friction_is_place : scene->base.smooth.place,
      "the mean line of the sole, all of which is levelled along x, is inclined to x "
      "by %.2f°: give the coordinates along it, or as the block lies, 'frame: world'",
      off);
}

/* What is reported is the pose at rest. A block that was measured in its place lies otherwise. */
static tp_status note_turned(tp_notes *notes, const tp_problem *problem, tp_message *message) {
  static const double few = 3;
  const tp_rested *own = problem->placement.rested;
  if (own == NULL || problem->placement.jointed != NULL) return TP_OK;
  const tp_bounded turned = tp_rest_turned_deg(own);
  char n[TP_NUMBER_SIZE];
  if (fabs(turned.value) <= few) return TP_OK;
  return tp_notes_add(notes, message, TP_CAUTION, problem->scene->base.rests_place,
                      "'place: rest' turned the block by %s°, and all results are of that pose: if "
                      "it was surveyed in its place, check outline and profile, or say 'contact: "
                      "{within: …}' instead",
                      tp_text_fixed(n, turned, 2));
}

tp_status tp_problem_cautions(tp_notes *notes, const tp_problem *problem, tp_message *message) {
  const tp_scene *scene = problem->scene;
  tp_status status = TP_OK;
  if (is_one_point(&problem->contact, &problem->lattice)) {
    const tp_place place = scene->base.place.file != NULL ? scene->base.place : scene->block.place;
    status = tp_notes_add(notes, message, TP_CAUTION, place,
                          "the block touches its base in one place only: it can balance there at "
                          "single tilts, where all moments about that place cancel, and at no "
                          "others; whether it balances at such a tilt may stay "
                          "undecided");
  }
  if (status == TP_OK) status = note_turned(notes, problem, message);
  if (status == TP_OK) status = note_near(notes, problem, message);
  if (status == TP_OK) status = tp_normal_stress_cautions(notes, problem, message);
  if (status == TP_OK) status = note_one_side(notes, scene, message);
  if (status == TP_OK) status = note_levelled(notes, problem, message);
  if (status == TP_OK) status = note_anchors(notes, scene, message);
  if (status == TP_OK && tp_problem_has_wetted(problem)) {
    return tp_water_cautions(notes, problem, message);
  }
  if (!scene->loads.water.given || fmpq_is_zero(scene->loads.water.height.value)) return status;
  const bool way[2] = {scene->towards_left, scene->towards_right};
  for (int k = 0; k < 2; k++) {
    if (way[k] && status == TP_OK) status = note_water(notes, problem, k == 0, message);
    if (way[k] && status == TP_OK) status = tp_water_note_joint(notes, problem, k == 0, message);
  }
  return status;
}
