/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base and the contact, as text and as JSON. */

#ifndef TP_REPORT_CONTACT_H
#define TP_REPORT_CONTACT_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_contact(tp_page *page);

/* The keys `frame` and `contact` of a case. */
void tp_json_rest(tp_json *json, const tp_rest_result *rest);
void tp_json_within(tp_json *json, const tp_within_result *within);
void tp_json_frame(tp_json *json, const tp_frame_result *frame);
void tp_json_contact(tp_json *json, const tp_contact_result *contact, bool has_weight);

#endif
