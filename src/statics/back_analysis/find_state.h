/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A back-analysis as it goes: what is looked for, what was tried, and a number that is. */

#ifndef TP_BACK_ANALYSIS_FIND_STATE_H
#define TP_BACK_ANALYSIS_FIND_STATE_H

#include "stability/varied.h"

/* How the result at a number stands to the wanted value. */
typedef enum tp_tried_standing {
  TP_TRIED_NONE, /* the scene has no result */
  TP_TRIED_BELOW,
  TP_TRIED_NEAR, /* its bound does not tell */
  TP_TRIED_ABOVE
} tp_tried_standing;

/* A number that was tried. */
typedef struct tp_tried {
  double x;
  tp_tried_standing standing;
} tp_tried;

typedef struct tp_search {
  const tp_find_options *options;
  tp_varied varied;
  bool of_many; /* the scene is of many blocks */
  int points;   /* of the range; solutions nearer to each other than two of them may be missed */
  double close; /* a share of a number, as near as it is bisected: some doubles of one block */
  tp_found *found;
  double own;  /* the number that the scene has */
  double step; /* between the points of the range */
  tp_message *message;
  tp_status status; /* of the system: memory; that a scene has no answer is none */
  tp_message why;   /* why the last scene had no answer */
  tp_tried *tried;  /* tried_count of them: all numbers that were tried */
  long tried_count, tried_room;
} tp_search;

enum { TP_SAMPLE_DIGITS = 80, TP_SEARCH_POINTS = 512 };

/* The result at a number, and less the wanted value, with its bound; and the digits of the result
 * where more are asked for than a double holds. */
typedef struct tp_sample {
  double x;
  bool known;
  bool is_bound; /* of many blocks: an upper bound alone */
  tp_bounded gap, result;
  tp_fos governing; /* the governing factor, where it was computed */
  char digits[TP_SAMPLE_DIGITS];
} tp_sample;

#endif
