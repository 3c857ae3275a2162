/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Nodes that are refuted, each as wide as its proof allows: no motion has one of their modes at
 * every contact while these blocks rest. So what is refuted in one branch is known in all others
 * (clause learning: Marques-Silva and Sakallah 1999, IEEE Transactions on Computers 48). */

#ifndef TP_CONTACT_MODES_NOGOODS_H
#define TP_CONTACT_MODES_NOGOODS_H

#include "contact_modes/node.h"

#include <stdint.h>

/* What a node must be for a nogood to refute it: a contact has no more than these modes, of a pair
 * of corners its first side and its twin; or a block rests. */
typedef struct tp_nogood_term {
  int32_t contact, twin, block; /* -1: it has none */
  uint16_t own, of_twin;
} tp_nogood_term;

/* Its terms, up to those of the next; two of them that a node does not meet are watched, so that
 * nothing is asked of it while they are not. */
typedef struct tp_nogood {
  int32_t terms, watched[2], next[2], before[2];
  bool is_used; /* another refutation follows from it */
} tp_nogood;

typedef struct tp_nogoods {
  const tp_resting *resting;
  long count, room;
  tp_nogood *all;
  long term_count, term_room;
  tp_nogood_term *terms;
  int32_t *watching; /* by contact, then by block: twice the first nogood that watches it, and which
                     of its two; -1: none does */
} tp_nogoods;

TP_MUST_USE bool tp_nogoods_init(tp_nogoods *nogoods, const tp_resting *resting);
void tp_nogoods_clear(tp_nogoods *nogoods);

/* It becomes the last one, and is to be asked. */
TP_MUST_USE tp_status tp_nogoods_add(tp_nogoods *nogoods, const tp_modes_node *refuted,
                                     tp_message *message);

/* What a nogood says of a node: nothing; that it is refuted; that of one contact the modes of the
 * term are. `work` grows by what it took. */
typedef enum tp_nogood_says {
  TP_NOGOOD_NOTHING,
  TP_NOGOOD_REFUTES,
  TP_NOGOOD_LIMITS
} tp_nogood_says;
tp_nogood_says tp_nogoods_ask(tp_nogood_term *term, long *work, tp_nogoods *nogoods, long number,
                              const tp_modes_node *node);

/* Of those that watch a contact or a block that has changed: the next one after `at`, which begins
 * with -1, that may say something; -1: no more do. */
long tp_nogoods_watching(long *at, const tp_nogoods *nogoods, long contact, long block);

/* A node that is refuted by it. */
void tp_nogoods_take(tp_modes_node *refuted, tp_nogoods *nogoods, long number);

/* From a refuted node and a nogood another refuted node, that has the modes of either at this
 * contact, and of both at all others. */
void tp_nogoods_resolve(tp_modes_node *refuted, tp_nogoods *nogoods, long number, long contact);

#endif
