/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The roles of a drawing's objects, and what a chain of joined pieces must be for one: the block is
 * one closed outline, the base one open line that runs from left to right, holes and parts are
 * closed; what is not says so. */

#ifndef TP_FORMAT_ROLE_H
#define TP_FORMAT_ROLE_H

#include "format/drawing.h"

typedef enum tp_drawing_role {
  TP_DRAWING_UNUSED,
  TP_DRAWING_BLOCK,
  TP_DRAWING_BASE,
  TP_DRAWING_HOLE,
  TP_DRAWING_PART
} tp_drawing_role;

/* "block", "base", "hole", "part", "not used". */
const char *tp_drawing_role_name(tp_drawing_role role);

/* Is a chain, one of `chains`, what its role wants? */
TP_MUST_USE tp_status tp_role_check(const tp_drawing *chains, const tp_drawing_object *chain,
                                    tp_drawing_role role, tp_message *message);

/* Has no second chain the role of the block, or of the base? `roles` are those of the chains. */
TP_MUST_USE tp_status tp_role_check_only(const tp_drawing *chains, const tp_drawing_role *roles,
                                         tp_drawing_role role, tp_message *message);

/* A chain that was checked: closed where its role wants it, the base from left to right. False when
 * memory is exhausted. */
TP_MUST_USE bool tp_role_finish(tp_drawing_object *chain, tp_drawing_role role);

#endif
