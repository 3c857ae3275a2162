/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Worksheets of topple solve --batch, by a library that is loaded where one is named. */

#ifndef TP_CLI_BATCH_XLSX_H
#define TP_CLI_BATCH_XLSX_H

#include "topple.h"

/* Does the name end in .xlsx? */
bool tp_cli_is_xlsx(const char *path);

/* Can they be written? Told before anything is computed. */
TP_MUST_USE tp_status tp_cli_may_write_xlsx(tp_message *message);

/* tp_xlsx_read and tp_xlsx_write (xlsx/xlsx.h). */
TP_MUST_USE tp_status tp_cli_read_xlsx(char **csv, const char *path, tp_message *message);
TP_MUST_USE tp_status tp_cli_write_xlsx(const char *path, const tp_batch *batch,
                                        tp_message *message);

#endif
