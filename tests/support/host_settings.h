/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a program may have set in its thread before it calls the library. */

#ifndef TP_TEST_HOST_SETTINGS_H
#define TP_TEST_HOST_SETTINGS_H

/* What a program may have set, as it is in this thread. */
typedef struct setting {
  int rounding, traps;
  unsigned control, other; /* of the SSE unit: denormals, too; of the x87 */
  char decimal_point[8];
  long exponent_least, exponent_most;
} setting;

setting setting_now(void);

void as_it_comes(void);
void decimal_comma(void);
void decimal_comma_of_the_thread(void);
void rounding_up(void);
void flushing_to_zero(void);

/* What decimal_comma_of_the_thread made. */
void give_locale_back(void);

typedef struct named_setting {
  const char *name;
  void (*set)(void);
} named_setting;

/* All of them, `as it comes` first. */
enum { SETTINGS = 12 };
extern const named_setting settings[SETTINGS];

#endif
