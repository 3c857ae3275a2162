/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parts of a picture by OpenCV, behind a C face. In the library of `topple trace` alone. */

#ifndef TP_GEOM_SEGMENT_H
#define TP_GEOM_SEGMENT_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tp_segment_status {
  TP_SEGMENT_DONE,
  TP_SEGMENT_NO_MEMORY,
  TP_SEGMENT_FAILED
} tp_segment_status;

/* GrabCut of Rother, Kolmogorov and Blake (2004): mixtures of Gaussians of the colours inside and
 * outside, a minimal cut between them, `rounds` times. `rgb` has three bytes a pixel. `mask` holds
 * 0 where a pixel is outside for certain, 1 where it is rather outside and 2 where it is rather
 * inside, and then 1 where it is inside and 0 elsewhere. The same input gives the same mask. */
tp_segment_status tp_segment(unsigned char *mask, const unsigned char *rgb, int width, int height,
                             int rounds);

#ifdef __cplusplus
}
#endif

#endif
