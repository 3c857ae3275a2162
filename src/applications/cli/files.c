/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finds the folder of examples beside the program or as installed, reads files of at most 64 MiB,
 * and creates files without replacing others. */

#define _GNU_SOURCE
#include "cli/files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_BYTES = 64 << 20 };

static tp_status fail(tp_message *message, tp_status status, const char *what, const char *path,
                      const char *why) {
  char plain[400];
  tp_plain_text(plain, sizeof plain, path);
  snprintf(message->text, sizeof message->text, "%s %s: %s", what, plain, why);
  return status;
}

static bool is_folder(const char *path) {
  struct stat own;
  return stat(path, &own) == 0 && S_ISDIR(own.st_mode);
}

bool tp_cli_examples_folder(char folder[PATH_MAX]) {
  static const char *const relative[] = {TP_DATA_FROM_PROGRAM "/topple/examples",
                                         TP_SOURCE_FROM_BUILD "/examples"};
  char program[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  if (length > 0) {
    program[length] = '\0';
    program[tp_cli_folder_length(program)] = '\0';
    for (size_t k = 0; k < sizeof relative / sizeof relative[0]; k++) {
      const int written = snprintf(folder, PATH_MAX, "%s%s", program, relative[k]);
      if (written < PATH_MAX && is_folder(folder)) return true;
    }
  }
  snprintf(folder, PATH_MAX, "%s/topple/examples", TP_DATA_FOLDER);
  return is_folder(folder);
}

bool tp_cli_join(char path[PATH_MAX], const char *folder, const char *name) {
  if (strlen(folder) + strlen(name) + 2 > PATH_MAX) return false;
  stpcpy(stpcpy(stpcpy(path, folder), "/"), name);
  return true;
}

size_t tp_cli_folder_length(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash != NULL ? (size_t)(slash + 1 - path) : 0;
}

/* ---- reading -----------------------------------------------------------------------------------
 */

static tp_status read_open(char **text, size_t *length, FILE *file, const char *path,
                           tp_message *message) {
  struct stat own;
  if (fstat(fileno(file), &own) != 0 || !S_ISREG(own.st_mode)) {
    return fail(message, TP_SYSTEM_FAILED, "cannot read", path, "it is not a file");
  }
  if (own.st_size > MOST_BYTES) {
    return fail(message, TP_BAD_INPUT, "cannot read", path, "it has more than 64 MB");
  }
  char *bytes = malloc((size_t)own.st_size + 1);
  if (bytes == NULL) return TP_OUT_OF_MEMORY;
  const size_t got = fread(bytes, 1, (size_t)own.st_size, file);
  if (ferror(file) != 0) {
    free(bytes);
    return fail(message, TP_SYSTEM_FAILED, "cannot read", path, strerror(errno));
  }
  bytes[got] = '\0';
  *text = bytes;
  *length = got;
  return TP_OK;
}

tp_status tp_cli_read_file(char **text, size_t *length, const char *path, tp_message *message) {
  struct stat state; /* a pipe would keep the open waiting */
  const bool other = stat(path, &state) == 0 && !S_ISREG(state.st_mode);
  FILE *file = other ? NULL : fopen(path, "rbe");
  if (other) return fail(message, TP_SYSTEM_FAILED, "cannot read", path, "it is not a file");
  if (file == NULL) return fail(message, TP_SYSTEM_FAILED, "cannot open", path, strerror(errno));
  const tp_status status = read_open(text, length, file, path, message);
  (void)fclose(file);
  return status;
}

/* ---- writing -----------------------------------------------------------------------------------
 */

static bool has_bytes(const char *path, const char *bytes, size_t length) {
  char *text = NULL;
  size_t own = 0;
  tp_message ignored = {.text = ""};
  const bool same = tp_cli_read_file(&text, &own, path, &ignored) == TP_OK && own == length &&
                    memcmp(text, bytes, length) == 0;
  free(text);
  return same;
}

tp_status tp_cli_may_create(const char *path, const char *bytes, size_t length, bool same_will_do,
                            tp_message *message) {
  struct stat own;
  if (lstat(path, &own) != 0) return TP_OK;
  if (same_will_do && has_bytes(path, bytes, length)) return TP_OK;
  return fail(message, TP_BAD_INPUT, "will not overwrite", path,
              "it already exists; remove it, or write another one with -o FILE");
}

static tp_status make_folders(const char *path, tp_message *message) {
  char folder[PATH_MAX];
  if (strlen(path) >= sizeof folder) {
    return fail(message, TP_BAD_INPUT, "cannot write", path, strerror(ENAMETOOLONG));
  }
  for (const char *slash = strchr(path + 1, '/'); *path != '\0' && slash != NULL;
       slash = strchr(slash + 1, '/')) {
    memcpy(folder, path, (size_t)(slash - path));
    folder[slash - path] = '\0';
    if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
      return fail(message, TP_SYSTEM_FAILED, "cannot make the folder", folder, strerror(errno));
    }
  }
  return TP_OK;
}

static bool write_all(int file, const char *bytes, size_t length) {
  while (length > 0) {
    const ssize_t written = write(file, bytes, length);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes += written;
    length -= (size_t)written;
  }
  return true;
}

tp_status tp_cli_create_file(const char *path, const char *bytes, size_t length, bool same_will_do,
                             bool *created, tp_message *message) {
  tp_status status = tp_cli_may_create(path, bytes, length, same_will_do, message);
  if (status == TP_OK) status = make_folders(path, message);
  if (status != TP_OK) return status;
  if (same_will_do && access(path, F_OK) == 0) return TP_OK;
  const int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return fail(message, TP_SYSTEM_FAILED, "cannot write", path, strerror(errno));
  const bool whole = write_all(file, bytes, length);
  const int why = errno;
  if (close(file) == 0 && whole) {
    *created = true;
    return TP_OK;
  }
  (void)unlink(path);
  return fail(message, TP_SYSTEM_FAILED, "cannot write", path, strerror(whole ? errno : why));
}
