/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Gap, normal and contact point of a feature of the block and one of the base, for disc, straight
 * piece and hollow. */

#include "contact_springs/meeting.h"

#include <math.h>

tp_placing tp_placing_of(const tp_body_state *state) {
  return (tp_placing){state->moved, cos(state->turned), sin(state->turned)};
}

bool tp_features_can_meet(const tp_feature *of_block, const tp_feature *of_base) {
  if (of_block->kind == TP_FEATURE_DISC) return of_base->kind != TP_FEATURE_HOLLOW;
  return of_base->kind == TP_FEATURE_DISC;
}

static tp_xy negative(tp_xy v) {
  return (tp_xy){-v.x, -v.y};
}

static bool stands_above(double along, const tp_feature *piece, double grace) {
  return along >= -(grace + piece->before) && along <= piece->length + piece->behind + grace;
}

static bool disc_on_straight(tp_meeting *m, const tp_feature *disc, const tp_feature *piece,
                             const tp_placing *p, double grace, double below) {
  const tp_xy centre = tp_xy_plus(p->moved, 1, tp_placing_turn(p, disc->centre));
  const tp_xy v = tp_xy_minus(centre, piece->from);
  const double height = tp_xy_dot(v, piece->normal), along = tp_xy_dot(v, piece->tangent);
  m->gap = height - disc->radius;
  if (!(m->gap < below) || !stands_above(along, piece, grace)) return false;
  if (!tp_feature_reaches_beside(disc, tp_placing_turn_back(p, negative(piece->normal)))) {
    return false;
  }
  m->normal = piece->normal;
  m->at = tp_xy_plus(centre, -height, piece->normal);
  return true;
}

static bool straight_on_disc(tp_meeting *m, const tp_feature *piece, const tp_feature *disc,
                             const tp_placing *p, double grace, double below) {
  const tp_xy centre = tp_placing_turn_back(p, tp_xy_minus(disc->centre, p->moved));
  const tp_xy v = tp_xy_minus(centre, piece->from);
  m->gap = tp_xy_dot(v, piece->normal) - disc->radius;
  if (!(m->gap < below) || !stands_above(tp_xy_dot(v, piece->tangent), piece, grace)) return false;
  m->normal = negative(tp_placing_turn(p, piece->normal));
  if (!tp_feature_reaches_beside(disc, m->normal)) return false;
  m->at = tp_xy_plus(disc->centre, disc->radius, m->normal);
  return true;
}

static bool disc_on_disc(tp_meeting *m, const tp_feature *of_block, const tp_feature *of_base,
                         const tp_placing *p, double grace, double below) {
  const tp_xy centre = tp_xy_plus(p->moved, 1, tp_placing_turn(p, of_block->centre));
  const tp_xy v = tp_xy_minus(centre, of_base->centre);
  const double square = tp_xy_dot(v, v), reach = of_block->radius + of_base->radius + below;
  m->gap = below; /* at least, and most pairs are */
  if (!(square < reach * reach) || !(square > 0)) return false;
  const double apart = sqrt(square);
  m->gap = apart - of_block->radius - of_base->radius;
  m->normal = (tp_xy){v.x / apart, v.y / apart};
  const double slack = grace / apart;
  if (!tp_feature_reaches(of_base, m->normal, slack)) return false;
  if (!tp_feature_reaches(of_block, tp_placing_turn_back(p, negative(m->normal)), slack)) {
    return false;
  }
  m->at = tp_xy_plus(of_base->centre, of_base->radius, m->normal);
  return true;
}

static bool hollow_on_disc(tp_meeting *m, const tp_feature *hollow, const tp_feature *disc,
                           const tp_placing *p, double grace, double below) {
  const tp_xy centre = tp_xy_plus(p->moved, 1, tp_placing_turn(p, hollow->centre));
  const tp_xy v = tp_xy_minus(disc->centre, centre);
  const double apart = hypot(v.x, v.y);
  m->gap = hollow->radius - apart - disc->radius;
  if (!(m->gap < below) || !(apart > 0)) return false;
  const tp_xy outwards = {v.x / apart, v.y / apart};
  if (!tp_feature_reaches(hollow, tp_placing_turn_back(p, outwards), grace / apart)) return false;
  if (!tp_feature_reaches_beside(disc, outwards)) return false;
  m->normal = outwards; /* the rock of the block is behind the hollow's wall */
  m->at = tp_xy_plus(disc->centre, disc->radius, outwards);
  return true;
}

bool tp_features_meet(tp_meeting *meeting, const tp_feature *of_block, const tp_feature *of_base,
                      const tp_placing *placing, double grace, double below) {
  if (of_block->kind == TP_FEATURE_STRAIGHT) {
    return straight_on_disc(meeting, of_block, of_base, placing, grace, below);
  }
  if (of_block->kind == TP_FEATURE_HOLLOW) {
    return hollow_on_disc(meeting, of_block, of_base, placing, grace, below);
  }
  if (of_base->kind == TP_FEATURE_STRAIGHT) {
    return disc_on_straight(meeting, of_block, of_base, placing, grace, below);
  }
  return disc_on_disc(meeting, of_block, of_base, placing, grace, below);
}
