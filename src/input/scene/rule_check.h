/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks of the numbers of a profile rule: bounds, seeds and measures of roughness. */

#ifndef TP_SCENE_RULE_CHECK_H
#define TP_SCENE_RULE_CHECK_H

#include "scene/profile_rule.h"

#include <stdint.h>

/* A number within [low, high], or strictly within. */
TP_MUST_USE tp_status tp_check_within(const tp_quantity *quantity, const char *name,
                                      const char *low, const char *high, bool strictly,
                                      tp_message *message);
TP_MUST_USE tp_status tp_check_seed(uint64_t *seed, const tp_quantity *quantity,
                                    tp_message *message);
/* How rough a profile is by the one number that is given: an RMS height, or Z2, also for a JRC. */
TP_MUST_USE tp_status tp_check_roughness(fmpq_t size, bool *is_height, const tp_quantity *by,
                                         tp_message *message);

#endif
