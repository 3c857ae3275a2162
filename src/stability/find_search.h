/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Looking for the numbers at which a result has a wanted value: points of a range, and what lies
 * between them. */

#ifndef TP_FIND_SEARCH_H
#define TP_FIND_SEARCH_H

#include "stability/varied.h"

typedef struct tp_search {
  const tp_find_options *options;
  tp_varied scene;
  double low, high; /* the range */
  tp_message *message;
  tp_status status; /* of the system: memory; that a scene has no answer is none */
  tp_message why;   /* why the last scene had no answer */
} tp_search;

/* Fill in what is found from found->low to found->high, and cut that to where the scene has an
 * answer; how it went is in search->status. */
void tp_search_scan(tp_search *search, tp_found *found);

#endif
