/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study by up to a thousand ranks, each a thread of this process that reaches the others through
 * memory: the summary of one process, to the byte, and what each rank hands over, in bytes and in
 * calls, which does not grow with the number of ranks while each has as many samples. What the
 * first one receives is bounded by the columns of the result. */

#include "suite.h"
#include "topple.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_RANKS = 1000, CHUNK = 20, CHUNKS_OF_RANK = 2 };

typedef struct letter {
  void *bytes;
  size_t size;
} letter;

typedef struct machine machine;

typedef struct rank {
  machine *of;
  tp_study_ranks calls;
  const uint64_t *own; /* of the sum that is going on */
  letter letters[64];  /* sent, and received */
  size_t sent, received, bytes, sums;
  pthread_cond_t posted;
  pthread_t thread;
  tp_status status;
  tp_message message;
  tp_study_result *result;
} rank;

struct machine {
  const tp_study *study;
  size_t count;
  pthread_mutex_t lock;
  pthread_barrier_t meet;
  rank *ranks;
};

/* Each adds up for itself, between two meetings. */
static bool sum(void *context, uint64_t *before, uint64_t *all, const uint64_t *own, size_t count) {
  rank *r = context;
  const machine *m = r->of;
  r->own = own;
  r->sums++;
  r->bytes += count * sizeof *own;
  pthread_barrier_wait(&r->of->meet);
  if (before != NULL) memset(before, 0, count * sizeof *before);
  memset(all, 0, count * sizeof *all);
  for (size_t k = 0; k < m->count; k++) {
    for (size_t j = 0; j < count; j++) {
      if (before != NULL && k < r->calls.rank) before[j] += m->ranks[k].own[j];
      all[j] += m->ranks[k].own[j];
    }
  }
  pthread_barrier_wait(&r->of->meet);
  return true;
}

static bool send(void *context, const void *bytes, size_t size) {
  rank *r = context;
  void *copy = malloc(size + 1);
  if (copy == NULL || r->sent == sizeof r->letters / sizeof r->letters[0]) return false;
  if (size > 0) memcpy(copy, bytes, size);
  pthread_mutex_lock(&r->of->lock);
  r->letters[r->sent++] = (letter){copy, size};
  pthread_cond_signal(&r->posted);
  pthread_mutex_unlock(&r->of->lock);
  r->bytes += size;
  return true;
}

static bool receive(void *context, size_t from, void **bytes, size_t *size) {
  const rank *first = context;
  rank *r = first->of->ranks + from;
  pthread_mutex_lock(&r->of->lock);
  while (r->received == r->sent) pthread_cond_wait(&r->posted, &r->of->lock);
  const letter own = r->letters[r->received++];
  pthread_mutex_unlock(&r->of->lock);
  *bytes = own.bytes;
  *size = own.size;
  return true;
}

static void *run_rank(void *context) {
  rank *r = context;
  tp_study_options options = tp_study_options_default();
  options.threads = 1;
  options.ranks = &r->calls;
  r->status = tp_study_run(&r->result, r->of->study, &options, &r->message);
  tp_cleanup();
  return NULL;
}

/* All of them at once; the report of the first one is the caller's. */
static char *run(machine *m, const tp_study *study, size_t count) {
  pthread_attr_t small;
  *m = (machine){.study = study, .count = count, .ranks = calloc(count, sizeof *m->ranks)};
  ck_assert_ptr_nonnull(m->ranks);
  ck_assert_int_eq(pthread_mutex_init(&m->lock, NULL), 0);
  ck_assert_int_eq(pthread_barrier_init(&m->meet, NULL, (unsigned)count), 0);
  ck_assert_int_eq(pthread_attr_init(&small), 0);
  ck_assert_int_eq(pthread_attr_setstacksize(&small, (size_t)1 << 20), 0);
  for (size_t k = 0; k < count; k++) {
    rank *r = m->ranks + k;
    r->of = m;
    r->calls = (tp_study_ranks){k, count, r, sum, send, receive};
    ck_assert_int_eq(pthread_cond_init(&r->posted, NULL), 0);
    ck_assert_int_eq(pthread_create(&r->thread, &small, run_rank, r), 0);
  }
  for (size_t k = 0; k < count; k++) {
    const rank *r = m->ranks + k;
    ck_assert_int_eq(pthread_join(r->thread, NULL), 0);
    ck_assert_msg(r->status == TP_OK, "%s", r->message.text);
    ck_assert(k == 0 ? r->result != NULL : r->result == NULL);
    ck_assert_uint_eq(r->sent, r->received);
  }
  char *report = NULL;
  ck_assert_int_eq(tp_report_study_json(&report, m->ranks->result), TP_OK);
  tp_study_result_free(m->ranks->result);
  pthread_attr_destroy(&small);
  pthread_barrier_destroy(&m->meet);
  pthread_mutex_destroy(&m->lock);
  return report;
}

