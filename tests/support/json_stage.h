/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the writer of JSON is held to: the very bytes, or nothing. */

#ifndef TP_TEST_JSON_STAGE_H
#define TP_TEST_JSON_STAGE_H

#include "output/json.h"
#include "suite.h"

#include <stdlib.h>

static inline void prints(tp_json *j, const char *expected) {
  char *text = NULL;
  ck_assert_int_eq(tp_json_finish(j, &text), TP_OK);
  ck_assert_str_eq(text, expected);
  free(text);
}

static inline void is_refused(tp_json *j) {
  char *text = NULL;
  ck_assert_int_eq(tp_json_finish(j, &text), TP_SYSTEM_FAILED);
  ck_assert_ptr_null(text);
  ck_assert_ptr_null(j->text.data);
}

#endif
