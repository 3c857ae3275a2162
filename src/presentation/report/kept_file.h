/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A report of a scene as a file. */

#ifndef TP_REPORT_KEPT_FILE_H
#define TP_REPORT_KEPT_FILE_H

#include "scene/scene.h"

/* Written whole or not at all, and over no file of the scene. `what` was to be kept in memory. */
TP_MUST_USE tp_status tp_report_keep_file(const tp_scene *scene, const char *path, const char *data,
                                          size_t length, const char *what, tp_message *message);

#endif
