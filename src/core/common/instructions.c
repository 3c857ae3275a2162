/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* glibc has asked the processor at the start; the compiler's library, where glibc does not tell,
 * would ask again, which takes tens of microseconds on a virtual machine. */

#include "common/instructions.h"

#ifdef __x86_64__
#if __has_include(<sys/platform/x86.h>)
#include <sys/platform/x86.h>
#endif
#endif

#ifdef CPU_FEATURE_ACTIVE
#define HAS_AVX2 (CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(FMA))
#define HAS_AVX512 CPU_FEATURE_ACTIVE(AVX512F)
#else
#define HAS_AVX2 (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#define HAS_AVX512 __builtin_cpu_supports("avx512f")
#endif

bool tp_instructions_present(tp_instructions set) {
  switch (set) {
  case TP_INSTRUCTIONS_BASELINE:
    return true;
#ifdef __x86_64__
  case TP_INSTRUCTIONS_AVX2:
    return HAS_AVX2;
  case TP_INSTRUCTIONS_AVX512:
    return HAS_AVX512;
#endif
  default:
    return false;
  }
}

tp_instructions tp_instructions_chosen(tp_instructions asked) {
  if (asked != TP_INSTRUCTIONS_BEST) return asked;
  if (tp_instructions_present(TP_INSTRUCTIONS_AVX512)) return TP_INSTRUCTIONS_AVX512;
  if (tp_instructions_present(TP_INSTRUCTIONS_AVX2)) return TP_INSTRUCTIONS_AVX2;
  return TP_INSTRUCTIONS_BASELINE;
}
