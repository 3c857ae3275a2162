/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/file.h"
#include "message.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static tp_status fail(const char *path, const char *why, tp_message *message) {
  return tp_fail(
      message, TP_SYSTEM_FAILED, (tp_place){path, 0, 0},
      "cannot be written: %s; name a file in a folder that exists, can be written to and has "
      "room",
      why);
}

/* A rename would replace a device or a pipe instead of writing to it. */
static bool is_special(const char *path) {
  struct stat state;
  return stat(path, &state) == 0 && !S_ISREG(state.st_mode);
}

tp_status tp_file_open(tp_file *file, const char *path, tp_message *message) {
  if (is_special(path)) return fail(path, "it is no regular file", message);
  const size_t size = strlen(path) + 32;
  char *temporary = malloc(size);
  if (temporary == NULL) return tp_fail_memory(message, "the name of a file");
  snprintf(temporary, size, "%s.%ld.part", path, (long)getpid());
  const int descriptor = open(temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    const int why = errno;
    free(temporary);
    return fail(path, strerror(why), message);
  }
  *file = (tp_file){path, temporary, descriptor};
  return TP_OK;
}

tp_status tp_file_write(const tp_file *file, const char *text, size_t length, tp_message *message) {
  while (length > 0) {
    const ssize_t written = write(file->descriptor, text, length);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(file->path, strerror(errno), message);
    text += written;
    length -= (size_t)written;
  }
  return TP_OK;
}

tp_status tp_file_close(tp_file *file, tp_status status, tp_message *message) {
  /* some file systems tell of a full disk only now */
  const bool closed = close(file->descriptor) == 0;
  if (status == TP_OK && (!closed || rename(file->temporary, file->path) != 0)) {
    status = fail(file->path, strerror(errno), message);
  }
  if (status != TP_OK) unlink(file->temporary);
  free(file->temporary);
  *file = (tp_file){0};
  return status;
}
