/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of a solid, by the rule that single blocks and many blocks have as well
 * (docs/solids.md). Included by topple_solid.h. */

#ifndef TOPPLE_SOLID_SAFETY_H
#define TOPPLE_SOLID_SAFETY_H

#include "topple_governing.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Can a motion begin? From the most severe on. */
typedef enum tp_solid_outlook {
  TP_SOLID_COLLAPSES, /* no forces hold it */
  TP_SOLID_CAN_MOVE,  /* forces can hold it, but a motion can begin, proven */
  TP_SOLID_OPEN,      /* whether a motion can begin is not decided */
  TP_SOLID_STANDS     /* no motion can begin */
} tp_solid_outlook;

/* collapses, can begin, undecided or none. */
const char *tp_solid_outlook_name(tp_solid_outlook outlook);

/* The factor against one way to move, between two proven bounds. */
typedef struct tp_solid_factor {
  tp_fos_definition definition; /* on driving loads, or by strength reduction */
  tp_mechanism mechanism;       /* against which; undecided where it is not known */
  double least;                 /* infinite: nothing makes it move so */
  double most;                  /* infinite: no upper bound is proven, or as above */
} tp_solid_factor;

/* The greatest numbers of entries. */
enum {
  TP_SOLID_FACTORS = 3, /* factors in a state */
  TP_SOLID_STATES = 4   /* states of a solid */
};

/* A solid under one set of loads. */
typedef struct tp_solid_state {
  bool is_static;                            /* without its earthquake */
  bool has_mean_normals;                     /* on a ground, with the mean of all normals */
  tp_solid_outlook motion;                   /* can a motion begin? */
  double least, most;                        /* the bounds of its factor, the least of `factors` */
  size_t factor_count;                       /* the number of known factors */
  tp_solid_factor factors[TP_SOLID_FACTORS]; /* factor_count of them */
} tp_solid_state;

/* Over all states. The state that governs is the most severe; the factor is the least of all. */
typedef struct tp_solid_safety {
  tp_solid_outlook motion; /* the answer for the state that governs */
  tp_fos fos;              /* a number where both bounds agree to a thousandth, else why not */
  double least, most;      /* its proven bounds; 0 and infinite where nothing is proven */
  bool has_factor;         /* the state that governs has one that governs: */
  tp_solid_factor factor;  /* if has_factor: that */
  size_t governing;        /* that state */
  size_t state_count;      /* the number of states */
  tp_solid_state states[TP_SOLID_STATES]; /* state_count of them */
} tp_solid_safety;

#ifdef __cplusplus
}
#endif

#endif
