/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a wedge between two joints does (docs/solids.md). Included by topple_solid.h. */

#ifndef TOPPLE_SOLID_WEDGE_H
#define TOPPLE_SOLID_WEDGE_H

#include "topple_solid_safety.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A plane that bounds a wedge, as its scene gives it. */
typedef struct tp_wedge_side {
  double dip_deg;            /* of the plane */
  double dip_direction_deg;  /* the azimuth of that */
  double friction_angle_deg; /* of a joint; else 0 */
  double cohesion_kpa;       /* likewise */
} tp_wedge_side;

/* A corner of a wedge, from where the line of both joints comes out of the face. */
typedef struct tp_wedge_corner {
  double east_m, north_m, up_m; /* in metres */
} tp_wedge_corner;

/* What a horizontal force towards an azimuth does to a wedge, as a static share of its weight. */
typedef struct tp_wedge_azimuth {
  double azimuth_deg;        /* towards which */
  const char *slides_on;     /* a static string: on which joints with its scene's earthquake */
  bool has_fos;              /* its scene's earthquake drives it: */
  tp_bounded fos;            /* if has_fos: strength over what drives it */
  bool has_acceleration;     /* it stands without a horizontal force, and not with any: */
  tp_bounded acceleration_g; /* if has_acceleration: the least at which the factor is 1, in g */
  const char *acceleration_slides_on; /* a static string: likewise there */
} tp_wedge_azimuth;

/* A bolt that pulls a wedge. */
typedef struct tp_wedge_bolt {
  double azimuth_deg;     /* towards which it pulls */
  double dip_deg;         /* below the horizontal; above it, below 0 */
  tp_bounded force_n;     /* its pull, which is active: it counts among what drives the wedge */
  bool has_capacity;      /* that it can bear is given: */
  double capacity_kn;     /* if has_capacity: that */
  tp_bounded utilisation; /* if has_capacity: force over that */
} tp_wedge_bolt;

/* A wedge between two joints A and B, as Hoek and Bray have it: friction and cohesion act against
 * the sliding alone, along the line of both joints or down one of them; no joint is in tension, and
 * nothing turns. Water fills the joints and the crack: its pressure rises from zero at the surface
 * to the depth in between, in the mean a sixth of the head of the height, or a third of that of the
 * crack. */
typedef struct tp_solid_wedge {
  tp_wedge_side sides[5];     /* the joints A and B, the face, the ground above, and if has_crack
                                 the crack */
  tp_wedge_corner corners[6]; /* the ends of the crest on A and on B; behind them those on A and on
                                 B, and the deepest, which are one without a crack; the toe */
  tp_bounded plunge_deg, trend_deg; /* of the line of both joints, downwards */
  tp_bounded areas_m2[2];           /* of the joints A and B */
  bool has_crack;                   /* a tension crack ends it: */
  tp_bounded crack_area_m2;         /* if has_crack: its area */
  bool has_water;                   /* it is full of water: */
  tp_bounded water_kpa;   /* if has_water: the mean pressure on the joints and the crack */
  tp_mechanism verdict;   /* stands, slides, leaves its base, or undecided */
  const char *slides_on;  /* a static string: a and b, a, b, or neither */
  tp_bounded normal_n[2]; /* on A and B, without the water's */
  tp_bounded driving_n; /* along the way in which it slides; along the line of both joints down it,
                           and below zero where an earthquake pulls it up */
  bool has_fos;         /* something drives it: */
  tp_bounded fos;       /* if has_fos: strength over what drives it; the least of all azimuths where
                           its earthquake has none */
  tp_solid_safety safety; /* its factor of safety, also without its earthquake */
  bool has_azimuth;       /* an earthquake pushes it along the horizontal: */
  double azimuth_deg;     /* if has_azimuth: towards which: its own, or else the worst */
  bool has_worst;         /* likewise: */
  tp_bounded worst_fos; /* if has_worst: the least factor of all azimuths, proven from both sides */
  double worst_azimuth_deg;    /* if has_worst: at which it was found */
  const char *worst_slides_on; /* a static string: on which joints it slides there */
  bool has_acceleration;       /* it stands without a horizontal earthquake: */
  tp_bounded acceleration_g; /* if has_acceleration: the least static horizontal acceleration of all
                                azimuths at which the factor is 1, in g, proven likewise */
  double acceleration_azimuth_deg;    /* if has_acceleration: towards which it was found */
  const char *acceleration_slides_on; /* a static string: on which joints it slides there */
  bool has_acceleration_ahead;        /* the same where its earthquake has an azimuth: */
  tp_bounded acceleration_ahead_g;    /* if has_acceleration_ahead: towards that */
  size_t bolt_count;                  /* of the bolts */
  tp_wedge_bolt *bolts;               /* bolt_count of them, in the order of the scene */
  bool has_support; /* its scene requires a factor that it has not, and a further active force gives
                       it, with both joints pressed: */
  tp_bounded support_n;           /* if has_support: the least force that does */
  tp_bounded support_azimuth_deg; /* if has_support: towards which it pulls, */
  tp_bounded support_dip_deg;     /* if has_support: and how steeply below the horizontal */
  size_t azimuth_count;           /* of the azimuths */
  tp_wedge_azimuth *azimuths;     /* azimuth_count of them: evenly from 0 on */
} tp_solid_wedge;

#ifdef __cplusplus
}
#endif

#endif
