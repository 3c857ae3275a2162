/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rays and modes of a section (solid_section.h). */

#ifndef TP_SOLID_CONTACTS_SOLID_SECTION_MODES_H
#define TP_SOLID_CONTACTS_SOLID_SECTION_MODES_H

#include "solid_contacts/solid_section_parts.h"

/* False when memory is exhausted. */
TP_MUST_USE bool tp_solid_section_find_modes(tp_solid_section *section);

#endif
