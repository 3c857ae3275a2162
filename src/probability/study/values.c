/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers of a study file as exact expressions, rounded to nearest where a double is wanted, whole
 * numbers within bounds, and paths beside the study file. */

#define _GNU_SOURCE /* asprintf */
#include "study/values.h"

#include "common/outside.h"
#include "scene/expression.h"

#include <inttypes.h>
#include <mpfr.h> /* before what FLINT has for it */

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <flint/fmpq.h>

tp_status tp_study_fail(const tp_study_reader *reader, const tp_node *node, const char *format,
                        ...) {
  char text[600];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return tp_refuse(reader->message, TP_FAULT_RANGE, tp_node_place(node, reader->study->path), "%s",
                   text);
}

tp_status tp_study_fail_of(const tp_study_reader *reader, const tp_node *node, tp_status status,
                           const tp_message *inner) {
  return tp_fail(reader->message, status, tp_node_place(node, reader->study->path), "%s",
                 inner->text);
}

tp_status tp_study_read_exact(const tp_study_reader *reader, fmpq_t value, const tp_node *node,
                              const char *name) {
  if (node->kind != TP_NODE_SCALAR) {
    return tp_study_fail(reader, node, "'%s' takes a number", tp_quote_all(name).text);
  }
  tp_place place = tp_node_place(node, reader->study->path);
  place.column += node->text_offset;
  return tp_expression_evaluate(value, node->text, place, NULL, reader->message);
}

double tp_study_double(const fmpq_t value) {
  enum { DOUBLE = 53 };
  mpfr_t rounded;
  mpfr_init2(rounded, DOUBLE);
  fmpq_get_mpfr(rounded, value, MPFR_RNDN);
  const double number = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return number;
}

tp_status tp_study_read_number(const tp_study_reader *reader, double *value, const tp_node *node,
                               const char *name) {
  fmpq_t exact;
  fmpq_init(exact);
  const tp_status status = tp_study_read_exact(reader, exact, node, name);
  if (status == TP_OK) *value = tp_study_double(exact);
  fmpq_clear(exact);
  return status;
}

tp_status tp_study_read_whole(const tp_study_reader *reader, uint64_t *value, const tp_node *node,
                              const char *name, uint64_t least, uint64_t most) {
  fmpq_t exact;
  fmpq_init(exact);
  tp_status status = tp_study_read_exact(reader, exact, node, name);
  if (status == TP_OK) {
    const bool whole = fmpz_is_one(fmpq_denref(exact)) && fmpq_sgn(exact) >= 0 &&
                       fmpz_cmp_ui(fmpq_numref(exact), least) >= 0 &&
                       fmpz_cmp_ui(fmpq_numref(exact), most) <= 0;
    if (whole) {
      *value = fmpz_get_ui(fmpq_numref(exact));
    } else {
      status = tp_study_fail(reader, node, "'%s' takes a whole number from %" PRIu64 " to %" PRIu64,
                             tp_quote_all(name).text, least, most);
    }
  }
  fmpq_clear(exact);
  return status;
}

char *tp_study_beside(const tp_study *study, const char *name) {
  const char *slash = strrchr(study->path, '/');
  char *path = NULL;
  if (name[0] == '/' || slash == NULL) return strdup(name);
  if (asprintf(&path, "%.*s/%s", (int)(slash - study->path), study->path, name) < 0) return NULL;
  return path;
}
