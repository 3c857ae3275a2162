/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How far two triangles are apart, in doubles, for messages: nothing is decided by it. */

#ifndef TP_SOLID_TRIANGLE_DISTANCE_H
#define TP_SOLID_TRIANGLE_DISTANCE_H

/* The least of all distances between a corner of one and the other, and between sides of both, with
 * the two points; of triangles that cross, a distance within them. */
double tp_triangle_distance(double points[2][3], double one[3][3], double other[3][3]);

/* From a point to a triangle, with the nearest point of it. */
double tp_point_triangle_distance(double nearest[3], const double point[3], double triangle[3][3]);

#endif
