/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "cli/study_signal.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t interrupted; /* the signal, or 0 */

static void note_signal(int number) {
  interrupted = number;
}

int tp_cli_study_signal(void) {
  return interrupted;
}

void tp_cli_study_catch(void) {
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
