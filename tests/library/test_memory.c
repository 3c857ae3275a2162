/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory that runs out: every call, with its n-th request failing, for n from the first to the
 * last, in turn once and with all that come after it. It then says so, leaves its output alone and
 * gives back all that it took. Requests of FLINT and GMP, which know of no failure, do not fail
 * here; test_out_of_memory.py tells what the program does there.
 *
 * By default a quarter of the n that memory_calls.c gives for each call, spread evenly, and all of
 * those under ./check --long; with TOPPLE_EVERY_REQUEST set every n, or 5000 of the calls that make
 * more requests. */

#include "failing_memory.h"
#include "memory_calls.h"
#include "rounds.h"
#include "runner.h"

#include <flint/flint.h>
#include <gmp.h>
#include <stdlib.h>

/* FLINT and GMP are spared. */

static void *take(size_t size) {
  const bool before = failing_memory_state.spared;
  failing_memory_state.spared = true;
  void *memory = malloc(size);
  failing_memory_state.spared = before;
  return memory;
}

static void *take_zeros(size_t count, size_t size) {
  const bool before = failing_memory_state.spared;
  failing_memory_state.spared = true;
  void *memory = calloc(count, size);
  failing_memory_state.spared = before;
  return memory;
}

static void *resize(void *old, size_t size) {
  const bool before = failing_memory_state.spared;
  failing_memory_state.spared = true;
  void *memory = realloc(old, size);
  failing_memory_state.spared = before;
  return memory;
}

static void *resize_known(void *memory, size_t size_before, size_t size) {
  (void)size_before;
  return resize(memory, size);
}

static void give_back(void *memory, size_t size) {
  (void)size;
  free(memory);
}

/* The blocks that stay when what FLINT keeps for the next call is given back. */
static long run(void (*call)(void), long fail_at, bool lasting) {
  failing_memory_state.requests = 0;
  failing_memory_state.lasting = lasting;
  failing_memory_state.fail_at = fail_at;
  call();
  failing_memory_state.fail_at = 0;
  flint_cleanup();
  return failing_memory_state.live;
}

enum { LOST_BY_CGAL = 1000, MOST_POINTS = 5000 };

START_TEST(every_request) {
  const memory_call *own = memory_calls + _i;
  (void)run(own->run, 0, false); /* what libraries keep for good */
  long kept = run(own->run, 0, false);
  const long requests = failing_memory_state.requests;
  ck_assert_int_ge(requests, 2);
  const long points = getenv("TOPPLE_EVERY_REQUEST") != NULL
                          ? MOST_POINTS
                          : rounds((own->points + 3) / 4, own->points);
  const long step = 1 + (requests - 1) / points;
  for (long n = 1; n <= requests; n += step) {
    failing_memory_state.was_new = false;
    const long live = run(own->run, n, (n / step) % 2 == 1);
    /* CGAL's containers lose what they just took where the next request of theirs fails, and a
     * triangulation that its failure left broken is abandoned */
    if (failing_memory_state.was_new && live - kept <= LOST_BY_CGAL) kept = live;
    ck_assert_msg(live == kept, "%s: %ld blocks are not given back after request %ld of %ld failed",
                  own->name, live - kept, n, requests);
  }
}
END_TEST

int main(void) {
  __flint_set_memory_functions(take, take_zeros, resize, free);
  mp_set_memory_functions(take, resize_known, give_back);
  Suite *suite = suite_create("memory");
  TCase *tests = tcase_create("requests");
  tcase_set_timeout(tests, 0);
  tcase_add_loop_test(tests, every_request, 0, memory_call_count);
  suite_add_tcase(suite, tests);
  return run_suite(suite);
}
