/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The style of pages: on a screen light or dark, as its reader wants it, from 400 dots wide on; on
 * paper A4 in black. Nothing is told by a colour alone. Contrasts are 7 to 1 and more (WCAG AAA).
 */

#ifndef TP_DOCUMENT_HTML_STYLE_H
#define TP_DOCUMENT_HTML_STYLE_H

extern const char tp_html_style[];

#endif
