/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reading what a base profile is made by (generate/generate.h). `line` has its file and mark. */

#ifndef TP_READ_GENERATED_H
#define TP_READ_GENERATED_H

#include "scene/read.h"

#include <stdint.h>

/* A number that a map must have. */
TP_MUST_USE tp_status tp_read_rule_of(const tp_reader *reader, fmpq_t value, const tp_node *map,
                                      const char *key, const char *example, tp_rule rule);
/* One that it may have, within [low, high] or strictly within. */
TP_MUST_USE tp_status tp_read_within(const tp_reader *reader, fmpq_t value, const tp_node *map,
                                     const char *key, const char *low, const char *high,
                                     bool strictly);
/* The key `seed`, which must be there where something is drawn. */
TP_MUST_USE tp_status tp_read_seed(const tp_reader *reader, uint64_t *seed, const tp_node *map,
                                   bool draws);
/* The key `start`, [x, y], unless given the origin. */
TP_MUST_USE tp_status tp_read_start(const tp_reader *reader, fmpq_t x, fmpq_t y,
                                    const tp_node *map);

TP_MUST_USE tp_status tp_read_teeth_profile(const tp_reader *reader, tp_polyline *line,
                                            const tp_node *node);
TP_MUST_USE tp_status tp_read_self_affine(const tp_reader *reader, tp_polyline *line,
                                          const tp_node *node);

#endif
