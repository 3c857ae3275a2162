/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reading values of a scene out of its nodes. Shared by the readers of its sections. */

#ifndef TP_READ_H
#define TP_READ_H

#include "scene/node.h"
#include "scene/scene.h"

typedef struct tp_reader {
  tp_scene *scene;
  tp_message *message;
} tp_reader;

/* An expression; `name` is the key or the role of the value in messages. */
TP_MUST_USE tp_status tp_read_number(const tp_reader *reader, fmpq_t value, const tp_node *node,
                                     const char *name);

/* A number that must be above zero. */
TP_MUST_USE tp_status tp_read_positive(const tp_reader *reader, fmpq_t value, const tp_node *node,
                                       const char *name);

/* A quantity that may be missing (`node` NULL: not given). */
TP_MUST_USE tp_status tp_read_quantity(const tp_reader *reader, tp_quantity *quantity,
                                       const tp_node *node, const char *name);
TP_MUST_USE tp_status tp_read_bool(const tp_reader *reader, bool *value, const tp_node *node,
                                   const char *name);

/* A point, [x, y]. */
TP_MUST_USE tp_status tp_read_point(const tp_reader *reader, tp_quantity *x, tp_quantity *y,
                                    const tp_node *node, const char *name);

/* A list of [x, y], or the name of a CSV file beside the scene. */
TP_MUST_USE tp_status tp_read_points(const tp_reader *reader, tp_polyline *line,
                                     const tp_node *node, bool closed, const char *name);

/* The child that a mapping must have. */
TP_MUST_USE tp_status tp_read_required(const tp_reader *reader, const tp_node **child,
                                       const tp_node *mapping, const char *key,
                                       const char *example);

TP_MUST_USE tp_status tp_read_block(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_arcs(const tp_reader *reader, const tp_node *node);
void tp_arcs_clear(tp_block_description *block);
TP_MUST_USE tp_status tp_read_rounded(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_loads(const tp_reader *reader, const tp_node *node);
void tp_loads_description_init(tp_loads_description *loads);
void tp_loads_description_clear(tp_loads_description *loads);
/* An angle in degrees within [0, 90], 90 itself excluded or not; `node` NULL: not given. */
TP_MUST_USE tp_status tp_read_angle(const tp_reader *reader, tp_quantity *angle,
                                    const tp_node *node, const char *name, bool excluded);

/* The keys friction_angle_deg and friction of the scene. */
TP_MUST_USE tp_status tp_read_friction(const tp_reader *reader, const tp_node *root);
void tp_friction_description_init(tp_friction_description *friction);
void tp_friction_description_clear(tp_friction_description *friction);
TP_MUST_USE tp_status tp_read_frame(const tp_reader *reader, const tp_node *node);
TP_MUST_USE tp_status tp_read_base(const tp_reader *reader, const tp_node *node);

/* Notes on numbers of the scene that look as if they stood in another unit. */
TP_MUST_USE tp_status tp_read_cautions(const tp_reader *reader);

/* Fail at a node. */
tp_status tp_read_fail(const tp_reader *reader, const tp_node *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
