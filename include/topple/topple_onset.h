/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion of a case: up to which tilt no motion can begin. Included by topple.h.
 *
 * The static limit (topple_limit.h) asks whether some forces of the base hold the block; the onset
 * asks whether the block, released from rest, can begin to move by forces that Coulomb friction
 * allows (Pang and Trinkle 2000: strong against weak stability). Below the onset it is certain to
 * stand; beyond the limit it is certain to move; between them the forces that the way it came to
 * lie there has locked in decide.
 *
 * Friction is the scene's, where it depends on the stress that at the onset's, and for motions that
 * at the scene's tilt. Cohesion has to be overcome in full along every straight line of contact of
 * which a point stays closed and slips, a bond in full on every facet that opens; the onset never
 * lies above the limit. */

#ifndef TOPPLE_ONSET_H
#define TOPPLE_ONSET_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the onset is. */
typedef enum tp_onset_kind {
  TP_ONSET_NOT_ASKED, /* the scene gives no friction angle, or the limit was not asked for */
  TP_ONSET_AT_ANGLE,
  TP_ONSET_NEVER,    /* no motion can begin at any tilt up to 90 degrees */
  TP_ONSET_NOWHERE,  /* a motion can begin level, and at every tilt back from it */
  TP_ONSET_UNDECIDED /* at the precision allowed */
} tp_onset_kind;

/* Tilts between -90 and 90 degrees at which a motion can begin, both ends included. Between two
 * windows none can: there it is certain to stand again. */
typedef struct tp_window {
  bool from_below, to_above; /* it has no lower end, no upper end, within that range */
  tp_bounded from_deg;       /* if !from_below: its lower end */
  tp_bounded to_deg;         /* if !to_above: its upper end */
  tp_mechanism begins; /* what can begin at its lower end, or, without one, at its upper end */
  bool from_by_strength, to_by_strength; /* a little more or less of all strength moves that end;
                                            known of the ends next to the scene's tilt */
} tp_window;

/* Tilts from one to another throughout which the same motions can begin. */
typedef struct tp_motion_range {
  bool from_below, to_above; /* as of a window */
  tp_bounded from_deg;       /* if !from_below: its lower end */
  tp_bounded to_deg;         /* if !to_above: its upper end */
  unsigned motions; /* set of mechanism: the bit 1u << mechanism for each of slides, topples, slides
                       and topples, leaves its base; never 0 */
} tp_motion_range;

/* What a contact does in a motion. */
typedef enum tp_contact_state {
  TP_CONTACT_OPENS,
  TP_CONTACT_STICKS,
  TP_CONTACT_SLIPS_DOWN_DIP, /* the block's point moves down-dip along the facet */
  TP_CONTACT_SLIPS_UP_DIP
} tp_contact_state;

/* An end of a facet in a motion, and the force on the block there as a share of its weight. */
typedef struct tp_motion_contact {
  size_t facet;           /* from left to right along the contact, those in a point included */
  bool of_facet;          /* false: on a facet of the base of another friction that begins there */
  bool at_right_end;      /* of that facet */
  tp_contact_state state; /* sticks, or slips */
  bool has_pivot;         /* it is one of the contact's points, */
  size_t pivot;           /* this one, by its index */
  bool has_force;         /* false: nothing fixes how the contacts that stay share the load */
  tp_bounded share_x, share_y; /* if has_force: along x and y of the scene */
} tp_motion_contact;

/* What a motion has to overcome, as a force on the block over its weight, and its moment about the
 * centroid over the weight, metres, counter-clockwise positive. */
typedef struct tp_motion_resistance {
  tp_bounded share_x, share_y; /* along x and y of the scene */
  tp_bounded moment_m;         /* about the centroid */
} tp_motion_resistance;

