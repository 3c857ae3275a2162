/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* glibc's getopt asks for translations by this name, where it is not part of glibc; here messages
 * stay English. */

#include "config.h"
