/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Settings, "KEY=FORMULA": a number of a scene that is to be what the formula says as if it stood
 * there in the file. A scene keeps those that it was made by, and its solution tells them. */

#ifndef TP_SCENE_SETTING_H
#define TP_SCENE_SETTING_H

#include "scene/scene.h"

/* How long the key before the first = is; the whole, where there is none. */
size_t tp_setting_key_length(const char *setting);

/* The value of the formula; NULL: no parameters. */
TP_MUST_USE tp_status tp_setting_evaluate(fmpq_t value, const char *setting,
                                          const tp_parameters *parameters, tp_message *message);

#endif
