/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A harness without libFuzzer: runs on every file of a folder, in a child, so that a crash is
 * counted and the rest goes on. */

#include "fuzz.h"

#include <dirent.h>
#include <flint/flint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

static void run_file(const char *path) {
  FILE *file = fopen(path, "rb");
  uint8_t *data = malloc(1 << 20);
  FUZZ_EXPECT(file != NULL && data != NULL);
  const size_t size = fread(data, 1, 1 << 20, file);
  FUZZ_EXPECT(feof(file));
  fclose(file);
  (void)LLVMFuzzerTestOneInput(data, size);
  free(data);
}

static int is_input(const struct dirent *entry) {
  return entry->d_name[0] != '.';
}

/* From `*begun` on, counting up before each; ends the process. */
_Noreturn static void run_files(const char *folder, struct dirent **files, int count,
                                volatile int *begun) {
  char path[4096];
  while (*begun < count) {
    snprintf(path, sizeof path, "%s/%s", folder, files[(*begun)++]->d_name);
    run_file(path);
  }
  flint_cleanup();
  for (int k = 0; k < count; k++) free(files[k]);
  free(files);
  exit(0);
}

int main(int argc, char **argv) {
  struct dirent **files = NULL;
  const int count = argc == 2 ? scandir(argv[1], &files, is_input, alphasort) : -1;
  if (count <= 0) {
    fprintf(stderr, "usage: %s FOLDER with inputs in it\n", argv[0]);
    return 2;
  }
  volatile int *begun =
      mmap(NULL, sizeof *begun, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  FUZZ_EXPECT((void *)begun != MAP_FAILED);
  int failed = 0, ended = 1;
  /* a child that ends well has run all that were left */
  while (ended != 0 && failed <= count) {
    const pid_t child = fork();
    if (child == 0) run_files(argv[1], files, count, begun);
    FUZZ_EXPECT(child > 0 && waitpid(child, &ended, 0) == child);
    if (ended == 0) break;
    failed++;
    fprintf(stderr, "%s/%s: %s %d\n", argv[1], files[*begun > 0 ? *begun - 1 : 0]->d_name,
            WIFSIGNALED(ended) ? "signal" : "status",
            WIFSIGNALED(ended) ? WTERMSIG(ended) : WEXITSTATUS(ended));
  }
  for (int k = 0; k < count; k++) free(files[k]);
  free(files);
  printf("%d passed, %d failed\n", count - failed, failed);
  return failed > 0;
}
