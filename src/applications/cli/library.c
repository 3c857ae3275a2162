/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Path of the running program by /proc/self/exe, a check of the library's owner and mode, dlopen,
 * and a check of its version. */

#include "cli/library.h"

#include "topple_basics.h"

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

static void *load(const char *name) {
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

/* The library of figures, which is public, has a name of its own for it. */
static bool fits(void *library, tp_cli_why *why) {
  static const char *const names[] = {"tp_module_version", "tp_figure_version"};
  const char *(*version)(void) = NULL;
  for (size_t k = 0; k < sizeof names / sizeof names[0] && version == NULL; k++) {
    *(void **)&version = dlsym(library, names[k]);
  }
  const char *own = version != NULL ? version() : "unknown";
  if (strcmp(own, TP_VERSION) == 0) return true;
  snprintf(why->text, sizeof why->text,
           "its version is %.40s, and that of this program " TP_VERSION
           ": install both of the same version",
           own);
  return false;
}

void *tp_cli_load_call(const char *library, const char *call, tp_cli_why *why) {
  void *loaded = load(library);
  if (loaded != NULL && !fits(loaded, why)) return NULL;
  void *found = loaded != NULL ? dlsym(loaded, call) : NULL;
  if (found != NULL) return found;
  const char *reason = dlerror();
  snprintf(why->text, sizeof why->text, "%s", reason != NULL ? reason : "no reason is given");
  return NULL;
}
