/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Argument list of a C function with one double for each symbol of a derivation. */

#include "report/c_arguments.h"

#include "output/encode.h"

#include <string.h>

void tp_c_arguments(tp_text *t, const tp_derivation *d, const char *first) {
  tp_text_add(t, "(%s", first);
  for (size_t k = 0; k < d->symbol_count; k++) {
    tp_text_add(t, "%sdouble ", k > 0 || *first != '\0' ? ", " : "");
    tp_encode_plain(t, d->symbols[k]);
  }
  tp_text_add(t, d->symbol_count == 0 && *first == '\0' ? "void) {\n" : ") {\n");
}

void tp_add_symbol(tp_text *t, const char *symbol, const char *parameter) {
  tp_encode_plain(t, symbol);
  if (strcmp(symbol, parameter) == 0) return;
  tp_text_add(t, " for ");
  tp_encode_plain(t, parameter);
}
