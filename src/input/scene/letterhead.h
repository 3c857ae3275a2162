/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene says of its calculation sheet: the key report. */

#ifndef TP_SCENE_LETTERHEAD_H
#define TP_SCENE_LETTERHEAD_H

#include "common/message.h"
#include "output/language.h"

/* The texts of a letterhead, each the key of its name. */
typedef enum tp_letterhead_text {
  TP_LETTERHEAD_COMPANY,
  TP_LETTERHEAD_PROJECT,
  TP_LETTERHEAD_JOB,
  TP_LETTERHEAD_AUTHOR,
  TP_LETTERHEAD_CHECKER,
  TP_LETTERHEAD_DATE,
  TP_LETTERHEAD_TEXTS
} tp_letterhead_text;

/* The sign before decimals. */
typedef enum tp_decimal_sign {
  TP_DECIMAL_OF_LANGUAGE,
  TP_DECIMAL_POINT,
  TP_DECIMAL_COMMA
} tp_decimal_sign;

typedef struct tp_letterhead {
  TP_OUTSIDE char *texts[TP_LETTERHEAD_TEXTS]; /* NULL: not given */
  TP_OUTSIDE char *logo;                       /* path; NULL: none */
  tp_place logo_place;
  const tp_language *language; /* NULL: not given */
  tp_decimal_sign decimal;
  bool brief; /* two pages, without the appendix */
} tp_letterhead;

/* The key of a text: company, project … */
const char *tp_letterhead_key(tp_letterhead_text text);

/* A decimal sign by its word, point or comma; false: it is neither. */
bool tp_decimal_sign_read(tp_decimal_sign *sign, const char *word);

/* A copy for another owner; false when memory is exhausted, and what was copied is to be cleared.
 */
TP_MUST_USE bool tp_letterhead_copy(tp_letterhead *copy, const tp_letterhead *letterhead);
void tp_letterhead_clear(tp_letterhead *letterhead);

#endif
