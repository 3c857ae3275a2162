/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The languages that phrases.csv has a column for, English first. */

#ifndef TP_TERMS_PHRASES_H
#define TP_TERMS_PHRASES_H

#include "output/language.h"

extern const tp_language tp_languages[];
extern const size_t tp_language_count;

/* "en, es, de" */
extern const char tp_language_codes[];

/* That of the code; NULL: there is none. */
const tp_language *tp_language_find(const char *code);

#endif
