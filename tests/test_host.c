/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The library in programs that have set their thread up otherwise.
 *
 * A program in German printed `28,734` into JSON, found no root and drew a wrong map; one that
 * rounds downwards got bounds that do not hold; one with traps was killed. Here the whole library
 * runs once in a thread as it comes, and again in each setting of a program: every byte that it
 * says must be the same, and the setting must be there as before. Nothing is known of the truth:
 * that is the business of the other tests, which run in a thread as it comes. */

#define _GNU_SOURCE
#include "runner.h"

#include "host.h"
#include "topple.h"

#include <fenv.h>
#include <locale.h>
#include <mpfr.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__SSE__)
#include <fpu_control.h>
#include <xmmintrin.h>
#endif

#define EXAMPLE(name) TP_EXAMPLES "/" name

static char folder[] = "/tmp/topple-host-XXXXXX";

/* ---- everything that the library says ----------------------------------------------------------
 */

enum { MOST_TEXTS = 200 };

typedef struct said {
  size_t count;
  char *texts[MOST_TEXTS];
} said;

/* No assertion and no arithmetic here: a setting of the program may forbid it. */
static char **next(said *s) {
  return s->texts + s->count++;
}

static char *note(said *s, tp_status status, const tp_message *message) {
  char **text = next(s);
  if (asprintf(text, "status %d: %s", (int)status, status == TP_OK ? "" : message->text) < 0) {
    *text = NULL;
  }
  return *text;
}

/* Times differ from run to run, and must be printed alike. */
static void fix_times(tp_solution *solution) {
  for (size_t k = 0; k < solution->effect_count; k++) solution->effects[k].seconds = 0.00123456789;
}

static void read_whole(said *s, const char *path) {
  FILE *file = fopen(path, "rb");
  char *text = calloc(1, 1 << 20);
  if (file != NULL) fread(text, 1, (1 << 20) - 1, file);
  if (file != NULL) fclose(file);
  /* Cairo counts the surfaces of a process */
  for (char *at = text; at != NULL && (at = strstr(at, "surface")) != NULL;) {
    at += strlen("surface");
    memmove(at, at + strspn(at, "0123456789"), strlen(at + strspn(at, "0123456789")) + 1);
  }
  *next(s) = text;
}

static void say_solution(said *s, const tp_scene *scene, bool elements, int digits, bool figure) {
  tp_message message = {""};
  tp_solution *solution = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.elements = elements;
  options.digits = digits;
  tp_status status = tp_solve(&solution, scene, &options, &message);
  note(s, status, &message);
  if (status != TP_OK) return;
  fix_times(solution);
  if (tp_report_text(next(s), solution) != TP_OK) s->count--;
  if (tp_report_json(next(s), solution) != TP_OK) s->count--;
  if (tp_report_elements(next(s), solution) != TP_OK) s->count--;
  const tp_solution *const both[2] = {solution, solution};
  if (tp_report_table(next(s), both, 2) != TP_OK) s->count--;
  if (figure) {
    char path[sizeof folder + 20];
    strcat(strcpy(path, folder), "/figure.svg");
    note(s, tp_report_figure(path, scene, solution, &message), &message);
    read_whole(s, path);
  }
  tp_solution_free(solution);
}

static void say_example(said *s, const char *path, bool elements, int digits, bool figure) {
  tp_message message = {""};
  tp_scene *scene = NULL;
  note(s, tp_scene_read(&scene, path, &message), &message);
  if (scene != NULL) say_solution(s, scene, elements, digits, figure);
  tp_scene_free(scene);
}

/* An outline whose sums are taken in doubles at once. */
static void say_large(said *s) {
  static char text[4 << 20];
  tp_message message = {""};
  tp_scene *scene = NULL;
  char *at =
      stpcpy(text, "topple: 1\nlength_unit: mm\ntilt: {towards: left}\nblock:\n  outline:\n");
  for (int k = 0; k <= 40000; k++) at += sprintf(at, "  - [%d, %d]\n", 7 * k, k * k % 11);
  strcpy(at, "  - [280000, 90000]\n  - [0, 90000]\n");
  note(s, tp_scene_read_text(&scene, text, "large", &message), &message);
  if (scene != NULL) say_solution(s, scene, false, 9, false);
  tp_scene_free(scene);
}

