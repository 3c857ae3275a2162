/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From which loads and strengths on a motion can begin within a section (solid_section.h). */

#ifndef TP_SOLID_CONTACTS_SOLID_SECTION_ONSET_H
#define TP_SOLID_CONTACTS_SOLID_SECTION_ONSET_H

#include "solid_contacts/solid_section.h"

/* Do forces hold the load? Exactly, with tan(phi) as it is rounded. False when memory is exhausted.
 */
TP_MUST_USE bool tp_solid_section_holds(bool *holds, const tp_solid_section *section,
                                        const tp_hold_load *load);

/* From where on a motion can begin along a number x, seen from `from`: where one can begin there,
 * the lower end of the interval of such numbers, else the first number above. */
typedef struct tp_solid_section_onset {
  bool moves_at_from;
  bool is_endless;         /* not moving there, and at no number above */
  double x;                /* if not endless; to 1e-12 of itself and of one */
  double twist[TP_WRENCH]; /* if not endless: of the motion that begins */
} tp_solid_section_onset;

/* Under R + x D, x from 0 on; all numbers from `limit` on are known to move it. */
TP_MUST_USE bool tp_solid_section_driving(tp_solid_section_onset *onset,
                                          const tp_solid_section *section, const tp_hold_load *rest,
                                          const tp_hold_load *way, double from, double limit);
/* With strength divided by x, seen from one. */
TP_MUST_USE bool tp_solid_section_strength(tp_solid_section_onset *onset,
                                           const tp_solid_section *section,
                                           const tp_hold_load *load, double limit);

#endif
