/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a solved scene says: block, contact, and for each direction of tilt pivots, sliding, both
 * limits, the mechanism and its margin. Plain structs, made by tp_solve (topple_solve.h), that own
 * what they point to: tp_solution_free frees it all. A field is to be read where the one beside it,
 * or its kind or state, says so; else it is 0. Lengths are in metres along the axes of the frame
 * that topple.h explains, angles in degrees. */

#ifndef TOPPLE_SOLUTION_H
#define TOPPLE_SOLUTION_H

#include "topple_contact.h"
#include "topple_governing.h"
#include "topple_limit.h"
#include "topple_onset.h"
#include "topple_poses.h"

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

/* A point of the contact about which the block might turn. */
typedef struct tp_pivot {
  size_t index;       /* its number along the contact from the left, from 0 */
  tp_pivot_kind kind; /* where it lies */
  bool rounded;       /* the corner is: (x, y) is where the axis then lies */
  bool admissible;    /* to first order: turning about it opens every contact facet */
  bool computed;      /* its numbers were asked for (tp_solve_options.pivots); else they are 0 */
  bool never;         /* loads keep it from toppling about this pivot at any tilt */
  bool always; /* loads keep it from standing on this pivot at any tilt: there is no critical angle
                */
  tp_bounded x_m, y_m;           /* if computed: the point, or the axis */
  tp_bounded critical_angle_deg; /* if computed && !never && !always: -180 to 180; above 90 it never
                                    topples, below 0 not even level */
  size_t limit_count; /* with loads: every tilt in (0, 90) at which it fails, or is held again */
  tp_bounded *limits_deg; /* owned by the case */
  tp_fos fos; /* if computed: Eq. (2): tan(critical angle) / tan(tilt); with loads stabilising
                           over overturning moment */
  tp_fos fos_elements; /* if computed: (A1.3): each element's components by their own sign */
} tp_pivot;

/* What a section is cut into (section 5.1 of the paper): triangles, of a toothed block slabs too.
 */
typedef enum tp_element_kind { TP_ELEMENT_TRIANGLE, TP_ELEMENT_SLAB } tp_element_kind;

/* One element of the account of moments about the governing pivot. */
typedef struct tp_element {
  tp_element_kind kind;    /* triangle or slab */
  size_t part;             /* 0: the block; k: its k-th part */
  tp_bounded weight;       /* N, or a fraction of the block's when the scene gives no unit weight */
  tp_bounded normal_arm_m; /* x arm of the component W cos(alpha); > 0 stabilises */
  tp_bounded parallel_arm_m;             /* y arm of the component W sin(alpha); > 0 overturns */
  tp_bounded stabilising, overturning;   /* weight times metre, not below 0 */
  tp_bounded area_m2;                    /* of it */
  tp_bounded centroid_x_m, centroid_y_m; /* of its area */
} tp_element;

/* The account of moments by elements about the governing pivot (Appendix A1 of the paper). */
typedef struct tp_account {
  size_t account_count;   /* 0 when the account was not asked for */
  tp_element *account;    /* account_count of them */
  bool at_critical_angle; /* the scene gives no tilt angle: the account is drawn up at the limit */
  tp_bounded angle_deg;   /* the tilt that it is for */
  tp_bounded stabilising, overturning; /* the sums */
} tp_account;

/* Patton's sliding angle phi_b + i (Eq. 6) on the governing facet. No statics of contact forces
 * stands behind it: a facet wholly up-dip of the centroid sheds its load as the table tilts, and of
 * the others the one that rises most steeply down-dip governs. Where that would slide on level
 * ground, the block wedges itself between its facets, and all of them count. */
typedef struct tp_sliding {
  bool known;  /* the scene gives a friction angle */
  bool never;  /* at no tilt: phi_b + i reaches 90 degrees */
  bool always; /* at every tilt: its loads push it down-dip harder than it resists at any */
  bool opens;  /* sliding along this facet is not blocked by another one */
  bool uneven; /* facets parallel to this one have more friction: it slides along all of them */
  tp_bounded friction_angle_deg; /* phi_b, at the normal stress where it slides; of facets with
                                    different frictions the least along which it slides */
  tp_bounded facet_angle_deg;    /* i, positive where the block must climb */
  tp_bounded facet_x0_m, facet_y0_m, facet_x1_m, facet_y1_m; /* its ends, left and right */
  tp_bounded critical_angle_deg; /* if !never && !always: with loads, from the forces along and
                                    across the facet */
  tp_fos fos;                    /* tan(phi_b + i) / tan(tilt) (Eq. 6); with loads by the forces */
  bool has_forces; /* with loads and a tilt: fos is ((normal - uplift) tan(phi) + cohesion + held) /
                      driving, of these forces at that tilt, N */
  tp_bounded friction_tangent; /* if has_forces: tan(phi), at the normal stress of the tilt */
  tp_bounded normal_n;         /* if has_forces: what presses on the facet, water aside */
  tp_bounded uplift_n;   /* if has_forces: by how much water presses less; below 0 it presses */
  tp_bounded cohesion_n; /* if has_forces: cohesion times the area of the contact */
  tp_bounded held_n;     /* if has_forces: the pull of passive anchors that holds back */
  tp_bounded driving_n;  /* if has_forces: along the facet, down-dip */
  tp_fos fos_strength;   /* by reducing tan(phi_b): tan(phi_b) / tan(tilt - i); without loads */
} tp_sliding;

