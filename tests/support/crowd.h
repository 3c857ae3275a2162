/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Threads that run one function at the same time, each with a number of its own. */

#ifndef TP_TEST_CROWD_H
#define TP_TEST_CROWD_H

enum { THREADS = 8 };

typedef struct crowd crowd;
typedef void crowd_run(crowd *among, int number);

/* From the main thread, which waits for all of them; they begin together. */
void run_together(crowd_run *run);

/* Within: wait until all are here, where a thread takes what another one made. */
void crowd_wait(crowd *among);

#endif
