/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reader of accelerograms in the PEER format .at2. */

#ifndef TP_SCENE_RECORD_AT2_H
#define TP_SCENE_RECORD_AT2_H

#include "scene/record_source.h"

/* An accelerogram as PEER's .at2 (scene/record.h). */
TP_MUST_USE tp_status tp_record_read_at2(tp_polyline *record, tp_record_source *source);

#endif