/* Can the toe alone hold the block at its critical angle, where moment equilibrium puts all the
 * weight on it? Only if the reaction lies in the friction cone of the facets at the toe, that is up
 * to phi_b + i of the steepest of them, or where facets have different frictions to the largest.
 * If not, the block may begin to move before its critical angle: contact forces decide, which
 * moments do not see. */
typedef struct tp_toe {
  bool known;   /* the scene gives a friction angle, and a pivot governs */
  bool holds;   /* it can */
  bool upright; /* a facet at the toe stands upright in the way: it holds at any angle */
  tp_bounded limit_angle_deg; /* if !upright: phi_b + i */
} tp_toe;

/* Where a load counts in the factor of safety: stabilising over overturning moment. */
typedef enum tp_load_side { TP_STABILISES, TP_OVERTURNS, TP_LESSENS_OVERTURNING } tp_load_side;

/* One load of that account. */
typedef struct tp_load_result {
  const char *name;               /* a static string */
  TP_OUTSIDE char *called_for_by; /* file:line:column; empty where it is of no one place */
  tp_bounded moment_nm; /* about the governing pivot at the scene's tilt, overturning positive */
  tp_load_side side;    /* where it counts */
  bool has_arm;         /* it is a force that is not 0: */
  tp_bounded force_n;   /* if has_arm: its size at the scene's tilt */
  tp_bounded arm_m;     /* if has_arm: of the governing pivot from its line, overturning positive */
} tp_load_result;

/* What a rounded toe does beyond its critical angle: roll to a new rest, or over. */
typedef enum tp_rolls { TP_ROLLS_NOT, TP_ROLLS_BACK, TP_ROLLS_OVER } tp_rolls;

/* One direction of tilt. */
typedef struct tp_case {
  tp_direction towards;    /* which */
  size_t candidate_count;  /* points of the contact: candidate pivots in all */
  size_t pivot_count;      /* of the pivots in the list */
  tp_pivot *pivots;        /* those asked for (tp_solve_options.pivots), from left to right */
  bool has_toppling_pivot; /* some pivot is admissible: */
  size_t toppling_pivot; /* place in `pivots` of the admissible one with the least critical angle */
  bool toppling_tie;     /* another admissible pivot has the same critical angle: */
  long toppling_tie_bits; /* 0: exactly; else so many bits do not distinguish the two */
  tp_rolls rolls; /* the corner at the governing pivot; TP_ROLLS_NOT: sharp, or under loads */
  bool rests;     /* at the scene's tilt, beyond the critical angle, it rolls to a new rest */
  tp_bounded rest_turn_deg; /* if rests: by what it turns on its base */
  tp_sliding sliding;       /* by angles, without statics */
  tp_toe toe;               /* can it bear what moments put on it? */
  tp_limit limit;           /* with the base of the scene */
  tp_limit limit_otherwise; /* if limit_otherwise.kind != TP_LIMIT_NOT_ASKED: with a base that ends
                               at the toe, or extends past it, if the scene's does not */
  bool base_matters;        /* the two differ in kind, in mechanism, or by more than 1e-6 degrees */
  tp_onset onset;           /* up to which tilt no motion can begin, with the base of the scene */
  tp_limit limit_holds_from;  /* if limit_holds_from.kind != TP_LIMIT_NOT_ASKED: by contact forces,
                           as the table is tilted the other way under the same loads: at tilts below
                           minus its angle the block begins to move up-dip */
  tp_mechanism mechanism;     /* at the scene's tilt; without one, the first as the table is tilted.
                                 Where it moves, what can begin there: of several motions that
                                 of the limit if it is among them, else the first of the onset's
                                 `beginnings`, which name them all */
  tp_mechanism first;         /* what happens first as the table is tilted from level */
  bool has_first_angle;       /* not where it is interlocked, or holds at no tilt, or undecided */
  tp_bounded first_angle_deg; /* where `first` happens */
  bool has_margin;            /* false, too, where the onset is at no angle or undecided */
  tp_bounded margin_deg; /* the lower of the onset and `first_angle_deg` minus the scene's tilt */
  bool has_margin_to_first;       /* there are both: */
  tp_bounded margin_to_first_deg; /* first_angle_deg minus the scene's tilt */
  bool slides_sooner;   /* the friction that a bond adds apart, it slides before `limit` */
  bool falls_backwards; /* at this tilt it topples or slides the other way, up-dip */
  tp_governing_fos governing_fos; /* at the scene's tilt */
  tp_account elements;            /* if elements.account_count > 0: by elements, where asked for */
  tp_bounded *limits;             /* of the pivots listed, with loads */
  size_t load_count;     /* with loads and a tilt: the weight's two components, then each load */
  tp_load_result *loads; /* about the governing pivot */
  bool
      water_overtops; /* water that stays level: beyond this tilt it would stand above the top of */
  tp_bounded water_overtops_deg; /* if water_overtops: its face, whose pressure is computed as if
                                    the face continued upwards */
  bool may_steepen;          /* it lies at its place, stands there, and as it steepens a motion can
                                begin (topple_onset.h): */
  tp_bounded steepen_by_deg; /* if may_steepen: after so much, */
  tp_bounded steepen_to_deg; /* if may_steepen: at that dip, or tilt */
  tp_limit_balance balance;  /* of `limit` */
  bool has_tilt_of_factor; /* the factor on driving loads is that of two tilts, of the weight alone:
                            */
  tp_bounded tilt_of_factor_deg; /* if has_tilt_of_factor: at which the motion begins */
} tp_case;

