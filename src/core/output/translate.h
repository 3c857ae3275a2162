/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A text that was composed in English, in another language.
 *
 * Cautions, verdicts and what is told of an input are put together where they are known, from
 * numbers, names and words. Here the English text is taken apart again by the phrases of the
 * language: a phrase with arguments is a pattern, "It may steepen by %s°", what stands at its
 * arguments is translated likewise, and the phrase of the other language is filled with that. Of
 * phrases that fit the one with most of the text in it counts. Where none fits, the text is taken
 * sentence by sentence, then clause by clause; what no phrase has stays as it is. So a language
 * needs no code, and a text of which a phrase is missing is told in English, never wrongly. */

#ifndef TP_OUTPUT_TRANSLATE_H
#define TP_OUTPUT_TRANSLATE_H

#include "output/language.h"
#include "output/text.h"

/* Append it; `comma` before the decimals of its numbers. */
void tp_translate(tp_text *text, const tp_language *language, bool comma, const char *english);

#endif