/* A mode in which the block can begin to move at the scene's tilt. */
typedef struct tp_motion {
  tp_mechanism mechanism; /* slides, topples, slides and topples, or leaves its base */
  tp_bounded acceleration_x_g, acceleration_y_g; /* of the centroid, in units of gravity, along x
                                                    and y of the scene */
  tp_bounded angular_g_per_m; /* angular acceleration over gravity, 1 / m; counter-clockwise > 0 */
  bool accelerations_fixed;   /* false: a range of them is possible, of which one end is given */
  bool greatest;     /* that end is the greatest, of a slide that bonds pull on: with no more pull
                        than balance needs */
  bool has_strength; /* under cohesion or bonds: */
  tp_motion_resistance cohesion,
      bond; /* if has_strength: of lines that slip, of facets that open; the cohesion of a line that
               sticks is part of its contact's force */
  bool has_centre;                   /* of rotation */
  tp_bounded centre_x_m, centre_y_m; /* where it is */
  size_t contact_count;              /* of the contacts */
  tp_motion_contact *contacts;       /* those that do not open */
} tp_motion;

/* As many mechanisms begin a motion: slides, topples, slides and topples, leaves its base. */
enum { TP_BEGINNINGS_MAX = 4 };

/* The onset of a case, and how the block moves at the scene's tilt. */
typedef struct tp_onset {
  tp_onset_kind kind; /* is it at an angle? */
  bool too_dear;      /* undecided, since the proof takes more work than is allowed */
  tp_bounded
      friction_angle_deg; /* if kind != TP_ONSET_NOT_ASKED: at the normal stress of the onset */
  tp_bounded critical_angle_deg; /* if kind == TP_ONSET_AT_ANGLE: alpha_s, the lower end of the
                                    window that holds level ground, or else of the first above it;
                                    below 0: certain to stand only when tilted back */
  tp_mechanism mechanism; /* if kind == TP_ONSET_AT_ANGLE || kind == TP_ONSET_NOWHERE: what can
                             begin there, or first */
  bool tie;               /* another mechanism can begin at the same tilt: */
  tp_mechanism tied_with; /* if tie: that one */
  long tie_bits;          /* 0: exactly; else so many bits do not distinguish the two */
  bool has_centre;        /* of rotation of what can begin there */
  tp_bounded centre_x_m, centre_y_m; /* where it is */
  bool below_limit;    /* alpha_s is more than 1e-6 degrees below the limit: between them the
                          result depends on loading history */
  size_t window_count; /* all of them, from below; owned by the case */
  tp_window *windows;  /* in which a motion can begin */
  bool has_ranges; /* where the options ask for them; not under cohesion or bonds, not with friction
                      that depends on the stress, and not where they stay open */
  size_t range_count;      /* from below; where two meet, one motion takes over from another */
  tp_motion_range *ranges; /* if has_ranges: owned by the case */
  bool paradox; /* in some mode at the scene's tilt friction would press the slipping contact harder
                   (Painleve): rigid bodies with Coulomb friction have no unique answer there */
  bool has_motions; /* at the scene's tilt, where there is one, and where they do not stay open */
  size_t motion_count;    /* 0: none can begin */
  tp_motion *motions;     /* if has_motions: owned by the case */
  size_t beginning_count; /* of their mechanisms, each once: what can begin at the scene's tilt, */
  tp_mechanism beginnings[TP_BEGINNINGS_MAX]; /* if has_motions: in the order of tp_mechanism */
  tp_fos fos; /* by which tan(phi), cohesion and bond have to be divided, or multiplied, all alike,
                 before it changes whether a motion can begin at the scene's tilt, the nearer of
                 the two: above 1 where none can begin, unbounded where none does whatever the
                 strength; below 1 where one can, TP_FOS_UNDEFINED where one does whatever the
                 strength. That no change lies nearer is searched, not proven */
  bool fos_raised;            /* what changes it is more strength, not less */
  tp_mechanism fos_mechanism; /* what begins, or ends, there */
  tp_fos fos_driving; /* by which the loads that drive the block down-dip have to be multiplied
                         until a motion can begin, while those that rest on the base stay: above 1
                         where none can begin at the scene's tilt, unbounded where none begins at
                         any multiple; below 1 where one can begin, TP_FOS_UNDEFINED where one can
                         even without driving loads. For the weight alone tan(onset) / tan(tilt) */
  tp_mechanism fos_driving_mechanism; /* if fos_driving.state == TP_FOS_NUMBER: what begins there */
  bool has_driving_centre;            /* it turns: */
  tp_bounded driving_centre_x_m, driving_centre_y_m; /* if has_driving_centre: about this point */
} tp_onset;

#ifdef __cplusplus
}
#endif

#endif
