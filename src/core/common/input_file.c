/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a path is, by stat before it is opened and by fstat once it is, as it may be another by
 * then. It is opened without blocking, since the open of a pipe waits for a writer. */

#define _GNU_SOURCE
#include "common/input_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool begins(const char *text, const char *beginning) {
  return strncmp(text, beginning, strlen(beginning)) == 0;
}

/* Is it a descriptor that the process already has? */
static bool is_descriptor(const char *path) {
  return begins(path, "/dev/fd/") || begins(path, "/proc/self/fd/") ||
         strcmp(path, "/dev/stdin") == 0;
}

static tp_status check(const struct stat *state, const char *path, tp_message *message) {
  const mode_t mode = state->st_mode;
  if (S_ISREG(mode) || S_ISDIR(mode)) return TP_OK; /* the first read of a folder fails */
  if (is_descriptor(path) && (S_ISFIFO(mode) || S_ISSOCK(mode))) return TP_OK;
  const char *what = S_ISFIFO(mode) ? "a pipe" : S_ISSOCK(mode) ? "a socket" : "a device";
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 0, 0},
                   "is not a regular file but %s, which may never end; name a file", what);
}

tp_status tp_input_check(const char *path, tp_message *message) {
  struct stat state;
  if (stat(path, &state) != 0) return tp_fail_file(message, path, "opened", errno);
  return check(&state, path, message);
}

tp_status tp_input_open(FILE **file, const char *path, tp_message *message) {
  struct stat state;
  tp_status status = tp_input_check(path, message);
  if (status != TP_OK) return status;
  const int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0) return tp_fail_file(message, path, "opened", errno);
  if (fstat(descriptor, &state) != 0) {
    status = tp_fail_file(message, path, "read", errno);
  } else {
    status = check(&state, path, message);
  }
  const int flags = fcntl(descriptor, F_GETFL);
  if (status == TP_OK && (flags < 0 || fcntl(descriptor, F_SETFL, flags & ~O_NONBLOCK) != 0)) {
    status = tp_fail_file(message, path, "read", errno);
  }
  FILE *stream = status == TP_OK ? fdopen(descriptor, "rb") : NULL;
  if (stream == NULL) {
    if (status == TP_OK) status = tp_fail_file(message, path, "opened", errno);
    close(descriptor);
    return status;
  }
  *file = stream;
  return TP_OK;
}
