/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene solved at its own tilt, and what that tells of it at further ones
 * (evaluation/further.h). */

#ifndef TP_STABILITY_TILTS_H
#define TP_STABILITY_TILTS_H

#include "scene/scene.h"

/* Further tilts, above -90 and below 90 degrees, and solutions at them: what a solve of the scene
 * with that tilt tells, but for notes, settings and effects. NULL where one is needed to tell. */
typedef struct tp_tilts {
  size_t count;
  const fmpq *degrees;
  tp_solution **solutions; /* room for them; the caller's to free where the status is TP_OK */
} tp_tilts;

/* Of a scene that is not turned from the world's frame. */
TP_MUST_USE tp_status tp_solve_tilts(tp_solution **solution, tp_tilts *tilts, const tp_scene *scene,
                                     const tp_solve_options *options, tp_message *message);

/* As tp_solve with options that are complete, but without the cautions for which a scene is solved
 * twice: for searches and samples, of which nobody reads them. */
TP_MUST_USE tp_status tp_solve_numbers(tp_solution **solution, const tp_scene *scene,
                                       const tp_solve_options *options, tp_message *message);

#endif
