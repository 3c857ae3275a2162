/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block as its author gave it, before it is turned or set down: messages on what is no block
 * speak of those coordinates. */

#ifndef TP_PROBLEM_AS_GIVEN_H
#define TP_PROBLEM_AS_GIVEN_H

#include "block/section.h"

/* Is it a block, and which lattice do it and its base (NULL: none) lie on? On failure `lattice` is
 * cleared. */
TP_MUST_USE tp_status tp_as_given_check(tp_lattice *lattice, const tp_scene *scene,
                                        const tp_section *section, const tp_polyline *base,
                                        tp_message *message);

#endif
