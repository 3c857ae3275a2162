/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is the library that solved of the same version as this one, which draws? */

#ifndef TP_FIGURE_VERSION_H
#define TP_FIGURE_VERSION_H

#include "common/message.h"

/* A program that is linked with both may find them of two versions when it begins. One that loads
 * them itself, as Python, compares tp_version and tp_figure_version. */
TP_MUST_USE tp_status tp_figure_check_version(tp_message *message);

/* At the head of each entry. */
#define TP_REFUSE_OTHER_VERSION(message)                                                           \
  do {                                                                                             \
    const tp_status tp_version_checked = tp_figure_check_version(message);                         \
    if (tp_version_checked != TP_OK) return tp_version_checked;                                    \
  } while (0)

#endif
