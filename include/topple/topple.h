/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Topple: does a rock block stand, slide or topple on its base, and at which tilt?
 *
 * The whole public library. A scene is read from a file, or built in memory (topple_scene.h),
 * solved, and reported:
 *
 *     tp_scene *scene = NULL;
 *     tp_solution *solution = NULL;
 *     tp_message message;
 *     tp_status status = tp_scene_read(&scene, "block.yaml", &message);
 *     if (status == TP_OK) {
 *       const tp_solve_options options = tp_solve_options_default();
 *       status = tp_solve(&solution, scene, &options, &message);
 *     }
 *     if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
 *     tp_solution_free(solution);
 *     tp_scene_free(scene);
 *
 * Frame: x along the mean plane of the base, up-dip to the right; y normal to it, up. Tilting
 * towards the left lowers the side x -> -infinity. SI units; angles in degrees where the name
 * says so. Every computed number is a tp_bounded: the truth lies within `error` of `value`.
 * The library never prints, exits or aborts by itself and keeps no mutable globals. Where memory is
 * exhausted its own requests, libyaml's and CGAL's end a call with TP_OUT_OF_MEMORY; FLINT and GMP
 * print and abort the process, so sizes are bounded before they are called. A program that wants
 * another end gives them functions that do not return without memory, before its first call:
 * __flint_set_memory_functions and mp_set_memory_functions, as src/applications/cli/memory.c does.
 * What FLINT keeps for the next call of a thread is given back by tp_cleanup().
 *
 * What the calling thread has set stays as it is: every call puts the locale, the floating-point
 * environment (rounding, traps, flushing to zero) and MPFR's range of exponents aside, and brings
 * them back as it returns; one that is left by a jump, from a function for memory, does not.
 * Threads may call at the same time, each on different objects; a scene that nobody changes or
 * frees may be read by several at once. Options begin with their size, which `…_default()` fills
 * in: a program that was compiled with an older library, whose structs of options end sooner, takes
 * the defaults for what it does not know; a size of 0, or above what the library knows, is bad
 * input. No pointer may be NULL, but for a message, which then is not written, and what a _free
 * function is given; a call that gets one is TP_BAD_INPUT, and its message names it. */

#ifndef TOPPLE_H
#define TOPPLE_H

#include "topple_accuracy.h"
#include "topple_batch.h"
#include "topple_block_system.h"
#include "topple_blocks.h"
#include "topple_chart.h"
#include "topple_converge.h"
#include "topple_derive.h"
#include "topple_explain.h"
#include "topple_figure.h"
#include "topple_find.h"
#include "topple_generate.h"
#include "topple_load_cases.h"
#include "topple_profile.h"
#include "topple_scene.h"
#include "topple_sheet.h"
#include "topple_solid.h"
#include "topple_solve.h"
#include "topple_study.h"
#include "topple_sweep.h"
#include "topple_tilt.h"
#include "topple_tilt_test.h"
#include "topple_verify.h"

#endif
