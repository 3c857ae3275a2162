/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The logo of a letterhead: a small PNG, JPEG or SVG file, told by its bytes. Nothing of it is
 * executed: HTML and Markdown hold it as a picture, in which a viewer runs nothing; the PDF has
 * PNG and JPEG. */

#ifndef TP_DOCUMENT_LOGO_H
#define TP_DOCUMENT_LOGO_H

#include "common/message.h"

typedef enum tp_logo_kind { TP_LOGO_NONE, TP_LOGO_PNG, TP_LOGO_JPEG, TP_LOGO_SVG } tp_logo_kind;

typedef struct tp_logo {
  tp_logo_kind kind;
  char *bytes; /* owned */
  size_t length;
  int width, height; /* in dots; 0 of SVG */
} tp_logo;

/* "png", "jpeg" or "svg+xml": what follows image/. */
const char *tp_logo_type(tp_logo_kind kind);

/* Read the file that `place` asks for. Refused where it cannot be read, is none of the kinds, is
 * cut off, or too large: a logo has at most 1 MiB and 4096 dots a side. */
TP_MUST_USE tp_status tp_logo_read(tp_logo *logo, const char *path, tp_place place,
                                   tp_message *message);
void tp_logo_clear(tp_logo *logo);

#endif
