/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The words of the program for what results are: one word for one thing, in every text that it
 * writes. */

#ifndef TP_REPORT_WORDS_H
#define TP_REPORT_WORDS_H

#include "topple.h"

/* What a factor of safety is that is no number above zero; NULL of one that is, and of one that was
 * not asked for. */
const char *tp_text_fos(tp_fos fos);

/* Likewise of a block of a survey: unbounded, none or undecided; NULL where the factor is a number,
 * or there is none. */
const char *tp_text_batch_fos(const tp_batch_row *row);

const char *tp_text_to_move(tp_mechanism mechanism); /* "slide and topple" */
const char *tp_text_motion(tp_mechanism mechanism);  /* "sliding and toppling" */
/* How the block of a case stands before its angle is told: "Tilted towards the left"; of a scene in
 * the frame of the world "As it lies, towards the left", the side that it can go to. */
const char *tp_text_stance(const tp_solution *solution, const tp_case *of);
/* Where tilts count from: "on level ground"; of a scene in the frame of the world "where its mean
 * plane is level", or "as it lies" where that is what they count from. */
const char *tp_text_level(const tp_solution *solution);
/* What a tilt from there on is: "tilted", in the frame of the world "steepened", or "turned" where
 * they count from how it lies, up-dip; and the same as a verb, "steepen" or "turn". */
const char *tp_text_tilted(const tp_solution *solution);
const char *tp_text_steepen(const tp_solution *solution);
/* Over the angles at which pivots let it topple: "topples at", "at a dip of" or "turned by". */
const char *tp_text_topples_at(const tp_solution *solution);
/* "at the scene's tilt", or in the frame of the world "as it lies". */
const char *tp_text_present(const tp_solution *solution);
/* How the table of a tilt test stands: "Tilted towards the left", "On level ground". */
const char *tp_text_table(const tp_tilt_test *test, const tp_tilt_case *of);

#endif
