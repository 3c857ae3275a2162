/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An outline of a million vertices from file to verdict, part by part.
 *
 *     bench_million [VERTICES]
 *
 * Measured: a rough profile with four-decimal coordinates in mm is written to a temporary CSV file
 * with a scene that names it; then each part of the way is timed on it, in turn, medians of 5.
 * Times are of computing (this thread), which other programs on the machine disturb less. To be
 * read: `read and solve` is the whole way. What it takes beyond the parts above it goes into the
 * pivots, the sliding and the higher rungs of the ladder; exact moments and the triangulation are
 * parts that this scene does not call for. The lattice holds the vertices of the outline and again
 * those of the mated base; all times are per vertex of the outline. The peak memory is that of one
 * reading and solving, before anything else has run. */

#include "bench.h"

#include "accuracy/rough_outline.h"

#include "base/contact.h"
#include "block/check.h"
#include "block/moments.h"
#include "scene_reading/csv.h"

#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { ROUNDS = 5, PATH_SIZE = 512, LEAST_VERTICES = 100 };

/* What the parts work on (kept) and what they make (dropped after each run). */
typedef struct work {
  long count;
  char folder[PATH_SIZE], csv[PATH_SIZE + 16], yaml[PATH_SIZE + 16];
  tp_scene *scene;
  tp_section section;
  tp_base base;
  tp_lattice lattice;
  struct {
    tp_polyline line;
    tp_scene *scene;
    tp_section section;
    tp_base base;
    tp_lattice lattice;
    tp_geom_triangulation triangulation;
    tp_contact contact;
    tp_solution *solution;
  } made;
  tp_message message;
} work;

static tp_status read_csv(work *w) {
  tp_notes notes = {0};
  const char *unit = NULL;
  const tp_status status = tp_csv_read(&w->made.line, &unit, w->csv, true, &notes, &w->message);
  tp_notes_clear(&notes);
  return status;
}

static tp_status make_section(work *w) {
  tp_status status = tp_section_init(&w->made.section, &w->scene->block, &w->message);
  if (status == TP_OK)
    status = tp_base_init(&w->made.base, w->scene, &w->made.section, &w->message);
  return status;
}

static tp_status make_lattice(work *w) {
  const tp_polyline *chains[] = {w->section.rings, &w->base.ring, &w->section.element_corners};
  return tp_lattice_init(&w->made.lattice, chains, 3, w->scene->metres_per_unit, &w->message);
}

static tp_status check_section(work *w) {
  return tp_check_section(&w->made.triangulation, &w->section, &w->lattice, &w->message);
}

static tp_status find_contact(work *w) {
  return tp_contact_init(&w->made.contact, &w->section, NULL, &w->base, &w->lattice, &w->message);
}

static tp_status evaluate_moments(work *w, tp_rung rung) {
  tp_moments moments;
  tp_moments_init(&moments);
  tp_moments_evaluate(&moments, &w->section, &w->lattice, w->scene->metres_per_unit, rung,
                      TP_SUM_COUNT);
  tp_moments_clear(&moments);
  return TP_OK;
}

static tp_status moments_in_double(work *w) {
  return evaluate_moments(w, (tp_rung){TP_LEVEL_DOUBLE, 80});
}

static tp_status moments_exactly(work *w) {
  return evaluate_moments(w, (tp_rung){TP_LEVEL_EXACT, 320});
}

static tp_status triangulate(work *w) {
  return tp_check_triangulate(&w->made.triangulation, &w->section, &w->lattice, &w->message);
}

static tp_status read_scene(work *w) {
  return tp_scene_read(&w->made.scene, w->yaml, &w->message);
}

static tp_status solve_with(work *w, tp_pivots_listed pivots) {
  tp_solve_options options = tp_solve_options_default();
  options.pivots = pivots;
  const tp_status status = read_scene(w);
  if (status != TP_OK) return status;
  return tp_solve(&w->made.solution, w->made.scene, &options, &w->message);
}

/* As the program does it, and with the numbers of a million pivots. */
static tp_status read_and_solve(work *w) {
  return solve_with(w, TP_PIVOTS_BY_COUNT);
}

static tp_status read_and_solve_all_pivots(work *w) {
  return solve_with(w, TP_PIVOTS_ALL);
}

typedef struct part {
  const char *name;
  tp_status (*run)(work *w);
} part;

static const part parts[] = {
    {"read CSV", read_csv},
    {"section and base", make_section},
    {"lattice", make_lattice},
    {"check outline", check_section},
    {"contact", find_contact},
    {"moments, double", moments_in_double},
    {"moments, exact", moments_exactly},
    {"triangulate", triangulate},
    {"tp_scene_read", read_scene},
    {"read and solve", read_and_solve},
    {"... all pivots", read_and_solve_all_pivots},
};
enum { PARTS = sizeof parts / sizeof parts[0] };

static void drop_made(work *w) {
  tp_polyline_clear(&w->made.line);
  tp_section_clear(&w->made.section);
  tp_base_clear(&w->made.base);
  tp_lattice_clear(&w->made.lattice);
  tp_geom_triangulation_clear(&w->made.triangulation);
  tp_contact_clear(&w->made.contact);
  tp_solution_free(w->made.solution);
  tp_scene_free(w->made.scene);
  memset(&w->made, 0, sizeof w->made);
}

