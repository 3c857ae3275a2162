/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edit distance of Levenshtein with one row of the table, and the distance within which a word is
 * suggested. */

#include "common/nearest.h"

#include <string.h>

/* Longer than any key: between such words no distance is taken. */
enum { LONGEST = 63 };

size_t tp_word_distance(const char *one, const char *other) {
  const size_t na = strlen(one), nb = strlen(other);
  if (na > LONGEST || nb > LONGEST) return LONGEST;
  size_t row[LONGEST + 1];
  for (size_t j = 0; j <= nb; j++) row[j] = j;
  for (size_t i = 1; i <= na; i++) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= nb; j++) {
      const size_t replaced = diagonal + (one[i - 1] != other[j - 1]);
      const size_t removed = row[j] + 1, added = row[j - 1] + 1;
      diagonal = row[j];
      row[j] = replaced < removed ? replaced : removed;
      if (added < row[j]) row[j] = added;
    }
  }
  return row[nb];
}

size_t tp_word_reach(const char *word) {
  return 3 + strlen(word) / 4;
}
