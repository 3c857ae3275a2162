/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene in which all of the block that lies within a distance of its profile touches it: vertices
 * of the outline are moved onto the profile, which stays (base/snap.h). Points of holes, parts and
 * loads that lie on an edge of the outline go with it, at the share of the edge at which they lie.
 */

#ifndef TP_PROBLEM_SNAPPED_H
#define TP_PROBLEM_SNAPPED_H

#include "base/snap.h"
#include "scene/moved.h"

typedef struct tp_snapped {
  tp_scene scene; /* shares with the scene what does not move */
  tp_snap snap;
  double gap, gap_error; /* the largest left, in scene lengths */
} tp_snapped;

/* On failure `*snapped` stays NULL. Whether the block still is one is seen when it is used: */
TP_MUST_USE tp_status tp_snapped_init(tp_snapped **snapped, const tp_scene *scene,
                                      tp_message *message);
void tp_snapped_free(tp_snapped *snapped);

/* ... then the message of that becomes one of the move too. */
void tp_snapped_explain(const tp_scene *scene, tp_message *message);

#endif
