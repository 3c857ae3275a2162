/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a result is told with: notes and cautions on the settings and the shaking. */

#ifndef TP_TILT_WORDS_H
#define TP_TILT_WORDS_H

#include "scene/scene.h"
#include "topple_tilt_test.h"

TP_MUST_USE tp_status tp_tilt_notes(tp_tilt_test *test, const tp_scene *scene, tp_message *message);

#endif
