/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A page for a terminal, 80 columns wide: numbers in the scene's units, every printed digit
 * certain. */

#ifndef TP_REPORT_PAGE_H
#define TP_REPORT_PAGE_H

#include "output/text.h"

typedef struct tp_page {
  tp_text text;
  const tp_solution *solution;
} tp_page;

/* A length, or a moment per unit of force, in the scene's length unit. */
const char *tp_page_length(const tp_page *page, char out[TP_NUMBER_SIZE], tp_bounded metres,
                           int digits);

/* A coordinate in the scene's length unit, to about a millionth of the block's size, so that points
 * of a block far from the origin stay apart. */
const char *tp_page_coordinate(const tp_page *page, char out[TP_NUMBER_SIZE], tp_bounded metres);

/* Block, contact and friction of the scene: its label, then nine columns in what is said of it. */
void tp_page_add_input(tp_page *page);

/* An angle with up to three decimals that are not zero. */
const char *tp_page_degrees(char out[TP_NUMBER_SIZE], tp_bounded angle);

/* A factor of safety, or what stands for it where it is no number. */
const char *tp_page_fos(char out[TP_NUMBER_SIZE], tp_fos fos);

/* How a tie is known, as the end of a sentence: exactly, or as far as so many bits tell. */
void tp_page_add_tie(tp_page *page, long bits);

/* A force in N, or a stress in Pa: in the unit that the scene asks for, else in thousands where it
 * is large. */
void tp_page_add_force(tp_page *page, tp_bounded newtons);
void tp_page_add_stress(tp_page *page, tp_bounded pascals);

/* A number of SI in a unit that the scene may ask for: its value is converted, and its bound
 * outward; as it is where none is asked for. */
tp_bounded tp_page_in(tp_bounded number, tp_result_unit unit);

/* " about pivot 1, the valley at (0, 0)" of a pivot's place, " about (x, y)" of another. */
void tp_page_add_centre(tp_page *page, const tp_case *own, tp_bounded x_m, tp_bounded y_m);

#endif
