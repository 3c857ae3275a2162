/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a solution of many blocks does not say by itself, though a user may take it to. */

#ifndef TP_BLOCK_SYSTEM_SYSTEM_CAUTIONS_H
#define TP_BLOCK_SYSTEM_SYSTEM_CAUTIONS_H

#include "scene/scene.h"
#include "topple_block_system.h"

/* `falls_at_rest`: an earthquake holds blocks that collapse before it shakes and after. */
TP_MUST_USE tp_status tp_system_add_cautions(tp_block_system *system, const tp_scene *scene,
                                             bool falls_at_rest, tp_message *message);

#endif