static void say_derivation(said *s, tp_notation notation) {
  tp_message message = {""};
  tp_scene *scene = NULL;
  tp_derivation *derivation = NULL;
  tp_family *family = NULL;
  tp_derive_options options = tp_derive_options_default();
  options.notation = notation;
  options.elements = options.rounded = options.limit = true;
  note(s, tp_scene_read(&scene, EXAMPLE("block_e_valley.yaml"), &message), &message);
  if (scene == NULL) return;
  note(s, tp_derive(&derivation, scene, &options, &message), &message);
  if (derivation != NULL && tp_report_derivation(next(s), derivation) != TP_OK) s->count--;
  if (derivation != NULL && tp_report_derivation_json(next(s), derivation) != TP_OK) s->count--;
  note(s, tp_derive_family(&family, scene, notation, &message), &message);
  if (family != NULL && tp_report_family(next(s), family) != TP_OK) s->count--;
  if (family != NULL && tp_report_family_json(next(s), family) != TP_OK) s->count--;
  tp_family_free(family);
  tp_derivation_free(derivation);
  tp_scene_free(scene);
}

static const char claims[] =
    "topple_claims: 1\ntitle: Numbers with decimals\n"
    "geometries: {slab: {scene: " EXAMPLE(
        "slab_left.yaml") "}}\n"
                          "claims:\n"
                          "- {id: angle, where: here, geometry: slab, quantity: critical_angle, "
                          "printed: 26.565}\n"
                          "- {id: formula, where: here, geometry: slab, quantity: critical_angle, "
                          "printed: atan(0.5)}\n";

static void say_verdicts(said *s) {
  tp_message message = {""};
  tp_verification *own = NULL, *paper = NULL;
  note(s, tp_verify_text(&own, claims, "claims", &message), &message);
  note(s, tp_verify(&paper, EXAMPLE("paper/claims.yaml"), &message), &message);
  const tp_verification *const both[2] = {own, paper};
  for (int k = 0; k < 2; k++) {
    if (both[k] == NULL) continue;
    if (tp_report_verification(next(s), both[k]) != TP_OK) s->count--;
    if (tp_report_verification_json(next(s), both[k]) != TP_OK) s->count--;
    if (tp_report_verification_markdown(next(s), both[k]) != TP_OK) s->count--;
  }
  tp_verification_free(own);
  tp_verification_free(paper);
}

static void say_found(said *s, const char *path, const tp_find_options *options) {
  tp_message message = {""};
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_found *found = NULL;
  const tp_solve_options solve = tp_solve_options_default();
  note(s, tp_find(&found, path, options, &message), &message);
  note(s, tp_scene_read(&scene, path, &message), &message);
  if (scene != NULL) note(s, tp_solve(&solution, scene, &solve, &message), &message);
  if (solution != NULL) fix_times(solution);
  if (found != NULL && tp_report_found(next(s), found, options) != TP_OK) s->count--;
  if (found != NULL && solution != NULL &&
      tp_report_found_json(next(s), found, solution) != TP_OK) {
    s->count--;
  }
  tp_found_free(found);
  tp_solution_free(solution);
  tp_scene_free(scene);
}

static void say_chart(said *s, tp_status status, tp_chart *chart, const tp_message *message,
                      bool draw) {
  note(s, status, message);
  if (chart == NULL) return;
  if (tp_report_chart_csv(next(s), chart) != TP_OK) s->count--;
  if (tp_report_chart_json(next(s), chart) != TP_OK) s->count--;
  if (draw) {
    tp_message why = {""};
    char path[sizeof folder + 20];
    strcat(strcpy(path, folder), "/chart.svg");
    note(s, tp_report_chart_file(chart, path, TP_CHART_SVG, &why), &why);
    read_whole(s, path);
  }
  tp_chart_free(chart);
}