/* Build what the later parts start from. */
static tp_status keep_inputs(work *w) {
  tp_status status = tp_scene_read(&w->scene, w->yaml, &w->message);
  if (status == TP_OK) status = make_section(w);
  if (status != TP_OK) return status;
  w->section = w->made.section;
  w->base = w->made.base;
  memset(&w->made, 0, sizeof w->made);
  status = make_lattice(w);
  w->lattice = w->made.lattice;
  memset(&w->made, 0, sizeof w->made);
  return status;
}

static void drop_inputs(work *w) {
  tp_lattice_clear(&w->lattice);
  tp_base_clear(&w->base);
  tp_section_clear(&w->section);
  tp_scene_free(w->scene);
}

static void print_table(double seconds[PARTS][ROUNDS], long count) {
  printf("%-18s %10s %10s\n", "part", "ms", "ns/vertex");
  for (int p = 0; p < PARTS; p++) {
    const double median = gsl_stats_median(seconds[p], 1, ROUNDS);
    printf("%-18s %10.2f %10.1f\n", parts[p].name, 1e3 * median, 1e9 * median / (double)count);
  }
}

static tp_status time_parts(work *w, double seconds[PARTS][ROUNDS]) {
  tp_status status = keep_inputs(w);
  for (int round = 0; round < ROUNDS && status == TP_OK; round++) {
    for (int p = 0; p < PARTS && status == TP_OK; p++) {
      const double began = bench_computed();
      status = parts[p].run(w);
      seconds[p][round] = bench_computed() - began;
      drop_made(w);
    }
  }
  drop_inputs(w);
  return status;
}

static tp_status measure(work *w) {
  double seconds[PARTS][ROUNDS];
  struct rusage usage = {0};
  tp_status status = read_and_solve(w);
  getrusage(RUSAGE_SELF, &usage);
  drop_made(w);
  if (status == TP_OK) status = time_parts(w, seconds);
  if (status != TP_OK) {
    fprintf(stderr, "%s\n", w->message.text);
    return status;
  }
  print_table(seconds, w->count);
  printf("%ld vertices; goal of read and solve for a million: 3000 ms\n", w->count);
  printf("peak memory of one reading and solving: %.0f MB; goal for a million: 500 MB\n",
         (double)usage.ru_maxrss * 1024e-6);
  return TP_OK;
}

/* Write the outline; false, with a message, where that fails. */
static bool write_csv(const work *w) {
  FILE *file = fopen(w->csv, "w");
  double *x = calloc((size_t)w->count, sizeof *x), *y = calloc((size_t)w->count, sizeof *y);
  bool done = file != NULL && x != NULL && y != NULL;
  if (done) {
    tp_rough_outline(x, y, w->count);
    fprintf(file, "x,y\n");
    for (long k = 0; k < w->count; k++) fprintf(file, "%.4f,%.4f\n", x[k] / 1e4, y[k] / 1e4);
    done = ferror(file) == 0;
  }
  if (file != NULL && fclose(file) != 0) done = false;
  free(x);
  free(y);
  if (!done) fprintf(stderr, "%s cannot be written\n", w->csv);
  return done;
}

static bool write_scene(const work *w) {
  FILE *file = fopen(w->yaml, "w");
  bool done = file != NULL && fputs("topple: 1\n"
                                    "length_unit: mm\n"
                                    "block: {outline: outline.csv, unit_weight_kn_m3: 26}\n"
                                    "base: {mated: true}\n"
                                    "friction_angle_deg: 30\n"
                                    "tilt: {towards: both, angle_deg: 20}\n",
                                    file) >= 0;
  if (file != NULL && fclose(file) != 0) done = false;
  if (!done) fprintf(stderr, "%s cannot be written\n", w->yaml);
  return done;
}

static bool make_folder(work *w) {
  const char *parent = getenv("TMPDIR");
  if (parent == NULL || *parent == '\0') parent = "/tmp";
  const int length = snprintf(w->folder, sizeof w->folder, "%s/topple-bench-XXXXXX", parent);
  if (length >= PATH_SIZE || mkdtemp(w->folder) == NULL) {
    fprintf(stderr, "no temporary folder can be made in %s\n", parent);
    return false;
  }
  snprintf(w->csv, sizeof w->csv, "%s/outline.csv", w->folder);
  snprintf(w->yaml, sizeof w->yaml, "%s/scene.yaml", w->folder);
  return true;
}

int main(int argc, char **argv) {
  work w = {.count = argc > 1 ? bench_count(argv[1], LEAST_VERTICES) : 1000000};
  if (argc > 2 || w.count == 0) {
    fprintf(stderr, "usage: bench_million [VERTICES, at least %d]\n", LEAST_VERTICES);
    return 2;
  }
  if (!make_folder(&w)) return BENCH_FAILED;
  const bool done = write_csv(&w) && write_scene(&w) && measure(&w) == TP_OK;
  unlink(w.csv);
  unlink(w.yaml);
  rmdir(w.folder);
  flint_cleanup();
  return done ? 0 : BENCH_FAILED;
}
