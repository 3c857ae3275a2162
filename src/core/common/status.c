/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The meaning and the exit status of every status, from the one list in topple_basics.h; the
 * version of the library; texts freed, and what a thread keeps. */

#include "topple.h"

#include <flint/flint.h>
#include <stdlib.h>

const char *tp_version(void) {
  return TP_VERSION;
}

int tp_version_number(void) {
  return TP_VERSION_NUMBER;
}

void tp_text_free(char *text) {
  free(text);
}

void tp_cleanup(void) {
  flint_cleanup();
}

const char *tp_status_meaning(tp_status status) {
  switch (status) {
#define TP_STATUS_MEANING(name, number, exit_status, meaning)                                      \
  case name:                                                                                       \
    return meaning;
    TP_STATUS_LIST(TP_STATUS_MEANING)
#undef TP_STATUS_MEANING
  }
  return "unknown status";
}

int tp_status_exit(tp_status status) {
  switch (status) {
#define TP_STATUS_EXIT(name, number, exit_status, meaning)                                         \
  case name:                                                                                       \
    return exit_status;
    TP_STATUS_LIST(TP_STATUS_EXIT)
#undef TP_STATUS_EXIT
  }
  enum { SYSTEM_FAILED = 5 }; /* a number that is no status: the caller's memory is in disorder */
  return SYSTEM_FAILED;
}
