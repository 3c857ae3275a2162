/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Meaning and exit status of every status, from the one list in topple_basics.h. */

#include "topple.h"

const char *tp_status_meaning(tp_status status) {
  switch (status) {
#define TP_STATUS_MEANING(name, exit_status, meaning)                                              \
  case name:                                                                                       \
    return meaning;
    TP_STATUS_LIST(TP_STATUS_MEANING)
#undef TP_STATUS_MEANING
  }
  return "unknown status";
}

int tp_status_exit(tp_status status) {
  switch (status) {
#define TP_STATUS_EXIT(name, exit_status, meaning)                                                 \
  case name:                                                                                       \
    return exit_status;
    TP_STATUS_LIST(TP_STATUS_EXIT)
#undef TP_STATUS_EXIT
  }
  enum { SYSTEM_FAILED = 5 }; /* a number that is no status: the caller's memory is in disorder */
  return SYSTEM_FAILED;
}
