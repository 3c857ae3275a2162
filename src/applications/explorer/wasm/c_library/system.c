/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls of Linux that a page in a browser has no answer to: they fail as on a system that lacks
 * them, and the program says what it cannot do. */

#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <spawn.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/socket.h>

static int refuse(void) {
  errno = ENOSYS;
  return -1;
}

/* The number of processors is asked for elsewhere, and is one. */
int sched_getaffinity(pid_t process, size_t size, cpu_set_t *set) {
  (void)process, (void)size, (void)set;
  return refuse();
}

int __sched_cpucount(size_t size, const cpu_set_t *set) {
  (void)size, (void)set;
  return 1;
}

int prctl(int option, ...) {
  (void)option;
  return refuse();
}

int posix_spawnp(pid_t *restrict process, const char *restrict file,
                 const posix_spawn_file_actions_t *actions,
                 const posix_spawnattr_t *restrict attributes, char *const argv[restrict],
                 char *const environment[restrict]) {
  (void)process, (void)file, (void)actions, (void)attributes, (void)argv, (void)environment;
  return ENOSYS;
}

int inotify_init1(int flags) {
  (void)flags;
  return refuse();
}

int inotify_add_watch(int notifier, const char *path, uint32_t events) {
  (void)notifier, (void)path, (void)events;
  return refuse();
}

int fallocate(int file, int mode, off_t offset, off_t length) {
  (void)file, (void)mode, (void)offset, (void)length;
  return refuse();
}

/* emscripten's own would open connections to servers. */
int socketpair(int domain, int type, int protocol, int sockets[2]) {
  (void)domain, (void)type, (void)protocol, (void)sockets;
  return refuse();
}

ssize_t send(int socket, const void *bytes, size_t count, int flags) {
  (void)socket, (void)bytes, (void)count, (void)flags;
  return refuse();
}

ssize_t recv(int socket, void *bytes, size_t count, int flags) {
  (void)socket, (void)bytes, (void)count, (void)flags;
  return refuse();
}

int shutdown(int socket, int how) {
  (void)socket, (void)how;
  return refuse();
}

/* No library is loaded beside the one file of the page, and emscripten's own calls would end the
 * program: the linker puts these in their place. */
void *__wrap_dlopen(const char *path, int mode) {
  (void)path, (void)mode;
  return NULL;
}

void *__wrap_dlsym(void *restrict library, const char *restrict name) {
  (void)library, (void)name;
  return NULL;
}

char *__wrap_dlerror(void) {
  static char why[] = "a page loads no libraries";
  return why;
}
