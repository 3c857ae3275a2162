/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Topple: does a rock block stand, slide or topple on its base, and at which tilt?
 *
 * The whole public library. A scene is read from a file, solved, and reported:
 *
 *     tp_scene *scene = NULL;
 *     tp_solution *solution = NULL;
 *     tp_message message;
 *     tp_status status = tp_scene_read(&scene, "block.yaml", &message);
 *     if (status == TP_OK) {
 *       const tp_solve_options options = tp_solve_options_default();
 *       status = tp_solve(&solution, scene, &options, &message);
 *     }
 *     if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
 *     tp_solution_free(solution);
 *     tp_scene_free(scene);
 *
 * Frame: x along the mean plane of the base, up-dip to the right; y normal to it, up. Tilting
 * towards the left lowers the side x -> -infinity. SI units; angles in degrees where the name
 * says so. Every computed number is a tp_bounded: the truth lies within `error` of `value`.
 * The library never prints, exits or aborts by itself and keeps no mutable globals. Where memory is
 * exhausted its own requests, libyaml's and CGAL's end a call with TP_OUT_OF_MEMORY; FLINT and GMP
 * print and abort the process, so sizes are bounded before they are called. A program that wants
 * another end gives them functions that do not return without memory, before its first call:
 * __flint_set_memory_functions and mp_set_memory_functions, as src/cli/memory.c does. What FLINT
 * keeps for the next call is given back by flint_cleanup().
 *
 * What the calling thread has set is its own: every call puts the locale, the floating-point
 * environment (rounding, traps, flushing to zero) and MPFR's range of exponents aside, and brings
 * them back as it returns; one that is left by a jump, from a function for memory, does not.
 * Threads may call at the same time. No pointer may be NULL, but for a message, which then is not
 * told, and what a _free function is given; a call that gets one is TP_BAD_INPUT, and its message
 * names it. */

#ifndef TOPPLE_H
#define TOPPLE_H

#include "topple_contact.h"
#include "topple_governing.h"
#include "topple_limit.h"
#include "topple_onset.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a pivot lies on the underside of the block (Fig. 8 of Alejano et al.). */
typedef enum tp_pivot_kind {
  TP_PIVOT_VALLEY,   /* a low end: both neighbours on the underside are higher */
  TP_PIVOT_PEAK,     /* a high end: both neighbours are lower */
  TP_PIVOT_FLAT_END, /* the end of a facet that is parallel to the mean plane */
  TP_PIVOT_FLANK     /* between a low and a high end */
} tp_pivot_kind;

typedef struct tp_pivot {
  tp_pivot_kind kind;
  bool rounded;    /* the corner is: (x, y) is where the axis then lies */
  bool admissible; /* to first order: turning about it opens every contact facet */
  tp_bounded x_m, y_m;
  tp_bounded
      critical_angle_deg; /* -180 to 180; above 90 it never topples, below 0 not even level */
  bool never;             /* loads keep it from toppling about this pivot at any tilt, ... */
  bool always;            /* ... or from standing on it at any: there is no critical angle */
  size_t limit_count; /* with loads: every tilt in (0, 90) at which it lets go, or holds again */
  tp_bounded *limits_deg; /* owned by the case */
  tp_fos fos_resultant; /* Eq. (2): tan(critical angle) / tan(tilt); with loads what stabilises over
                           what overturns */
  tp_fos fos_elements;  /* (A1.3): each element's components by their own sign */
} tp_pivot;

typedef enum tp_element_kind { TP_ELEMENT_TRIANGLE, TP_ELEMENT_SLAB } tp_element_kind;

/* One element of the account of moments about the governing pivot. */
typedef struct tp_element {
  tp_element_kind kind;
  size_t part;             /* 0: the block; k: its k-th part */
  tp_bounded weight;       /* N, or a fraction of the block's when the scene gives no unit weight */
  tp_bounded normal_arm_m; /* x arm of the component W cos(alpha); > 0 stabilises */
  tp_bounded parallel_arm_m; /* y arm of the component W sin(alpha); > 0 overturns */
  tp_bounded stabilising;    /* weight times metre */
  tp_bounded overturning;
} tp_element;

