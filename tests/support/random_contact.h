/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a drawn scene has where block and base meet. */

#ifndef TP_TEST_RANDOM_CONTACT_H
#define TP_TEST_RANDOM_CONTACT_H

#include "random_scenes.h"

/* All vertices 2^shift times as fine, those of the underside up to one step off: kinks of this part
 * of the block. The base follows where it has the same vertices. */
void random_contact_draw_kinks(random_scene *scene, random_numbers *state);

/* Rock past an end of the profile that rises beside the block, upright or leaning off, and goes on
 * level above. */
void random_contact_draw_wall(random_scene *scene, random_numbers *state);

#endif
