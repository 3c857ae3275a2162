/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the settings of a tilt test take from its answer, as a page of 80 columns. */

#include "report/converge.h"
#include "common/host.h"
#include "output/encode.h"
#include "report/notes.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>

static const char *unit_of(tp_converge_setting setting) {
  static const char *const units[TP_CONVERGE_SETTINGS] = {
      [TP_CONVERGE_TOLERANCE] = "°",      [TP_CONVERGE_STIFFNESS] = " GPa/m",
      [TP_CONVERGE_STIFFNESS_RATIO] = "", [TP_CONVERGE_TIME_STEP] = " s",
      [TP_CONVERGE_DAMPING] = "",         [TP_CONVERGE_ROUNDING] = " m",
      [TP_CONVERGE_STEP_TOLERANCE] = "",  [TP_CONVERGE_LEAST_BOUNCE] = ""};
  return units[setting];
}

/* In its unit, GPa/m of a stiffness. */
static void write_value(char out[32], tp_converge_setting setting, double value) {
  if (isinf(value)) {
    snprintf(out, 32, "stiff limit");
  } else {
    snprintf(out, 32, "%.3g", setting == TP_CONVERGE_STIFFNESS ? value / 1e9 : value);
  }
}

/* Decimals of an answer that is asked to within so much. */
static int decimals_of(double asked) {
  return asked > 0 ? (int)fmin(9, fmax(2, 2 - floor(log10(asked)))) : 6;
}

static void add_seconds(tp_text *t, double seconds) {
  if (seconds < 1) {
    tp_text_add(t, "%8.3g ms\n", 1e3 * seconds);
  } else {
    tp_text_add(t, "%8.3g s\n", seconds);
  }
}

static void add_level(tp_text *t, const tp_converge_level *level, int decimals) {
  char value[32];
  write_value(value, level->setting, level->value);
  tp_text_add(t, "  %c %18s", level->own ? '*' : ' ', value);
  if (level->known) {
    tp_text_add(t, " %13.*f %13.*f", decimals, level->bracket_least, decimals, level->bracket_most);
  } else {
    tp_text_add(t, " %27s", "undecided");
  }
  tp_text_add(t, " %6zu ", level->runs);
  add_seconds(t, level->seconds);
}

static void add_verdict(tp_text *t, const tp_converge_finding *f, const tp_tilt_convergence *c) {
  const char *unit = c->quantity == TP_CONVERGE_ANGLE ? "°" : "";
  char needed[32];
  write_value(needed, f->setting, f->needed);
  switch (f->verdict) {
  case TP_CONVERGE_HOLDS:
    tp_text_add(t, "    converged: the answers lie within %.2g%s", f->spread, unit);
    if (f->has_needed && f->setting != TP_CONVERGE_TOLERANCE) {
      tp_text_add(t, ", from %s%s on", needed, isinf(f->needed) ? "" : unit_of(f->setting));
    }
    break;
  case TP_CONVERGE_REFINED:
    tp_text_add(t, "    refined to %s%s: from that value on the answers lie within %.2g%s", needed,
                unit_of(f->setting), f->spread, unit);
    break;
  case TP_CONVERGE_DEPENDS:
    tp_text_add(t, "    not converged: it changes the answer by %.2g%s", f->spread, unit);
    break;
  case TP_CONVERGE_OPEN:
    tp_text_add(t, "    undecided: a run was undecided, or stopped");
    break;
  }
  tp_text_add(t, "\n");
}

static void add_outcome(tp_text *t, const tp_tilt_convergence_case *own,
                        const tp_tilt_convergence *c, int decimals) {
  const bool angle = c->quantity == TP_CONVERGE_ANGLE;
  const char *unit = angle ? "°" : "";
  tp_text_add(t, "\n  %s over all of these: %.*f%s to %.*f%s.\n",
              angle ? "Critical angle" : "Least overturning factor", decimals,
              own->over_settings_least, unit, decimals, own->over_settings_most, unit);
  tp_text_add(t,
              own->converged ? "  Converged to the %.3g%s that %s asked.\n"
                             : "  Not converged to the %.3g%s that %s asked.\n",
              angle ? c->asked : 100 * c->asked, angle ? "°" : " %", angle ? "was" : "is");
}

static void add_case(tp_text *t, const tp_tilt_convergence_case *own,
                     const tp_tilt_convergence *c) {
  const bool angle = c->quantity == TP_CONVERGE_ANGLE;
  const int decimals = decimals_of(angle ? c->asked : c->asked * own->over_settings_most);
  if (!angle && c->settings.release_deg == 0) {
    tp_text_add(t, "\nOn level ground\n\n");
  } else {
    tp_text_add(t, "\nTilted towards the %s\n\n", tp_direction_name(own->towards));
  }
  if (own->has_onset && own->has_limit && angle) {
    tp_text_add(t,
                "  Statics: certain to stand up to α_s = %.*f°, to move beyond\n  α_w = %.*f°.\n\n",
                decimals, own->onset_deg, decimals, own->limit_deg);
  }
  if (!own->known) {
    tp_text_add(t, "  The test has no bracket that could converge: see 'topple tilt'.\n");
    return;
  }
  tp_text_add(t, "  %20s %13s %13s %6s %11s\n", "setting", angle ? "stands at" : "withstands",
              angle ? "moves at" : "overturned by", "runs", "time");
  for (size_t k = 0; k < own->setting_count; k++) {
    const tp_converge_finding *f = own->settings + k;
    const char *unit = unit_of(f->setting);
    tp_text_add(t, "\n  %s%s%s\n", tp_converge_setting_name(f->setting),
                unit[0] == '\0'  ? ""
                : unit[0] == ' ' ? ","
                                 : ", ",
                unit);
    for (size_t j = 0; j < f->count; j++) add_level(t, own->levels + f->first + j, decimals);
    add_verdict(t, f, c);
  }
  add_outcome(t, own, c, decimals);
}

void tp_text_convergence(tp_text *t, const tp_tilt_convergence *c) {
  for (size_t k = 0; k < c->case_count; k++) add_case(t, c->cases + k, c);
  tp_text_add(t, "\n  * as it is set. Simulated: no bound is proven.\n");
}

tp_status tp_report_tilt_convergence(char **text, const tp_tilt_convergence *convergence) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, convergence);
  tp_text t = {0};
  if (convergence->title != NULL) {
    tp_encode_plain(&t, convergence->title);
    tp_text_add(&t, "\n\n");
  }
  const char *engine = tp_tilt_engine_name(convergence->settings.engine);
  const char *quantity = tp_converge_quantity_name(convergence->quantity);
  tp_text_add(&t, "The %s by %s, over the settings of its test\n", quantity, engine);
  tp_text_convergence(&t, convergence);
  if (convergence->notes.count > 0) tp_text_add(&t, "\n");
  tp_text_notes(&t, &convergence->notes);
  return tp_text_finish(&t, text);
}