typedef struct tp_account {
  size_t count; /* 0 when the account was not asked for */
  tp_element *elements;
  bool at_critical_angle; /* the scene gives no tilt angle: the account is drawn up at the limit */
  tp_bounded angle_deg;
  tp_bounded stabilising, overturning; /* sums */
} tp_account;

/* Patton's sliding angle phi_b + i (Eq. 6) on the facet that governs. No statics of contact forces
 * stands behind it: a facet wholly up-dip of the centroid sheds its load as the table tilts, and of
 * the others the one that rises most steeply down-dip governs. Where that would slide on level
 * ground, the block wedges itself between its facets, and all of them count. */
typedef struct tp_sliding {
  bool known;  /* the scene gives a friction angle */
  bool never;  /* at no tilt: phi_b + i reaches 90 degrees */
  bool always; /* at every tilt: its loads push it down-dip harder than it resists at any */
  bool opens;  /* no other facet stands in the way of sliding along this one */
  tp_bounded friction_angle_deg; /* phi_b, at the normal stress where it slides */
  tp_bounded facet_angle_deg;    /* i, positive where the block must climb */
  tp_bounded facet_x0_m, facet_y0_m, facet_x1_m, facet_y1_m;
  tp_bounded critical_angle_deg; /* with loads, from the forces along and across the facet */
  tp_fos fos;
  tp_fos fos_strength; /* by reducing tan(phi_b): tan(phi_b) / tan(tilt - i); without loads */
} tp_sliding;

/* Can the toe alone hold the block at its critical angle, where moment equilibrium puts all the
 * weight on it? Only if the reaction lies in the friction cone of the facets at the toe, that is up
 * to phi_b + i of the steepest of them. If not, the block may let go before its critical angle:
 * contact forces decide, which moments do not see. */
typedef struct tp_toe {
  bool known; /* the scene gives a friction angle, and a pivot governs */
  bool holds;
  bool upright; /* a facet at the toe stands upright in the way: it holds at any angle */
  tp_bounded limit_angle_deg; /* phi_b + i; unless upright */
} tp_toe;

/* A load's moment about the governing pivot at the scene's tilt, N m, overturning positive, and
 * where it counts. */
typedef enum tp_load_side { TP_STABILISES, TP_OVERTURNS, TP_LESSENS_OVERTURNING } tp_load_side;

typedef struct tp_load_result {
  const char *name;
  TP_OUTSIDE char called_for_by[256];
  tp_bounded moment_nm;
  tp_load_side side;
} tp_load_result;

/* What a rounded toe does beyond its critical angle: roll to a new rest, or over. */
typedef enum tp_rolls { TP_ROLLS_NOT, TP_ROLLS_BACK, TP_ROLLS_OVER } tp_rolls;

