/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By stripes of columns: each is factorised by itself, a few columns at a time, then taken from all
 * behind it in pieces that stay in the machine's registers, three columns by three vectors. */

#include "assemblage/front.h"

#include <math.h>
#include <string.h>

enum { STRIPE = 48, NARROW = 6, WIDE = 3, SUMS = 8 };

typedef double two_lanes __attribute__((vector_size(16)));
#ifdef __x86_64__
typedef double four_lanes __attribute__((vector_size(32)));
typedef double eight_lanes __attribute__((vector_size(64)));
#endif

static inline double sum_of(const double v[SUMS]) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

#ifdef __x86_64__
#define KERNEL(name) avx512_##name
#define TARGET __attribute__((target("avx512f")))
#define LANES 8
#include "assemblage/front_in.h"

#define KERNEL(name) avx2_##name
#define TARGET __attribute__((target("avx2")))
#define LANES 4
#include "assemblage/front_in.h"
#endif

#define KERNEL(name) baseline_##name
#define TARGET
#define LANES 2
#include "assemblage/front_in.h"

const tp_front_kernel *tp_front_kernel_choose(tp_instructions instructions) {
  static const tp_front_kernel *const kernels[] = {
      [TP_INSTRUCTIONS_BASELINE] = &baseline_kernel,
#ifdef __x86_64__
      [TP_INSTRUCTIONS_AVX2] = &avx2_kernel,
      [TP_INSTRUCTIONS_AVX512] = &avx512_kernel,
#endif
  };
  return kernels[tp_instructions_chosen(instructions)];
}
