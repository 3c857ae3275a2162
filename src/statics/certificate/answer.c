/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory of the balls of a limit's answer. */

#include "certificate/answer.h"

#include <string.h>

bool tp_limit_answer_init(tp_limit_answer *answer, const tp_cones *cones) {
  memset(answer, 0, sizeof *answer);
  if (!tp_face_init(&answer->face, cones)) return false;
  if (!tp_face_init(&answer->other, cones)) {
    tp_face_clear(&answer->face);
    return false;
  }
  arb_init(answer->sine);
  arb_init(answer->cosine);
  arb_init(answer->degrees);
  arb_init(answer->inclination);
  for (int k = 0; k < 2; k++) arb_init(answer->forces + k);
  return true;
}

void tp_limit_answer_clear(tp_limit_answer *answer) {
  tp_face_clear(&answer->face);
  tp_face_clear(&answer->other);
  arb_clear(answer->sine);
  arb_clear(answer->cosine);
  arb_clear(answer->degrees);
  arb_clear(answer->inclination);
  for (int k = 0; k < 2; k++) arb_clear(answer->forces + k);
}