typedef struct tp_case {
  tp_direction towards;
  size_t pivot_count;
  tp_pivot *pivots; /* from left to right along the contact */
  bool has_governing;
  size_t governing;        /* index of the admissible pivot with the least critical angle */
  bool governing_tie;      /* another admissible pivot has the same critical angle: */
  long governing_tie_bits; /* 0: exactly; else so many bits do not tell the two apart */
  tp_rolls rolls; /* the corner at the governing pivot; TP_ROLLS_NOT: sharp, or under loads */
  bool rests;     /* at the scene's tilt, beyond the critical angle, it rolls to a new rest ... */
  tp_bounded rest_turn_deg; /* ... turned by this on its base */
  tp_sliding sliding;
  tp_toe toe;
  tp_limit limit; /* with the base of the scene */
  tp_limit
      limit_otherwise; /* with a base that ends at the toe, or goes on, if the scene's does not */
  bool base_matters;   /* the two differ in kind, in mechanism, or by more than 1e-6 degrees */
  tp_onset onset;      /* up to which tilt no motion can begin, with the base of the scene */
  tp_limit limit_back; /* by contact forces, as the table is tilted the other way under the same
                          loads: at tilts below minus its angle the block lets go up-dip */
  tp_mechanism mechanism;     /* at the scene's tilt; without one, the first as the table is tilted.
                                 Where it moves, what can begin there: where several motions can, that
                                 of the limit if it is among them, else the first of the onset's
                                 `beginnings`, which name them all */
  tp_mechanism first;         /* what happens first as the table is tilted from level */
  bool has_first_angle;       /* not where it is interlocked, or holds at no tilt, or undecided */
  tp_bounded first_angle_deg; /* where `first` happens */
  bool has_margin;            /* false, too, where the onset is at no angle or undecided */
  tp_bounded margin_deg; /* the lower of the onset and `first_angle_deg` minus the scene's tilt */
  bool has_margin_to_first;
  tp_bounded margin_to_first_deg; /* first_angle_deg minus the scene's tilt */
  bool slides_sooner;   /* the friction that a bond adds apart, it slides before `limit` */
  bool falls_backwards; /* at this tilt it topples or slides the other way, up-dip */
  tp_governing_fos governing_fos; /* at the scene's tilt */
  tp_account account;
  tp_bounded *limits; /* of all pivots, with loads */
  size_t load_count;  /* with loads and a tilt: the weight's two components, then each load */
  tp_load_result *loads;
  bool
      water_overtops; /* water that stays level: beyond this tilt it would stand above the top of */
  tp_bounded water_overtops_deg; /* its face, whose pressure is reckoned as if the face went on */
} tp_case;

typedef struct tp_block_result {
  tp_bounded area_m2;
  tp_bounded centroid_x_m, centroid_y_m; /* of the weight */
  /* About the centroid, weighted by unit weight over mean unit weight. */
  tp_bounded second_moment_xx_m4, second_moment_yy_m4, second_moment_xy_m4;
  tp_bounded thickness_m;
  bool has_weight;
  tp_bounded weight_n;
  size_t vertices, holes, parts, triangles; /* no vertices: an ellipse */
} tp_block_result;

/* A toothed block in both of the paper's descriptions (its section 5.1). */
typedef struct tp_teeth_result {
  bool known;
  size_t count;                                                       /* N */
  tp_bounded width_m, height_m, depth_m;                              /* a, b, c */
  tp_bounded block_width_m, mean_height_m, amplitude_m, wavelength_m; /* dx, y, A, lambda */
  tp_pivot_kind left_end, right_end;
} tp_teeth_result;

/* What ran, and what in the scene called for it. */
typedef struct tp_effect {
  const char *name;
  TP_OUTSIDE char called_for_by[256]; /* file:line:column, or an option */
  double seconds;
  tp_level level;
} tp_effect;

enum { TP_EFFECTS_MAX = 24 };

typedef struct tp_solution {
  TP_OUTSIDE char *title;
  const char *length_unit; /* of the scene; a static string */
  double metres_per_unit;
  bool has_tilt_angle;
  tp_bounded tilt_angle_deg;
  bool has_friction;
  tp_bounded friction_angle_deg;
  bool friction_is_residual; /* Barton's law: the angle at a stress is above it */
  bool friction_is_patton;   /* Patton's law: phi_b + i of the scene */
  tp_block_result block;
  tp_teeth_result teeth;
  tp_frame_result frame;
  tp_contact_result contact;
  bool loaded; /* the scene calls for loads besides the weight */
  size_t case_count;
  tp_case cases[2];
  tp_notes notes; /* of the scene's reading and of its solution */
  size_t effect_count;
  tp_effect effects[TP_EFFECTS_MAX];
  tp_level level;   /* the arithmetic that certified the numbers */
  long bits;        /* working precision of the last evaluation */
  int digits;       /* asked of every number */
  bool open_number; /* one is not certain to them, and given with the bound that it has: 0, as a
                       rule */
  long zero_bits; /* 0: every decision is proven; else some rest on quantities that so many bits do
                     not tell from zero, besides the ties that say so themselves */
  struct tp_decimals *decimals; /* owns the digits of numbers beyond a double, where asked for */
} tp_solution;

typedef struct tp_scene tp_scene;