/* To the byte; where not, from there on. */
static void expect_same(const char *together, const char *alone, size_t ranks) {
  size_t same = 0;
  while (together[same] != '\0' && together[same] == alone[same]) same++;
  ck_assert_msg(together[same] == alone[same], "by %zu ranks: %.200s\nalone: %.200s", ranks,
                together + same, alone + same);
}

static void end(machine *m) {
  for (size_t k = 0; k < m->count; k++) pthread_cond_destroy(&m->ranks[k].posted);
  free(m->ranks);
}

/* A slab at three tilts, of so many samples. */
static tp_study *make_study(size_t samples, const char *more) {
  char text[600];
  tp_study *study = NULL;
  tp_message message = {.text = ""};
  snprintf(text, sizeof text,
           "topple_study: 1\nscene: slab.yaml\nsamples: %zu\nsampling: {chunk: %d}\nvary:\n"
           "  friction_angle_deg: {normal: {mean: 29, deviation: 2}}\n"
           "  block.slab.height: {uniform: {low: -0.02, high: 4}}\ntilts_deg: [25, 30]\n%s",
           samples, CHUNK, more);
  const tp_status status =
      tp_study_read_text(&study, text, TP_EXAMPLES "/studies/study.yaml", &message);
  ck_assert_msg(status == TP_OK, "%s", message.text);
  return study;
}

static char *run_alone(const tp_study *study) {
  const tp_study_options options = tp_study_options_default();
  tp_study_result *result = NULL;
  char *report = NULL;
  ck_assert_int_eq(tp_study_run(&result, study, &options, NULL), TP_OK);
  ck_assert_int_eq(tp_report_study_json(&report, result), TP_OK);
  tp_study_result_free(result);
  return report;
}

/* Of all but the first, the most that one hands over, and in how many calls. */
static void measure(size_t *bytes, size_t *calls, const machine *m) {
  *bytes = *calls = 0;
  for (size_t k = 1; k < m->count; k++) {
    const rank *r = m->ranks + k;
    if (r->bytes > *bytes) *bytes = r->bytes;
    if (r->sums + r->sent > *calls) *calls = r->sums + r->sent;
  }
}

START_TEST(flat) {
  static const size_t counts[] = {2, 3, 10, 100, MOST_RANKS};
  size_t bytes[5], calls[5];
  for (size_t k = 0; k < 5; k++) {
    machine m;
    tp_study *study = make_study(counts[k] * CHUNKS_OF_RANK * CHUNK, "");
    char *alone = run_alone(study), *together = run(&m, study, counts[k]);
    expect_same(together, alone, counts[k]);
    measure(bytes + k, calls + k, &m);
    printf("%4zu ranks: %zu bytes and %zu calls of one\n", counts[k], bytes[k], calls[k]);
    end(&m);
    free(alone);
    free(together);
    tp_study_free(study);
  }
  /* rounds are by time: of one chunk, or of all that a rank has; no more of them for more ranks */
  const size_t rounds = CHUNKS_OF_RANK, sums = 2 * rounds + 8;
  for (size_t k = 0; k < 5; k++) {
    ck_assert_uint_le(calls[k], sums + 1);
    /* a sum is some 150 numbers; columns are 12 numbers a sample, once */
    ck_assert_uint_le(bytes[k], sums * 160 * sizeof(uint64_t) +
                                    (size_t)CHUNKS_OF_RANK * CHUNK * 16 * sizeof(double) + 64);
  }
}
END_TEST

/* Where one process ends, though the ranks after it have computed further. */
START_TEST(ends_early) {
  tp_study *study = make_study(200000, "until: {half_width: 0.06}\n");
  char *alone = run_alone(study);
  ck_assert_ptr_nonnull(strstr(alone, "\"end\": \"certain\""));
  static const size_t counts[] = {2, 7, 64};
  for (size_t k = 0; k < 3; k++) {
    machine m;
    char *together = run(&m, study, counts[k]);
    expect_same(together, alone, counts[k]);
    end(&m);
    free(together);
  }
  free(alone);
  tp_study_free(study);
}
END_TEST

SUITE(study_many_ranks) {
  Suite *suite = suite_create("a study by many ranks");
  TCase *tests = tcase_create("ranks");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, flat);
  tcase_add_test(tests, ends_early);
  suite_add_tcase(suite, tests);
  return suite;
}