/* Bolts of one entry of the scene's anchors, or a pressure of a support, as the scene
 * has them. */
typedef struct tp_support {
  bool is_pressure;         /* of a lining or a wall; else bolts */
  bool passive;             /* counts as resistance; else takes from what overturns */
  tp_bounded force_kn;      /* if !is_pressure: of one bolt */
  size_t rows;              /* if !is_pressure: of the bolts */
  bool has_spacing;         /* bolts of a row stand apart by: */
  tp_bounded spacing_m;     /* if has_spacing: along the slope */
  tp_bounded force_kn_m;    /* per metre along the slope, of all rows */
  tp_bounded total_kn;      /* on the thickness of the block, of all rows */
  bool has_capacity;        /* of one bolt: */
  tp_bounded capacity_kn;   /* if has_capacity: what it can bear */
  tp_bounded utilisation;   /* if has_capacity: the force over that */
  bool has_length;          /* of one bolt: */
  tp_bounded length_m;      /* if has_length: of the whole */
  tp_bounded bond_length_m; /* if has_length: beyond the block, the least of all rows */
} tp_support;

/* The block as a body. */
typedef struct tp_block_result {
  tp_bounded area_m2;                    /* of the section, without holes */
  tp_bounded centroid_x_m, centroid_y_m; /* of the weight */
  tp_bounded second_moment_xx_m4, second_moment_yy_m4,
      second_moment_xy_m4; /* int x^2, y^2, x y dA about the centroid, weighted by unit weight over
                              mean unit weight */
  tp_bounded thickness_m;  /* normal to the section; 1 where the scene gives none */
  bool has_weight;         /* the scene gives a unit weight: */
  tp_bounded weight_n;     /* of the whole block */
  size_t vertices, holes, parts, triangles; /* no vertices: an ellipse */
} tp_block_result;

/* A toothed block in both of the paper's descriptions (its section 5.1). */
typedef struct tp_teeth_result {
  bool known;                                                         /* the block is one */
  size_t count;                                                       /* N */
  tp_bounded width_m, height_m, depth_m;                              /* a, b, c */
  tp_bounded block_width_m, mean_height_m, amplitude_m, wavelength_m; /* dx, y, A, lambda */
  tp_pivot_kind left_end, right_end;                                  /* valley or peak */
} tp_teeth_result;

/* What ran, and what in the scene called for it. */
typedef struct tp_effect {
  const char *name;               /* a static string */
  TP_OUTSIDE char *called_for_by; /* file:line:column, or an option */
  double seconds;                 /* without what other effects took meanwhile */
  tp_level level;                 /* the arithmetic that it ended with */
} tp_effect;

/* A number that was set in the scene by tp_scene_with_settings. */
typedef struct tp_setting {
  TP_OUTSIDE char *key;     /* of the number, as it was given */
  TP_OUTSIDE char *formula; /* likewise */
  const char *unit; /* of a length: that of the scene; NULL: the key names it, or there is none */
  tp_bounded value; /* of the formula */
} tp_setting;

/* A list of them. */
typedef struct tp_settings {
  size_t count;      /* of the items */
  tp_setting *items; /* in the order in which they were set; owned by what holds the list */
} tp_settings;

