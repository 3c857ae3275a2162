/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The words of a study's summary, on the page and in JSON. */

#ifndef TP_REPORT_STUDY_WORDS_H
#define TP_REPORT_STUDY_WORDS_H

#include "output/text.h"
#include "topple.h"

/* Room for a key on the page. */
enum { TP_STUDY_LABEL = 30 };

/* As on the page: critical angle, and so on. */
const char *tp_study_quantity_words(tp_study_quantity quantity);

/* Angles have two decimals, factors and accelerations three. */
bool tp_study_quantity_is_angle(tp_study_quantity quantity);
/* An angle, a factor of safety (rounded down) or an acceleration, with two or three decimals. */
const char *tp_study_number(char out[TP_NUMBER_SIZE], double value, tp_study_quantity quantity);

/* Words between blanks, over lines of a terminal. */
void tp_study_add_lines(tp_text *text, const char *words);

/* Samples, answer, and what varies. */
void tp_study_add_head(tp_text *text, const tp_study_result *result);

/* Sobol' indices, reliability and design values, of those that were asked for. */
void tp_study_add_analyses(tp_text *text, const tp_study_result *result);

#endif
