/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Path of the running program by /proc/self/exe, a check of the library's owner and mode, and
 * dlopen. */

#include "cli/library.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Is it there, and of someone who could as well have replaced the program: its owner, this user, or
 * the system's? A folder such as /tmp may hold the files of others. */
static bool is_trusted(const char *path, const struct stat *program) {
  struct stat own;
  if (stat(path, &own) != 0 || !S_ISREG(own.st_mode)) return false;
  const bool owner = own.st_uid == 0 || own.st_uid == geteuid() || own.st_uid == program->st_uid;
  return owner && (own.st_mode & S_IWOTH) == 0;
}

void *tp_cli_load_library(const char *name) {
  static const char *const relative[] = {"", TP_LIBRARY_FROM_PROGRAM "/"};
  char folder[PATH_MAX], path[2 * PATH_MAX];
  struct stat program;
  const ssize_t length = readlink("/proc/self/exe", folder, sizeof folder - 1);
  char *slash = NULL;
  if (length > 0) {
    folder[length] = '\0';
    slash = strrchr(folder, '/');
  }
  if (slash != NULL && stat("/proc/self/exe", &program) == 0) {
    slash[1] = '\0';
    for (size_t k = 0; k < sizeof relative / sizeof relative[0]; k++) {
      snprintf(path, sizeof path, "%s%s%s", folder, relative[k], name);
      if (is_trusted(path, &program)) return dlopen(path, RTLD_NOW);
    }
  }
  snprintf(path, sizeof path, "%s/%s", TP_LIBRARY_FOLDER, name);
  return dlopen(path, RTLD_NOW);
}
