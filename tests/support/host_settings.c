/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _GNU_SOURCE
#include "host_settings.h"

#include "comma_locale.h"

#include <fenv.h>
#include <langinfo.h>
#include <locale.h>
#include <mpfr.h>
#include <string.h>
#if defined(__SSE__)
#include <fpu_control.h>
#include <xmmintrin.h>
#endif

setting setting_now(void) {
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
  /* not localeconv, of which all threads share the answer */
  strncpy(now.decimal_point, nl_langinfo(RADIXCHAR), sizeof now.decimal_point - 1);
  return now;
}

void give_locale_back(void) {
  const locale_t own = uselocale(LC_GLOBAL_LOCALE);
  if (own != LC_GLOBAL_LOCALE) freelocale(own);
}

void as_it_comes(void) {
  fesetenv(FE_DFL_ENV);
  setlocale(LC_ALL, "C");
  give_locale_back();
  mpfr_set_emin(MPFR_EMIN_DEFAULT);
  mpfr_set_emax(MPFR_EMAX_DEFAULT);
}

void decimal_comma(void) {
  setlocale(LC_ALL, COMMA_LOCALE);
}

void decimal_comma_of_the_thread(void) {
  uselocale(newlocale(LC_ALL_MASK, COMMA_LOCALE, (locale_t)0));
}

void rounding_up(void) {
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

void flushing_to_zero(void) {
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

const named_setting settings[SETTINGS] = {
    {"as it comes", as_it_comes},
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
