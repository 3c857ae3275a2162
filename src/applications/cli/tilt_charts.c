/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads ranges of frequencies and factors, and writes the charts of reactions, phase and
 * overturning spectrum of a tilt test. */

#include "cli/tilt_charts.h"

#include "cli/signals.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

/* FROM:TO:COUNT, rising from above 0; with at least two, and `most`. */
static bool read_range(double *from, double *to, size_t *count, const char *text, long most) {
  char *end = NULL;
  *from = strtod(text, &end);
  if (end == text || *end != ':') return false;
  const char *second = end + 1;
  *to = strtod(second, &end);
  if (end == second || *end != ':') return false;
  const char *third = end + 1;
  const long read = strtol(third, &end, 10);
  if (end == third || *end != '\0' || read < 2 || read > most) return false;
  *count = (size_t)read;
  return *from > 0 && *from < *to && isfinite(*to);
}

void tp_tilt_charts_frequencies(tp_tilt_charts *charts, const char *text,
                                const struct argp_state *state) {
  tp_overturning_options *o = &charts->overturning;
  if (read_range(&o->from, &o->to, &o->count, text, 200)) return;
  tp_cli_refuse(
      state, "--frequencies takes FROM:TO:COUNT as 0.25:8:20, rising, of 2 to 200, not '%s'", text);
}

void tp_tilt_charts_factors(tp_tilt_options *options, const char *text,
                            const struct argp_state *state) {
  if (read_range(&options->overturning_from, &options->overturning_to, &options->overturning_count,
                 text, 100000)) {
    return;
  }
  tp_cli_refuse(
      state, "--factors takes FROM:TO:COUNT as 0.5:2:400, rising, of 2 to 100000, not '%s'", text);
}

void tp_tilt_charts_take(tp_tilt_chart *wish, const char *path, const char *option,
                         const struct argp_state *state) {
  tp_cli_take_file(&wish->path, path, option, state);
  if (!tp_chart_format_read(&wish->format, path)) {
    tp_cli_refuse(state, "%s '%s' must end in .svg, .pdf, .png or .csv", option, path);
  }
}

typedef tp_status chart_maker(tp_chart **chart, const tp_tilt_test *test, tp_message *message);

static tp_status write_chart(const tp_tilt_chart *wish, chart_maker *make, const tp_tilt_test *test,
                             tp_message *message) {
  tp_chart *chart = NULL;
  if (wish->path == NULL) return TP_OK;
  tp_status status = make(&chart, test, message);
  if (status == TP_OK) status = tp_report_chart_file(wish->path, chart, wish->format, message);
  tp_chart_free(chart);
  return status;
}

tp_status tp_tilt_charts_write(const tp_tilt_charts *charts, const tp_tilt_test *test,
                               tp_message *message) {
  const tp_status status = write_chart(&charts->reactions, tp_chart_tilt_reactions, test, message);
  if (status != TP_OK) return status;
  return write_chart(&charts->phase, tp_chart_tilt_phase, test, message);
}

static double seconds_now(void) {
  struct timespec now = {0, 0};
  (void)clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* How far a spectrum is. */
typedef struct spectrum_course {
  bool tells;
  size_t done, of;
  double began;
} spectrum_course;

static void tell_frequency(void *context, size_t done, size_t of) {
  spectrum_course *own = context;
  own->done = done;
  own->of = of;
  const double seconds = own->tells ? seconds_now() - own->began : 0;
  if (seconds > 0) tp_cli_tell_progress(done, of, (double)done / seconds);
}

tp_status tp_tilt_charts_spectrum(const tp_tilt_charts *a, const tp_scene *scene, const char *name,
                                  int *ended, tp_message *message) {
  if (a->spectrum.path == NULL) return TP_OK;
  spectrum_course course = {.tells = isatty(STDERR_FILENO) == 1, .began = seconds_now()};
  tp_overturning_options own = a->overturning;
  tp_chart *chart = NULL;
  own.stop = tp_cli_is_interrupted;
  own.progress = tell_frequency;
  own.context = &course;
  tp_status status = tp_chart_overturning(&chart, scene, &own, message);
  if (course.tells) tp_cli_clear_progress();
  if (status == TP_OK) {
    status = tp_report_chart_file(a->spectrum.path, chart, a->spectrum.format, message);
  }
  tp_chart_free(chart);
  if (status == TP_OK && tp_cli_is_interrupted(NULL)) {
    tp_cli_complain("%s: the overturning spectrum was interrupted after %zu of %zu frequencies",
                    name, course.done, course.of);
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_UNDECIDED));
  }
  return status;
}
