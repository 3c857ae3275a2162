/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public library's symbolic half: closed formulas of a scene. Results own what they point to,
 * and are freed by the call of their name. Included by topple.h. */

#ifndef TOPPLE_DERIVE_H
#define TOPPLE_DERIVE_H

#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How derived formulas are written: text for computer algebra, LaTeX, or C in doubles. */
typedef enum tp_notation { TP_NOTATION_TEXT, TP_NOTATION_LATEX, TP_NOTATION_C } tp_notation;

/* Numerator and denominator, coprime polynomials with whole coefficients, and both as one formula.
 */
typedef struct tp_fraction {
  char *numerator, *denominator; /* as polynomials */
  char *formula;                 /* as a formula */
} tp_fraction;

/* One element of a derivation about the governing pivot: its area times relative density, and the
 * arms of its weight; the signs are those at the scene's parameter values. */
typedef struct tp_derived_element {
  tp_element_kind kind;     /* triangle or slab */
  size_t part;              /* 0: the block; k: its k-th part */
  tp_fraction area;         /* times relative density */
  tp_fraction normal_arm;   /* x arm of the component W cos(alpha) */
  tp_fraction parallel_arm; /* y arm of the component W sin(alpha) */
  bool normal_stabilises;   /* the one is above 0 */
  bool parallel_overturns;  /* the other is */
} tp_derived_element;

/* A pivot in symbols. Factor of safety in elements form: (a cot(alpha) + b) / (c cot(alpha) + d)
 * with the sums of elements' moments a, b that stabilise and c, d that overturn, each element on
 * the side where it is at the scene's values. Where c = 0 it is fos_cot cot(alpha) + fos_constant,
 * as in (A1.3). */
typedef struct tp_derived_pivot {
  tp_direction towards;                         /* of the tilt */
  tp_pivot_kind kind;                           /* where it lies */
  bool admissible;                              /* to first order, at the scene's values */
  bool governs;                                 /* its critical angle is the least there */
  tp_fraction x, y;                             /* in scene lengths */
  tp_fraction tan_critical_angle;               /* of the critical angle; FoS, resultant form, is
                                                   tan_critical_angle cot(alpha) */
  tp_bounded critical_angle_deg;                /* at the scene's values */
  bool has_elements;                            /* the elements form was asked for */
  bool splits;                                  /* c = 0 */
  tp_fraction fos_cot, fos_constant;            /* if has_elements && splits */
  tp_fraction stabilising_cos, stabilising_sin; /* if has_elements: a, b */
  tp_fraction overturning_cos, overturning_sin; /* if has_elements: c, d */
} tp_derived_pivot;

/* The corner at the governing pivot of one direction, rounded (Appendix B): the axis moves along
 * the facet up-dip by the length r, with the mass kept. In the scene's parameters, r, sin(i) and
 * cos(i) with i the angle of that facet, and tan(alpha). */
typedef struct tp_derived_rounding {
  bool known;                     /* it was derived */
  tp_pivot_kind kind;             /* where that lies */
  tp_fraction tan_critical_angle; /* of the critical angle; FoS is tan_critical_angle cot(alpha) */
  tp_fraction rounding_length;    /* the r at which the block topples at alpha, (A2.4) */
  bool has_radius;                /* the side at the corner is normal to the base */
  tp_fraction corner_radius;      /* the r_c that this r belongs to, (A2.6) */
} tp_derived_rounding;

/* A force that holds the block at its limit: along the edge n + t tan(phi) of the friction cone at
 * a contact point if it acts against slip, n - t tan(phi) if not. */
typedef struct tp_derived_reaction {
  tp_fraction x, y;  /* of the contact point */
  bool against_slip; /* which edge it is */
} tp_derived_reaction;

/* What the solver finds beside a formula. */
typedef enum tp_check_verdict {
  TP_CHECK_SAME,     /* the formula's angle, within the proven bound */
  TP_CHECK_OTHER,    /* another angle */
  TP_CHECK_NONE,     /* no angle */
  TP_CHECK_CONTACT,  /* another contact: more or fewer facets or points, or ends of another kind */
  TP_CHECK_REFUSED,  /* the scene has no answer there */
  TP_CHECK_UNDECIDED /* at the precision allowed */
} tp_check_verdict;

