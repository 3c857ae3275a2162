/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Figures: Cairo is loaded when one is asked for, not at every start. They are drawn in a process
 * of their own, as Fontconfig crashes where memory runs out: the program then says so and ends
 * well. That process ends with this one. */

#define _GNU_SOURCE
#include "cli/cli.h"
#include "cli/library.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

/* For how long the process that draws may say nothing. A figure of 10^6 vertices takes seconds; but
 * where memory runs out Fontconfig can also wait for ever. */
enum { SILENCE_S = 120 };

/* What the process that draws has to tell: that all is ready, and it waits for a byte as consent;
 * or what it came to. */
typedef struct outcome {
  bool asks;
  tp_status status;
  tp_message message;
} outcome;

/* Calls what the library has by a name. */
typedef tp_status drawer_call(void *call, const void *what, tp_figure_consent consent,
                              tp_message *message);

static tp_status draw_here(drawer_call *draw, const char *name, const void *what,
                           tp_figure_consent consent, tp_message *message) {
  tp_cli_why why;
  void *call = tp_cli_load_call(TP_FIGURE_LIBRARY, name, &why);
  if (call != NULL) return draw(call, what, consent, message);
  snprintf(message->text, sizeof message->text,
           "figures and reports are drawn by " TP_FIGURE_LIBRARY
           ", which does not load (%s); install it beside Topple's "
           "other files",
           why.text);
  return TP_DEPENDENCY_FAILED;
}

/* What came from the other process: all that was waited for, its end, nothing for too long. */
typedef enum hearing { HEARD, ENDED, SILENT } hearing;

/* It is less than what a socket takes at once. */
static hearing receive(void *told, size_t size, int from) {
  size_t got = 0;
  while (got < size) {
    const ssize_t more = read(from, (char *)told + got, size - got);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0 && errno == EAGAIN) return SILENT;
    if (more <= 0) return ENDED;
    got += (size_t)more;
  }
  return HEARD;
}

/* Without a signal where nobody is there to take it. */
static bool tell(int to, const void *what, size_t size) {
  return send(to, what, size, MSG_NOSIGNAL) == (ssize_t)size;
}

/* In the process that draws: ask the other one. It has ended, or says no, where no byte comes. */
static bool ask_parent(void *context) {
  const int other = *(const int *)context;
  const outcome asking = {.asks = true};
  char consent = 0;
  return tell(other, &asking, sizeof asking) && receive(&consent, 1, other) == HEARD;
}

static tp_status fail(tp_message *message, tp_status status, const char *what) {
  snprintf(message->text, sizeof message->text, "the figure cannot be drawn: %s", what);
  return status;
}

/* Its last word, if it came. Consent is asked for once, here where the figure needs none. */
static hearing converse(outcome *told, int other, tp_figure_consent consent) {
  hearing heard = receive(told, sizeof *told, other);
  bool asked = false;
  while (heard == HEARD && told->asks) {
    const char yes = 1;
    asked = true;
    if (!consent.give(consent.context) || !tell(other, &yes, sizeof yes)) {
      shutdown(other, SHUT_WR);
    }
    heard = receive(told, sizeof *told, other);
  }
  if (heard == HEARD && !asked && told->status == TP_OK) (void)consent.give(consent.context);
  return heard;
}

/* What the other process came to. */
static tp_status await(pid_t process, int other, tp_figure_consent consent, tp_message *message) {
  outcome told = {.status = TP_OK};
  const hearing heard = converse(&told, other, consent);
  int ended = 0;
  if (heard == SILENT) kill(process, SIGKILL);
  while (waitpid(process, &ended, 0) < 0) {
    if (errno != EINTR) return fail(message, TP_SYSTEM_FAILED, strerror(errno));
  }
  if (heard == SILENT) {
    return fail(message, TP_DEPENDENCY_FAILED,
                "Cairo or Fontconfig hung, as they do where memory is short");
  }
  if (heard == HEARD && WIFEXITED(ended) && WEXITSTATUS(ended) == 0) {
    *message = told.message;
    return told.status;
  }
  if (WIFEXITED(ended)) return fail(message, TP_OUT_OF_MEMORY, "its process gave up");
  const int signal = WTERMSIG(ended);
  if (signal != SIGSEGV && signal != SIGBUS && signal != SIGABRT) {
    return fail(message, TP_SYSTEM_FAILED, "its process was ended from outside");
  }
  return fail(message, TP_DEPENDENCY_FAILED,
              "Cairo or Fontconfig crashed, as they do where memory is short");
}

