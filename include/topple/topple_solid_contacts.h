/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a solid does on contact points of a scene, and on a mesh of the ground (docs/solids.md).
 * Included by topple_solid.h. */

#ifndef TOPPLE_SOLID_CONTACTS_H
#define TOPPLE_SOLID_CONTACTS_H

#include "topple_solid_safety.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A motion that begins: a screw. No force that contacts can exert does negative work on it. */
typedef struct tp_solid_motion {
  tp_mechanism mechanism; /* slides: without a turn; topples: two contacts at least stay where they
                             are; else slides and topples */
  double axis[3];         /* unit vector in the axes of the mesh: it turns about it by the right
                             hand; without a turn: the way of all points */
  bool turns;             /* it turns: */
  double at[3];           /* if turns: the point of the axis that is nearest to the centroid */
  double pitch_m;         /* if turns: how far it moves along the axis in a turn of one radian */
} tp_solid_motion;

/* A point at which the ground touches the solid. */
typedef struct tp_solid_contact {
  double at[3];              /* in the coordinates of the mesh */
  double normal[3];          /* unit vector out of the ground, into the solid */
  double friction_angle_deg; /* of this contact */
  double distance_m;         /* from the surface of the mesh */
  double force[3];           /* where it stands: one of the forces on the solid, in shares of its
                                weight, that hold it together; else zeros */
} tp_solid_contact;

/* The tilt towards an azimuth up to which forces hold the solid on its contacts. */
typedef struct tp_solid_way {
  double azimuth_deg;        /* towards which it is tilted */
  tp_mechanism mechanism;    /* what it does there; interlocked: it is held at any tilt below 90
                                degrees; undecided: nothing is proven */
  bool has_critical;         /* there is such a tilt: */
  tp_bounded critical_deg;   /* if has_critical: that */
  tp_solid_motion motion;    /* if has_critical: which begins there */
  bool has_acceleration;     /* forces hold it at its tilt, and not against any acceleration: */
  tp_bounded acceleration_g; /* if has_acceleration: the static horizontal acceleration towards the
                                azimuth up to which they do at its tilt, in g */
  tp_mechanism acceleration_mechanism; /* if has_acceleration: what it does there */
} tp_solid_way;

/* A solid on contact points with normals and friction. Forces hold it where some forces, each in
 * its cone of Coulomb, are in equilibrium with its weight and earthquake. Where there are none it
 * certainly moves. Where there are some a motion can begin all the same between contacts that face
 * different ways, as friction need not be as great as equilibrium asks for. The verdict is: stands,
 * where no motion can begin; may move, where one can begin, or where that is not decided
 * (`safety`); what it does, where no forces hold it; undecided, too close to tell. */
