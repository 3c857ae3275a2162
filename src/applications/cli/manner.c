/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* State of --quiet and --color, and the rule for colours: option, NO_COLOR, TERM, terminal. */

#include "cli/manner.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef enum colouring { COLOUR_AUTO, COLOUR_ALWAYS, COLOUR_NEVER } colouring;

/* Of the one command line that a process has. */
static struct {
  colouring colour;
  bool quiet;
} manner;

void tp_cli_be_quiet(void) {
  manner.quiet = true;
}

bool tp_cli_is_quiet(void) {
  return manner.quiet;
}

bool tp_cli_colour_when(const char *when) {
  static const char *const names[] = {"auto", "always", "never"};
  for (int k = 0; k < 3; k++) {
    if (strcmp(when, names[k]) != 0) continue;
    manner.colour = (colouring)k;
    return true;
  }
  return false;
}

bool tp_cli_colours(int file) {
  if (manner.colour != COLOUR_AUTO) return manner.colour == COLOUR_ALWAYS;
  const char *none = getenv("NO_COLOR"), *terminal = getenv("TERM");
  return (none == NULL || *none == '\0') && terminal != NULL && strcmp(terminal, "dumb") != 0 &&
         isatty(file) == 1;
}
