/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a block touches its base, as a solution has it. Included by topple.h. */

#ifndef TOPPLE_CONTACT_H
#define TOPPLE_CONTACT_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Why the contact of a base begins, or ends, where it does. */
typedef enum tp_contact_end {
  TP_END_WHOLE,    /* all of a mated underside: its leftmost or rightmost vertex */
  TP_END_STATED,   /* the scene's 'between' */
  TP_END_STEEP,    /* the default: from there on it rises by more than it runs (over 45 degrees) */
  TP_END_OVERHANG, /* the default: beyond it the underside turns back over its support */
  TP_END_PROFILE   /* a separate profile: where the block touches it first, or last */
} tp_contact_end;

/* What the coordinates of the scene lie along. Points of all results have the coordinates that the
 * scene is given in. Components of forces and motions, arms and second moments are along the mean
 * plane and normal to it, or, of an earthquake up-dip, along the horizontal and the vertical as the
 * block lies: in the world's frame along axes that are turned from those of the coordinates. */
typedef struct tp_frame_result {
  bool stated;                  /* the scene says what they lie along */
  bool world;                   /* y runs up: the block lies as it lies */
  bool slope;                   /* if world: of a given dip, with x along it, as given */
  bool level;                   /* components are along the horizontal: an earthquake up-dip */
  bool fitted;                  /* the mean plane, to the contact; else given */
  bool dips;                    /* the mean plane is not level */
  tp_direction dips_towards;    /* if dips: its lower side */
  tp_bounded dip_deg;           /* if dips: its angle, 0 to 90: part of the tilt angle */
  bool has_dip_direction;       /* the scene gives it, or the strike */
  tp_bounded dip_direction_deg; /* if has_dip_direction: its azimuth, from north, 0 to 360 */
  tp_bounded turned_about_x_m, turned_about_y_m; /* if world: the point that stays as it turns */
  bool inclined; /* not stated, and the contact's mean line lies at more than 1 in 10 */
  tp_bounded inclination_deg; /* to x, at this, positive where it rises to the right */
  tp_bounded turned_deg;      /* if world: from x counter-clockwise to what components are along */
} tp_frame_result;

/* The contact as a whole. */
typedef struct tp_contact_result {
  bool mated;         /* the base is the counterpart of the underside; else a separate profile */
  bool shifted;       /* it was mated, before the block was shifted along it ('joint') */
  bool beyond_stated; /* false: the scene does not say how far the base extends past the block;
                         taken as 0 */
  tp_bounded beyond_left_m, beyond_right_m; /* how far the base extends past the block */
  tp_contact_end left_end, right_end;       /* why the contact begins, and ends, there */
  tp_bounded left_end_x_m, left_end_y_m, right_end_x_m, right_end_y_m; /* its ends */
  bool steep; /* some facet lies at more than 45 degrees from the mean plane */
  tp_bounded
      steepest_deg; /* of the steepest facet to the mean plane, 0 to 180: beyond 90 it overhangs */
  tp_bounded
      share_of_height;   /* the highest contact over the lowest, a share of the block's height */
  bool reaches_far;      /* above a half */
  size_t facets, points; /* facets of positive length; contacts in a single point */
  size_t corner_points;  /* of the points: a corner on a corner, which gives no restraint */
  tp_bounded length_m;   /* along the facets */
  tp_bounded nominal_length_m; /* projected on the mean plane: the paper's S is this x thickness */
  bool has_contact_ratio;      /* on a profile, if the block has an underside there: */
  tp_bounded contact_ratio;    /* that length over that of the underside */
  tp_bounded weight_per_contact_area_pa,
      weight_per_nominal_area_pa; /* if weight_per_contact_area_pa.value != 0: the block has a
                                     weight, and its contact a length */
} tp_contact_result;

/* Facets of the base with a different friction angle: from one number to another, counted from 1
 * from left to right, along the profile or the underside that the base is mated with. */
typedef struct tp_facet_friction_result {
  size_t first, last;   /* these numbers */
  size_t touching;      /* how many facets and single points of the contact are of them */
  tp_bounded angle_deg; /* that friction angle */
} tp_facet_friction_result;

/* A block that was set down on its profile ('place: rest'), and where it came to rest: it fell
 * upright, then turned about points of its contact. All of a solution is of that pose. */
typedef struct tp_rest_result {
  bool known;                               /* the scene asks for it */
  size_t turns;                             /* each about another point, or the other way round */
  size_t contacts;                          /* points of contact at rest */
  tp_bounded turned_deg;                    /* in all, -180 to 180, counter-clockwise above 0 */
  tp_bounded moved_x_m, moved_y_m;          /* its centroid */
  tp_bounded margin_left_m, margin_right_m; /* along x from the outermost contacts to the weight's
                        line, which passes between them; one below 0: it is wedged in */
} tp_rest_result;

/* A block that was shifted along the mated base that it fits ('joint') and came to rest there: how
 * open the joint is then. Gaps are along y, and lengths along x, of the part of the underside that
 * lies above the base. */
typedef struct tp_joint_result {
  bool known;               /* the scene asks for it */
  tp_bounded shift_m;       /* along x, to the right above 0 */
  tp_bounded above_base_m;  /* how much of the underside lies above the base */
  tp_bounded largest_gap_m; /* there */
  tp_bounded mean_gap_m;    /* the area of the gap over that length */
  bool has_closure;         /* the scene says up to which gap */
  tp_bounded closure_m;     /* gaps up to this count as closed */
  tp_bounded
      matching; /* if has_closure: the share of all of the underside that is closed, 0 to 1 */
  bool has_matching_sought;   /* the scene says how much, and the shift was searched: */
  tp_bounded matching_sought; /* the most of the underside that the scene wants closed, 0 to 1 */
  tp_bounded shift_before_m;  /* if has_matching_sought: the last shift before this one that was
                                 looked at */
  tp_bounded
      matching_before; /* if has_matching_sought: `matching` at that shift, above what is sought */
} tp_joint_result;

/* The parts near its contact that were moved there ('contact: {within: ...}'). All of a solution is
 * of the block so moved. */
typedef struct tp_within_result {
  bool known;                   /* the scene asks for it */
  size_t moved;                 /* vertices of the block, onto its base */
  size_t taken;                 /* points of the profile that became vertices of the block */
  tp_bounded within_m;          /* what the scene says */
  tp_bounded farthest_m;        /* the farthest that anything was moved */
  tp_bounded gap_left_m;        /* along y, the largest between the first contact and the last */
  tp_bounded overlap_removed_m; /* the deepest that a vertex of one lay in the other */
} tp_within_result;

/* The facets of a sole that were levelled, as they are shorter than a wavelength ('base: {smooth:
 * ...}') or as the friction angle is an apparent one ('friction_is: apparent'). All of a solution
 * is of the block on its base so levelled. */
typedef struct tp_smoothed_result {
  bool known;              /* the scene asks for it */
  bool apparent;           /* whatever their length, for the friction angle */
  size_t facets;           /* that were levelled */
  size_t stretches;        /* of them, one after another, each a straight line now */
  tp_bounded wavelength_m; /* if !apparent: what the scene says */
  tp_bounded farthest_m;   /* the farthest that a vertex lay from its line, along y */
} tp_smoothed_result;

#ifdef __cplusplus
}
#endif

#endif
