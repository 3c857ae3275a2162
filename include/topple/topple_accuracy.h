/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public library's account of what accuracy costs. Included by topple.h. */

#ifndef TOPPLE_ACCURACY_H
#define TOPPLE_ACCURACY_H

#include "topple_converge.h"
#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Ways to a number. */
typedef enum tp_accuracy_method {
  TP_ACCURACY_BOUNDARY,      /* critical angle of the sharp block, by sums along its boundary */
  TP_ACCURACY_TRIANGLES,     /* the same by sums over its triangles, triangulating included */
  TP_ACCURACY_ROUNDED_PAPER, /* with rounded corners: axis moved, mass kept (Appendix B) */
  TP_ACCURACY_ROUNDED_EXACT, /* with rounded corners, their tips taken off */
  TP_ACCURACY_LIMIT,         /* static limit: in doubles, certified in balls, or exactly */
  TP_ACCURACY_ONSET          /* onset of motion: sums as of the boundary, then balls */
} tp_accuracy_method;

/* How many there are. */
enum { TP_ACCURACY_METHODS = TP_ACCURACY_ONSET + 1 };

/* Its name in reports. */
const char *tp_accuracy_method_name(tp_accuracy_method method);

/* One method in one arithmetic. Angles are in degrees; logarithms serve where doubles underflow,
 * and are -INFINITY for 0. */
typedef struct tp_accuracy_run {
  tp_accuracy_method method; /* the way */
  tp_level level;  /* of the sums; of a limit: double unproven, ball certified, exact program */
  long bits;       /* working precision of what follows the sums */
  size_t vertices; /* of the block */
  double seconds;  /* of one evaluation: median of several */
  bool has_bound;  /* a limit in doubles alone has none */
  double bound, bound_log10;           /* if has_bound: proven, rounded up */
  double true_error, true_error_log10; /* against the exact value */
} tp_accuracy_run;

/* The result of one method, within the bound of every arithmetic. */
typedef struct tp_accuracy_value {
  tp_accuracy_method method; /* the way */
  size_t vertices;           /* of the block */
  tp_bounded angle_deg;      /* the exact value */
} tp_accuracy_value;

/* What was measured; owns what it points to. */
typedef struct tp_accuracy {
  size_t size;                    /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;         /* of the scene, or NULL */
  bool sweep;                     /* over sizes, not of one scene */
  tp_direction towards;           /* of the tilt */
  size_t run_count, value_count;  /* of both: */
  tp_accuracy_run *runs;          /* by method, size and price */
  tp_accuracy_value *values;      /* by method and size */
  size_t source_count;            /* of the sources */
  char **sources;                 /* files that the scene was read from */
  tp_tilt_convergence *simulated; /* of a scene that calls for a tilt test or for shaking: what the
                                settings of that take and cost; NULL: none */
} tp_accuracy;

/* Measure every method that the scene calls for, in the first direction in which it tilts; of one
 * that is simulated also the test over its settings, as tp_tilt_converge has it. The
 * exact value is one at 6144 bits. TP_NO_ANSWER where the scene has neither a critical angle, nor a
 * limit, nor an onset of motion; TP_UNDECIDED; TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_accuracy_of_scene(tp_accuracy **accuracy, const tp_scene *scene,
                                           tp_message *message);

/* The same for blocks on rough bases of `least` to `most` vertices (10 to 10^7), in steps of ten.
 * What costs more than some seconds is left out: triangles beyond 10^6 vertices, the limit and
 * the onset beyond 10^5. */
TP_MUST_USE tp_status tp_accuracy_sweep(tp_accuracy **accuracy, size_t least, size_t most,
                                        tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_accuracy_free(tp_accuracy *accuracy);

/* As a table, and as JSON. `*text` is allocated with malloc and is the caller's to free. */
TP_MUST_USE tp_status tp_report_accuracy(char **text, const tp_accuracy *accuracy);
TP_MUST_USE tp_status tp_report_accuracy_json(char **text, const tp_accuracy *accuracy);

/* Time against digits; or of a sweep, time and bound against size. To be freed by tp_chart_free. */
TP_MUST_USE tp_status tp_chart_accuracy(tp_chart **chart, const tp_accuracy *accuracy,
                                        tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
