/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of blocks as worksheets (Office Open XML, ECMA-376): one read as CSV, and one written. In
 * a library of its own, which alone needs libzip, expat and libxlsxwriter; the program loads it
 * where such a file is named. */

#ifndef TP_XLSX_XLSX_H
#define TP_XLSX_XLSX_H

#include "topple_batch.h"

/* The first worksheet of the workbook in `path` as CSV, to be freed, with the row n of the sheet on
 * line n. Of a formula the value that was saved with it; a number as it is stored, in decimals; a
 * date as words ("2026 November 25"), which are no number. Bad input where it is no workbook, where
 * a part of it unpacks to more than 128 MB or to more than a thousand times its size, and where it
 * declares a document type, as no workbook does. */
TP_MUST_USE tp_status tp_xlsx_read(char **csv, const char *path, tp_message *message);

/* The table of the batch into the file `path`, whole or not at all: names and remarks are texts,
 * whatever they begin with. The same table gives the same bytes. */
TP_MUST_USE tp_status tp_xlsx_write(const char *path, const tp_batch *batch, tp_message *message);

#endif
