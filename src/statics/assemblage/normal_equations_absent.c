/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In place of normal_equations.c, where Topple is built without CXSparse. */

#include "assemblage/normal_equations.h"

#include <stdio.h>
#include <string.h>

tp_status tp_normal_equations_init(tp_normal_equations *n, const tp_force_program *p,
                                   tp_message *message) {
  memset(n, 0, sizeof *n);
  (void)p;
  snprintf(
      message->text, sizeof message->text,
      "forces between many blocks need CXSparse, without which this program was built: install "
      "libsuitesparse-dev and build it anew");
  return TP_DEPENDENCY_FAILED;
}

void tp_normal_equations_clear(tp_normal_equations *n) {
  (void)n;
}

bool tp_normal_equations_factorise(tp_normal_equations *n, const double *diagonal) {
  (void)n;
  (void)diagonal;
  return false;
}

void tp_normal_equations_solve(tp_normal_equations *n, double *rows) {
  (void)n;
  (void)rows;
}
