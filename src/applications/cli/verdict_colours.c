/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The report of a solution, its verdicts and cautions coloured where its file is. */

#define _GNU_SOURCE
#include "cli/verdict_colours.h"

#include "cli/cli.h"
#include "cli/manner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define GREEN "\033[32m"
#define YELLOW "\033[33m"
#define RED "\033[31m"
#define BOLD "\033[1m"
#define PLAIN "\033[0m"

/* How a line of a report begins, and in which colour it is. What is not certain is not green. */
static const struct line {
  const char *begins, *colour;
} lines[] = {{"Tilted towards", BOLD},
             {"As it lies", BOLD},
             {"  FoS ", BOLD},
             {"  Stands ", GREEN},
             {"  Interlocked", GREEN},
             {"  May move", YELLOW},
             {"  Whether it stands", YELLOW},
             {"  Does not stand", RED},
             {"  Topples up-dip", RED},
             {"  Fails up-dip", RED},
             {"  Its loads topple", RED},
             {"  Its loads slide", RED},
             {"Caution", YELLOW}};

/* The colour of a line; NULL: none. Where sliding is not judged nothing is certain to stand. */
static const char *colour_of(const char *line, size_t length) {
  for (size_t k = 0; k < sizeof lines / sizeof lines[0]; k++) {
    if (strncmp(line, lines[k].begins, strlen(lines[k].begins)) == 0) {
      const bool by_moments = memmem(line, length, "by its moments", 14) != NULL;
      return by_moments && strcmp(lines[k].colour, GREEN) == 0 ? YELLOW : lines[k].colour;
    }
  }
  return NULL;
}

/* The first line is the title, which may be any text. */
static void write_coloured(FILE *out, const char *text) {
  for (bool first = true; *text != '\0'; first = false) {
    const size_t length = strcspn(text, "\n");
    const char *colour = first ? BOLD : colour_of(text, length);
    if (colour != NULL && length > 0) {
      fprintf(out, "%s%.*s" PLAIN, colour, (int)length, text);
    } else {
      fwrite(text, 1, length, out);
    }
    text += length;
    if (*text == '\n') fputc(*text++, out);
  }
}

int tp_cli_print_verdicts(const char *text) {
  if (!tp_cli_colours(STDOUT_FILENO)) return tp_cli_print(text);
  char *coloured = NULL;
  size_t length = 0;
  FILE *out = open_memstream(&coloured, &length);
  if (out == NULL) return tp_cli_print(text);
  write_coloured(out, text);
  const bool whole = ferror(out) == 0;
  const int ended = fclose(out) == 0 && whole ? tp_cli_print(coloured) : tp_cli_print(text);
  free(coloured);
  return ended;
}
