/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of words for mechanisms, pivots, contact states, directions and positions. */

#include "report/words.h"

const char *tp_text_fos(tp_fos fos) {
  switch (fos.state) {
  case TP_FOS_NUMBER:
    return fos.value.value < -fos.value.error ? "none: resisting action is negative" : NULL;
  case TP_FOS_NO_OVERTURNING:
    return "unbounded: no driving action";
  case TP_FOS_UNDEFINED:
    return "none: no strength holds it";
  case TP_FOS_UNDECIDED:
    return "undecided";
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
  return NULL;
}

const char *tp_text_to_move(tp_mechanism mechanism) {
  switch (mechanism) {
  case TP_SLIDES:
    return "slide";
  case TP_TOPPLES:
    return "topple";
  case TP_SLIDES_AND_TOPPLES:
    return "slide and topple";
  case TP_LEAVES_BASE:
    return "leave its base";
  default:
    return "move";
  }
}

const char *tp_text_motion(tp_mechanism mechanism) {
  switch (mechanism) {
  case TP_SLIDES:
    return "sliding";
  case TP_TOPPLES:
    return "toppling";
  case TP_SLIDES_AND_TOPPLES:
    return "sliding and toppling";
  case TP_LEAVES_BASE:
    return "leaving its base";
  default:
    return "any motion";
  }
}

const char *tp_text_stance(const tp_solution *solution, const tp_case *of) {
  const bool left = of->towards == TP_TOWARDS_LEFT;
  if (solution->frame.world) {
    return left ? "As it lies, towards the left" : "As it lies, towards the right";
  }
  return left ? "Tilted towards the left" : "Tilted towards the right";
}

const char *tp_text_level(const tp_solution *solution) {
  if (solution->frame.level) return "as it lies";
  return solution->frame.world ? "where its mean plane is level" : "on level ground";
}

const char *tp_text_tilted(const tp_solution *solution) {
  if (solution->frame.level) return "turned";
  return solution->frame.world ? "steepened" : "tilted";
}

const char *tp_text_steepen(const tp_solution *solution) {
  return solution->frame.level ? "turn" : "steepen";
}

const char *tp_text_topples_at(const tp_solution *solution) {
  if (solution->frame.level) return "turned by";
  return solution->frame.world ? "at a dip of" : "topples at";
}

const char *tp_text_present(const tp_solution *solution) {
  return solution->frame.world ? "as it lies" : "at the scene's tilt";
}

const char *tp_text_table(const tp_tilt_test *test, const tp_tilt_case *of) {
  if (test->settings.protocol == TP_TILT_RELEASE && test->settings.release_deg == 0) {
    return "On level ground";
  }
  return of->towards == TP_TOWARDS_LEFT ? "Tilted towards the left" : "Tilted towards the right";
}
