/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base and the contact, as text and as JSON. */

#ifndef TP_REPORT_CONTACT_H
#define TP_REPORT_CONTACT_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_contact(tp_page *page);

/* Does it end where the underside grows steep or overhangs, which the scene does not say? */
bool tp_contact_is_cut_by_default(const tp_contact_result *contact);

#endif
