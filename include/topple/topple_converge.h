/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The influence of the settings of a simulated tilt test on its answer, and the cost of each: the
 * critical angle, or the least shaking that overturns, over stiffness, time step, damping and
 * tolerance (docs/tilt_converge.md). Included by topple.h. */

#ifndef TOPPLE_CONVERGE_H
#define TOPPLE_CONVERGE_H

#include "topple_chart.h"
#include "topple_tilt_test.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is varied. Which of them an engine has: see each. */
typedef enum tp_converge_setting {
  TP_CONVERGE_TOLERANCE,       /* wanted width of the bracket, degrees: of all engines */
  TP_CONVERGE_STIFFNESS,       /* normal, Pa/m, the shear stiffness with it: path and springs */
  TP_CONVERGE_STIFFNESS_RATIO, /* shear over normal stiffness: path and springs */
  TP_CONVERGE_TIME_STEP,       /* s: springs */
  TP_CONVERGE_DAMPING,         /* local: springs */
  TP_CONVERGE_ROUNDING,        /* radius of corners, m: springs */
  TP_CONVERGE_STEP_TOLERANCE,  /* of a step of the motion, over extent and speed: events */
  TP_CONVERGE_LEAST_BOUNCE     /* a bounce no higher is passed, over the extent: events */
} tp_converge_setting;

/* How many there are. */
enum { TP_CONVERGE_SETTINGS = TP_CONVERGE_LEAST_BOUNCE + 1 };

/* The quantity that is to converge. */
typedef enum tp_converge_quantity {
  TP_CONVERGE_ANGLE,      /* critical, in degrees */
  TP_CONVERGE_OVERTURNING /* the least shaking that overturns, as a factor on the scene's */
} tp_converge_quantity;

/* The outcome for one setting. */
typedef enum tp_converge_verdict {
  TP_CONVERGE_HOLDS,   /* as it is set: finer ones change the answer by less than was asked */
  TP_CONVERGE_REFINED, /* not as it is set, but finer ones agree: the cheapest of them is taken for
                          the settings that follow */
  TP_CONVERGE_DEPENDS, /* the answer depends on it by more than was asked */
  TP_CONVERGE_OPEN     /* a run was not decided, or stopped */
} tp_converge_verdict;

/* Their names in reports: "time step", "critical angle", "holds". */
const char *tp_converge_setting_name(tp_converge_setting setting);
const char *tp_converge_quantity_name(tp_converge_quantity quantity);
const char *tp_converge_verdict_name(tp_converge_verdict verdict);

/* The test with one setting at one value, all others being as they are set. */
typedef struct tp_converge_level {
  tp_converge_setting setting;        /* which is varied */
  double value;                       /* in the unit of it; INFINITY: the limit of stiff contacts */
  bool own;                           /* it is as the scene has it, or as it was refined before */
  bool known;                         /* a bracket was found: */
  double bracket_least, bracket_most; /* if known: degrees, or factors */
  size_t runs;                        /* of the engine */
  double seconds;                     /* that they took: of what is short the least of several */
} tp_converge_level;

/* The result for one setting. Its levels follow each other from coarse to fine; of a ratio of
 * stiffnesses none is finer, and all of them must agree. */
typedef struct tp_converge_finding {
  tp_converge_setting setting; /* which */
  tp_converge_verdict verdict; /* what was found */
  double spread;               /* the width of all that must agree; at most that which was asked:
                                  it holds, or the finest do */
  bool has_needed;             /* the cheapest value from which on all finer ones agree: */
  double needed;               /* it */
  size_t first, count;         /* of the levels of the case */
} tp_converge_finding;

/* One direction of tilt. */
typedef struct tp_tilt_convergence_case {
  tp_direction towards;                           /* which */
  bool has_onset, has_limit;                      /* statics knows: */
  double onset_deg, limit_deg;                    /* alpha_s and alpha_w */
  bool known;                                     /* the test as it is set has a bracket: */
  double as_set_least, as_set_most;               /* if known: that */
  double over_settings_least, over_settings_most; /* if known: of it and of the finest levels
                         together; where settings were refined of the levels after that */
  bool converged;                                 /* every setting holds, or was refined */
  size_t setting_count;                           /* of the findings */
  tp_converge_finding *settings;                  /* a setting each */
  size_t level_count;                             /* of the levels */
  tp_converge_level *levels;                      /* by setting, then from coarse to fine */
} tp_tilt_convergence_case;

/* The result. Simulated numbers: no bound is proven. */
typedef struct tp_tilt_convergence {
  size_t size;                   /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;        /* of the scene; NULL: none */
  tp_tilt_settings settings;     /* of the test */
  tp_converge_quantity quantity; /* what was asked to converge */
  double asked;                  /* by how much settings may change it: the tolerance of the scene,
                                    degrees; of a factor its share */
  size_t case_count;             /* of the cases */
  tp_tilt_convergence_case *cases; /* a direction each */
  tp_notes notes;                  /* beside the answer */
  size_t source_count;             /* of the sources */
  char **sources;                  /* files that the scene was read from */
} tp_tilt_convergence;

/* Run the test of the scene at each level of each setting that its engine has. Of the options
 * `stop`, `progress` and `context` are taken. Bad input where the scene calls for no simulation, or
 * for a release without shaking, which has no critical angle. `*convergence` is the caller's, to be
 * freed by tp_tilt_convergence_free. TP_NO_ANSWER where the block does not fit its base. */
TP_MUST_USE tp_status tp_tilt_converge(tp_tilt_convergence **convergence, const tp_scene *scene,
                                       const tp_tilt_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_tilt_convergence_free(tp_tilt_convergence *convergence);

/* As a page, and as JSON (docs/json.md). `*text` is allocated with malloc and is the caller's to
 * free. */
TP_MUST_USE tp_status tp_report_tilt_convergence(char **text,
                                                 const tp_tilt_convergence *convergence);
TP_MUST_USE tp_status tp_report_tilt_convergence_json(char **text,
                                                      const tp_tilt_convergence *convergence);

/* The answer against what it costs, a curve for each setting. To be freed by tp_chart_free.
 * TP_NO_ANSWER where no level has a bracket. */
TP_MUST_USE tp_status tp_chart_tilt_convergence(tp_chart **chart,
                                                const tp_tilt_convergence *convergence,
                                                tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
