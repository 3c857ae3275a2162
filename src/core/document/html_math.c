/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Presentation MathML for HTML, and LaTeX for Markdown, by recursive descent over the signs of
 * document/math.h. */

#include "document/html_math.h"

#include "document/math.h"
#include "output/encode.h"

#include <string.h>

static void add_element(tp_text *t, const char *name, const tp_math_sign *s) {
  tp_text_add(t, "<%s>", name);
  if (*s->text == '<' || *s->text == '>' || *s->text == '&') {
    tp_text_add(t, "%s", *s->text == '<' ? "&lt;" : *s->text == '>' ? "&gt;" : "&amp;");
  } else {
    tp_text_append(t, s->text, s->length);
  }
  tp_text_add(t, "</%s>", name);
}

static void add_row(tp_text *t, const char *at, const char *end);

/* What is between braces, or a sign alone, as one element. */
static void add_argument(tp_text *t, const char **at, const char *end) {
  const tp_math_sign s = tp_math_next(at, end);
  tp_text_add(t, "<mrow>");
  if (s.kind == TP_MATH_GROUP) {
    add_row(t, s.text, s.text + s.length);
  } else if (s.kind != TP_MATH_END) {
    add_row(t, s.text, s.text + s.length);
  }
  tp_text_add(t, "</mrow>");
}

static void add_sign(tp_text *t, const tp_math_sign *s, const char **at, const char *end) {
  switch (s->kind) {
  case TP_MATH_LETTER:
    add_element(t, "mi", s);
    return;
  case TP_MATH_NUMBER:
    add_element(t, "mn", s);
    return;
  case TP_MATH_WORDS:
    add_element(t, "mtext", s);
    return;
  case TP_MATH_FUNCTION:
    add_element(t, "mi", s);
    tp_text_add(t, "<mspace width=\"0.17em\"></mspace>");
    return;
  case TP_MATH_GROUP:
    tp_text_add(t, "<mrow>");
    add_row(t, s->text, s->text + s->length);
    tp_text_add(t, "</mrow>");
    return;
  case TP_MATH_FRACTION:
    tp_text_add(t, "<mfrac>");
    add_argument(t, at, end);
    add_argument(t, at, end);
    tp_text_add(t, "</mfrac>");
    return;
  case TP_MATH_BAR:
    tp_text_add(t, "<mover accent=\"true\">");
    add_argument(t, at, end);
    tp_text_add(t, "<mo stretchy=\"false\">¯</mo></mover>");
    return;
  default:
    add_element(t, "mo", s);
    return;
  }
}

static void add_row(tp_text *t, const char *at, const char *end) {
  for (;;) {
    const tp_math_sign s = tp_math_next(&at, end);
    if (s.kind == TP_MATH_END) return;
    /* what stands before an index is known only when it has been read */
    tp_text own = {0};
    add_sign(&own, &s, &at, end);
    const bool below = tp_math_follows(at, end, TP_MATH_BELOW);
    const bool above = !below && tp_math_follows(at, end, TP_MATH_ABOVE);
    if (below || above) {
      (void)tp_math_next(&at, end);
      tp_text_add(t, below ? "<msub>" : "<msup>");
    }
    if (own.data != NULL) tp_text_append(t, own.data, own.length);
    t->failed = t->failed || own.failed;
    tp_text_drop(&own);
    if (below || above) {
      add_argument(t, &at, end);
      tp_text_add(t, below ? "</msub>" : "</msup>");
    }
  }
}

/* Where the line ends that begins here. */
static const char *line_end(const char *at) {
  const char *end = strstr(at, "\\\\");
  return end != NULL ? end : at + strlen(at);
}

void tp_math_to_html(tp_text *t, const char *equation) {
  for (const char *at = equation; *at != '\0';) {
    const char *end = line_end(at);
    tp_text_add(t, "<math display=\"block\"><mrow>");
    add_row(t, at, end);
    tp_text_add(t, "</mrow></math>\n");
    at = *end != '\0' ? end + 2 : end;
  }
}

/* Letters that Markdown's LaTeX has a name for stay as they are; it knows them all. Signs of
 * degrees and of a minus are the exception. */
static void add_latex(tp_text *t, const char *at, const char *end) {
  static const char *const signs[][2] = {{"°", "^\\circ"}, {"−", "-"}, {"·", "\\cdot "}};
  while (at < end) {
    size_t k = 0;
    while (k < 3 && strncmp(at, signs[k][0], strlen(signs[k][0])) != 0) k++;
    if (k < 3) {
      tp_text_add(t, "%s", signs[k][1]);
      at += strlen(signs[k][0]);
    } else {
      tp_text_append(t, at++, 1);
    }
  }
}

void tp_math_to_markdown(tp_text *t, const char *equation) {
  for (const char *at = equation; *at != '\0';) {
    const char *end = line_end(at);
    tp_text_add(t, "$$");
    add_latex(t, at, end);
    tp_text_add(t, "$$\n\n");
    at = *end != '\0' ? end + 2 : end;
  }
}
