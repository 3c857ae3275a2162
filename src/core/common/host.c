/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Saves and resets locale, floating-point environment and exponent range of MPFR, and restores
 * them. */

#include "common/host.h"

#include <mpfr.h>

tp_host tp_host_put_aside(void) {
  tp_host host = {.exponent_least = mpfr_get_emin(), .exponent_most = mpfr_get_emax()};
  host.mpfr_flags = mpfr_flags_save();
  fegetenv(&host.arithmetic);
  fesetenv(FE_DFL_ENV); /* denormal numbers are kept, too */
  /* The C locale is part of the C library: it takes no memory, no file, and is not given back. */
  host.locale = uselocale(newlocale(LC_ALL_MASK, "C", (locale_t)0));
  mpfr_set_emin(MPFR_EMIN_DEFAULT);
  mpfr_set_emax(MPFR_EMAX_DEFAULT);
  return host;
}

void tp_host_bring_back(const tp_host *host) {
  mpfr_set_emin(host->exponent_least);
  mpfr_set_emax(host->exponent_most);
  mpfr_flags_restore(host->mpfr_flags, MPFR_FLAGS_ALL);
  uselocale(host->locale);
  fesetenv(&host->arithmetic);
}