/* A condition tested in numbers from both sides: just inside the solver agrees with the formula,
 * just outside it finds what `beyond` says. */
typedef struct tp_derived_check {
  size_t condition;        /* of the condition */
  char *inside, *outside;  /* the scene's numbers that were changed, as in "c = 7.41, b = 100" */
  tp_check_verdict beyond; /* outside */
} tp_derived_check;

/* By condition; one without a check was not met first in any of the directions gone from the
 * scene's values. Not run: not asked for, or the outline has more than 2000 vertices, or the
 * conditions more than 100000 terms. */
typedef struct tp_derived_checks {
  bool run;                /* else there are none */
  size_t count;            /* of the items */
  tp_derived_check *items; /* by their condition */
} tp_derived_checks;

/* The static limit in symbols (docs/mechanics.md section 6), with the base of the scene: the
 * tangent of the critical angle in the scene's parameters and tan(phi) from the two forces of the
 * optimal basis, which meet the weight in the centre of rotation. It holds wherever no condition, a
 * formula, is below zero; those that hold for all positive parameters are left out if these are. */
typedef struct tp_derived_limit {
  bool known;                       /* false: interlocked, or nothing holds it */
  tp_mechanism mechanism;           /* what happens there */
  bool base_beyond_toe;             /* the base extends past the toe */
  tp_fraction tan_critical_angle;   /* of the critical angle */
  tp_bounded critical_angle_deg;    /* at the scene's values */
  tp_derived_reaction reactions[2]; /* the two forces */
  bool has_centre;                  /* of rotation */
  tp_fraction centre_x, centre_y;   /* where it is, in scene lengths */
  bool parameters_above_zero;       /* all parameters are, and the conditions suppose so */
  size_t condition_count;           /* of the conditions */
  tp_fraction *conditions;          /* not below zero where the formula holds */
  tp_derived_checks checks;         /* of the conditions */
} tp_derived_limit;

/* What holds the weight in balance at the onset of a motion: a force along an edge of the friction
 * cone at a contact point, as above; or what accelerates the block, as it turns about a point, or
 * slides. */
typedef struct tp_derived_row {
  bool is_force;     /* else a motion */
  bool against_slip; /* of a force */
  bool turns;        /* of a motion; else it slides, and no point is given */
  tp_fraction x, y;  /* if is_force || turns: the contact point, or the centre of turning */
} tp_derived_row;

/* The onset of motion in symbols (docs/onset.md), in those of the limit: the tangent of the tilt up
 * to which no motion can begin. It holds wherever all conditions, formulas, are above zero; they
 * are enough for that, and it may hold beyond them. */
typedef struct tp_derived_onset {
  tp_onset_kind kind;             /* at the scene's values */
  tp_mechanism mechanism;         /* what can begin there */
  bool below_limit;               /* certainly, at the scene's values */
  bool known;                     /* false: there is no angle, or */
  const char *reason;             /* why it is not derived, a static text; else NULL */
  bool same_as_limit;             /* one formula serves for both */
  tp_fraction tan_critical_angle; /* if known: of its angle */
  tp_bounded critical_angle_deg;  /* if known: at the scene's values */
  tp_derived_row balance[2];      /* if known: what balances the weight there */
  bool parameters_above_zero;     /* as for the limit */
  size_t condition_count;         /* of the conditions */
  tp_fraction *conditions;        /* above zero where the formula is sure to hold */
  tp_derived_checks checks;       /* of the conditions */
} tp_derived_onset;

/* The formulas of a scene. */
typedef struct tp_derivation {
  size_t size;                          /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;               /* of the scene, or NULL */
  tp_notation notation;                 /* how they are written */
  tp_fraction area, x_moment, y_moment; /* about the scene's origin, weighted by relative density */
  size_t symbol_count;                  /* of both: */
  TP_OUTSIDE char **symbols; /* as the formulas write them, which in C is another name where C keeps
                                one for itself */
  TP_OUTSIDE char **parameters;    /* symbol_count of them: as the scene calls them */
  size_t pivot_count;              /* of the pivots */
  tp_derived_pivot *pivots;        /* by direction, and along the contact */
  size_t element_count;            /* 0 unless asked for */
  tp_derived_element *elements[2]; /* by direction: about the governing pivot; NULL where none */
  tp_derived_rounding
      rounded[2];            /* by direction: the corner at the governing pivot, where asked for */
  tp_derived_limit limit[2]; /* by direction: the static limit, where asked for */
  tp_derived_onset onset[2]; /* by direction where kind != TP_ONSET_NOT_ASKED: with the limit */
  tp_notes notes;            /* of the scene's reading, and on its problem */
} tp_derivation;

