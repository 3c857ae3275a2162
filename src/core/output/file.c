/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes a temporary file in the same folder, copies owner and mode, and renames it, in a thread
 * with signals blocked; links, pipes, devices and files of several names are written in place. */

#define _GNU_SOURCE
#include "output/file.h"
#include "common/message.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

typedef struct output {
  const char *path, *bytes;
  size_t length;
  tp_figure_consent consent;
  tp_message *message;
} output;

static tp_status fail_as(const output *o, const char *why) {
  return tp_fail(
      o->message, TP_SYSTEM_FAILED, (tp_place){o->path, 0, 0},
      "cannot be written: %s; name a file in a folder that exists, can be written to and has room",
      why);
}

static tp_status fail(const output *o, int why) {
  return tp_fail_because(o->message, fail_as(o, strerror(why)), why);
}

/* All is ready. */
static tp_status ask(const output *o) {
  if (o->consent.give == NULL || o->consent.give(o->consent.context)) return TP_OK;
  return tp_fail(o->message, TP_SYSTEM_FAILED, (tp_place){o->path, 0, 0},
                 "not written: what goes with it could not be written");
}

static bool is_same(const struct stat *one, const struct stat *other) {
  return one->st_dev == other->st_dev && one->st_ino == other->st_ino;
}

/* A regular file that is the standard output by another name is to get our bytes where it is. */
static bool is_standard(const struct stat *state) {
  struct stat other;
  return (fstat(STDOUT_FILENO, &other) == 0 && is_same(state, &other)) ||
         (fstat(STDERR_FILENO, &other) == 0 && is_same(state, &other));
}

/* ---- signals -----------------------------------------------------------------------------------
 */

/* Those of writing to a pipe that nobody reads, and past the size allowed: errors serve instead. */
static void set_of_writing(sigset_t *set) {
  sigemptyset(set);
  sigaddset(set, SIGPIPE);
  sigaddset(set, SIGXFSZ);
}

/* All but those of faults. */
static void set_of_ending(sigset_t *set) {
  static const int faults[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP};
  sigfillset(set);
  for (size_t k = 0; k < sizeof faults / sizeof faults[0]; k++) sigdelset(set, faults[k]);
}

/* Signals that wait until release(). */
typedef struct held {
  sigset_t before, waiting;
} held;

static held hold(const sigset_t *set) {
  held own;
  sigpending(&own.waiting);
  pthread_sigmask(SIG_BLOCK, set, &own.before);
  return own;
}

/* Those of our own writing are taken; one that waited before is the program's. */
static void release(const held *own) {
  static const struct timespec at_once = {0, 0};
  sigset_t writing;
  set_of_writing(&writing);
  if (sigismember(&own->waiting, SIGPIPE) == 1) sigdelset(&writing, SIGPIPE);
  if (sigismember(&own->waiting, SIGXFSZ) == 1) sigdelset(&writing, SIGXFSZ);
  while (sigtimedwait(&writing, NULL, &at_once) > 0) {
  }
  pthread_sigmask(SIG_SETMASK, &own->before, NULL);
}

/* ---- writing -----------------------------------------------------------------------------------
 */

