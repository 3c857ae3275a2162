/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Splits a setting at its equals sign and evaluates its formula with the scene's parameters. */

#include "scene/setting.h"

#include <string.h>

size_t tp_setting_key_length(const char *setting) {
  return strcspn(setting, "=");
}

tp_status tp_setting_evaluate(fmpq_t value, const char *setting, const tp_parameters *parameters,
                              tp_message *message) {
  const char *formula = setting + tp_setting_key_length(setting) + 1;
  return tp_expression_evaluate(value, formula, (tp_place){setting, 0, 0}, parameters, message);
}
