/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signals while topple study runs. */

#ifndef TP_CLI_STUDY_SIGNAL_H
#define TP_CLI_STUDY_SIGNAL_H

/* The signal that interrupted the study, or 0. The first one is caught, a second one ends the
 * program at once. */
int tp_cli_study_signal(void);
void tp_cli_study_catch(void);

#endif
