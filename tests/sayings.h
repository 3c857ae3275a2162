/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Everything that the library says of some scenes, as texts to be compared. */

#ifndef TP_TEST_SAYINGS_H
#define TP_TEST_SAYINGS_H

#include <stdbool.h>
#include <stddef.h>

enum { MOST_SAYINGS = 200 };

typedef struct sayings {
  const char *folder; /* for files on the way */
  size_t count;
  char *texts[MOST_SAYINGS];
} sayings;

/* Both only add. There are no assertions and no arithmetic in doubles around the calls, which the
 * thread's settings may forbid. */
void say_everything(sayings *s);
/* One scene, solved to so many digits, with the account by elements. */
void say_scene(sayings *s, const char *path, int digits);
void sayings_forget(sayings *s);

#endif
