/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _GNU_SOURCE
#include "report/gnuplot.h"
#include "message.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct child {
  pid_t process;
  int commands, complaints; /* ours: to write to, to read from */
} child;

static tp_status fail(tp_message *message, const char *what, const char *why) {
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){0}, "%s: %s", what, why);
}

static int spawn(pid_t *process, int commands, int figure, int complaints) {
  char name[] = "gnuplot", settings[] = "-d"; /* none but its own settings */
  char *const arguments[] = {name, settings, NULL};
  posix_spawn_file_actions_t actions;
  int why = posix_spawn_file_actions_init(&actions);
  if (why != 0) return why;
  why = posix_spawn_file_actions_adddup2(&actions, commands, STDIN_FILENO);
  if (why == 0) why = posix_spawn_file_actions_adddup2(&actions, figure, STDOUT_FILENO);
  if (why == 0) why = posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
  if (why == 0) why = posix_spawnp(process, "gnuplot", &actions, NULL, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  return why;
}

static tp_status start(child *own, int figure, tp_message *message) {
  int commands[2], complaints[2];
  /* a pair of sockets, as writing to a pipe that gnuplot has left would end this process */
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, commands) != 0) {
    return fail(message, "a pipe to gnuplot", strerror(errno));
  }
  if (pipe2(complaints, O_CLOEXEC) != 0) {
    const int why = errno;
    close(commands[0]);
    close(commands[1]);
    return fail(message, "a pipe from gnuplot", strerror(why));
  }
  const int why = spawn(&own->process, commands[1], figure, complaints[1]);
  close(commands[1]);
  close(complaints[1]);
  own->commands = commands[0];
  own->complaints = complaints[0];
  if (why == 0) return TP_OK;
  close(commands[0]);
  close(complaints[0]);
  if (why != ENOENT) return fail(message, "gnuplot cannot be started", strerror(why));
  return tp_fail(
      message, TP_SYSTEM_FAILED, (tp_place){0},
      "gnuplot, which draws the figures, is not installed: 'apt-get install gnuplot-nox' "
      "on Debian; the numbers of a chart need none: --output FILE.csv");
}

/* Until gnuplot has read all, or has given up; it then says why. */
static void tell(const child *own, const char *script) {
  size_t left = strlen(script);
  while (left > 0) {
    const ssize_t sent = send(own->commands, script, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) break;
    script += sent;
    left -= (size_t)sent;
  }
  close(own->commands);
}

/* The first line of what it complained about, and the end of the rest. */
static void listen_to(const child *own, char *text, size_t size) {
  char rest[512];
  size_t length = 0;
  for (;;) {
    const bool room = length + 1 < size;
    const ssize_t got =
        read(own->complaints, room ? text + length : rest, room ? size - 1 - length : sizeof rest);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    if (room) length += (size_t)got;
  }
  text[length] = '\0';
  close(own->complaints);
  for (char *c = text; *c != '\0'; c++) {
    if (*c == '\n' || *c == '\t') *c = ' ';
  }
}

tp_status tp_gnuplot_run(const tp_file *file, const char *script, tp_message *message) {
  child own = {0};
  tp_status status = start(&own, file->descriptor, message);
  if (status != TP_OK) return status;
  char complaint[400];
  int ended = 0;
  tell(&own, script);
  listen_to(&own, complaint, sizeof complaint);
  while (waitpid(own.process, &ended, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0 && lseek(file->descriptor, 0, SEEK_END) > 0) {
    return TP_OK;
  }
  return fail(message, "gnuplot failed", complaint[0] != '\0' ? complaint : "it said nothing");
}
