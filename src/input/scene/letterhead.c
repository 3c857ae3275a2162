/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The letterhead of a scene: its keys, copied, and given back. */

#include "scene/letterhead.h"

#include <stdlib.h>
#include <string.h>

const char *tp_letterhead_key(tp_letterhead_text text) {
  static const char *const words[TP_LETTERHEAD_TEXTS] = {"company", "project", "job",
                                                         "author",  "checker", "date"};
  return words[text];
}

bool tp_decimal_sign_read(tp_decimal_sign *sign, const char *word) {
  const bool comma = strcmp(word, "comma") == 0;
  if (!comma && strcmp(word, "point") != 0) return false;
  *sign = comma ? TP_DECIMAL_COMMA : TP_DECIMAL_POINT;
  return true;
}

static bool copy_text(char **copy, const char *text) {
  *copy = text != NULL ? strdup(text) : NULL;
  return (*copy == NULL) == (text == NULL);
}

bool tp_letterhead_copy(tp_letterhead *copy, const tp_letterhead *own) {
  bool done = true;
  *copy = *own;
  for (int k = 0; k < TP_LETTERHEAD_TEXTS; k++) {
    done = copy_text(copy->texts + k, own->texts[k]) && done;
  }
  return copy_text(&copy->logo, own->logo) && done;
}

void tp_letterhead_clear(tp_letterhead *own) {
  for (int k = 0; k < TP_LETTERHEAD_TEXTS; k++) free(own->texts[k]);
  free(own->logo);
  *own = (tp_letterhead){0};
}
