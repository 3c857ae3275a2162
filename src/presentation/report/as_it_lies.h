/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is said of a block that lies at its place, on a slope or in the frame of the world: whether
 * it stands as it lies, what may begin, and by how much the slope may steepen. */

#ifndef TP_REPORT_AS_IT_LIES_H
#define TP_REPORT_AS_IT_LIES_H

#include "report/page.h"

/* Does the onset tell it of this case? */
bool tp_page_lies_known(const tp_solution *solution, const tp_case *own);

/* Sentences, the most important first; tilts that are less than its own come last, and only those
 * at which it would move. */
void tp_page_add_as_it_lies(tp_page *page, const tp_case *own);

/* "135° SE": the azimuth of a side of the section, where the scene says how it lies on the map;
 * else false. */
bool tp_text_azimuth(char out[TP_NUMBER_SIZE + 8], const tp_frame_result *frame, bool left);

#endif
