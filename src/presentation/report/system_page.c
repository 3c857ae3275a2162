/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Labels, names and the end of a table on the page of many blocks. */

#include "report/system_page.h"

void tp_text_more_rows(tp_text *t, size_t rows) {
  if (rows > TP_SYSTEM_ROWS) tp_text_add(t, "  and %zu more: see --json\n", rows - TP_SYSTEM_ROWS);
}

void tp_text_system_label(tp_text *t, const char *label) {
  enum { WIDTH = 38 };
  tp_text_add(t, "  %-*s", WIDTH, label);
}

void tp_text_system_name(tp_text *t, const char *name, int width) {
  char plain[128];
  tp_plain_text(plain, sizeof plain, name);
  tp_text_add(t, "%-*s", width, plain);
}
