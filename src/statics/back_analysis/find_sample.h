/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis: the result of a scene at a number, and the list of what is found. */

#ifndef TP_BACK_ANALYSIS_FIND_SAMPLE_H
#define TP_BACK_ANALYSIS_FIND_SAMPLE_H

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
  tp_found *found;
  double own;  /* the number that the scene has */
  double step; /* between the points of the range */
  tp_message *message;
  tp_status status; /* of the system: memory; that a scene has no answer is none */
  tp_message why;   /* why the last scene had no answer */
  tp_tried *tried;  /* tried_count of them: all numbers that were tried */
  long tried_count, tried_room;
} tp_search;

enum { TP_SAMPLE_DIGITS = 80 };

/* The result at a number, and less the wanted value, with its bound; and the digits of the result
 * where more are asked for than a double holds. */
typedef struct tp_sample {
  double x;
  bool known;
  tp_bounded gap, result;
  tp_fos governing; /* the governing factor, where it was computed */
  char digits[TP_SAMPLE_DIGITS];
} tp_sample;

/* The result of a case that a number is found for; false where it is none. */
bool tp_search_value(tp_bounded *value, const tp_case *own, tp_find_target target);

/* Is the target a factor of safety? */
bool tp_find_target_is_factor(tp_find_target target);

tp_sample tp_search_sample(tp_search *search, double x);

/* 1 above the wanted value, -1 below; 0 where that is not certain. */
int tp_search_side(const tp_sample *at);

void tp_search_add_solution(tp_search *search, double low, double high);
void tp_search_add_touching(tp_search *search, double low, double high);
/* Each end lies between two numbers. */
void tp_search_add_interval(tp_search *search, const double from[2], const double to[2]);

#endif