static void say_charts(said *s) {
  tp_message message = {""};
  tp_chart *chart[5] = {NULL};
  const tp_chart_fos_options fos = tp_chart_fos_options_default();
  const tp_chart_mechanisms_options mechanisms = tp_chart_mechanisms_options_default();
  const tp_chart_map_options line = {.scene = EXAMPLE("slab_left.yaml"),
                                     .x = {"block.slab.width", {20.5, 149.25}},
                                     .y = {"tilt", {0, 90}}},
                             plane = {.scene = EXAMPLE("slab_left.yaml"),
                                      .x = {"block.slab.width", {60.5, 70.25}},
                                      .y = {"block.slab.height", {50, 60}}};
  say_chart(s, tp_chart_fos(chart, &fos, &message), chart[0], &message, true);
  say_chart(s, tp_chart_mechanisms(chart + 1, &mechanisms, &message), chart[1], &message, false);
  say_chart(s, tp_chart_ranges(chart + 2, &message), chart[2], &message, false);
  say_chart(s, tp_chart_map(chart + 3, &line, &message), chart[3], &message, true);
  say_chart(s, tp_chart_map(chart + 4, &plane, &message), chart[4], &message, false);
}

static void say_accuracy(said *s) {
  tp_message message = {""};
  tp_scene *scene = NULL;
  tp_accuracy *of[2] = {NULL, NULL};
  tp_chart *chart[2] = {NULL, NULL};
  note(s, tp_scene_read(&scene, EXAMPLE("slab_left.yaml"), &message), &message);
  if (scene != NULL) note(s, tp_accuracy_of_scene(of, scene, &message), &message);
  note(s, tp_accuracy_sweep(of + 1, 10, 10, &message), &message);
  for (int k = 0; k < 2; k++) {
    if (of[k] == NULL) continue;
    for (size_t r = 0; r < of[k]->run_count; r++) of[k]->runs[r].seconds = 0.00123456789;
    if (tp_report_accuracy(next(s), of[k]) != TP_OK) s->count--;
    if (tp_report_accuracy_json(next(s), of[k]) != TP_OK) s->count--;
    say_chart(s, tp_chart_accuracy(chart + k, of[k], &message), chart[k], &message, false);
    tp_accuracy_free(of[k]);
  }
  tp_scene_free(scene);
}

static void say_everything(said *s) {
  say_example(s, EXAMPLE("block_e_valley.yaml"), true, 9, true);
  say_example(s, EXAMPLE("block_a_worn.yaml"), false, 40, true);
  say_example(s, EXAMPLE("block_under_water.yaml"), false, 9, false);
  say_example(s, EXAMPLE("boulder.yaml"), false, 9, false);
  say_example(s, EXAMPLE("no such scene.yaml"), false, 9, false);
  say_large(s);
  for (int k = TP_NOTATION_TEXT; k <= TP_NOTATION_C; k++) say_derivation(s, (tp_notation)k);
  say_verdicts(s);
  const tp_find_options find[2] = {
      {.key = "block.slab.width", .target = TP_FIND_CRITICAL_ANGLE, .value = 20.25},
      {.key = "block.slab.width",
       .target = TP_FIND_LIMIT_ANGLE,
       .value = 30.5,
       .has_range = true,
       .low = 10.5,
       .high = 100.25}};
  for (int k = 0; k < 2; k++) say_found(s, EXAMPLE("slab_left.yaml"), find + k);
  say_charts(s);
  say_accuracy(s);
}

static void forget(said *s) {
  for (size_t k = 0; k < s->count; k++) free(s->texts[k]);
  s->count = 0;
}

/* ---- the settings ------------------------------------------------------------------------------
 */

/* What a program may have set, as it is in this thread. */
typedef struct setting {
  int rounding, traps;
  unsigned control, other; /* of the SSE unit: denormals, too; of the x87 */
  char decimal_point[8];
  long exponent_least, exponent_most;
} setting;

static setting setting_now(void) {
  setting now = {.rounding = fegetround(),
                 .traps = fegetexcept(),
                 .exponent_least = mpfr_get_emin(),
                 .exponent_most = mpfr_get_emax()};
#if defined(__SSE__)
  now.control = _mm_getcsr() & ~0x3fU; /* without the flags of what happened */
  fpu_control_t x87;
  _FPU_GETCW(x87);
  now.other = x87;
#endif
  strncpy(now.decimal_point, localeconv()->decimal_point, sizeof now.decimal_point - 1);
  return now;
}

