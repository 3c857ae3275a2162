/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Child process by posix_spawn with a clean environment and default signals; its three streams are
 * served by poll within bounds of time and bytes. */

#define _GNU_SOURCE
#include "chart/program.h"
#include "common/clock.h"
#include "common/message.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

/* It answers in a second, with some megabytes at most; what takes more hangs, or runs away. */
enum { MOST_SECONDS = 60, MOST_BYTES = 256 << 20, COMPLAINT_SIZE = 400 };
enum { COMMANDS, FIGURE, COMPLAINTS, STREAMS };

/* The program, and our ends of its standard streams; -1 when closed. */
typedef struct child {
  const tp_plot_program *program;
  pid_t process;
  int ends[STREAMS];
  size_t told; /* of its input */
  char *figure;
  size_t length, capacity;
  char complaint[COMPLAINT_SIZE];
  size_t complained;
  bool no_memory;
} child;

static tp_status fail(tp_message *message, const child *own, const char *what, const char *why) {
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){0}, "%s %s: %s", own->program->name, what,
                 why);
}

static void close_all(int ends[STREAMS]) {
  for (int k = 0; k < STREAMS; k++) {
    if (ends[k] >= 0) close(ends[k]);
    ends[k] = -1;
  }
}

/* ---- starting it -------------------------------------------------------------------------------
 */

/* What the user has set for other programs would change the figure, or end in it: GNUTERM,
 * GNUPLOT_LIB, POSIXLY_CORRECT, the language, the fonts of the home folder. */
static char **environment(char *room[4], char *letters) {
  static const char *const kept[] = {"PATH", "LD_LIBRARY_PATH"};
  int count = 0;
  for (size_t k = 0; k < sizeof kept / sizeof kept[0]; k++) {
    for (char **own = environ; own != NULL && *own != NULL; own++) {
      const size_t length = strlen(kept[k]);
      if (strncmp(*own, kept[k], length) != 0 || (*own)[length] != '=') continue;
      room[count++] = *own;
      break;
    }
  }
  room[count++] = letters;
  room[count] = NULL;
  return room;
}

static int set_streams(posix_spawn_file_actions_t *actions, const int theirs[STREAMS]) {
  static const int standard[STREAMS] = {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO};
  int why = 0;
  for (int k = 0; k < STREAMS && why == 0; k++) {
    why = posix_spawn_file_actions_adddup2(actions, theirs[k], standard[k]);
  }
  return why;
}

/* It takes every signal as a program does that is started anew. */
static int set_signals(posix_spawnattr_t *attributes) {
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  int why = posix_spawnattr_setsigmask(attributes, &none);
  if (why == 0) why = posix_spawnattr_setsigdefault(attributes, &all);
  if (why == 0) {
    why = posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  return why;
}

static int spawn(child *own, const int theirs[STREAMS]) {
  char letters[] = "LC_ALL=C.UTF-8";
  char *room[4];
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  int why = posix_spawn_file_actions_init(&actions);
  if (why != 0) return why;
  why = posix_spawnattr_init(&attributes);
  if (why == 0) {
    why = set_streams(&actions, theirs);
    if (why == 0) why = set_signals(&attributes);
    if (why == 0) {
      why = posix_spawnp(&own->process, own->program->name, &actions, &attributes,
                         (char *const *)own->program->arguments, environment(room, letters));
    }
    posix_spawnattr_destroy(&attributes);
  }
  posix_spawn_file_actions_destroy(&actions);
  return why;
}

/* Above the standard streams, which the program may have closed, and which the program's become. */
static bool move_up(int ends[2]) {
  for (int k = 0; k < 2; k++) {
    if (ends[k] > STDERR_FILENO) continue;
    const int moved = fcntl(ends[k], F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (moved < 0) return false;
    close(ends[k]);
    ends[k] = moved;
  }
  return true;
}

/* Ours and theirs; a pair of sockets for the commands, as writing to a pipe that the program has
 * left would end this process. */
static bool open_streams(int ours[STREAMS], int theirs[STREAMS]) {
  for (int k = 0; k < STREAMS; k++) {
    int pair[2];
    const int opened = k == COMMANDS ? socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair)
                                     : pipe2(pair, O_CLOEXEC);
    if (opened != 0) return false;
    const bool moved = move_up(pair);
    ours[k] = pair[0];
    theirs[k] = pair[1];
    if (!moved || fcntl(ours[k], F_SETFL, O_NONBLOCK) != 0) return false;
  }
  return true;
}

static tp_status start(child *own, tp_message *message) {
  int theirs[STREAMS] = {-1, -1, -1};
  for (int k = 0; k < STREAMS; k++) own->ends[k] = -1;
  int why = open_streams(own->ends, theirs) ? 0 : errno;
  const bool opened = why == 0;
  if (opened) why = spawn(own, theirs);
  close_all(theirs);
  if (why == 0) return TP_OK;
  close_all(own->ends);
  if (!opened || why != ENOENT) return fail(message, own, "cannot be started", strerror(why));
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){0}, "%s, %s", own->program->name,
                 own->program->where_missing);
}

