/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Units that a scene asks for in its reports: names and factors of units_table.h. */

#ifndef TP_SCENE_READING_RESULT_UNIT_H
#define TP_SCENE_READING_RESULT_UNIT_H

#include "scene/scene.h"

/* Of that name and kind; NULL: there is none. */
const tp_unit *tp_result_unit_find(tp_unit_kind kind, const char *name);

/* Of that name, whatever it is of. */
const tp_unit *tp_result_unit_named(const char *name);

/* The names of a kind, or of all, for a message: "N, kN, MN". */
void tp_result_unit_names(char *list, size_t size, bool all, tp_unit_kind kind);

/* What reports print in, where the scene asks for it. */
tp_result_units tp_result_units_of(const tp_scene *scene);

#endif
