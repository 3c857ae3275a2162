/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reader of accelerograms as CSV with units in the header. */

#ifndef TP_SCENE_RECORD_CSV_H
#define TP_SCENE_RECORD_CSV_H

#include "scene/record_source.h"

/* An accelerogram as CSV with units in its header (scene/record.h); `column` counts from 1. */
TP_MUST_USE tp_status tp_record_read_csv(tp_polyline *record, tp_record_source *source,
                                         long column);

#endif
