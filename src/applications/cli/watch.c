/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A hash of the states of all files named (FNV-1a of sizes and times), compared after events of
 * inotify and once a second. */

#include "cli/watch.h"

#include "cli/example_list.h"
#include "cli/files.h"
#include "cli/signals.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LOOK_MS = 1000, SETTLE_MS = 40, AWAY_MS = 300 };

/* What tells one state of the files from another: their number, times, sizes, and which they are.
 */
typedef struct state {
  unsigned long long sum;
  bool all_there;
} state;

static void mix(state *own, unsigned long long number) {
  own->sum = (own->sum ^ number) * 1099511628211ULL;
}

static void mix_file(state *own, const char *path) {
  struct stat file;
  if (stat(path, &file) != 0) {
    mix(own, 1);
    own->all_there = false;
    return;
  }
  mix(own, (unsigned long long)file.st_ino);
  mix(own, (unsigned long long)file.st_size);
  mix(own, (unsigned long long)file.st_mtim.tv_sec);
  mix(own, (unsigned long long)file.st_mtim.tv_nsec);
}

/* The scene by its folder and its name in it. */
typedef struct watched {
  char folder[PATH_MAX];
  const char *name;
  int events; /* of inotify */
} watched;

static bool path_of(char path[PATH_MAX], const watched *own, const char *name) {
  if (name[0] != '/') return tp_cli_join(path, own->folder, name);
  if (strlen(name) >= PATH_MAX) return false;
  strcpy(path, name);
  return true;
}

static void watch_folder(const watched *own, char path[PATH_MAX]) {
  path[tp_cli_folder_length(path)] = '\0';
  (void)inotify_add_watch(own->events, path,
                          IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE |
                              IN_MODIFY);
}

/* The state of the scene and of all files that it names now; their folders are watched from here
 * on. A scene that cannot be read is a state of its own. */
static state look(const watched *own) {
  state now = {.sum = 14695981039346656037ULL, .all_there = true};
  tp_cli_file_group group;
  tp_message ignored = {.text = ""};
  char path[PATH_MAX];
  if (path_of(path, own, own->name)) {
    mix_file(&now, path);
    watch_folder(own, path);
  }
  if (tp_cli_file_group_init(&group, own->folder, own->name, TP_CLI_ANYWHERE, &ignored) != TP_OK) {
    return now;
  }
  for (size_t k = 1; k < group.count; k++) {
    if (!path_of(path, own, group.paths[k])) continue;
    mix_file(&now, path);
    watch_folder(own, path);
  }
  tp_cli_file_group_free(&group);
  return now;
}

/* Whatever happened is read away; true: something did within so many milliseconds. */
static bool wait_for_event(const watched *own, int milliseconds) {
  struct pollfd waited = {.fd = own->events, .events = POLLIN};
  char events[4096];
  if (poll(&waited, 1, milliseconds) <= 0) return false;
  return read(own->events, events, sizeof events) > 0;
}

/* Until the state is another one, and stays so; false: a signal came. */
static bool wait_for_change(const watched *own, state *before) {
  while (!tp_cli_is_interrupted(NULL)) {
    (void)wait_for_event(own, LOOK_MS);
    if (look(own).sum == before->sum) continue;
    while (!tp_cli_is_interrupted(NULL) && wait_for_event(own, SETTLE_MS)) continue;
    state now = look(own);
    /* an editor that puts a new file in place of the old one is given a moment */
    if (!now.all_there && before->all_there) (void)wait_for_event(own, AWAY_MS);
    now = look(own);
    if (now.sum == before->sum) continue;
    *before = now;
    return !tp_cli_is_interrupted(NULL);
  }
  return false;
}

static bool find_folder(watched *own, const char *scene) {
  const size_t length = tp_cli_folder_length(scene);
  if (length >= PATH_MAX) return false;
  strcpy(own->folder, ".");
  if (length > 0) {
    memcpy(own->folder, scene, length);
    own->folder[length] = '\0';
  }
  own->name = scene + length;
  return true;
}

tp_status tp_cli_watch(const char *scene, tp_cli_again *again, void *context, tp_message *message) {
  watched own;
  if (!find_folder(&own, scene)) {
    snprintf(message->text, sizeof message->text, "the name of the scene is too long");
    return TP_BAD_INPUT;
  }
  own.events = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (own.events < 0) {
    snprintf(message->text, sizeof message->text, "files cannot be watched: %s", strerror(errno));
    return TP_SYSTEM_FAILED;
  }
  tp_cli_catch_signals();
  state seen = look(&own);
  while (again(context) && wait_for_change(&own, &seen)) continue;
  (void)close(own.events);
  return TP_OK;
}