static void as_it_comes(void) {
  fesetenv(FE_DFL_ENV);
  setlocale(LC_ALL, "C");
  uselocale(LC_GLOBAL_LOCALE);
  mpfr_set_emin(MPFR_EMIN_DEFAULT);
  mpfr_set_emax(MPFR_EMAX_DEFAULT);
}

/* A locale with a decimal comma. Its sources are written here, since Debian's come with a package
 * that need not be there; localedef comes with the C library. */
static void make_locale(void) {
  char path[64], command[400];
  snprintf(path, sizeof path, "%s/comma", folder);
  FILE *file = fopen(path, "w");
  ck_assert_ptr_nonnull(file);
  fputs("comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\n"
        "grouping 3;3\nEND LC_NUMERIC\n",
        file);
  fclose(file);
  snprintf(path, sizeof path, "%s/ascii", folder);
  file = fopen(path, "w");
  ck_assert_ptr_nonnull(file);
  fputs("<code_set_name> ANSI_X3.4-1968\n<comment_char> %\n<escape_char> /\n<mb_cur_min> 1\n"
        "<mb_cur_max> 1\nCHARMAP\n",
        file);
  for (unsigned k = 0; k < 128; k++) fprintf(file, "<U%04X> /x%02x\n", k, k);
  fputs("END CHARMAP\n", file);
  fclose(file);
  /* it warns of the categories that are left out, and makes the locale all the same */
  snprintf(command, sizeof command,
           "localedef -c --no-archive -i '%s/comma' -f '%s/ascii' '%s/xx_XX' 2>'%s/complaints'",
           folder, folder, folder, folder);
  const int ended = system(command);
  (void)ended;
  setenv("LOCPATH", folder, 1);
}

static void decimal_comma(void) {
  setlocale(LC_ALL, "xx_XX");
}

static void decimal_comma_of_the_thread(void) {
  uselocale(newlocale(LC_ALL_MASK, "xx_XX", (locale_t)0));
}

static void rounding_up(void) {
  fesetround(FE_UPWARD);
}

static void rounding_down(void) {
  fesetround(FE_DOWNWARD);
}

static void rounding_to_zero(void) {
  fesetround(FE_TOWARDZERO);
}

static void all_traps(void) {
  feenableexcept(FE_ALL_EXCEPT);
}

static void some_traps(void) {
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
}

static void flushing_to_zero(void) {
#if defined(__SSE__)
  _mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
}

static void short_extended(void) {
#if defined(__SSE__)
  fpu_control_t x87 = _FPU_DEFAULT & ~_FPU_EXTENDED;
  _FPU_SETCW(x87);
#endif
}

static void few_exponents(void) {
  mpfr_set_emin(-5);
  mpfr_set_emax(5);
}

static void everything_at_once(void) {
  decimal_comma();
  few_exponents();
  rounding_down();
  flushing_to_zero();
  short_extended();
  all_traps();
}

static const struct {
  const char *name;
  void (*set)(void);
} settings[] = {{"as it comes", as_it_comes},
                {"decimal comma", decimal_comma},
                {"decimal comma of the thread", decimal_comma_of_the_thread},
                {"rounding up", rounding_up},
                {"rounding down", rounding_down},
                {"rounding to zero", rounding_to_zero},
                {"all traps", all_traps},
                {"some traps", some_traps},
                {"flushing to zero", flushing_to_zero},
                {"long doubles in single precision", short_extended},
                {"few exponents of MPFR", few_exponents},
                {"everything at once", everything_at_once}};
enum { SETTINGS = sizeof settings / sizeof settings[0] };

START_TEST(same_bytes_in_every_setting) {
  said first = {0};
  say_everything(&first);
  ck_assert_uint_gt(first.count, 80);
  ck_assert_uint_lt(first.count, MOST_TEXTS);
  for (size_t k = 0; k < first.count; k++) ck_assert_ptr_nonnull(first.texts[k]);
  for (int k = 0; k < SETTINGS; k++) {
    said again = {0};
    settings[k].set();
    const setting before = setting_now();
    say_everything(&again);
    const setting after = setting_now();
    as_it_comes();
    ck_assert_msg(memcmp(&before, &after, sizeof before) == 0, "%s: not as before",
                  settings[k].name);
    ck_assert_msg(again.count == first.count, "%s: %zu texts instead of %zu", settings[k].name,
                  again.count, first.count);
    for (size_t t = 0; t < first.count; t++) {
      const char *one = first.texts[t], *other = again.texts[t];
      size_t same = 0;
      while (one[same] != '\0' && one[same] == other[same]) same++;
      const size_t from = same > 60 ? same - 60 : 0;
      ck_assert_msg(one[same] == other[same], "%s, text %zu:\n%.120s\nand not\n%.120s",
                    settings[k].name, t, other + from, one + from);
    }
    forget(&again);
  }
  forget(&first);
}
END_TEST

