/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public library's dictionary: what a word of a scene or of a report means. Included by
 * topple.h. */

#ifndef TOPPLE_EXPLAIN_H
#define TOPPLE_EXPLAIN_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A term of rock mechanics, its symbol or another name of it; a key of a scene, a study or a file
 * of claims, by itself or with the way to it, as block.slab.width; or a key of results likewise:
 * everything that it means, with unit, formula and source, as a report of lines of at most 80
 * columns. Case, blanks, hyphens and underscores do not matter. `*text` is to be freed.
 * TP_NO_ANSWER where nothing is called so: the message names what is nearest. */
TP_MUST_USE tp_status tp_report_explained(char **text, const char *word, tp_message *message);

/* All terms, a line each, to be freed. */
TP_MUST_USE tp_status tp_report_terms(char **text);

#ifdef __cplusplus
}
#endif

#endif
