/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parts of the page of a solid. */

#ifndef TP_REPORT_SOLID_PAGE_H
#define TP_REPORT_SOLID_PAGE_H

#include "output/text.h"
#include "topple.h"

/* Digits of a tilt. */
enum { TP_SOLID_TILT_DIGITS = 8 };

/* Of a scene, in a few sentences: whether it stands at its tilt, how safely, and at which tilt it
 * moves. */
void tp_text_solid_answer(tp_text *t, const tp_solid *solid);
void tp_text_solid_answer_wrapped(tp_text *t, const tp_solid *solid); /* and an empty line */

/* "1.234", or why it is no number, with its bounds; rounded to the safe side. */
void tp_text_solid_factor(tp_text *t, const tp_solid_safety *safety, int digits);

/* Can it be held on its contacts, and can a motion begin? A sentence. */
const char *tp_text_solid_held(const tp_solid_contacts *contacts);

/* Where it was mended: the gaps that were closed; else nothing. */
void tp_text_solid_repair(tp_text *t, const tp_solid *solid);

/* Where it was thinned: what is left; else nothing. */
void tp_text_solid_thinning(tp_text *t, const tp_solid *solid);

/* What the first column of bands is, with its unit: band, or below, the height of a plane that cuts
 * it. */
enum { TP_SOLID_BAND_SIZE = 16 };
const char *tp_text_solid_band(char text[TP_SOLID_BAND_SIZE], const tp_solid *solid);
static inline const char *tp_text_solid_band_word(const tp_solid *solid) {
  return solid->has_below ? "below" : "band";
}

/* Of a scene: what the solid does at its tilt; else nothing. */
void tp_text_solid_stances(tp_text *t, const tp_solid *solid);

/* Of a scene with contacts: what the solid does on them; else nothing. */
void tp_text_solid_contacts(tp_text *t, const tp_solid *solid);

/* Of a scene with a mesh of the ground: its bands; else nothing. */
void tp_text_solid_ground(tp_text *t, const tp_solid *solid);

/* Do some forces hold it? */
bool tp_solid_is_held(const tp_solid_contacts *contacts);

/* The force of a contact across and along the surface there, in shares of the weight. */
typedef struct tp_contact_shares {
  double across, along;
} tp_contact_shares;
tp_contact_shares tp_solid_contact_shares(const tp_solid_contact *contact);

/* "slides along (x, y, z)" */
void tp_text_solid_motion(tp_text *t, const tp_solid_motion *motion);

/* Of a scene of a wedge: how safe it is; else nothing. */
void tp_text_solid_wedge(tp_text *t, const tp_solid *solid);

/* The way in which a wedge slides: "along the line of both joints". */
const char *tp_text_solid_wedge_way(const tp_solid_wedge *wedge);
const char *tp_text_solid_wedge_on(const char *slides_on);

/* Whether it has the factor that the scene requires, where it requires one. */
void tp_text_solid_required(tp_text *t, const tp_solid *solid);

/* The tilt and the earthquake of a scene, a line. */
void tp_text_solid_loads(tp_text *t, const tp_solid *solid);

#endif
