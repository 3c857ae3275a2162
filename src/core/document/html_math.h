/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Equations (math.h) in the languages of the writers. */

#ifndef TP_DOCUMENT_HTML_MATH_H
#define TP_DOCUMENT_HTML_MATH_H

#include "output/text.h"

/* As MathML, which browsers draw themselves: an element for each of its lines. */
void tp_math_to_html(tp_text *text, const char *equation);

/* As LaTeX between two pairs of dollars, as Markdown has it, for each of its lines. */
void tp_math_to_markdown(tp_text *text, const char *equation);

#endif
