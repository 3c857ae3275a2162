/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a derivation costs: reading a toothed scene of N teeth, deriving the tangents of all its
 * pivots in a, b and c, and writing them; medians of 9. The row "family" is one formula for every N
 * with its proof. Where python3 has SymPy, the same tangent about the toe by SymPy stands beside
 * it. */

#include "bench.h"

#include "topple.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SAMPLES = 9 };

static void fail(const char *what) {
  fprintf(stderr, "bench_derive: %s\n", what);
  exit(5);
}

static tp_scene *read_teeth(int count) {
  char path[] = "/tmp/topple-bench-XXXXXX";
  const int handle = mkstemp(path);
  if (handle < 0) fail("no temporary file");
  FILE *file = fdopen(handle, "w");
  if (file == NULL) fail("no temporary file");
  fprintf(file,
          "topple: 1\nlength_unit: mm\nparameters: {a: 30, b: 120, c: 5}\nblock:\n  teeth: {count: "
          "%d, width: a, height: b, depth: c, left_end: valley}\ntilt: {towards: left}\n",
          count);
  fclose(file);
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_scene_read(&scene, path, &message);
  unlink(path);
  if (status != TP_OK) fail(message.text);
  return scene;
}

static void derive_once(const tp_scene *scene) {
  const tp_derive_options options = tp_derive_options_default();
  tp_derivation *derivation = NULL;
  tp_message message = {.text = ""};
  if (tp_derive(&derivation, scene, &options, &message) != TP_OK) fail(message.text);
  tp_derivation_free(derivation);
}

static void family_once(const tp_scene *scene) {
  tp_family *family = NULL;
  tp_message message = {.text = ""};
  if (tp_derive_family(&family, scene, TP_NOTATION_TEXT, &message) != TP_OK) fail(message.text);
  tp_family_free(family);
}

static double median_ms(const tp_scene *scene, void (*once)(const tp_scene *)) {
  double samples[SAMPLES];
  once(scene);
  for (int k = 0; k < SAMPLES; k++) {
    const double began = bench_now();
    once(scene);
    samples[k] = 1e3 * (bench_now() - began);
  }
  return gsl_stats_median(samples, 1, SAMPLES);
}

/* SymPy's time for the tangent about the toe of three teeth, measured by itself; skipped where it
 * is not installed. */
static void print_sympy(void) {
  static const char program[] =
      "python3 -c \"\n"
      "import time, sympy as s\n"
      "def tangent(n):\n"
      "    a, b, c = s.symbols('a b c')\n"
      "    p = [(k*a, c*(k%2)) for k in range(n+1)] + [(n*a, b+c), (0*a, b+c)]\n"
      "    e = list(zip(p, p[1:] + p[:1]))\n"
      "    w = [x0*y1-x1*y0 for (x0, y0), (x1, y1) in e]\n"
      "    x = sum((q[0][0]+q[1][0])*v for q, v in zip(e, w))\n"
      "    y = sum((q[0][1]+q[1][1])*v for q, v in zip(e, w))\n"
      "    return s.cancel(x/y)\n"
      "tangent(2)\n"
      "for n in (3, 50):\n"
      "    t = time.perf_counter(); tangent(n)\n"
      "    print('sympy N = %-3d %14.3f   (the toe alone)' % (n, 1e3*(time.perf_counter()-t)))\n"
      "\" 2>/dev/null";
  fflush(stdout);
  if (system(program) != 0) printf("sympy           not installed, skipped\n");
}

int main(void) {
  static const int counts[] = {3, 10, 50, 200};
  printf("derivation                 ms\n");
  for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
    tp_scene *scene = read_teeth(counts[k]);
    printf("pivots, N = %-3d %12.3f\n", counts[k], median_ms(scene, derive_once));
    if (counts[k] == 3) printf("family          %12.3f\n", median_ms(scene, family_once));
    tp_scene_free(scene);
  }
  print_sympy();
  return 0;
}
