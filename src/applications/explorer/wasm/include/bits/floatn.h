/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* glibc's <argp.h> asks which formats its long doubles have had; here there has been one. */