/* The settings do what they say: a test whose comma is a point would find nothing. */
START_TEST(settings_are_set) {
  char text[16];
  volatile double third = 1, tiny = 0x1p-1022;
  decimal_comma();
  snprintf(text, sizeof text, "%g", 0.5);
  ck_assert_str_eq(text, "0,5");
  as_it_comes();
  rounding_up();
  third = third / 3;
  as_it_comes();
  ck_assert_double_gt(third, 1. / 3);
  flushing_to_zero();
  tiny = tiny / 2;
  as_it_comes();
#if defined(__SSE__)
  ck_assert(tiny == 0);
#endif
}
END_TEST

/* Sums of large blocks are shared by threads: those must round as the entry does. */
static void *rounding_here(void *result) {
  *(int *)result = fegetround();
  return NULL;
}

START_TEST(threads_round_as_the_entry) {
  int rounding = -1;
  rounding_up();
  {
    TP_GUARD_HOST;
    pthread_t thread;
    ck_assert_int_eq(pthread_create(&thread, NULL, rounding_here, &rounding), 0);
    pthread_join(thread, NULL);
  }
  const int after = fegetround();
  as_it_comes();
  ck_assert_int_eq(rounding, FE_TONEAREST);
  ck_assert_int_eq(after, FE_UPWARD);
}
END_TEST

/* Entries in several threads at once, each with a setting of its own. */
static void *solve_in_a_thread(void *argument) {
  const int which = *(const int *)argument;
  static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST};
  said *s = calloc(1, sizeof *s);
  fesetround(modes[which]);
  if (which % 2 == 0) decimal_comma_of_the_thread();
  const setting before = setting_now();
  if (s != NULL) say_example(s, EXAMPLE("block_e_valley.yaml"), true, 30, false);
  const setting after = setting_now();
  if (s != NULL && memcmp(&before, &after, sizeof before) != 0) forget(s);
  flint_cleanup();
  return s;
}

START_TEST(threads_of_different_settings) {
  enum { THREADS = 4 };
  pthread_t threads[THREADS];
  int which[THREADS];
  said *results[THREADS], expected = {0};
  say_example(&expected, EXAMPLE("block_e_valley.yaml"), true, 30, false);
  for (int k = 0; k < THREADS; k++) {
    which[k] = k;
    ck_assert_int_eq(pthread_create(threads + k, NULL, solve_in_a_thread, which + k), 0);
  }
  for (int k = 0; k < THREADS; k++) {
    void *result = NULL;
    pthread_join(threads[k], &result);
    results[k] = result;
    ck_assert_ptr_nonnull(results[k]);
    ck_assert_uint_eq(results[k]->count, expected.count);
    for (size_t t = 0; t < expected.count; t++) {
      ck_assert_msg(strcmp(results[k]->texts[t], expected.texts[t]) == 0, "text %zu differs", t);
    }
    forget(results[k]);
    free(results[k]);
  }
  forget(&expected);
}
END_TEST

int main(void) {
  if (mkdtemp(folder) == NULL) return 1;

  Suite *suite = suite_create("host");
  TCase *tests = tcase_create("settings");
  tcase_set_timeout(tests, 600);
  tcase_add_unchecked_fixture(tests, make_locale, as_it_comes);
  tcase_add_test(tests, settings_are_set);
  tcase_add_test(tests, same_bytes_in_every_setting);
  tcase_add_test(tests, threads_round_as_the_entry);
  tcase_add_test(tests, threads_of_different_settings);
  suite_add_tcase(suite, tests);
  const int failed = run_suite(suite);
  char command[64];
  snprintf(command, sizeof command, "rm -r '%s'", folder);
  return system(command) == 0 ? failed : 1;
}
