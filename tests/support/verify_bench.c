/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "verify_bench.h"

#include "suite.h"
#include "verify/subject_init.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

tp_status init_subject(tp_subject *subject, const char *name, tp_message *message) {
  static const char scene[] = "topple: 1\nlength_unit: m\nparameters: {w: 2, h: 3}\n"
                              "block: {slab: {width: w, height: h}}\nbase: {mated: true}\n"
                              "tilt: {towards: left, angle_deg: 20}\n";
  char path[] = "/tmp/topple-test-XXXXXX";
  const int handle = mkstemp(path);
  ck_assert_int_ge(handle, 0);
  ck_assert_int_eq(write(handle, scene, strlen(scene)), (ssize_t)strlen(scene));
  close(handle);
  fmpq values[2];
  for (int k = 0; k < 2; k++) fmpq_init(values + k);
  fmpq_set_si(values, 5, 1);
  fmpq_set_si(values + 1, 30, 1);
  const tp_declared declared[2] = {{name, values, false}, {"psi", values + 1, true}};
  const tp_subject_options options = {.scene = path, .declared_count = 2, .declared = declared};
  const tp_status status = tp_subject_init(subject, &options, (tp_place){"t", 1, 1}, message);
  unlink(path);
  for (int k = 0; k < 2; k++) fmpq_clear(values + k);
  return status;
}

void bench_init(bench *b) {
  b->message = (tp_message){.text = ""};
  ck_assert_msg(init_subject(&b->subject, "m", &b->message) == TP_OK, "%s", b->message.text);
  ck_assert(tp_sample_init(&b->sample, &b->subject));
}

void bench_clear(bench *b) {
  tp_sample_clear(&b->sample);
  tp_subject_clear(&b->subject);
}

void read_claim_formula(tp_formula *formula, bench *b, const char *text) {
  ck_assert_msg(tp_subject_read(formula, text, (tp_place){"t", 1, 1}, &b->subject, &b->message) ==
                    TP_OK,
                "%s: %s", text, b->message.text);
}

double value_of(bench *b, const char *text) {
  tp_formula formula;
  arb_t ball;
  arb_init(ball);
  read_claim_formula(&formula, b, text);
  ck_assert_msg(tp_evaluate_ball(ball, &formula, &b->subject, &b->sample, true, 128, &b->message) ==
                    TP_OK,
                "%s: %s", text, b->message.text);
  const double value = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
  tp_formula_clear(&formula);
  arb_clear(ball);
  return value;
}

bool same(bench *b, const char *one, const char *other) {
  const fmpz_mpoly_ctx_struct *ring = b->subject.field->ring;
  const char *texts[2] = {one, other};
  fmpz_mpoly_q_t values[2];
  for (int k = 0; k < 2; k++) {
    tp_formula formula;
    bool rational = false;
    fmpz_mpoly_q_init(values[k], ring);
    read_claim_formula(&formula, b, texts[k]);
    ck_assert_int_eq(tp_evaluate_field(values[k], &rational, &formula, &b->subject, &b->message),
                     TP_OK);
    ck_assert_msg(rational, "%s", texts[k]);
    tp_formula_clear(&formula);
  }
  const bool equal = fmpz_mpoly_q_equal(values[0], values[1], ring) != 0;
  fmpz_mpoly_q_clear(values[0], ring);
  fmpz_mpoly_q_clear(values[1], ring);
  return equal;
}
