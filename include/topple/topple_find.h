/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public library's back-analysis: for which number of a scene does a result have a wanted
 * value? Included by topple.h. */

#ifndef TOPPLE_FIND_H
#define TOPPLE_FIND_H

#include "topple_block_system.h"
#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a number of the scene is found for. Of many blocks there are TP_FIND_LIMIT_ANGLE,
 * TP_FIND_LIMIT_FOS, of which TP_FIND_FOS is another name, TP_FIND_GOVERNING_FOS, the lesser of
 * that and the factor on what drives, and the last two, of many blocks alone.
 */
typedef enum tp_find_target {
  TP_FIND_CRITICAL_ANGLE, /* of toppling, degrees */
  TP_FIND_FOS,            /* against toppling, at the scene's tilt; of many blocks as
                             TP_FIND_GOVERNING_FOS */
  TP_FIND_SLIDING_ANGLE,  /* of sliding, degrees */
  TP_FIND_SLIDING_FOS,
  TP_FIND_LIMIT_ANGLE,      /* the static limit, degrees */
  TP_FIND_LIMIT_FOS,        /* by strength reduction; of many blocks an upper bound, up to which
                               forces can hold them */
  TP_FIND_ONSET_ANGLE,      /* the onset of motion, degrees */
  TP_FIND_GOVERNING_FOS,    /* the governing factor at the scene's tilt */
  TP_FIND_FOS_GOODMAN_BRAY, /* of columns in a row, a double without a bound */
  TP_FIND_ACCELERATION      /* the critical horizontal acceleration, g */
} tp_find_target;

/* `key` is that of a number in the scene, as tp_scene_with takes it. */
typedef struct tp_find_options {
  size_t size;            /* of this struct, as `…_default()` has it */
  const char *key;        /* what is varied */
  tp_find_target target;  /* of which result, */
  double value;           /* and what it is to be */
  bool has_low, has_high; /* where one is not given: 0, or ten times the value in the scene */
  double low, high;       /* the range, in the units of the scene */
  const char *least_over; /* NULL: nothing; else the key of the dip_deg or direction_deg of an
                             anchor, of which `key` is the force: at the direction for which it is
                             least */
} tp_find_options;

/* The defaults: the critical angle, over the whole range; key and value are to be given. `size` is
 * that of the struct as the caller knows it. */
void tp_find_options_init(tp_find_options *options, size_t size);
static inline tp_find_options tp_find_options_default(void) {
  tp_find_options options;
  tp_find_options_init(&options, sizeof options);
  return options;
}

/* A stretch of solutions: the target has the same value, to 30 digits, at 9 numbers spread over it
 * and at its ends, and its bound holds the wanted one. Each end is bisected between a number where
 * that is so and one where it is not, or is an end of the range. What lies between the numbers that
 * were tried is not proven. */
typedef struct tp_found_interval {
  tp_bounded low, high; /* its ends */
} tp_found_interval;

/* A stretch over which the target is at least the wanted value: certain at both its ends, and at
 * every number between them that was tried. */
typedef struct tp_found_stretch {
  double low, high; /* its ends */
  bool begins;      /* just before it the target is certain to be below the value; false: the range
                       begins there, or the target is not known before it, or too close to the value */
  bool ends;        /* the same, just after it */
} tp_found_stretch;

/* Further results for many blocks at a number that was found. */
typedef struct tp_found_blocks {
  tp_system_verdict verdict;      /* what they do, with the scene's own strength */
  bool has_standing_fos;          /* they stand: */
  double standing_fos;            /* if has_standing_fos: as in tp_system_case */
  bool has_moving_fos;            /* a motion was found while forces can hold them: */
  double moving_fos;              /* if has_moving_fos: as in tp_system_case */
  bool has_fos_goodman_bray;      /* the blocks are columns in a row that some friction holds: */
  double fos_goodman_bray;        /* if has_fos_goodman_bray: the factor by Goodman and Bray */
  tp_system_safety governing_fos; /* the factor of safety there, with all motions that are looked
                                     for */
  bool is_upper_bound; /* the factor is only bounded above: a smaller one is neither proven nor
                          excluded */
} tp_found_blocks;

