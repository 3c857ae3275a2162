/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* GrabCut segmentation of OpenCV from a mask of probable foreground, with a fixed random seed
 * (Rother, Kolmogorov and Blake, SIGGRAPH 2004). */

#include "geom/segment.h"

#include <new>
#include <opencv2/imgproc.hpp>

tp_segment_status tp_segment(unsigned char *mask, const unsigned char *rgb, int width, int height,
                             int rounds) {
  try {
    const cv::Mat picture(height, width, CV_8UC3,
                          const_cast<unsigned char *>(rgb)); // it only reads
    cv::Mat labels(height, width, CV_8UC1, mask), inside, outside;
    static const unsigned char begins[] = {cv::GC_BGD, cv::GC_PR_BGD, cv::GC_PR_FGD};
    for (int k = 0; k < width * height; k++) mask[k] = begins[mask[k]];
    cv::theRNG() = cv::RNG(1); // of this thread: the centres that the colours are gathered about
    cv::grabCut(picture, labels, cv::Rect(), inside, outside, rounds, cv::GC_INIT_WITH_MASK);
    for (int k = 0; k < width * height; k++) {
      mask[k] = mask[k] == cv::GC_FGD || mask[k] == cv::GC_PR_FGD;
    }
    return TP_SEGMENT_DONE;
  } catch (const std::bad_alloc &) {
    return TP_SEGMENT_NO_MEMORY;
  } catch (const cv::Exception &e) {
    return e.code == cv::Error::StsNoMem ? TP_SEGMENT_NO_MEMORY : TP_SEGMENT_FAILED;
  } catch (...) {
    return TP_SEGMENT_FAILED;
  }
}