/* What is derived. */
typedef struct tp_derive_options {
  size_t size;          /* of this struct, as `…_default()` has it */
  tp_notation notation; /* how formulas are written */
  bool elements;        /* derive the elements form and list its elements */
  bool rounded;         /* round the corners at the governing pivots */
  bool limit;           /* derive the static limit and the onset of motion */
  bool checked;         /* look at their conditions from both sides in numbers */
} tp_derive_options;

/* The defaults: as text, the pivots alone; a limit that is asked for is checked. `size` is that of
 * the struct as the caller knows it. */
void tp_derive_options_init(tp_derive_options *options, size_t size);
static inline tp_derive_options tp_derive_options_default(void) {
  tp_derive_options options;
  tp_derive_options_init(&options, sizeof options);
  return options;
}

/* The closed formulas of a scene in its parameters, in scene lengths: area and moments, the
 * critical angle about every pivot, and what else is asked for. The scene was read from a file or a
 * text; its weight is its only load, its edges are straight. TP_NO_ANSWER where there is no closed
 * formula or it grows too long; TP_UNDECIDED; TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_derive(tp_derivation **derivation, const tp_scene *scene,
                                const tp_derive_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_derivation_free(tp_derivation *derivation);

/* How many members of a family fix a formula, and on how many more it is checked. */
enum { TP_FAMILY_FIXED = 4, TP_FAMILY_CHECKED = 6 };

/* One formula for every number of teeth of one parity: the tangent of the critical angle about the
 * toe of one direction of tilt. */
typedef struct tp_family_formula {
  tp_direction towards;           /* of the tilt */
  bool even;                      /* the number of teeth is */
  tp_pivot_kind kind;             /* of the toe */
  tp_fraction tan_critical_angle; /* of the critical angle about it */
} tp_family_formula;

/* The formulas of a toothed block for every number N of teeth. The sums over the underside add
 * terms that are polynomials of degree 2 at most in the number of the joint, the same for all
 * joints of a parity; for N of one parity they are polynomials in N of degree 3 at most, which
 * TP_FAMILY_FIXED members fix, so the formulas hold for every N. TP_FAMILY_CHECKED further members
 * were found to agree exactly. */
typedef struct tp_family {
  size_t size;                           /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;                /* of the scene, or NULL */
  tp_notation notation;                  /* how the formulas are written */
  char *count;                           /* what N is: a symbol, or 2 dx / lambda */
  bool count_is_symbol;                  /* beside those of the scene */
  size_t symbol_count;                   /* of both: */
  TP_OUTSIDE char **symbols;             /* as the formulas write them */
  TP_OUTSIDE char **parameters;          /* symbol_count of them: as the scene calls them */
  long fixed_by[2][TP_FAMILY_FIXED];     /* odd, even: the N that fix the formulas */
  long checked_on[2][TP_FAMILY_CHECKED]; /* the N that they were checked on */
  tp_family_formula formulas[4];         /* odd left, odd right, even left, even right */
} tp_family;

/* One formula for every number of teeth, for the scene's left end. Scenes of other blocks are bad
 * input. TP_NO_ANSWER and the rest as of tp_derive. */
TP_MUST_USE tp_status tp_derive_family(tp_family **family, const tp_scene *scene,
                                       tp_notation notation, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_family_free(tp_family *family);

/* What was derived, in its notation, and as JSON. `*text` is allocated with malloc and is the
 * caller's to free. */
TP_MUST_USE tp_status tp_report_family(char **text, const tp_family *family);
TP_MUST_USE tp_status tp_report_family_json(char **text, const tp_family *family);
TP_MUST_USE tp_status tp_report_derivation(char **text, const tp_derivation *derivation);
TP_MUST_USE tp_status tp_report_derivation_json(char **text, const tp_derivation *derivation);

#ifdef __cplusplus
}
#endif

#endif
