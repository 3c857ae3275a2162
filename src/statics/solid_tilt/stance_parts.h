/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a stance (stance.c) and its accelerations (shaken.c) share. */

#ifndef TP_SOLID_TILT_STANCE_PARTS_H
#define TP_SOLID_TILT_STANCE_PARTS_H

#include "solid/azimuth.h"
#include "solid/tilting.h"

/* The scene's tilt and earthquake in doubles with bounds. */
typedef struct tp_stance_loads {
  bool has_tilt;        /* else the base is level */
  double azimuth_deg;   /* of the tilt; below 0: any */
  double quake_deg;     /* of the earthquake; below 0: any */
  tp_near sine, cosine; /* of the tilt */
  tp_near horizontal;   /* k_h */
  tp_near gravity;      /* g */
} tp_stance_loads;

/* Of an edge of the support: P and q, east and north. */
typedef struct tp_stance_edge {
  tp_near arm;         /* P */
  tp_near east, north; /* q */
} tp_stance_edge;

static const tp_near tp_nothing = {0, 0}, tp_unity = {1, 0};

/* The least so far. */
typedef struct tp_least {
  bool found;
  tp_near value;    /* of all: proven */
  tp_near smallest; /* the one that was taken, */
  tp_mechanism mechanism;
  tp_near east, north; /* towards which */
} tp_least;

/* Take one more; true: it is the one that is taken. */
bool tp_least_take(tp_least *least, tp_near value, tp_mechanism mechanism);

/* The least root above zero of A x^2 + 2 B x + C, where C is below 0, by a quotient that does not
 * cancel: -C / (B + sqrt(B^2 - A C)), whatever the sign of A. False: there is none. */
bool tp_least_root(tp_near *root, tp_near a, tp_near b, tp_near c);

typedef struct tp_stance {
  const tp_stance_loads *loads;
  const tp_stance_edge *edges;
  size_t count;
  bool has_friction;
  tp_near friction;               /* tan(phi) */
  tp_near down[2];                /* t, east and north */
  tp_near weight_down, weight_on; /* g sin d, g cos d */
} tp_stance;

/* A vector of the map along t and along s, which is t turned clockwise seen from above. */
void tp_stance_turn(tp_near *along, tp_near *across, const tp_stance *x, tp_near east,
                    tp_near north);

#endif
