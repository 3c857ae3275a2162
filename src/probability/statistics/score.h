/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many deviations to either side an interval of a confidence within (0, 1) takes in. */

#ifndef TP_STATISTICS_SCORE_H
#define TP_STATISTICS_SCORE_H

#include <stddef.h>

/* Of a normal variable, where 1 - confidence is shared among so many intervals. */
double tp_normal_score(double confidence, size_t intervals);

/* Of Student's t with so many degrees of freedom, at least 1; beyond 20 000 the normal one, from
 * which it differs by less than 1e-4. */
double tp_student_score(double confidence, double freedom);

#endif
