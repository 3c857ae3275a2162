/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What pages and figures say of a scene of many blocks in the same words. */

#ifndef TP_REPORT_SYSTEM_WORDS_H
#define TP_REPORT_SYSTEM_WORDS_H

#include "block_system/governing_case.h"
#include "output/text.h"

/* "Towards the left, at a tilt of 20°" */
void tp_text_system_stance(tp_text *text, const tp_block_system *system, const tp_system_case *of);

/* "greatest tilt that forces can hold", and what that is. */
const char *tp_text_system_limit_name(const tp_block_system *system);
void tp_text_system_limit(tp_text *text, const tp_system_case *of);

/* The factor of safety, rounded down: a number, "above 1000", "unbounded", "none", or its bounds
 * where proofs leave it open. With its definition and mechanism: ", driving loads, slides". */
void tp_text_system_safety(tp_text *text, const tp_system_safety *safety);
void tp_text_system_against(tp_text *text, const tp_system_safety *safety);

/* Likewise by one definition, of a state of motion that its verdict tells. */
void tp_text_system_bounds(tp_text *text, const tp_system_bounds *bounds);

/* Up to where forces can hold the blocks, an upper bound of the factor: by strength a number,
 * "above 1000", "none: …" or "undecided"; on what drives a number and what begins beyond it, "above
 * 1000", or why it is none. */
void tp_text_system_factor(tp_text *text, const tp_system_case *of);
void tp_text_system_driving(tp_text *text, const tp_system_case *of);

/* Is the critical acceleration stated? Not of blocks that move before an earthquake shakes. Is a
 * motion proven to begin at less? */
bool tp_system_case_has_critical_acceleration(const tp_system_case *of);
bool tp_system_case_shakes_sooner(const tp_system_case *of);

/* A force in kN; what is less than the search tells of the largest is nothing. */
double tp_text_system_force_kn(double newtons, const tp_system_case *of);

/* With how many significant digits coordinates are told: five of where contacts lie among each
 * other, however far from the origin that is. */
int tp_text_system_digits(const tp_block_system *system);

/* Of which state the collapse is: "with strength divided by the factor", "at the greatest dip". */
const char *tp_text_system_collapse(const tp_block_system *system, const tp_system_case *of);

/* Lines on motions that begin though forces can hold the blocks: up to where they are excluded,
 * from where on one is proven, or why they were not looked for. */
void tp_text_system_beginnings(tp_text *text, const tp_block_system *system,
                               const tp_system_case *of);

/* What strength is divided by where a motion is proven to begin. */
void tp_text_system_moving(tp_text *text, const tp_system_case *of);

/* The heading of the motion that is proven, with what strength is divided by there. */
void tp_text_system_start(tp_text *text, const tp_system_case *of);

/* The support that is asked for: what to design for, or why there is none; and what the limit of
 * forces says, which is optimistic: false where that adds nothing. */
void tp_text_system_design_support(tp_text *text, const tp_system_case *of);
bool tp_text_system_optimistic_support(tp_text *text, const tp_system_case *of);
/* With which forces no motion can begin, and with which one can: false where that was not looked
 * for. */
bool tp_text_system_standing_support(tp_text *text, const tp_system_case *of);

#endif
