/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All resting poses of a block on its profile, and from which starting positions it comes to each
 * ('place: all'). Included by topple.h. */

#ifndef TOPPLE_POSES_H
#define TOPPLE_POSES_H

#include "topple_contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Outcome for a block that is set down. */
typedef enum tp_settling_end {
  TP_COMES_TO_REST,     /* in some pose */
  TP_ROLLS_OFF_LEFT,    /* over the left end of what it touches of its profile */
  TP_ROLLS_OFF_RIGHT,   /* over the right end */
  TP_BALANCES,          /* its centroid lies exactly over the only point that could stop it */
  TP_SETTLING_UNDECIDED /* several corners touch at once in a pose that is no fraction, or it takes
                           more turns than any block was seen to */
} tp_settling_end;

/* comes to rest, rolls off to the left, rolls off to the right, balances, undecided */
const char *tp_settling_end_name(tp_settling_end end);

/* Starting positions next to each other from which a block ends alike: shifts along x from where
 * the scene has it. */
typedef struct tp_basin {
  tp_settling_end end; /* how */
  size_t pose; /* if end == TP_COMES_TO_REST: in this one of the poses, where it comes to rest */
  tp_bounded from_m, to_m;                   /* its borders */
  tp_bounded share;                          /* of all starting positions */
  tp_bounded turned_from_deg, turned_to_deg; /* if end == TP_COMES_TO_REST: by what it turns in all
                                                next to these borders, where it comes to rest */
} tp_basin;

/* Does a block stand in a pose, when the table is tilted in one direction? */
typedef struct tp_pose_verdict {
  tp_direction towards;          /* which */
  tp_mechanism mechanism;        /* at the scene's tilt; without one, the first as it is tilted */
  tp_mechanism first;            /* what happens first as the table is tilted from level */
  bool has_critical_angle;       /* that is at an angle */
  tp_bounded critical_angle_deg; /* where it happens */
  tp_fos fos;                    /* the governing one, at the scene's tilt */
  bool least; /* of all poses this one begins to move first as the table is tilted */
} tp_pose_verdict;

/* A resting pose: what touches, vertices and edges. Over a basin the pose shifts and turns with the
 * starting position; its numbers here are those from the middle of its widest basin; of the
 * pose that the block reaches as given, those from there. */
typedef struct tp_resting_pose {
  size_t basins;           /* how many basins lead to it */
  size_t widest_basin;     /* index of the widest of them */
  tp_bounded share;        /* of these basins, of all starting positions */
  tp_bounded shift_m;      /* the starting position that its numbers are of */
  tp_rest_result rest;     /* turn, shift of its centroid, margins */
  tp_bounded centroid_y_m; /* how high it lies: its energy over its weight */
  tp_bounded first_contact_x_m, first_contact_y_m, last_contact_x_m,
      last_contact_y_m;        /* of its points of contact, along x */
  size_t verdict_count;        /* as many as the solution has cases; 0: it cannot be solved there */
  tp_pose_verdict verdicts[2]; /* in their order */
} tp_resting_pose;

/* The resting poses of a block, the likeliest first. */
typedef struct tp_poses_result {
  bool known;              /* the scene asks for them */
  tp_bounded from_m, to_m; /* all starting positions: some part of it stands over the profile */
  tp_bounded spacing_m;    /* no basin wider than that is missed; a narrower one may be */
  tp_bounded border_m;     /* borders were narrowed to that, but where their errors say otherwise */
  size_t settlings;        /* starting positions that were tried */
  bool has_given;          /* the block of the scene, at shift 0, comes to rest in a known pose */
  size_t given;           /* index of that pose; of a position between two basins this is unknown */
  size_t pose_count;      /* of the poses */
  tp_resting_pose *poses; /* owned by the solution */
  size_t basin_count;     /* of the basins */
  tp_basin *basins;       /* from left to right; owned by the solution */
} tp_poses_result;

#ifdef __cplusplus
}
#endif

#endif
