/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A boulder of a million triangles, from its file to its poses and its rose.
 *
 *     bench_solid [RINGS]
 *
 * Measured: a rough ball of 2 RINGS meridians is written as a binary STL; each part of the way is
 * timed on it once, and the whole by tp_solid_of_file with its peak memory before all else. Seconds
 * are those that the thread computed. */

#include "bench.h"

#include "solid/gate.h"
#include "solid/hull_facets.h"
#include "solid/solid_sums.h"

#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { RINGS = 500, LEAST_RINGS = 4, HEAD = 80 };

/* Half axes of 1, roughened by waves of falling height. */
static void set_point(float at[3], long rings, long ring, long meridian) {
  static const double pi = 3.14159265358979323846;
  const double polar = pi * (double)ring / (double)rings;
  const double turn = pi * (double)meridian / (double)rings;
  const double x = sin(polar) * cos(turn), y = sin(polar) * sin(turn), z = cos(polar);
  double radius = 1;
  for (int k = 1; k <= 6; k++) {
    const double wave = pow(1.8, k);
    radius += 0.05 * pow(0.6, k) * sin(wave * (x + 0.7 * y * k) + wave * z + k);
  }
  const bool pole = ring == 0 || ring == rings;
  at[0] = (float)(pole ? 0 : radius * x);
  at[1] = (float)(pole ? 0 : radius * y);
  at[2] = (float)(radius * z);
}

static void write_triangle(FILE *out, long rings, const long corners[3][2]) {
  const float normal[3] = {0};
  const uint16_t rest = 0;
  fwrite(normal, sizeof normal, 1, out);
  for (int c = 0; c < 3; c++) {
    float at[3];
    set_point(at, rings, corners[c][0], corners[c][1] % (2 * rings));
    fwrite(at, sizeof at, 1, out);
  }
  fwrite(&rest, sizeof rest, 1, out);
}

/* 4 RINGS (RINGS - 1) triangles. */
static bool write_stl(const char *path, long rings) {
  FILE *out = fopen(path, "wb");
  if (out == NULL) return false;
  const char head[HEAD] = "made by bench_solid";
  const uint32_t count = (uint32_t)(4 * rings * (rings - 1));
  fwrite(head, sizeof head, 1, out);
  fwrite(&count, sizeof count, 1, out);
  for (long m = 0; m < 2 * rings; m++) {
    for (long r = 0; r < rings; r++) {
      const long upper[3][2] = {{r, m}, {r + 1, m}, {r + 1, m + 1}};
      const long lower[3][2] = {{r, m}, {r + 1, m + 1}, {r, m + 1}};
      if (r + 1 < rings) write_triangle(out, rings, upper);
      if (r > 0) write_triangle(out, rings, lower);
    }
  }
  const bool done = ferror(out) == 0;
  return fclose(out) == 0 && done;
}

static double lap(const char *what, double since, long triangles) {
  const double now = bench_computed();
  printf("%-28s %8.3f s %8.1f ns a triangle\n", what, now - since,
         1e9 * (now - since) / (double)triangles);
  return bench_computed();
}

static tp_status time_parts(const char *path, tp_message *message) {
  tp_mesh mesh = {0};
  tp_surface surface = {0};
  tp_hull_facets facets = {0};
  double since = bench_computed();
  tp_status status = tp_mesh_read(&mesh, path, message);
  const long count = mesh.face_count;
  since = lap("read", since, count);
  if (status == TP_OK) status = tp_surface_init(&surface, &mesh, -1, message);
  since = lap("whole numbers", since, count);
  if (status == TP_OK) status = tp_gate_areas(&surface, message);
  since = lap("areas", since, count);
  if (status == TP_OK) status = tp_gate_edges(&surface, message);
  since = lap("edges, pieces", since, count);
  if (status == TP_OK) status = tp_gate_clashes(&surface, message);
  since = lap("triangles that meet", since, count);
  if (status == TP_OK) status = tp_hull_facets_init(&facets, &surface, message);
  since = lap("hull, facets", since, count);
  if (status == TP_OK) {
    tp_near near[TP_SOLID_SUM_COUNT];
    fmpz exact[TP_SOLID_SUM_COUNT];
    fmpz_t multiple;
    fmpz_init(multiple);
    for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_init(exact + k);
    tp_solid_sums_near(near, &surface);
    since = lap("moments in doubles", since, count);
    tp_solid_sums_exact(exact, multiple, &surface);
    (void)lap("moments in whole numbers", since, count);
    for (int k = 0; k < TP_SOLID_SUM_COUNT; k++) fmpz_clear(exact + k);
    fmpz_clear(multiple);
  }
  tp_hull_facets_clear(&facets);
  tp_surface_clear(&surface);
  tp_mesh_clear(&mesh);
  return status;
}

static tp_status time_whole(const char *path, tp_message *message) {
  const tp_solid_options options = tp_solid_options_default();
  tp_solid *solid = NULL;
  const double since = bench_computed();
  const tp_status status = tp_solid_of_file(&solid, path, &options, message);
  if (status == TP_OK) {
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    (void)lap("tp_solid_of_file", since, (long)solid->triangles);
    printf("%-28s %8.0f MB, %zu triangles, %zu facets, %zu poses\n", "peak memory",
           (double)used.ru_maxrss / 1024, solid->triangles, solid->facets, solid->pose_count);
  }
  tp_solid_free(solid);
  return status;
}

int main(int argc, char **argv) {
  const long rings = argc > 1 ? bench_count(argv[1], LEAST_RINGS) : RINGS;
  char folder[] = "/tmp/bench_solid_XXXXXX", path[sizeof folder + 16];
  tp_message message = {.text = ""};
  if (rings == 0 || mkdtemp(folder) == NULL) {
    fprintf(stderr, "usage: bench_solid [RINGS]\n");
    return BENCH_FAILED;
  }
  snprintf(path, sizeof path, "%s/rock.stl", folder);
  tp_status status = TP_SYSTEM_FAILED;
  if (write_stl(path, rings)) status = time_whole(path, &message);
  if (status == TP_OK) status = time_parts(path, &message);
  if (status != TP_OK) fprintf(stderr, "bench_solid: %s\n", message.text);
  unlink(path);
  rmdir(folder);
  return status == TP_OK ? 0 : BENCH_FAILED;
}