typedef struct tp_solid_contacts {
  size_t contact_count;       /* of them */
  tp_solid_contact *contacts; /* contact_count of them: in the order of the scene */
  tp_mechanism verdict;       /* at its tilt, as told above */
  bool has_motion;            /* none do: */
  tp_solid_motion motion;     /* if has_motion: one that begins */
  bool is_in_section; /* all normals and loads are across one axis, to both sides of which contacts
                         have partners: motions within that section are decided */
  tp_solid_safety safety;     /* can a motion begin, and its factor of safety */
  bool has_fos;               /* that factor is a number: */
  tp_bounded fos;             /* if has_fos: the same */
  tp_mechanism fos_mechanism; /* if has_fos: what it does then */
  bool has_fos_friction;      /* some friction is needed, and some is enough; an upper bound: */
  tp_bounded fos_friction; /* if has_fos_friction: what tan(phi) of all contacts may be divided by
                              until no forces hold it */
  bool has_fos_driving;    /* something drives it along its base, and what rests is held: */
  tp_bounded fos_driving;  /* if has_fos_driving: what the part of its weight along the base and
                              the earthquake may be multiplied by until no forces hold it */
  tp_mechanism fos_driving_mechanism; /* if has_fos_driving: what it does then */
  bool fos_driving_is_open;           /* nothing is proven of it */
  bool has_onset;                     /* it is known from which tilt on a motion can begin: */
  tp_bounded onset_deg; /* if has_onset: without an earthquake, towards the azimuth of its tilt */
  bool has_certain;     /* in no section, a stretch of tilts from level on is proven: */
  double certain_to_stand_deg; /* if has_certain: without an earthquake, towards the azimuth of its
                                  tilt: no motion can begin up to this tilt, and perhaps beyond */
  bool has_onset_acceleration; /* in a section, the onset by an acceleration at its tilt: */
  tp_bounded onset_acceleration_g; /* if has_onset_acceleration: towards the azimuth of its
                                      earthquake, or of its tilt, in g */
  bool has_critical;               /* it is held level, and not at any tilt: */
  tp_bounded critical_deg; /* if has_critical: without an earthquake, the tilt up to which it is
                              held: towards the azimuth of its tilt, or the least of all */
  tp_bounded
      critical_azimuth_deg;  /* if has_critical: towards which; of the least where it was found */
  tp_solid_motion critical;  /* if has_critical: the motion that begins there */
  size_t way_count;          /* the azimuths, where it is held level; else 0 */
  tp_solid_way *ways;        /* way_count of them: evenly from 0 on */
  bool is_held_level;        /* do forces hold it level? */
  bool has_acceleration;     /* forces hold it at its tilt, and not against any acceleration: */
  tp_bounded acceleration_g; /* if has_acceleration: the static horizontal acceleration up to which
                                they do at its tilt, the least of all azimuths, in g */
  tp_bounded acceleration_azimuth_deg; /* if has_acceleration: towards which it was found */
  tp_solid_motion acceleration;        /* if has_acceleration: the motion that begins there */
  bool has_acceleration_ahead;         /* the same where its earthquake has an azimuth: */
  tp_bounded acceleration_ahead_g;     /* if has_acceleration_ahead: the one towards that */
} tp_solid_contacts;

/* On a mesh of the ground, where all counts as touching that is within a band of it. */
typedef struct tp_solid_ground_band {
  double band;                 /* in lengths of the scene */
  size_t found;                /* contacts within it, */
  size_t contacts;             /* of which so many are left without those that lie between others of
                                  one plane */
  double widest_m;             /* the widest gap that counts as touching */
  double normals_deg;          /* the greatest angle between two of their normals */
  tp_mechanism verdict;        /* as of contacts */
  bool has_fos;                /* likewise */
  tp_bounded fos;              /* if has_fos: likewise */
  bool has_critical;           /* likewise */
  tp_bounded critical_deg;     /* if has_critical: likewise */
  bool has_acceleration;       /* likewise */
  tp_bounded acceleration_g;   /* if has_acceleration: likewise */
  bool has_smooth;             /* the same points, each with the mean of their normals, so that none
                                  is wedged: */
  tp_mechanism smooth_verdict; /* if has_smooth: what it does on them */
  bool has_smooth_fos;         /* if has_smooth: likewise */
  tp_bounded smooth_fos;       /* if has_smooth_fos: likewise */
  bool has_smooth_critical;    /* if has_smooth: likewise */
  tp_bounded smooth_critical_deg; /* if has_smooth_critical: likewise */
} tp_solid_ground_band;

/* The mesh of the ground that a solid rests on. */
typedef struct tp_solid_ground {
  TP_OUTSIDE char *file;   /* the mesh, */
  TP_OUTSIDE char *object; /* and the one object of it that is meant; NULL: all of it */
  size_t vertices;         /* that its triangles have */
  size_t triangles;        /* of it */
  double entered_m;        /* how deep the solid enters it at most: no more than the least band */
  size_t band_count;       /* of the bands */
  tp_solid_ground_band *bands; /* band_count of them: in the order of the scene */
  size_t governing;            /* the least of them, of which the contacts are: from 0 */
  tp_solid_safety safety; /* in that: on the contacts, and where these are in no section with the
                             mean of their normals as well */
  double metres_per_unit; /* of a length of its mesh */
} tp_solid_ground;

#ifdef __cplusplus
}
#endif

#endif