/* The numbers, in scene units, for which the target has the value: at the ends of value +- error of
 * each it is certain to lie on different sides. `touching`: numbers within whose bounds the target
 * comes so close to the value that its bound does not decide whether it reaches it, and at whose
 * ends it is certain to lie on the same side: a double solution, or none; or beyond which, at an
 * end of the range, the scene has no answer. Of a target that turns more than once between two of
 * the 512 points of the range that were tried, solutions may be missed. */
typedef struct tp_found {
  size_t size;                  /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *key;         /* as it was asked for */
  double low, high;             /* the range, cut to where the scene has an answer */
  tp_bounded least, greatest;   /* of the results at the numbers that were tried */
  size_t count;                 /* 0: none in the range */
  tp_bounded *solutions;        /* count of them: at which it has the value */
  size_t touching_count;        /* of those that touch */
  tp_bounded *touching;         /* as explained above */
  size_t interval_count;        /* of the intervals */
  tp_found_interval *intervals; /* throughout which it has the value */
  tp_governing_fos *governing;  /* if governing != NULL: of each solution, where a factor of safety
                                   was asked for: the factors there, and which of them governs */
  tp_bounded *per_metre_kn; /* if per_metre_kn != NULL: of each solution that is the force of bolts
                            at a spacing, kN per metre along the slope, of all their rows */
  TP_OUTSIDE char *least_over; /* if least_over != NULL: the key of a direction, as asked for: */
  double direction_deg;        /* the scene has this instead of its own, 0 where there is none */
  size_t at_least_count;       /* of the stretches: */
  tp_found_stretch *at_least;  /* over which the target is at least the value, in order */
  bool is_support; /* a factor of safety was asked for, and `key` is the force of an anchor, or the
                      pressure of a lining or wall */
  bool has_design; /* if is_support: the first stretch begins within the range, and there
                      the governing factor is above the value too: */
  double design;   /* if has_design: the least number of the first stretch, rounded up to at least 4
                      digits; the scene was solved with it */
  tp_bounded design_result; /* if has_design: the target there, certain to be above the value */
  tp_found_blocks *blocks; /* if blocks != NULL: of each solution, of a scene of many blocks: of the
                              direction that governs there */
  bool is_upper_bound;     /* many blocks: the results at the numbers that were tried, and so
                              `least` and `greatest`, are only upper bounds */
} tp_found;

/* Look for the numbers; `*found` is to be freed by tp_found_free. `scene` tilts in one direction,
 * or lies in place, where many blocks are solved to the side that governs; it is not changed. Of
 * more than two free blocks a factor of safety is searched for by its upper bounds. A number at
 * which a smaller factor is proven is moved to the nearest at which none is, or left out. Of many
 * blocks results are proven to 1e-6 of themselves and 64 points of the range are tried, so that a
 * number is as near as that tells. With `least_over` the direction of the least force is searched
 * in doubles, at every 5 degrees and then by Brent's minimiser, to 1e-4 degrees; what is found at
 * the direction given is as certain as without, that no other direction needs less is not proven.
 * TP_NO_ANSWER where the target cannot depend on the number, or the scene has it nowhere in the
 * range; none in the range is an answer. TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_find(tp_found **found, const tp_scene *scene,
                              const tp_find_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_found_free(tp_found *found);

/* The target of that name: critical_angle, fos, sliding_angle, sliding_fos, limit_angle, limit_fos,
 * onset_angle, governing_fos, fos_goodman_bray or critical_acceleration; false for another one. */
bool tp_find_target_read(tp_find_target *target, const char *name);

/* And its name. */
const char *tp_find_target_name(tp_find_target target);

/* What was found, as `topple solve --find` prints it. `*text` is allocated with malloc and is the
 * caller's to free. */
TP_MUST_USE tp_status tp_report_found(char **text, const tp_found *found,
                                      const tp_find_options *options);

/* JSON of it, with a solution of the scene as it is, as `topple solve --json` prints it. */
TP_MUST_USE tp_status tp_report_found_json(char **text, const tp_found *found,
                                           const tp_solution *solution);

/* The same with that of many blocks, as tp_report_block_system_json prints it. */
TP_MUST_USE tp_status tp_report_found_block_system_json(char **text, const tp_found *found,
                                                        const tp_block_system *system);

#ifdef __cplusplus
}
#endif

#endif