static tp_status write_all(int descriptor, const output *o) {
  const char *from = o->bytes;
  size_t left = o->length;
  while (left > 0) {
    const ssize_t written = write(descriptor, from, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(o, errno);
    from += written;
    left -= (size_t)written;
  }
  return TP_OK;
}

/* Into the file itself. Of a regular file the room is reserved first: what fails then leaves it as
 * it was. Another one may take its time, in which the program can be ended. */
static tp_status write_in_place(int descriptor, const struct stat *state, const output *o) {
  sigset_t set;
  tp_status status = TP_OK;
  const bool regular = S_ISREG(state->st_mode);
  (regular ? set_of_ending : set_of_writing)(&set);
  const held signals = hold(&set);
  if (regular && o->length > 0 && fallocate(descriptor, 0, 0, (off_t)o->length) != 0 &&
      errno != EOPNOTSUPP && errno != ENOSYS) {
    status = fail(o, errno);
  }
  if (status == TP_OK && regular && !is_standard(state)) status = ask(o);
  if (status == TP_OK) status = write_all(descriptor, o);
  if (status == TP_OK && regular && ftruncate(descriptor, (off_t)o->length) != 0) {
    status = fail(o, errno);
  }
  release(&signals);
  return status;
}

int tp_file_create_beside(char **name, const char *path) {
  enum { TRIES = 1000 };
  const char *slash = strrchr(path, '/');
  const int folder = slash != NULL ? (int)(slash - path) + 1 : 0;
  int descriptor = -1;
  for (int k = 0; k < TRIES && descriptor < 0; k++) {
    if (asprintf(name, "%.*s.topple-%ld-%d.part", folder, path, (long)getpid(), k) < 0) {
      *name = NULL;
      errno = ENOMEM;
      return -1;
    }
    descriptor = open(*name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) break;
    const int why = errno;
    free(*name);
    *name = NULL;
    errno = why;
    if (why != EEXIST) return -1;
  }
  return descriptor;
}

static bool keep_owner(int descriptor, const struct stat *state) {
  struct stat own;
  if (fstat(descriptor, &own) != 0) return false;
  if ((own.st_uid != state->st_uid || own.st_gid != state->st_gid) &&
      fchown(descriptor, state->st_uid, state->st_gid) != 0) {
    return false;
  }
  return fchmod(descriptor, state->st_mode & 07777) == 0;
}

/* The file at `path`, no link; `before` is what is there, or NULL. False: it cannot be done so. */
static bool replace(tp_status *status, const char *path, const struct stat *before,
                    const output *o) {
  char *name = NULL;
  const int descriptor = tp_file_create_beside(&name, path);
  const int why = errno;
  if (descriptor < 0 && before != NULL && (why == EACCES || why == EPERM || why == EROFS)) {
    return false;
  }
  if (descriptor < 0) {
    *status = fail(o, why);
    return true;
  }
  const bool kept = before == NULL || keep_owner(descriptor, before);
  *status = kept ? write_all(descriptor, o) : TP_OK;
  /* some file systems tell of a full disk only now */
  const bool closed = close(descriptor) == 0;
  if (kept && *status == TP_OK && !closed) *status = fail(o, errno);
  if (kept && *status == TP_OK) *status = ask(o);
  if (kept && *status == TP_OK && rename(name, path) != 0) *status = fail(o, errno);
  if (!kept || *status != TP_OK) unlink(name);
  free(name);
  return kept;
}

static bool replace_at_once(tp_status *status, const char *path, const struct stat *before,
                            const output *o) {
  sigset_t ending;
  set_of_ending(&ending);
  const held signals = hold(&ending);
  const bool done = replace(status, path, before, o);
  release(&signals);
  return done;
}

/* ---- what is there -----------------------------------------------------------------------------
 */

static tp_status check_sources(const output *o, tp_file_sources sources) {
  struct stat own, other;
  if (stat(o->path, &own) != 0 || !S_ISREG(own.st_mode)) return TP_OK;
  for (size_t k = 0; k < sources.count; k++) {
    if (stat(sources.paths[k], &other) != 0 || !is_same(&own, &other)) continue;
    return tp_refuse(
        o->message, TP_FAULT_ARGUMENT, (tp_place){o->path, 0, 0},
        "this is a file that is read here ('%.300s') and would be lost; write to another "
        "name",
        sources.paths[k]);
  }
  return TP_OK;
}

static tp_status write_over(int descriptor, const output *o) {
  struct stat before;
  if (fstat(descriptor, &before) != 0) return fail(o, errno);
  if (!S_ISREG(before.st_mode) || before.st_nlink > 1 || is_standard(&before)) {
    return write_in_place(descriptor, &before, o);
  }
  char *real = realpath(o->path, NULL);
  if (real == NULL) return fail(o, errno);
  tp_status status = TP_OK;
  if (!replace_at_once(&status, real, &before, o)) {
    status = write_in_place(descriptor, &before, o);
  }
  free(real);
  return status;
}

/* There is no file; a link may be there. */
static tp_status check_new(const output *o) {
  struct stat link;
  return lstat(o->path, &link) == 0 ? fail_as(o, "it is a link that leads nowhere") : TP_OK;
}

static tp_status write_new(const output *o) {
  tp_status status = check_new(o);
  if (status != TP_OK) return status;
  (void)replace_at_once(&status, o->path, NULL, o);
  return status;
}

tp_status tp_file_write(const char *path, const char *bytes, size_t length, tp_file_sources sources,
                        tp_message *message) {
  return tp_file_write_if(path, bytes, length, sources, (tp_figure_consent){0}, message);
}

tp_status tp_file_write_if(const char *path, const char *bytes, size_t length,
                           tp_file_sources sources, tp_figure_consent consent,
                           tp_message *message) {
  const output o = {path, bytes, length, consent, message};
  tp_status status = check_sources(&o, sources);
  if (status != TP_OK) return status;
  const int descriptor = open(path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return errno == ENOENT ? write_new(&o) : fail(&o, errno);
  status = write_over(descriptor, &o);
  if (close(descriptor) != 0 && status == TP_OK) status = fail(&o, errno);
  return status;
}

tp_status tp_file_open_to_add(int *descriptor, const char *path, tp_message *message) {
  enum { HOW = O_WRONLY | O_CLOEXEC | O_NOCTTY };
  const output o = {.path = path, .message = message};
  int own = open(path, HOW);
  if (own < 0 && errno == ENOENT) {
    const tp_status status = check_new(&o);
    if (status != TP_OK) return status;
    own = open(path, HOW | O_CREAT | O_EXCL, 0666);
  }
  if (own < 0) return fail(&o, errno);
  *descriptor = own;
  return TP_OK;
}
