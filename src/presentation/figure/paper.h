/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A document on A4 pages, by Cairo: measured in points, y down. All of it is drawn twice, first on
 * a page of one dot to count pages, then as PDF. */

#ifndef TP_FIGURE_PAPER_H
#define TP_FIGURE_PAPER_H

#include "document/document.h"
#include "figure/figure.h"

/* What draws a figure of its own, and how large it is. */
typedef struct tp_vector_picture {
  bool (*draw)(cairo_t *cr, const void *context); /* false: memory is exhausted */
  const void *context;
  double width, height;
} tp_vector_picture;

typedef struct tp_paper {
  cairo_t *cr;
  cairo_surface_t *pdf; /* NULL while pages are counted */
  const tp_document *document;
  const tp_vector_picture *drawing;
  double y;           /* where the next thing begins */
  int page, pages;    /* this one, from 1, and how many; 0: not known yet */
  double left;        /* of the first page, beside its sketch */
  bool measured;      /* it is known */
  cairo_status_t why; /* of a picture that cannot be read */
} tp_paper;

#define TP_PAPER_WIDTH 595.28
#define TP_PAPER_HEIGHT 841.89
#define TP_PAPER_LEFT 48.0
#define TP_PAPER_TOP 48.0
#define TP_PAPER_BOTTOM 790.0 /* nothing but the foot stands below */
#define TP_PAPER_ROOM (TP_PAPER_WIDTH - 2 * TP_PAPER_LEFT)

/* Room for so much in one piece: a new page where there is none. */
void tp_paper_need(tp_paper *paper, double height);

/* What follows begins a page of its own. */
void tp_paper_begin_page(tp_paper *paper);

/* Logo and company, at the top of the first page. */
void tp_paper_add_letterhead(tp_paper *paper);

/* The foot, and the end of the page. */
void tp_paper_end_page(const tp_paper *paper);

/* As many of the bytes as are whole characters and fit into the width in the font set, one
 * character at least. */
size_t tp_paper_fitting(cairo_t *cr, const char *word, size_t length, double width);

enum { TP_PAPER_LINE = 512 };

/* The next line of words that fit into the width in the font set, and step past it; false where
 * nothing is left. */
bool tp_paper_line(cairo_t *cr, char line[TP_PAPER_LINE], const char **text, double width);

void tp_paper_add_table(tp_paper *paper, const tp_passage *passage);
void tp_paper_add_listing(tp_paper *paper, const char *text);
void tp_paper_add_equation(tp_paper *paper, const char *equation);

/* The picture of a PNG file, or one whose status says why there is none. */
cairo_surface_t *tp_paper_png(const char *bytes, size_t length);

/* The document as PDF. */
TP_MUST_USE tp_status tp_paper_pdf(char **bytes, size_t *length, const tp_document *document,
                                   const tp_vector_picture *drawing, tp_message *message);

#endif
