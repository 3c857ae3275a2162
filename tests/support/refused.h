/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the tests of refused arguments share. */

#ifndef TP_TEST_REFUSED_H
#define TP_TEST_REFUSED_H

#include "suite.h"

#include "topple.h"

#include <string.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name

static tp_message message;

/* An output that must not be written to. */
static char untouched;
#define UNTOUCHED(type) ((type *)(void *)&untouched)

/* The call is refused, and says what of. */
#define REFUSED(call, named)                                                                       \
  do {                                                                                             \
    message.text[0] = '\0';                                                                        \
    ck_assert_int_eq(call, TP_BAD_INPUT);                                                          \
    ck_assert_msg(strstr(message.text, named) != NULL, "%s: '%s'", #call, message.text);           \
  } while (false)

/* The same of a report, which has no message. */
#define UNWRITTEN(call) ck_assert_int_eq(call, TP_BAD_INPUT)

#endif
