/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a solid does on its base at a tilt, with an earthquake.
 *
 * The base dips by d towards t, the unit vector down it; s lies across, along the strike. With the
 * weight 1 and shares k_h towards the horizontal azimuth e and k_v up, g = 1 - k_v, c = e . t and
 * w = e . s on the map, the resultant has
 *     N = g cos d - k_h c sin d,   T = (g sin d + k_h c cos d) t + k_h w s.
 * About an edge with the arm a and the unit vector n outwards, with the centroid at the height H,
 * it topples where H T . n > a N; it slides where |T| > N tan(phi). With P = a and q = H n, of each
 * edge times its length, all of it is in P and q.
 *
 * Factors of safety (docs/mechanics.md). On driving loads the part of the weight along the base and
 * the earthquake are multiplied by f, and the part of the weight across the base, cos d, stays:
 *     N(f) = cos d - f (cos d - N),   T(f) = f T,
 * so that it topples about an edge at f = P cos d / (P (cos d - N) + T . q), and slides at
 * f = tan(phi) cos d / (tan(phi) (cos d - N) + |T|). By strength reduction it slides at
 * N tan(phi) / |T|; no strength keeps it from toppling. The least of all counts, with the
 * earthquake and without. Where the tilt has no azimuth, the earthquake has none either, and the
 * worst is that both go the same way: T = g sin d + k_h cos d, N = g cos d - k_h sin d, towards
 * each edge. Where the earthquake alone has none, P (cos d - N) + T . q is P k_v cos d + g sin d
 * q_t + k_h |(P sin d + q_t cos d, q_s)| at its worst, linear in the direction of the earthquake,
 * and the worst of sliding is down the dip: |T| - N tan(phi) is concave in c, and rises with it at
 * c = 1 where tan(phi) >= tan d.
 *
 * Accelerations without k_h of the scene: about an edge
 *     k = g (P cos d - q_t sin d) / (c (P sin d + q_t cos d) + w q_s),
 * over all azimuths g (P cos d - q_t sin d) / |(P sin d + q_t cos d, q_s)| towards that vector; of
 * sliding the least root of |T|^2 = N^2 tan^2(phi), over all azimuths g tan(phi - d), down the dip:
 * the cone of friction cuts the horizontal plane below in a conic with the radius of curvature
 * tan(phi) at that end of its axis. */

#ifndef TP_SOLID_TILT_STANCE_H
#define TP_SOLID_TILT_STANCE_H

#include "scene/scene.h"
#include "solid_tilt/stance_parts.h"

void tp_stance_loads_of(tp_stance_loads *loads, const tp_scene *scene);

/* The stance, and the accelerations of the rose, by its `count` edges. */
void tp_stance_find(tp_solid_band *band, const tp_stance_loads *loads, const tp_stance_edge *edges,
                    size_t count, bool has_friction, double friction_angle_deg);

#endif
