/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene whose mated sole is levelled where its facets are short: what digitising adds to it, or
 * what an apparent friction angle has in it already, is no strength.
 *
 * A facet is short where it is shorter than the wavelength along the line between both ends of the
 * contact; of a friction angle that is apparent all are. Each stretch of short facets, one after
 * another along the contact, becomes the straight line between its ends, and both ends stay. Where
 * all of the contact is one stretch it becomes the line along its mean plane that leaves the area
 * of the block as it is:
 *
 *     y = m x + c,  c = sum (h_k + h_k+1) / 2 (x_k+1 - x_k) / (x_n - x_0),  h = y - m x,
 *
 * with m that of the mean plane: 0 where x runs along it, else as given, or as fitted to the
 * contact (base/mean_plane.h). All of it is rational. The base, which is mated, follows, and so do
 * points of holes, parts and loads that lie on a side of the block whose end is moved. */

#ifndef TP_PROBLEM_SMOOTHED_H
#define TP_PROBLEM_SMOOTHED_H

#include "scene/moved.h"

typedef struct tp_smoothed {
  tp_scene scene; /* shares with the scene what does not move */
  bool all;       /* whatever their length */
  bool inclined;  /* all of the contact, whose mean line lies off x by more than 1 in 100, */
  fmpq_t incline; /* by so much */
  long levelled;  /* facets */
  long stretches;
  fmpq_t farthest; /* that a vertex lay from its line, along y; scene lengths */
} tp_smoothed;

/* Does the scene ask for it? */
bool tp_smoothed_is_asked(const tp_scene *scene);

/* On failure `*smoothed` stays NULL. */
TP_MUST_USE tp_status tp_smoothed_init(tp_smoothed **smoothed, const tp_scene *scene,
                                       tp_message *message);
void tp_smoothed_free(tp_smoothed *smoothed);

#endif
