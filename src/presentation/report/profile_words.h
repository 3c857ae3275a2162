/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the reports of a profile share. */

#ifndef TP_REPORT_PROFILE_WORDS_H
#define TP_REPORT_PROFILE_WORDS_H

#include "topple.h"

const char *tp_text_profile_origin(tp_profile_origin origin);
const char *tp_text_profile_series(tp_profile_series series);

#endif
