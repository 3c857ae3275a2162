/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the answer depend on the distance of 'contact: {within: …}'? */

#ifndef TP_STABILITY_HALF_TOLERANCE_H
#define TP_STABILITY_HALF_TOLERANCE_H

#include "output/text.h"
#include "scene/scene.h"
#include "topple.h"

/* The factor of safety of a direction in a caution: a number, or why there is none. */
const char *tp_caution_fos(char out[TP_NUMBER_SIZE], const tp_case *own);

/* Solve a scene. */
typedef tp_status tp_half_tolerance_solve(tp_solution **solution, const tp_scene *scene,
                                          const tp_solve_options *options, tp_message *message);

/* Solves the scene once more with half of its distance. Adds a caution to the notes of `solution`,
 * which is that of the whole distance, where the verdict of a direction is another one, or a factor
 * of safety or the tilt of the first motion differs by more than a hundredth. Nothing is done where
 * the scene gives no distance. TP_OUT_OF_MEMORY alone is a failure. */
TP_MUST_USE tp_status tp_half_tolerance_check(tp_solution *solution, const tp_scene *scene,
                                              const tp_solve_options *options,
                                              tp_half_tolerance_solve *solve, tp_message *message);

#endif
