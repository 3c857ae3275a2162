/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Handlers of SIGINT, SIGTERM and SIGHUP that note the signal once; the process ends by the same
 * signal after its output. */

#include "cli/signals.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t interrupted; /* the signal, or 0 */

static void note_signal(int number) {
  interrupted = number;
}

int tp_cli_signal(void) {
  return interrupted;
}

void tp_cli_catch_signals(void) {
  static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
  struct sigaction action = {.sa_handler = note_signal, .sa_flags = SA_RESETHAND | SA_RESTART};
  struct sigaction before;
  sigemptyset(&action.sa_mask);
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
    if (sigaction(numbers[k], NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
      (void)sigaction(numbers[k], &action, NULL);
    }
  }
}

bool tp_cli_is_interrupted(void *context) {
  (void)context;
  return interrupted != 0;
}

void tp_cli_end_by_signal(void) {
  const int number = interrupted;
  if (number == 0) return;
  (void)signal(number, SIG_DFL);
  (void)raise(number);
}