static tp_status draw(drawer_call *drawer, const char *name, const void *what,
                      tp_figure_consent consent, tp_message *message) {
  int ends[2];
  if (fflush(NULL) != 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    return fail(message, TP_SYSTEM_FAILED, strerror(errno));
  }
  const pid_t parent = getpid(), process = fork();
  if (process == 0) {
    outcome own = {.status = TP_OK};
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(TP_EXIT_SYSTEM); /* it has ended already */
    close(ends[0]);
    own.status =
        draw_here(drawer, name, what, (tp_figure_consent){ask_parent, &ends[1]}, &own.message);
    exit(tell(ends[1], &own, sizeof own) ? 0 : TP_EXIT_SYSTEM);
  }
  const int why = errno;
  close(ends[1]);
  const struct timeval silence = {.tv_sec = SILENCE_S};
  setsockopt(ends[0], SOL_SOCKET, SO_RCVTIMEO, &silence, sizeof silence);
  const tp_status status = process > 0 ? await(process, ends[0], consent, message)
                                       : fail(message, TP_SYSTEM_FAILED, strerror(why));
  close(ends[0]);
  return status;
}

/* What is to be drawn, for the other process, which has all of this one's memory. */
typedef struct solved {
  const char *path;
  const tp_scene *scene;
  const tp_solution *solution; /* or: */
  const tp_block_system *system;
  const tp_sheet_options *options;
  const tp_solid *solid;
} solved;

static tp_status draw_figure(void *call, const void *what, tp_figure_consent consent,
                             tp_message *message) {
  tp_status (*function)(const char *, const tp_scene *, const tp_solution *, tp_figure_consent,
                        tp_message *) = NULL;
  const solved *own = what;
  *(void **)&function = call;
  return function(own->path, own->scene, own->solution, consent, message);
}

/* What goes with a sheet is printed before it: no consent is asked for. */
static tp_status draw_sheet(void *call, const void *what, tp_figure_consent consent,
                            tp_message *message) {
  tp_status (*function)(const char *, const tp_scene *, const tp_solution *,
                        const tp_sheet_options *, tp_message *) = NULL;
  const solved *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->scene, own->solution, own->options, message);
}

tp_status tp_cli_draw(const char *path, const tp_scene *scene, const tp_solution *solution,
                      tp_figure_consent consent, tp_message *message) {
  const solved own = {.path = path, .scene = scene, .solution = solution};
  return draw(draw_figure, "tp_report_figure_if", &own, consent, message);
}

static tp_status draw_blocks(void *call, const void *what, tp_figure_consent consent,
                             tp_message *message) {
  tp_status (*function)(const char *, const tp_scene *, const tp_block_system *, tp_figure_consent,
                        tp_message *) = NULL;
  const solved *own = what;
  *(void **)&function = call;
  return function(own->path, own->scene, own->system, consent, message);
}

tp_status tp_cli_draw_system(const char *path, const tp_scene *scene, const tp_block_system *system,
                             tp_figure_consent consent, tp_message *message) {
  const solved own = {.path = path, .scene = scene, .system = system};
  return draw(draw_blocks, "tp_report_figure_block_system_if", &own, consent, message);
}

static tp_status draw_solid(void *call, const void *what, tp_figure_consent consent,
                            tp_message *message) {
  tp_status (*function)(const char *, const tp_solid *, tp_figure_consent, tp_message *) = NULL;
  const solved *own = what;
  *(void **)&function = call;
  return function(own->path, own->solid, consent, message);
}

tp_status tp_cli_draw_solid(const char *path, const tp_solid *solid, tp_figure_consent consent,
                            tp_message *message) {
  const solved own = {.path = path, .solid = solid};
  return draw(draw_solid, "tp_report_figure_solid_if", &own, consent, message);
}

static bool agree(void *context) {
  (void)context;
  return true;
}

tp_status tp_cli_write_sheet(const char *path, const tp_scene *scene, const tp_solution *solution,
                             const tp_sheet_options *options, tp_message *message) {
  const solved own = {.path = path, .scene = scene, .solution = solution, .options = options};
  return draw(draw_sheet, "tp_report_sheet", &own, (tp_figure_consent){agree, NULL}, message);
}

