/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "study_folder.h"

#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[100];

static void remove_folder(void) {
  char path[200];
  DIR *files = opendir(folder);
  const struct dirent *file = NULL;
  while (files != NULL && (file = readdir(files)) != NULL) {
    if (file->d_name[0] != '.') unlink(fuzz_study_path(path, file->d_name));
  }
  if (files != NULL) closedir(files);
  rmdir(folder);
}

/* In memory where there is such a file system. */
static void make_folder(void) {
  static const char *const scene =
      "topple: 1\nlength_unit: m\nparameters: {h: 2}\nblock: {slab: {width: 2, height: h}, "
      "unit_weight_kn_m3: 25}\nbase: {mated: true}\nfriction_angle_deg: 30\n"
      "loads: {seismic: {horizontal: 0.05}}\ntilt: {towards: left, angle_deg: 25}\n";
  static const char *const table = "phi,h\n30,1\n25.5,2\n33,4\n";
  snprintf(folder, sizeof folder, "%s/topple-fuzz-XXXXXX",
           access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp");
  FUZZ_EXPECT(mkdtemp(folder) != NULL);
  FUZZ_EXPECT(atexit(remove_folder) == 0);
  fuzz_study_write("slab.yaml", scene, strlen(scene));
  fuzz_study_write("table.csv", table, strlen(table));
}

const char *fuzz_study_path(char path[200], const char *name) {
  if (folder[0] == '\0') make_folder();
  snprintf(path, 200, "%.90s/%.100s", folder, name);
  return path;
}

void fuzz_study_write(const char *name, const char *text, size_t length) {
  char path[200];
  FILE *file = fopen(fuzz_study_path(path, name), "wb");
  FUZZ_EXPECT(file != NULL);
  FUZZ_EXPECT(fwrite(text, 1, length, file) == length);
  FUZZ_EXPECT(fclose(file) == 0);
}
