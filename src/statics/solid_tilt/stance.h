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
 * Factors of safety: a N / (H T . n), the least over edges that lie that way, and N tan(phi) / |T|:
 * by how much the tangent of the resultant's inclination to the base may grow in its azimuth.
 * Where the tilt has no azimuth, the earthquake has none either, and the worst is that both go the
 * same way: T = g sin d + k_h cos d, N = g cos d - k_h sin d, towards each edge. Where the
 * earthquake alone has none, the factor f about an edge is the least root of
 *     (P g cos d - f g sin d q_t)^2 = k_h^2 ((P sin d + f cos d q_t)^2 + f^2 q_s^2),
 * and of sliding that down the dip, for |F| is the same for all and N the least there.
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
