/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple COMMAND ...: the table of commands, standard streams, help and version. */

#define _GNU_SOURCE
#include "cli/cli.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct command {
  const char *name, *what;
  int (*run)(int argc, char **argv);
} commands[] = {
    {"solve", "Does the block of a scene stand, slide or topple, and at which tilt?", tp_cli_solve},
    {"sweep", "Solve over a range of one or two numbers of a scene, as a table", tp_cli_sweep},
    {"derive", "The closed formulas of a scene, in its parameters", tp_cli_derive},
    {"verify", "Verdicts on printed formulas and numbers, each proven", tp_cli_verify},
    {"accuracy", "Cost of accuracy: time, bound and true error of each arithmetic",
     tp_cli_accuracy},
    {"chart", "Factors of safety and mechanism maps as figures", tp_cli_chart},
    {"profile", "How rough is a base or a measured profile, and which JRC follows?",
     tp_cli_profile},
    {"tilt", "Simulate a tilt test, or the shaking of the base", tp_cli_tilt},
    {"trace", "Trace the outline of a block in a photograph into a scene", tp_cli_trace},
    {"solid", "Poses and tilts of a solid rock, from its mesh", tp_cli_solid},
    {"study", "The probability of each verdict, where numbers of a scene vary", tp_cli_study},
    {"new", "Begin a scene: by five questions, or from options", tp_cli_new},
    {"examples", "List the example scenes, or write one", tp_cli_examples},
    {"explain", "Explain a word of a scene or a report", tp_cli_explain},
};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

/* At the end, for what help and version wrote: a full disk is an error there too. */
static void close_output(void) {
  if (ferror(stdout) == 0 && fflush(stdout) == 0) return;
  tp_cli_complain("cannot write to the standard output: %s", strerror(errno));
  _exit(TP_EXIT_SYSTEM);
}

/* A standard stream that is closed would be the next file that is opened, and get what is meant for
 * the stream. Reading and printing then fail; complaints go nowhere. */
static bool open_standard_streams(void) {
  static const int modes[] = {O_WRONLY, O_RDONLY, O_WRONLY};
  for (int k = STDIN_FILENO; k <= STDERR_FILENO; k++) {
    if (fcntl(k, F_GETFD) >= 0 || errno != EBADF) continue;
    if (open("/dev/null", modes[k]) != k) return false;
  }
  return true;
}

static void print_help(FILE *out) {
  fprintf(out, "Usage: topple COMMAND [OPTION...] ...\n"
               "Stability of a rock block of any outline on a base of any profile.\n\n");
  for (int k = 0; k < COMMANDS; k++)
    fprintf(out, "  %-10s %s\n", commands[k].name, commands[k].what);
  fprintf(out, "\nA scene file alone is short for 'topple solve SCENE'.\n"
               "'topple COMMAND --help' lists the options of a command.\n\n"
               "  --help     print this help\n"
               "  --version  print the version\n\n"
               "Exit status: 0 done, 1 a claim was refuted or a design factor of safety not met,\n"
               "2 wrong usage, 3 bad input, 4 undecided at the precision allowed, 5 the system\n"
               "failed.\n");
}

static int run_command(const struct command *command, int argc, char **argv) {
  char name[64];
  snprintf(name, sizeof name, "topple %s", command->name);
  argv[0] = name;
  return command->run(argc, argv);
}

static int has_suffix(const char *text, const char *suffix) {
  const size_t n = strlen(text), m = strlen(suffix);
  return n >= m && strcmp(text + n - m, suffix) == 0;
}

int main(int argc, char **argv) {
  if (!open_standard_streams() || atexit(close_output) != 0) return TP_EXIT_SYSTEM;
  tp_cli_guard_memory();
  if (argc < 2) {
    print_help(stderr);
    return TP_EXIT_USAGE;
  }
  const char *first = argv[1];
  if (strcmp(first, "--help") == 0 || strcmp(first, "-?") == 0 || strcmp(first, "help") == 0) {
    print_help(stdout);
    return 0;
  }
  if (strcmp(first, "--version") == 0 || strcmp(first, "-V") == 0) {
    printf("topple %s\n", TP_VERSION);
    return 0;
  }
  for (int k = 0; k < COMMANDS; k++) {
    if (strcmp(first, commands[k].name) == 0) return run_command(commands + k, argc - 1, argv + 1);
  }
  if (has_suffix(first, ".yaml") || has_suffix(first, ".yml"))
    return run_command(commands, argc, argv);
  tp_cli_complain("'%s' is neither a command nor a scene file; 'topple --help' lists the commands",
                  first);
  return TP_EXIT_USAGE;
}
