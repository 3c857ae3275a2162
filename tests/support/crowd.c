/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _GNU_SOURCE
#include "crowd.h"

#include <check.h>
#include <flint/flint.h>
#include <pthread.h>

struct crowd {
  pthread_barrier_t barrier;
  crowd_run *run;
};

typedef struct member {
  crowd *of;
  int number;
} member;

static void *enter(void *argument) {
  const member *own = argument;
  crowd_wait(own->of);
  own->of->run(own->of, own->number);
  flint_cleanup(); /* what FLINT keeps for the next call, by thread */
  return NULL;
}

void crowd_wait(crowd *among) {
  pthread_barrier_wait(&among->barrier);
}

void run_together(crowd_run *run) {
  crowd own = {.run = run};
  pthread_t threads[THREADS];
  member members[THREADS];
  ck_assert_int_eq(pthread_barrier_init(&own.barrier, NULL, THREADS), 0);
  for (int k = 0; k < THREADS; k++) {
    members[k] = (member){&own, k};
    ck_assert_int_eq(pthread_create(threads + k, NULL, enter, members + k), 0);
  }
  for (int k = 0; k < THREADS; k++) pthread_join(threads[k], NULL);
  pthread_barrier_destroy(&own.barrier);
}
