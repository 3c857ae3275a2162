/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finds a library beside the running code or in the folder where it was to be installed, checks its
 * owner and mode, loads it by dlopen, and checks its version. */

#define _GNU_SOURCE /* dladdr */
#include "common/library_beside.h"

#include "topple_basics.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* What this code lies in: by the loader a library has its path, a program the name that it was
 * called by. */
static bool find_own(char path[PATH_MAX]) {
  static const char here = 0;
  Dl_info info;
  if (dladdr(&here, &info) != 0 && info.dli_fname != NULL && strchr(info.dli_fname, '/') != NULL &&
      realpath(info.dli_fname, path) != NULL) {
    return true;
  }
  const ssize_t length = readlink("/proc/self/exe", path, PATH_MAX - 1);
  path[length > 0 ? length : 0] = '\0';
  return length > 0;
}

/* Is it there, and of someone who could as well have replaced what this code lies in: its owner,
 * this user, or the system's? A folder such as /tmp may hold the files of others. */
static bool is_trusted(const char *path, const struct stat *beside) {
  struct stat own;
  if (stat(path, &own) != 0 || !S_ISREG(own.st_mode)) return false;
  const bool owner = own.st_uid == 0 || own.st_uid == geteuid() || own.st_uid == beside->st_uid;
  return owner && (own.st_mode & S_IWOTH) == 0;
}

static void *load(const char *name) {
  static const char *const relative[] = {"", TP_LIBRARY_FROM_PROGRAM "/"};
  char own[PATH_MAX], path[2 * PATH_MAX];
  struct stat beside;
  if (find_own(own) && stat(own, &beside) == 0) {
    own[strrchr(own, '/') + 1 - own] = '\0';
    for (size_t k = 0; k < sizeof relative / sizeof relative[0]; k++) {
      snprintf(path, sizeof path, "%s%s%s", own, relative[k], name);
      if (is_trusted(path, &beside)) return dlopen(path, RTLD_NOW | RTLD_LOCAL);
    }
  }
  snprintf(path, sizeof path, "%s/%s", TP_LIBRARY_FOLDER, name);
  return dlopen(path, RTLD_NOW | RTLD_LOCAL);
}

void *tp_library_beside(const char *name, tp_library_why *why) {
  void *library = load(name);
  if (library == NULL) {
    const char *reason = dlerror();
    snprintf(why->text, sizeof why->text, "%s", reason != NULL ? reason : "no reason is given");
    return NULL;
  }
  const char *(*version)(void) = NULL;
  *(void **)&version = dlsym(library, "tp_module_version");
  const char *own = version != NULL ? version() : "unknown";
  if (strcmp(own, TP_VERSION) == 0) return library;
  snprintf(why->text, sizeof why->text,
           "its version is %.40s, and that of what loads it " TP_VERSION
           ": install both of the same version",
           own);
  return NULL;
}