/* A unit that reports print in. */
typedef struct tp_result_unit {
  const char *name; /* a static string; NULL: the scene asks for none, and reports choose */
  double si;        /* one of it in m, N, N m or Pa, rounded to a double once; 1 without a name */
} tp_result_unit;

/* Those that a scene asks for. */
typedef struct tp_result_units {
  tp_result_unit length; /* m */
  tp_result_unit force;  /* N */
  tp_result_unit moment; /* N m */
  tp_result_unit stress; /* Pa */
} tp_result_units;

/* An earthquake that was analysed: of a block that lies on a slope one down-dip and one up-dip,
 * each with the vertical part of the scene and without it. */
typedef struct tp_earthquake {
  tp_direction towards;   /* the side to which its horizontal part drives the block */
  bool up_dip;            /* against the dip */
  bool vertical;          /* with the scene's vertical part */
  tp_mechanism mechanism; /* what the block does under it */
  tp_fos fos;             /* its governing factor */
  bool fails_against;     /* it moves the other way than it is shaken: `fos` is no measure of this
                             earthquake */
} tp_earthquake;

/* Down-dip and up-dip, each with and without the vertical part. */
enum { TP_EARTHQUAKES_MAX = 4 };

/* A scene solved. */
typedef struct tp_solution {
  size_t size;                /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;     /* of the scene, or NULL */
  TP_OUTSIDE char *load_case; /* the name of the load case that it is of; NULL: of none */
  char *partial_factors;      /* those that it was solved with, as they act in the combination that
                                 governs; NULL: none */
  const char *length_unit;    /* that reports print in: the scene's, unless it asks for another; a
                                 static string */
  double metres_per_unit;     /* as a double */
  tp_result_units result_units;  /* that the scene asks for */
  bool has_tilt_angle;           /* the scene gives one: */
  tp_bounded tilt_angle_deg;     /* that the block lies at, along its mean plane */
  bool has_friction;             /* the scene gives one: */
  tp_bounded friction_angle_deg; /* if has_friction: of the contact */
  bool friction_is_residual;     /* Barton's law: the angle at a stress is above it */
  bool friction_is_patton;       /* Patton's law: phi_b + i of the scene */
  tp_block_result block;         /* area, centroid, weight */
  tp_teeth_result teeth;         /* of a toothed block */
  tp_rest_result rest;           /* of a block that was set down on its profile */
  tp_poses_result poses;         /* all in which it can rest, where the scene asks for them */
  tp_joint_result joint;         /* of a block that was shifted along its mated base */
  tp_within_result within;       /* of a block that was moved onto its profile where it is near */
  tp_smoothed_result smoothed;   /* of a sole whose facets were levelled */
  tp_frame_result frame;         /* what the coordinates lie along */
  size_t earthquake_count;       /* where several were analysed; else 0 */
  tp_earthquake earthquakes[TP_EARTHQUAKES_MAX]; /* the first of them governs: the cases are its */
  tp_contact_result contact;                     /* where the block touches its base */
  bool loaded;                                   /* the scene calls for loads besides the weight */
  size_t case_count;                             /* directions that the scene tilts in, */
  size_t case_size;    /* of a tp_case, as the library has it (tp_solution_case) */
  tp_case *cases;      /* left before right */
  tp_notes notes;      /* of the scene's reading and of its solution */
  size_t effect_count; /* what ran: */
  tp_effect *effects;  /* in the order in which it first did */
  tp_level level;      /* the arithmetic that certified the numbers */
  long bits;           /* working precision of the last evaluation */
  int digits;          /* asked of every number */
  bool open_number;    /* one is not certain to them, and is given with its actual bound: 0, as a
                          rule */
  long zero_bits; /* 0: every decision is proven; else some rest on quantities that so many bits do
                     not distinguish from zero, besides the ties reported as such */
  tp_settings settings;                      /* what was set in the scene */
  size_t friction_facet_count;               /* entries of facets with different friction, */
  tp_facet_friction_result *friction_facets; /* in the order of the scene */
  size_t support_count;                      /* bolts and pressures of a support, */
  tp_support *supports;                      /* in the order of the scene */
  struct tp_decimals *decimals; /* owns the digits of numbers beyond a double, where asked for */
  unsigned combination; /* if partial_factors != NULL: of favourable and unfavourable actions, the
                           one that governs, as the library counts them */
} tp_solution;

/* Case `k`, from 0, of a solution: where it lies also if the library, newer than the program, has
 * more members in a case than the program knows. */
static inline const tp_case *tp_solution_case(const tp_solution *solution, size_t k) {
  return (const tp_case *)(const void *)((const char *)solution->cases + k * solution->case_size);
}

#ifdef __cplusplus
}
#endif

#endif