/* ---- talking to it -----------------------------------------------------------------------------
 */

static void close_end(child *own, int which) {
  close(own->ends[which]);
  own->ends[which] = -1;
}

/* Until it has read all, or reads no more. */
static void tell(child *own) {
  const tp_plot_program *program = own->program;
  const ssize_t sent = send(own->ends[COMMANDS], program->input + own->told,
                            program->input_length - own->told, MSG_NOSIGNAL);
  if (sent < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (sent > 0) own->told += (size_t)sent;
  if (sent < 0 || own->told == program->input_length) close_end(own, COMMANDS);
}

static void take(child *own, const char *bytes, size_t count) {
  if (count > own->capacity - own->length) {
    const size_t capacity = 2 * (own->capacity + count);
    char *larger = capacity <= MOST_BYTES ? realloc(own->figure, capacity) : NULL;
    own->no_memory = larger == NULL;
    if (larger == NULL) return;
    own->figure = larger;
    own->capacity = capacity;
  }
  memcpy(own->figure + own->length, bytes, count);
  own->length += count;
}

static void listen_to(child *own, int which) {
  char bytes[1 << 14];
  const ssize_t got = read(own->ends[which], bytes, sizeof bytes);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (got <= 0) {
    close_end(own, which);
  } else if (which == FIGURE) {
    take(own, bytes, (size_t)got);
  } else {
    const size_t room = sizeof own->complaint - 1 - own->complained;
    const size_t kept = (size_t)got < room ? (size_t)got : room;
    memcpy(own->complaint + own->complained, bytes, kept);
    own->complained += kept;
  }
}

/* Until it has closed what it writes to; false when it does nothing any more, or too much. */
static bool talk(child *own) {
  while (own->ends[FIGURE] >= 0 || own->ends[COMPLAINTS] >= 0) {
    struct pollfd ends[STREAMS];
    for (int k = 0; k < STREAMS; k++) {
      ends[k] = (struct pollfd){own->ends[k], k == COMMANDS ? POLLOUT : POLLIN, 0};
    }
    const int ready = poll(ends, STREAMS, MOST_SECONDS * 1000);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    if (ends[COMMANDS].revents != 0) tell(own);
    for (int k = FIGURE; k < STREAMS; k++) {
      if (ends[k].revents != 0) listen_to(own, k);
    }
    if (own->no_memory) return false;
  }
  return true;
}

/* ---- ending it ---------------------------------------------------------------------------------
 */

/* How it ended: true when well. The program may have asked the system to forget its children; it is
 * then judged by what it said. */
static bool ended_well(const child *own, int ended, bool known) {
  return known ? WIFEXITED(ended) && WEXITSTATUS(ended) == 0 : own->complained == 0;
}

/* Wait until it ends, not for ever; false when it does not. */
static bool await(const child *own, bool *well) {
  const double began = tp_clock_now();
  for (;;) {
    int ended = 0;
    const pid_t found = waitpid(own->process, &ended, WNOHANG);
    if (found == own->process || (found < 0 && errno == ECHILD)) {
      *well = ended_well(own, ended, found > 0);
      return true;
    }
    if (tp_clock_now() - began > MOST_SECONDS) return false;
    poll(NULL, 0, 1);
  }
}

static void end(const child *own) {
  kill(own->process, SIGKILL);
  while (waitpid(own->process, NULL, 0) < 0 && errno == EINTR) {
  }
}

static tp_status complain(child *own, tp_message *message) {
  for (char *c = own->complaint; *c != '\0'; c++) {
    if (*c == '\n' || *c == '\t') *c = ' ';
  }
  return fail(message, own, "failed",
              own->complained > 0 ? own->complaint : "it drew nothing and printed no message");
}

static tp_status have_drawn(child *own, tp_message *message) {
  bool well = false;
  const bool said = talk(own);
  close_all(own->ends);
  if (said && await(own, &well)) return well && own->length > 0 ? TP_OK : complain(own, message);
  end(own);
  if (own->no_memory) return tp_fail_memory(message, "the figure");
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){0},
                 "%s failed: it did not respond for %d seconds and was stopped; does '%s' "
                 "work by itself?",
                 own->program->name, (int)MOST_SECONDS, own->program->name);
}

tp_status tp_program_run(char **figure, size_t *length, const tp_plot_program *program,
                         tp_message *message) {
  child *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the figure");
  own->program = program;
  tp_status status = start(own, message);
  if (status == TP_OK) status = have_drawn(own, message);
  if (status == TP_OK) {
    *figure = own->figure;
    *length = own->length;
  } else {
    free(own->figure);
  }
  free(own);
  return status;
}
