/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A locale with a decimal comma, COMMA_LOCALE, for programs that set it. */

#ifndef TP_TEST_COMMA_LOCALE_H
#define TP_TEST_COMMA_LOCALE_H

#define COMMA_LOCALE "xx_XX"

/* Make it in a folder, which LOCPATH then names. */
void comma_locale_make(const char *folder);

#endif
