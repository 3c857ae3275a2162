/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parts of the page of a solid. */

#ifndef TP_REPORT_SOLID_PAGE_H
#define TP_REPORT_SOLID_PAGE_H

#include "output/text.h"
#include "topple.h"

/* Digits of a tilt. */
enum { TP_SOLID_TILT_DIGITS = 8 };

/* Of a scene: what the solid does at its tilt; else nothing. */
void tp_text_solid_stances(tp_text *t, const tp_solid *solid);

/* Of a scene with contacts: what the solid does on them; else nothing. */
void tp_text_solid_contacts(tp_text *t, const tp_solid *solid);

/* Of a scene of a wedge: how safe it is; else nothing. */
void tp_text_solid_wedge(tp_text *t, const tp_solid *solid);

/* Whether it has the factor that the scene requires, where it requires one. */
void tp_text_solid_required(tp_text *t, const tp_solid *solid);

/* The tilt and the earthquake of a scene, a line. */
void tp_text_solid_loads(tp_text *t, const tp_solid *solid);

#endif
