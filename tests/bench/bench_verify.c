/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What verdicts cost: the paper's whole claims file, median of 9. */

#include "bench.h"

#include "topple.h"

#include <stdio.h>

enum { SAMPLES = 9 };

int main(int argc, char **argv) {
  double samples[SAMPLES];
  size_t claims = 0;
  for (int k = 0; k < SAMPLES && argc == 2; k++) {
    tp_verification *verification = NULL;
    tp_message message = {.text = ""};
    const double began = bench_now();
    if (tp_verify(&verification, argv[1], &message) != TP_OK) {
      fprintf(stderr, "bench_verify: %s\n", message.text);
      return 5;
    }
    samples[k] = 1e3 * (bench_now() - began);
    claims = verification->count;
    tp_verification_free(verification);
  }
  if (claims == 0) return 2;
  const double all = gsl_stats_median(samples, 1, SAMPLES);
  printf("claims %zu, all %.1f ms, each %.3f ms\n", claims, all, all / (double)claims);
  return 0;
}
