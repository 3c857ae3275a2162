/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A simulated tilt test: the path of a block to its failure, and its motion after that
 * (docs/mechanics.md section 7; section 4.3 of the paper). Included by topple.h.
 *
 * All lengths in metres and all components along the frame of the base: x up-dip or down-dip as in
 * the scene, y normal to the base. Simulated numbers have no proven bound: where one is needed they
 * are stated with the bracket, or the balance, that was reached. */

#ifndef TOPPLE_TILT_H
#define TOPPLE_TILT_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How the test is simulated. */
typedef enum tp_tilt_engine {
  TP_TILT_PATH,   /* quasi-static: equilibrium of a block on contact springs, followed from event
                     to event */
  TP_TILT_RIGID,  /* dynamics of a rigid block on rigid contacts, from event to event, with impacts
                   */
  TP_TILT_SPRINGS /* dynamics by explicit time steps on contact springs with damping */
} tp_tilt_engine;

/* How the table is moved. */
typedef enum tp_tilt_protocol {
  TP_TILT_RAMP,   /* at a steady speed from level */
  TP_TILT_STEPS,  /* a fresh start at each angle, the least that moves it bracketed by bisection */
  TP_TILT_RELEASE /* held at an angle, released */
} tp_tilt_protocol;

/* An event at a contact, or of the whole block. */
typedef enum tp_tilt_event_kind {
  TP_EVENT_OPENS,     /* a contact */
  TP_EVENT_CLOSES,    /* a contact, with the speed at which it did */
  TP_EVENT_SLIPS,     /* a contact that stuck or was open */
  TP_EVENT_STICKS,    /* a contact that slipped */
  TP_EVENT_COLLAPSES, /* no equilibrium is left: the block is in motion for good, or until it rests
                         again */
  TP_EVENT_RESTS,     /* the block is at rest again */
  TP_EVENT_OVERTURNS, /* it has turned by more than a quarter of a turn */
  TP_EVENT_LEAVES_BASE, /* no part of it is above the base any more */
  TP_EVENT_ACCUMULATES  /* rebounds below a threshold are ignored: its contact closes */
} tp_tilt_event_kind;

/* One of these events. */
typedef struct tp_tilt_event {
  tp_tilt_event_kind what; /* what happened */
  double time_s;           /* from the start of the run; 0 on a quasi-static path */
  double angle_deg;        /* of the table */
  double x_m, y_m;         /* where on the base; of the whole block: its centroid */
  long facet;       /* of the base, counted from 1 from left to right; 0: none, or an end face */
  double speed_m_s; /* of approach, where the contact closes; of slip, where it slips */
} tp_tilt_event;

/* The block at one moment. */
typedef struct tp_tilt_moment {
  double time_s, angle_deg;                /* when, and at which tilt of the table */
  double moved_x_m, moved_y_m, turned_deg; /* of its centroid, and counter-clockwise */
  double speed_x_m_s, speed_y_m_s;         /* of its centroid */
  double turning_rad_s;                    /* counter-clockwise */
  double kinetic_energy_j;                 /* of its motion and its turn */
  double energy_balance_j; /* work of gravity, loads and shaking less kinetic energy, what springs
                              hold, and what friction, damping and impacts took: 0 but for errors.
                              NaN on a quasi-static path, which sums none */
} tp_tilt_moment;

/* The reaction on one facet of the base at one moment. */
typedef struct tp_tilt_reaction {
  size_t moment;            /* index of its tp_tilt_moment */
  long facet;               /* counted from 1 */
  double normal_n, shear_n; /* shear positive where it pushes the block towards +x */
} tp_tilt_reaction;

#ifdef __cplusplus
}
#endif

#endif
