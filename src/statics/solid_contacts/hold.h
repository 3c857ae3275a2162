/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on contact points with friction: is a load held, how far along a way, with which share of
 * the friction? Each answer is proven on its own (hold_proof.h); what is not proven is open.
 *
 * All loads act at the centroid. Those that are held are a convex cone, so that those of load + t
 * way, t from zero on, are held up to one t. */

#ifndef TP_SOLID_CONTACTS_HOLD_H
#define TP_SOLID_CONTACTS_HOLD_H

#include "solid_contacts/hold_proof.h"
#include "solid_contacts/hold_search.h"

typedef struct tp_hold {
  const tp_friction_cones *cones;
  double friction;       /* mu is divided by this */
  tp_near share;         /* one over that */
  tp_hold_search search; /* with all forces that were found so far */
  tp_hold_basis basis;
  bool has_apart;          /* some motion goes away from all contacts: */
  double apart[TP_WRENCH]; /* if has_apart: that */
  tp_held deep, found;     /* room for forces */
} tp_hold;

/* To be cleared also where it is false: memory is exhausted. */
TP_MUST_USE bool tp_hold_init(tp_hold *hold, const tp_friction_cones *cones, double friction);
void tp_hold_clear(tp_hold *hold);

typedef enum tp_hold_side {
  TP_HOLD_OPEN,  /* too close to tell */
  TP_HOLD_HOLDS, /* forces that hold the load exist: those of `found` */
  TP_HOLD_MOVES  /* none do: the twist moves it */
} tp_hold_side;

TP_MUST_USE bool tp_hold_load_side(tp_hold_side *side, double twist[TP_WRENCH], tp_hold *hold,
                                   const tp_hold_load *load);

typedef struct tp_hold_limit {
  bool is_endless; /* all of the way is held, proven */
  bool is_open;    /* nothing is proven */
  tp_near t;
  double twist[TP_WRENCH]; /* of the motion that proves it */
} tp_hold_limit;

/* How far along the way a load is held that is held itself. */
TP_MUST_USE bool tp_hold_limit_find(tp_hold_limit *limit, tp_hold *hold, const tp_hold_load *load,
                                    const tp_hold_load *way);

typedef enum tp_hold_factor_kind {
  TP_HOLD_FACTOR,    /* with a bound */
  TP_HOLD_FREE,      /* it is held without friction, or with a millionth of it */
  TP_HOLD_POWERLESS, /* a million times the friction does not hold it */
  TP_HOLD_FACTOR_OPEN
} tp_hold_factor_kind;

/* By how much tan(phi) of all contacts may be divided until the load is no longer held; and the
 * motion that begins then. */
TP_MUST_USE bool tp_hold_factor(tp_hold_factor_kind *kind, tp_near *factor, double twist[TP_WRENCH],
                                const tp_friction_cones *cones, const tp_hold_load *load);

#endif