/* Read the scene in `path`. Files that the scene names are looked for beside it. */
TP_MUST_USE tp_status tp_scene_read(tp_scene **scene, const char *path, tp_message *message);
/* The same from text in memory; `name` is what messages call it, and files that the scene names are
 * looked for beside a file of that name. */
TP_MUST_USE tp_status tp_scene_read_text(tp_scene **scene, const char *text, const char *name,
                                         tp_message *message);
void tp_scene_free(tp_scene *scene);

enum { TP_DIGITS_MAX = 1000 };

typedef struct tp_solve_options {
  bool elements;           /* draw up the account of moments by elements */
  bool limit;              /* find the static limit, where the scene gives a friction angle */
  bool strength_reduction; /* and its factor of safety, where the scene gives a tilt angle */
  bool motion_ranges;      /* find which motions can begin at every tilt (tp_onset.ranges) */
  int digits;     /* relative accuracy asked of every number: 10^-digits, 1 to TP_DIGITS_MAX */
  tp_level level; /* the dearest arithmetic allowed; TP_UNDECIDED where it is not enough */
} tp_solve_options;

tp_solve_options tp_solve_options_default(void);

/* Stability of the scene's block in each direction of tilt that the scene asks for. */
TP_MUST_USE tp_status tp_solve(tp_solution **solution, const tp_scene *scene,
                               const tp_solve_options *options, tp_message *message);
void tp_solution_free(tp_solution *solution);

/* Did the precision allowed leave a mechanism open, or a number less certain than was asked? Every
 * other number is certain all the same, and each has its proven bound. */
bool tp_solution_is_undecided(const tp_solution *solution);

/* Does every case meet a design factor of safety: is its governing one certainly as much, at a tilt
 * at which the block stands? Cautious: without a tilt or a friction angle, and where a motion can
 * begin, it is not met; what is not decided, or as near to the factor as its bound, is open. */
typedef enum tp_design { TP_DESIGN_MET, TP_DESIGN_NOT_MET, TP_DESIGN_OPEN } tp_design;
tp_design tp_solution_meets(const tp_solution *solution, double design_fos);
tp_design tp_case_meets(const tp_case *own, double design_fos); /* one of them */

/* Reports: `*text` is allocated with malloc and is the caller's to free. */
TP_MUST_USE tp_status tp_report_text(char **text, const tp_solution *solution);
TP_MUST_USE tp_status tp_report_elements(char **text, const tp_solution *solution);
TP_MUST_USE tp_status tp_report_json(char **text, const tp_solution *solution);
/* Notes and cautions of a solution, as on its page; an empty text where there are none. */
TP_MUST_USE tp_status tp_report_notes(char **text, const tp_solution *solution);
/* What ran: effects, what called for each, and what each cost. */
TP_MUST_USE tp_status tp_report_effects(char **text, const tp_solution *solution);

/* JSON with all pivots, or with those that can govern or hold the block alone: they bear their
 * index. tp_report_json lists them all up to 300. */
typedef enum tp_pivots_listed {
  TP_PIVOTS_BY_COUNT,
  TP_PIVOTS_ALL,
  TP_PIVOTS_GOVERNING
} tp_pivots_listed;
TP_MUST_USE tp_status tp_report_json_pivots(char **text, const tp_solution *solution,
                                            tp_pivots_listed listed);
/* A table, a row for each direction of each solution: tilt, verdict, governing factor, and the
 * angles by every way. In Markdown, with the limit on a base that ends at the toe and on one that
 * goes on; in CSV, each number followed by its bound, with the limit on the scene's base. A factor
 * that is but an upper bound, since another is undecided, is left out of CSV. */
TP_MUST_USE tp_status tp_report_table(char **text, const tp_solution *const *solutions,
                                      size_t count);
TP_MUST_USE tp_status tp_report_csv(char **text, const tp_solution *const *solutions, size_t count);

#ifdef __cplusplus
}
#endif

#include "topple_accuracy.h"
#include "topple_chart.h"
#include "topple_derive.h"
#include "topple_figure.h"
#include "topple_find.h"
#include "topple_verify.h"

#endif
