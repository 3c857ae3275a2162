/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a survey in words. */

#ifndef TP_REPORT_BATCH_H
#define TP_REPORT_BATCH_H

#include "document/document.h"
#include "topple_batch.h"

/* A cell of a row, certain digits alone. */
typedef struct tp_batch_cell {
  char text[TP_NUMBER_SIZE + 16];
} tp_batch_cell;

/* "1.234", "unbounded", "none"; empty of a row without a case. */
tp_batch_cell tp_batch_fos(const tp_batch_row *row);
tp_batch_cell tp_batch_required(const tp_batch_row *row);
/* With the sign of degrees. */
tp_batch_cell tp_batch_margin(const tp_batch_row *row);
tp_batch_cell tp_batch_dip(const tp_batch_row *row);
/* required/FoS. */
tp_batch_cell tp_batch_utilisation(const tp_batch_row *row);
/* Has a row a load case? Then these have columns. */
bool tp_batch_has_cases(const tp_batch *batch);
/* Against which motion the factor is. */
const char *tp_batch_against(const tp_batch_row *row);

/* "5 blocks: 2 fail, 1 is undecided, 2 hold." */
void tp_batch_add_sum(tp_text *text, const tp_batch *batch);

/* The page: the sum, the table, remarks, and of each picture a figure. `pictures` has one for each
 * row, taken over; one that is empty is none. */
void tp_batch_build_page(tp_document *document, const tp_batch *batch, tp_picture *pictures);

#endif
