/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "draws_stage.h"

#include <check.h>

const tp_draw_method methods[METHODS] = {TP_DRAW_MONTE_CARLO, TP_DRAW_LATIN_HYPERCUBE,
                                         TP_DRAW_SOBOL};
const double correlation[9] = {1, 0.6, -0.3, 0.6, 1, 0.2, -0.3, 0.2, 1};

tp_draws_walk *begun(const tp_draws *draws, uint64_t first) {
  tp_draws_walk *walk = NULL;
  tp_message message = {.text = ""};
  const tp_status status = tp_draws_begin(&walk, draws, first, NULL, &message);
  ck_assert_msg(status == TP_OK, "%s", message.text);
  return walk;
}
