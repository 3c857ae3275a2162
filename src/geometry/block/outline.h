/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outlines that a scene describes by a few numbers: toothed blocks (Alejano et al., Fig. 5) and
 * slabs. The joints of the teeth lie at multiples of a, in turn at the heights 0 and c; exact. */

#ifndef TP_BLOCK_OUTLINE_H
#define TP_BLOCK_OUTLINE_H

#include "scene/scene.h"

/* The outline of a toothed block (Fig. 5), from its lower left end counter-clockwise, valleys at
 * y = 0, peaks at y = c, the top at y = b + c. False when memory is exhausted. */
TP_MUST_USE bool tp_outline_teeth(tp_polyline *outline, const tp_teeth *teeth, tp_mark mark);

/* A vertex of that outline as a whole combination of width a, height b and depth c. */
typedef struct tp_teeth_point {
  long x_a;
  int y_b, y_c;
} tp_teeth_point;

/* The k-th vertex, 0 <= k < count + 3: the joints of the underside, then the two upper corners. */
tp_teeth_point tp_outline_teeth_point(const tp_teeth *teeth, long k);

/* Height of the underside at the k-th joint between sub-blocks (k < 0 and k > N go on beyond the
 * block): 0 or c. */
void tp_outline_joint_height(fmpq_t y, const tp_teeth *teeth, long joint);

/* Corners of the elements of Appendix A: at the k-th joint the points (k a, c) and (k a, b + c),
 * each pair in that order. */
TP_MUST_USE bool tp_outline_teeth_elements(tp_polyline *corners, const tp_teeth *teeth);

#endif
