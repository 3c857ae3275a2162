/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whole-process time of `topple solve SCENE` beside programs that do nothing.
 *
 *     bench_process TOPPLE TRIVIAL LINKED SCENE [RUNS]
 *
 * Measured: from posix_spawn to the end of waitpid, the output going to /dev/null; one run of each
 * in turn, so that a change of the machine's mood strikes all. To be read: what the trivial
 * program takes is the operating system's; the same program linked with FLINT and Arb adds what the
 * loader takes to bind them, which Debian has them do at once, and nothing of topple can come below
 * that; what topple takes beyond it is its own libraries and solving. The goal is 3 ms. The median
 * counts; the minimum is the quiet machine. */

#include "bench.h"

#include <errno.h>
#include <fcntl.h>
#include <gsl/gsl_sort.h>
#include <spawn.h>
#include <stdbool.h>
#include <string.h>
#include <sys/wait.h>

enum { WARM_UP = 5, RUNS = 101, LEAST_RUNS = 41, PROGRAMS = 3 };

extern char **environ;

/* One run in seconds; negative, with a message, where it failed. */
static double run_once(char *const *command, const posix_spawn_file_actions_t *actions) {
  pid_t child = 0;
  int status = 0;
  const double began = bench_now();
  const int error = posix_spawn(&child, command[0], actions, NULL, command, environ);
  if (error != 0) {
    fprintf(stderr, "%s cannot be started: %s\n", command[0], strerror(error));
    return -1;
  }
  while (waitpid(child, &status, 0) < 0) {
    if (errno == EINTR) continue;
    fprintf(stderr, "%s cannot be waited for: %s\n", command[0], strerror(errno));
    return -1;
  }
  const double seconds = bench_now() - began;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    fprintf(stderr, "%s failed\n", command[0]);
    return -1;
  }
  return seconds;
}

/* Fill `samples` with `runs` times of the commands. */
static int run_in_turn(double *samples[PROGRAMS], long runs, char *const *commands[PROGRAMS],
                       const posix_spawn_file_actions_t *actions) {
  for (long k = -WARM_UP; k < runs; k++) {
    for (int c = 0; c < PROGRAMS; c++) {
      const double seconds = run_once(commands[c], actions);
      if (seconds < 0) return BENCH_FAILED;
      if (k >= 0) samples[c][k] = seconds;
    }
  }
  return 0;
}

static void print_table(double *samples[PROGRAMS], long runs) {
  static const char *const names[PROGRAMS] = {"topple solve", "trivial", "with FLINT"};
  for (int c = 0; c < PROGRAMS; c++) gsl_sort(samples[c], 1, (size_t)runs);
  const double reference = gsl_stats_median_from_sorted_data(samples[1], 1, (size_t)runs);
  printf("%-14s %6s %10s %10s %10s %16s\n", "program", "runs", "min ms", "median ms", "max ms",
         "median/trivial");
  for (int c = 0; c < PROGRAMS; c++) {
    const double median = gsl_stats_median_from_sorted_data(samples[c], 1, (size_t)runs);
    printf("%-14s %6ld %10.3f %10.3f %10.3f %16.2f\n", names[c], runs, 1e3 * samples[c][0],
           1e3 * median, 1e3 * samples[c][runs - 1], median / reference);
  }
}

static int measure(double *samples[PROGRAMS], long runs, char *const *commands[PROGRAMS]) {
  posix_spawn_file_actions_t actions;
  int error = posix_spawn_file_actions_init(&actions);
  if (error == 0) {
    error = posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    const int result = error == 0 ? run_in_turn(samples, runs, commands, &actions) : BENCH_FAILED;
    posix_spawn_file_actions_destroy(&actions);
    if (error == 0) return result;
  }
  fprintf(stderr, "the output cannot be sent to /dev/null: %s\n", strerror(error));
  return BENCH_FAILED;
}

int main(int argc, char **argv) {
  const long runs = argc > 5 ? bench_count(argv[5], LEAST_RUNS) : RUNS;
  if (argc < 5 || argc > 6 || runs == 0) {
    fprintf(stderr, "usage: bench_process TOPPLE TRIVIAL LINKED SCENE [RUNS, at least %d]\n",
            LEAST_RUNS);
    return 2;
  }
  char solve[] = "solve";
  char *topple[] = {argv[1], solve, argv[4], NULL};
  char *trivial[] = {argv[2], NULL}, *linked[] = {argv[3], NULL};
  char *const *commands[PROGRAMS] = {topple, trivial, linked};
  double *samples[PROGRAMS];
  bool done = true;
  for (int c = 0; c < PROGRAMS; c++) {
    samples[c] = calloc((size_t)runs, sizeof(double));
    done = done && samples[c] != NULL;
  }
  int result = BENCH_FAILED;
  if (done) {
    result = measure(samples, runs, commands);
    if (result == 0) print_table(samples, runs);
  } else {
    fprintf(stderr, "out of memory\n");
  }
  for (int c = 0; c < PROGRAMS; c++) free(samples[c]);
  return result;
}
