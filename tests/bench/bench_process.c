/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whole-process time of `topple solve SCENE` beside a program that does nothing.
 *
 *     bench_process TOPPLE TRIVIAL SCENE [RUNS]
 *
 * Measured: from posix_spawn to the end of waitpid, the output going to /dev/null; one run of each
 * in turn, so that a change of the machine's mood strikes both. To be read: what the trivial
 * program takes is the operating system's, what topple takes beyond it is loading its libraries and
 * solving. The median counts; the minimum is the quiet machine. */

#include "bench.h"

#include <errno.h>
#include <fcntl.h>
#include <gsl/gsl_sort.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>

enum { WARM_UP = 5, RUNS = 101, LEAST_RUNS = 41 };

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

/* Fill `samples[0]` and `samples[1]` with `runs` times of the two commands. */
static int run_in_turn(double *samples[2], long runs, char *const *commands[2],
                       const posix_spawn_file_actions_t *actions) {
  for (long k = -WARM_UP; k < runs; k++) {
    for (int c = 0; c < 2; c++) {
      const double seconds = run_once(commands[c], actions);
      if (seconds < 0) return BENCH_FAILED;
      if (k >= 0) samples[c][k] = seconds;
    }
  }
  return 0;
}

static void print_table(double *samples[2], long runs) {
  static const char *const names[] = {"topple solve", "trivial"};
  for (int c = 0; c < 2; c++) gsl_sort(samples[c], 1, (size_t)runs);
  const double reference = gsl_stats_median_from_sorted_data(samples[1], 1, (size_t)runs);
  printf("%-14s %6s %10s %10s %10s %16s\n", "program", "runs", "min ms", "median ms", "max ms",
         "median/trivial");
  for (int c = 0; c < 2; c++) {
    const double median = gsl_stats_median_from_sorted_data(samples[c], 1, (size_t)runs);
    printf("%-14s %6ld %10.3f %10.3f %10.3f %16.2f\n", names[c], runs, 1e3 * samples[c][0],
           1e3 * median, 1e3 * samples[c][runs - 1], median / reference);
  }
}

static int measure(double *samples[2], long runs, char *const *commands[2]) {
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
  const long runs = argc > 4 ? bench_count(argv[4], LEAST_RUNS) : RUNS;
  if (argc < 4 || argc > 5 || runs == 0) {
    fprintf(stderr, "usage: bench_process TOPPLE TRIVIAL SCENE [RUNS, at least %d]\n", LEAST_RUNS);
    return 2;
  }
  char solve[] = "solve";
  char *topple[] = {argv[1], solve, argv[3], NULL}, *trivial[] = {argv[2], NULL};
  char *const *commands[2] = {topple, trivial};
  double *samples[2] = {calloc((size_t)runs, sizeof(double)), calloc((size_t)runs, sizeof(double))};
  int result = BENCH_FAILED;
  if (samples[0] == NULL || samples[1] == NULL) {
    fprintf(stderr, "out of memory\n");
  } else {
    result = measure(samples, runs, commands);
    if (result == 0) print_table(samples, runs);
  }
  free(samples[0]);
  free(samples[1]);
  return result;
}