static tp_status draw_system_sheet(void *call, const void *what, tp_figure_consent consent,
                                   tp_message *message) {
  tp_status (*function)(const char *, const tp_scene *, const tp_block_system *,
                        const tp_sheet_options *, tp_message *) = NULL;
  const solved *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->scene, own->system, own->options, message);
}

tp_status tp_cli_write_system_sheet(const char *path, const tp_scene *scene,
                                    const tp_block_system *system, const tp_sheet_options *options,
                                    tp_message *message) {
  const solved own = {.path = path, .scene = scene, .system = system, .options = options};
  return draw(draw_system_sheet, "tp_report_sheet_block_system", &own,
              (tp_figure_consent){agree, NULL}, message);
}

static tp_status draw_solid_sheet(void *call, const void *what, tp_figure_consent consent,
                                  tp_message *message) {
  tp_status (*function)(const char *, const tp_scene *, const tp_solid *, const tp_sheet_options *,
                        tp_message *) = NULL;
  const solved *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->scene, own->solid, own->options, message);
}

tp_status tp_cli_write_solid_sheet(const char *path, const tp_scene *scene, const tp_solid *solid,
                                   const tp_sheet_options *options, tp_message *message) {
  const solved own = {.path = path, .scene = scene, .solid = solid, .options = options};
  return draw(draw_solid_sheet, "tp_report_sheet_solid", &own, (tp_figure_consent){agree, NULL},
              message);
}

typedef struct studied {
  const char *path;
  const tp_study *study;
  const tp_study_result *result;
  const tp_sheet_options *options;
} studied;

static tp_status draw_study(void *call, const void *what, tp_figure_consent consent,
                            tp_message *message) {
  tp_status (*function)(const char *, const tp_study *, const tp_study_result *,
                        const tp_sheet_options *, tp_message *) = NULL;
  const studied *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->study, own->result, own->options, message);
}

tp_status tp_cli_write_study_sheet(const char *path, const tp_study *study,
                                   const tp_study_result *result, const tp_sheet_options *options,
                                   tp_message *message) {
  const studied own = {path, study, result, options};
  return draw(draw_study, "tp_report_sheet_study", &own, (tp_figure_consent){agree, NULL}, message);
}

typedef struct tilted {
  const char *path;
  const tp_scene *scene;
  const tp_tilt_test *test;
  const tp_sheet_options *options;
} tilted;

static tp_status draw_tilt(void *call, const void *what, tp_figure_consent consent,
                           tp_message *message) {
  tp_status (*function)(const char *, const tp_scene *, const tp_tilt_test *,
                        const tp_sheet_options *, tp_message *) = NULL;
  const tilted *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->scene, own->test, own->options, message);
}

tp_status tp_cli_write_tilt_sheet(const char *path, const tp_scene *scene, const tp_tilt_test *test,
                                  const tp_sheet_options *options, tp_message *message) {
  const tilted own = {path, scene, test, options};
  return draw(draw_tilt, "tp_report_sheet_tilt", &own, (tp_figure_consent){agree, NULL}, message);
}

typedef struct surveyed {
  const char *path, *ending; /* the file of the page, or the folder of the figures */
  const tp_batch *batch;
  size_t figures;
} surveyed;

static tp_status draw_page(void *call, const void *what, tp_figure_consent consent,
                           tp_message *message) {
  tp_status (*function)(const char *, const tp_batch *, size_t, tp_message *) = NULL;
  const surveyed *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->batch, own->figures, message);
}

static tp_status draw_figures(void *call, const void *what, tp_figure_consent consent,
                              tp_message *message) {
  tp_status (*function)(const char *, const char *, const tp_batch *, tp_message *) = NULL;
  const surveyed *own = what;
  (void)consent;
  *(void **)&function = call;
  return function(own->path, own->ending, own->batch, message);
}

tp_status tp_cli_write_batch_page(const char *path, const tp_batch *batch, size_t figures,
                                  tp_message *message) {
  const surveyed own = {path, NULL, batch, figures};
  return draw(draw_page, "tp_report_sheet_batch", &own, (tp_figure_consent){agree, NULL}, message);
}

tp_status tp_cli_write_batch_figures(const char *folder, const char *ending, const tp_batch *batch,
                                     tp_message *message) {
  const surveyed own = {folder, ending, batch, 0};
  return draw(draw_figures, "tp_report_figures_batch", &own, (tp_figure_consent){agree, NULL},
              message);
}
