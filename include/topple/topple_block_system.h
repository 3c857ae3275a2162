/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks in contact, in one scene (docs/blocks_in_contact.md): the greatest tilt that forces
 * between them can hold, the factor of safety by strength reduction, and how they begin to move
 * beyond. Included by topple.h.
 *
 * Limits are those of limit analysis (Livesley 1978): below them some forces within the strength of
 * all joints hold every block, above them none do, and collapse is certain; each is proven from
 * both sides. That forces can hold the blocks does not say that they do: friction lets blocks move
 * for which forces in equilibrium exist. The verdict `stands` is given only where that is
 * excluded, and `may move` where one is proven to be possible though forces can hold them. Forces
 * and weights are per metre of thickness. */

#ifndef TOPPLE_BLOCK_SYSTEM_H
#define TOPPLE_BLOCK_SYSTEM_H

#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How many blocks a scene has, with those that are ground; 0: it is of one block on its base. */
size_t tp_scene_block_count(const tp_scene *scene);

/* What many blocks do as they lie. */
typedef enum tp_system_verdict {
  TP_SYSTEM_STANDS,    /* no motion can begin */
  TP_SYSTEM_CAN_HOLD,  /* some forces hold all blocks; whether a motion can begin all the same is
                          not excluded */
  TP_SYSTEM_MAY_MOVE,  /* some forces hold all blocks, and a motion can begin all the same */
  TP_SYSTEM_COLLAPSES, /* no forces hold them: a motion begins */
  TP_SYSTEM_UNDECIDED  /* at the precision of the proofs */
} tp_system_verdict;

/* In words: stands, can be held, may move, collapses, undecided. */
const char *tp_system_verdict_name(tp_system_verdict verdict);

/* A block. */
typedef struct tp_system_block {
  TP_OUTSIDE char *name;   /* as the scene has it, or its number */
  bool ground;             /* it is fixed */
  tp_bounded area_m2;      /* of its section */
  tp_bounded centroid_x_m; /* its centroid, in the scene's axes */
  tp_bounded centroid_y_m; /* likewise */
  bool has_weight;         /* the scene gives unit weights: */
  tp_bounded weight_n_m;   /* if has_weight: per metre of thickness */
} tp_system_block;

/* A piece of an edge that two blocks share, or a corner of one within an edge of the other. */
typedef struct tp_system_contact {
  size_t first, second; /* numbers of the blocks; the first lies on the left of the way from
                          one end to the other */
  bool corner;          /* both ends are one point */
  tp_bounded from_x_m, from_y_m; /* the first end */
  tp_bounded to_x_m, to_y_m;     /* the second one */
  tp_bounded friction_angle_deg; /* of this contact */
  tp_bounded cohesion_kpa;       /* likewise, against sliding */
  tp_bounded tension_kpa;        /* and its tensile strength */
} tp_system_contact;

/* How a block begins to move in a collapse. Velocities are to a common scale: the fastest corner of
 * all has 1. */
typedef struct tp_system_motion {
  tp_mechanism mechanism;        /* stands (it stays at rest), slides, topples, or both */
  double velocity_x, velocity_y; /* of its centroid, in the scene's axes */
  double turn_per_m; /* counter-clockwise, per metre that the fastest corner moves; 0 of one that
                        slides */
} tp_system_motion;

/* What the joint does in a collapse. */
typedef enum tp_joint_state {
  TP_JOINT_AT_REST, /* no relative motion */
  TP_JOINT_SLIPS,   /* along the contact */
  TP_JOINT_OPENS    /* at one end or both */
} tp_joint_state;

/* In a word: closed, slips, opens. */
const char *tp_joint_state_name(tp_joint_state state);

/* What an end of a contact does as a motion begins. It slips forward where the first block moves
 * against the second one in the direction on whose left it lies. */
typedef enum tp_touch_state {
  TP_TOUCH_OPENS,
  TP_TOUCH_STICKS,
  TP_TOUCH_SLIPS_FORWARD,
  TP_TOUCH_SLIPS_BACK
} tp_touch_state;

/* In words: opens, sticks, slips forward, slips back. */
const char *tp_touch_state_name(tp_touch_state state);

/* Both ends of a contact as a motion begins; of a corner they are one. */
typedef struct tp_system_touch {
  tp_touch_state first_end, second_end; /* what each does */
} tp_system_touch;

/* A motion that can begin from rest, proven: accelerations, and forces in the contacts by Coulomb's
 * law, of which Newton's law holds for every block. */
typedef struct tp_system_start {
  double divisor;                   /* what the strength of all joints is divided by */
  double tilt_angle_deg;            /* at which all lies */
  size_t motion_count, touch_count; /* of the lists */
  tp_system_motion *motions; /* motion_count of them: by block, accelerations as velocities of a
                                collapse are given: the fastest corner of all has 1 */
  tp_system_touch *touches;  /* touch_count of them: by contact */
} tp_system_start;

/* Were motions looked for that begin though forces can hold the blocks? */
typedef enum tp_system_sought {
  TP_SYSTEM_SOUGHT,         /* and their exclusion */
  TP_SYSTEM_SOUGHT_TOO_MANY /* neither, of more than 48 free blocks: that none begins was tried by
                               equilibrium without any friction alone */
} tp_system_sought;

/* The force in a contact at the limit. */
typedef struct tp_system_force {
  double normal_n_m;    /* compression, without what water bears; below 0 only with tensile strength
                         */
  double shear_n_m;     /* on the first block, above 0 from the first end to the second */
  double x_m, y_m;      /* where it acts; where there is none, the middle */
  tp_bounded water_n_m; /* by which water in it pushes the two blocks apart, besides */
  tp_joint_state state; /* in the collapse */
} tp_system_force;

/* What acts on a block besides its weight and an earthquake. */
typedef enum tp_system_load_kind {
  TP_SYSTEM_LOAD_WATER_IN_JOINTS,
  TP_SYSTEM_LOAD_WATER_ON_FACES,
  TP_SYSTEM_LOAD_PRESSURE,
  TP_SYSTEM_LOAD_SURCHARGE,
  TP_SYSTEM_LOAD_SUPPORT_PRESSURE,
  TP_SYSTEM_LOAD_ANCHOR, /* of a bolt there are two where both ends hold in free blocks */
  TP_SYSTEM_LOAD_FORCE
} tp_system_load_kind;

/* In words: water in joints, water on faces, pressure, surcharge, support pressure, anchor, force.
 */
const char *tp_system_load_kind_name(tp_system_load_kind kind);

/* One such load on one block, at the tilt of the case; water on it is one load in joints and one on
 * faces. */
typedef struct tp_system_load {
  tp_system_load_kind kind;            /* what it is */
  size_t block;                        /* the number of the block */
  tp_bounded force_x_n_m, force_y_n_m; /* per metre of thickness, in the scene's axes */
  tp_bounded moment_n; /* about the block's centroid, in N m per metre, counter-clockwise */
} tp_system_load;

/* Is there a support that holds the blocks? */
typedef enum tp_system_support_state {
  TP_SYSTEM_SUPPORT_NUMBER,     /* a force, and no less */
  TP_SYSTEM_SUPPORT_NOT_NEEDED, /* they are held without */
  TP_SYSTEM_SUPPORT_NONE,       /* no such force holds them */
  TP_SYSTEM_SUPPORT_UNDECIDED   /* at the precision of the proofs */
} tp_system_support_state;

/* The least force at a point of a block with which forces within the strength of all joints over a
 * factor hold the blocks as they lie; and that by Goodman and Bray (1976). */
typedef struct tp_system_support {
  tp_system_support_state state; /* is there one? */
  size_t block;                  /* the number of the block that it acts on */
  tp_bounded x_m, y_m;           /* where */
  tp_bounded direction_deg;      /* of the force, from x towards y */
  tp_bounded fos;                /* the factor */
  tp_bounded force_n_m;          /* if state == TP_SYSTEM_SUPPORT_NUMBER: per metre. It is
                                    optimistic: some forces hold the blocks with it, and a motion may
                                    begin all the same */
  bool has_goodman_bray;         /* it acts on the toe of columns in a row, and can hold it: */
  double goodman_bray_n_m; /* if has_goodman_bray: the force for which to design, by their method
                              with strength divided by the factor; 0: none is needed */
  bool was_sought;         /* was it looked for from which force on no motion can begin? */
  bool has_standing;       /* some such force was found: */
  double standing_n_m, standing_to_n_m; /* if has_standing: with any force from the former to the
                                           latter no motion can begin, proven. More may push the
                                           blocks up */
  bool has_moving;                      /* a lesser force does not suffice: */
  double moving_n_m; /* if has_moving: with that force a motion can begin, or no forces hold the
                        blocks, proven */
} tp_system_support;

/* Is there a limit as all is tilted? */
typedef enum tp_system_limit {
  TP_SYSTEM_LIMIT_NUMBER,   /* a tilt */
  TP_SYSTEM_INTERLOCKED,    /* forces hold the blocks up to 90 degrees */
  TP_SYSTEM_LIMIT_UNDECIDED /* at the precision of the proofs */
} tp_system_limit;

/* What a column does by Goodman and Bray (1976). */
typedef enum tp_column_state {
  TP_COLUMN_STABLE,  /* it needs nothing of the next one */
  TP_COLUMN_TOPPLES, /* on the next one */
  TP_COLUMN_SLIDES   /* on its base */
} tp_column_state;

/* In a word: stable, topples, slides. */
const char *tp_column_state_name(tp_column_state state);

/* One column, with the friction of the joints as the scene has it. */
typedef struct tp_goodman_bray_column {
  size_t block;           /* its number */
  tp_column_state state;  /* what it does */
  double toppling_n_m;    /* P(n-1,t), that it needs against toppling; not above 0: none */
  double sliding_n_m;     /* P(n-1,s), against sliding */
  double push_n_m;        /* P(n-1), the greatest of both and 0: it pushes the next one towards the
                             toe by so much; the toe lacks it */
  double base_normal_n_m; /* on its base, compression */
  double base_shear_n_m;  /* above 0: up the slope */
  bool base_holds;        /* these are within the friction of the base */
} tp_goodman_bray_column;

/* Limit equilibrium of columns side by side (Goodman and Bray 1976): forces between columns act at
 * the top of each contact, with the friction there fully mobilised. Its numbers are doubles without
 * a bound. */
typedef struct tp_goodman_bray {
  bool applies;              /* the free blocks are such a row, which is pressed to this side */
  TP_OUTSIDE char *why_not;  /* if !applies: a sentence */
  bool has_fos;              /* this friction or a greater one is enough: */
  double fos;                /* if has_fos: tan(phi) of all joints over that at which the force at
                                the toe is zero; */
  bool fos_is_least;         /* it is only known to be more: the search ended there */
  bool has_friction_angle;   /* all joints have the same friction, and there is such a limit: */
  double friction_angle_deg; /* if has_friction_angle: at which that force is zero */
  bool has_forces;           /* the scene gives unit weights, so that forces are known in N */
  bool has_support;          /* and a support can hold the toe: */
  double support_n_m;        /* if has_support: horizontal, into the slope, at the top of the toe's
                                free side, that holds it; 0: it needs none */
  size_t column_count;       /* of the list */
  tp_goodman_bray_column *columns; /* column_count of them: from the toe up; forces are 0 where the
                                      scene gives no unit weights */
} tp_goodman_bray;

/* Proven bounds of the factor of safety by one definition: the number by which what drives the
 * blocks is multiplied, or the strength of all joints divided, where a motion can begin. Where one
 * can begin as they lie both are below 1, next to it. */
typedef struct tp_system_bounds {
  bool counts;            /* it decides when a motion begins; false: none, as where more strength
                             does not stop a motion that can begin */
  double at_least;        /* the factor is no less; 0: nothing is proven */
  double at_most;         /* it is no more: a motion can begin there, or no forces hold the blocks
                             beyond; an infinity where neither is proven */
  tp_mechanism mechanism; /* how the blocks begin to move there; stands: that is not known */
} tp_system_bounds;

/* The factor of safety: the least of those by both definitions (docs/blocks_in_contact.md). */
typedef struct tp_system_safety {
  tp_fos fos;                   /* TP_FOS_NO_OVERTURNING: unbounded; TP_FOS_UNDEFINED: none above 0;
                                   TP_FOS_UNDECIDED: between the bounds alone */
  double at_least, at_most;     /* proven bounds; an infinity where there is none above */
  bool has_definition;          /* it is by one of the definitions: */
  tp_fos_definition definition; /* if has_definition: by which, with the least upper bound */
  tp_mechanism mechanism;       /* if has_definition: against which motion; stands: not known */
  bool without_earthquake;      /* it is that of the blocks without the scene's earthquake */
} tp_system_safety;

/* One direction of tilt. */
typedef struct tp_system_case {
  tp_direction towards;          /* the side that the tilt lowers */
  tp_bounded tilt_angle_deg;     /* at which it lies: below 0, tilted to the other side */
  tp_system_verdict verdict;     /* what the blocks do there */
  tp_system_limit limit;         /* is there one? */
  tp_bounded critical_angle_deg; /* if limit == TP_SYSTEM_LIMIT_NUMBER: the greatest tilt of all
                                    that forces can hold, with earthquake, water and all other loads
                                    as they are */
  bool has_acceleration;         /* that, and it lies below: */
  tp_bounded critical_acceleration_g; /* if has_acceleration: the horizontal one, in g, to this
                                         side, that forces can hold at the tilt with the vertical
                                         part of the scene's earthquake; none where they hold no
                                         less, and where a motion can begin with none */
  tp_fos fos;         /* an upper bound of the factor of safety, by strength reduction: the number
                         by which the strength of all joints can be divided until no forces hold
                         the blocks as they lie;
                         TP_FOS_UNDEFINED: not 1000 times as much holds them */
  bool fos_is_least;  /* that is only proven to be exceeded: the search ended there */
  tp_fos fos_driving; /* an upper bound as well, by what drives: the number by which the loads
                         that drive the blocks to this side can be multiplied until no forces hold
                         them, those that rest on the base staying (docs/blocks_in_contact.md).
                         TP_FOS_NO_OVERTURNING: nothing drives them; TP_FOS_UNDEFINED: not even
                         without are they held */
  bool fos_driving_is_least;          /* that is only proven to be exceeded */
  tp_mechanism fos_driving_mechanism; /* if fos_driving.state == TP_FOS_NUMBER &&
                                         !fos_driving_is_least: how they begin to move beyond it */
  tp_system_sought sought;            /* how far motions were looked for */
  bool has_standing_fos;              /* it stands, and: */
  double standing_fos; /* if has_standing_fos: no motion can begin with the strength divided by
                          any number from 1 to this one, proven */
  bool standing_fos_is_least; /* the search ended there */
  bool has_moving_fos;        /* a motion was found: */
  double moving_fos;          /* if has_moving_fos: the least number found by which strength can be
                                 divided for a motion to begin, proven; the true factor is no more */
  bool moving_fos_is_most;    /* the search ended there */
  bool has_standing_fos_driving; /* it stands, and something drives it: */
  double standing_fos_driving; /* if has_standing_fos_driving: no motion can begin with what drives
                                  multiplied by any number from 1 to this one, proven */
  bool has_moving_fos_driving; /* a motion was found: */
  double moving_fos_driving;   /* if has_moving_fos_driving: the least number found by which what
                                  drives can be multiplied for a motion to begin, proven */
  bool has_standing_angle;     /* it stands, and: */
  double standing_angle_deg; /* if has_standing_angle: no motion can begin at any tilt from its own
                                to this one, proven */
  bool has_moving_angle;     /* a motion was found: */
  double moving_angle_deg; /* if has_moving_angle: the least tilt found, of those from level on, at
                              which a motion can begin, proven */
  tp_system_bounds fos_by_strength, fos_by_driving; /* the factor of safety by each definition */
  bool has_static; /* the scene has an earthquake: without it as well a motion may begin, and */
  tp_system_verdict static_verdict; /* if has_static: this is what the blocks do then */
  tp_system_bounds static_fos_by_strength,
      static_fos_by_driving; /* if has_static: the factor then */
  tp_system_safety
      governing_fos;            /* the factor of safety of the case, with and without earthquake */
  bool has_moving_acceleration; /* a motion was found, and none can begin without: */
  double moving_acceleration_g; /* if has_moving_acceleration: the least horizontal acceleration, in
                                   g, to this side, with which one can begin, of those found */
  bool has_standing_acceleration; /* it stands, and: */
  double standing_acceleration_g; /* if has_standing_acceleration: no motion can begin with any from
                                     that of the scene up to this one, proven */
  bool has_start;        /* a motion can begin as the blocks lie, or, where that is not known, with
                            the strength divided by moving_fos: */
  tp_system_start start; /* if has_start: that motion */
  bool has_required_fos; /* the scene requires a factor: */
  tp_design meets_required;  /* if has_required_fos: is it met? */
  bool has_support;          /* the scene asks for a support: */
  tp_system_support support; /* if has_support: which */
  bool has_forces;           /* the scene gives unit weights, so that forces are known in N */
  size_t motion_count, force_count; /* of the lists; 0: no collapse is known */
  tp_system_motion
      *motions; /* motion_count of them: by block, of the collapse, with the strength
                   divided by the factor, or at the critical tilt where there is none */
  tp_system_force
      *forces;           /* force_count of them: by contact, that hold the blocks just before it */
  bool without_vertical; /* both are of the earthquake without its vertical part */
  size_t load_count;     /* of the list */
  tp_system_load *loads; /* load_count of them: what acts besides weights and earthquake */
  tp_goodman_bray goodman_bray; /* beside it, of columns in a row */
  bool has_undilated_fos; /* it is not known whether a motion can begin, and an estimate settled: */
  double undilated_fos; /* if has_undilated_fos: the factor by strength reduction of joints that do
                           not dilate as they slip, an estimate without a bound */
  double undilated_fos_spread;    /* if has_undilated_fos: by how much its last rounds differ */
  bool has_undilated_fos_driving; /* the same, on driving loads: */
  double undilated_fos_driving;   /* if has_undilated_fos_driving: that estimate */
  double undilated_fos_driving_spread; /* if has_undilated_fos_driving: by how much its last rounds
                                          differ */
} tp_system_case;

/* All that is known of the blocks of a scene. */
typedef struct tp_block_system {
  size_t size;             /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;  /* of the scene; NULL: none */
  TP_OUTSIDE char *scene;  /* what its file is called */
  char *length_unit;       /* of the scene: mm, cm, m, km, in or ft */
  double metres_per_unit;  /* rounded */
  bool lies_in_place;      /* on a slope or in the frame of the world: tilts are dips */
  bool has_required_fos;   /* the scene requires a factor: */
  tp_bounded required_fos; /* if has_required_fos: which */
  tp_notes notes;          /* and cautions beside the answer */
  tp_settings settings;    /* what was set in the scene */
  size_t block_count, contact_count, case_count; /* of the lists */
  tp_system_block *blocks;        /* block_count of them: in the order of the scene */
  tp_system_contact *contacts;    /* contact_count of them: by the numbers of their blocks */
  tp_system_case *cases;          /* case_count of them: one for each direction */
  size_t governing;               /* the number of the case that governs */
  tp_system_safety governing_fos; /* the factor of safety over all cases */
  char *partial_factors; /* those that it was solved with, as they act in the combination that
                            governs; NULL: none. All numbers are of the factored scene */
} tp_block_system;

/* Solve a scene of many blocks. Of the options strength_reduction alone counts. Statuses as of
 * tp_solve. */
TP_MUST_USE tp_status tp_solve_block_system(tp_block_system **system, const tp_scene *scene,
                                            const tp_solve_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_block_system_free(tp_block_system *system);

/* Did the proofs leave a verdict open? */
bool tp_block_system_is_undecided(const tp_block_system *system);

/* Has a case certainly a factor of `required`, by strength reduction and by what drives, with and
 * without the scene's earthquake? Met only where no motion can begin with the strength divided by
 * it, nor by less, nor with what drives multiplied so: the factor of limit analysis is above that
 * of joints that do not dilate as they slip. Not met where a motion can begin at that number or at
 * a lesser one, and where the factor of Goodman and Bray is below it, too. */
tp_design tp_system_case_meets(const tp_system_case *one, double required);

/* Does every case certainly have a factor of `required`? */
tp_design tp_block_system_meets(const tp_block_system *system, double required);

/* Reports, as `topple solve` prints them. Texts are as of tp_report_text. */
TP_MUST_USE tp_status tp_report_block_system(char **text, const tp_block_system *system);
TP_MUST_USE tp_status tp_report_block_system_json(char **text, const tp_block_system *system);

/* The JSON with the geometry of the scene that was solved, for programs that draw it, as
 * tp_report_json_outlines. Bad input where the system is that of another scene. */
TP_MUST_USE tp_status tp_report_block_system_json_outlines(char **text, const tp_scene *scene,
                                                           const tp_block_system *system,
                                                           tp_message *message);

/* CSV: a head, and a row for each direction, with what was set before it. */
TP_MUST_USE tp_status tp_report_block_system_csv(char **text, const tp_block_system *system);

/* Several in one table, each with a row for each direction: in Markdown, and in CSV with the
 * numbers that were set before. None of `systems` is NULL. */
TP_MUST_USE tp_status tp_report_block_systems_table(char **text,
                                                    const tp_block_system *const *systems,
                                                    size_t count);
TP_MUST_USE tp_status tp_report_block_systems_csv(char **text,
                                                  const tp_block_system *const *systems,
                                                  size_t count);

/* How the blocks of the case that governs begin to move, as an SVG that moves: the motion proven to
 * be possible, or else that of the collapse, magnified. It is one instant drawn larger, not what
 * follows of it. TP_NO_ANSWER where no motion is known; bad input where the system is that of
 * another scene. Texts are as of tp_report_text. */
TP_MUST_USE tp_status tp_report_block_system_animation(char **text, const tp_scene *scene,
                                                       const tp_block_system *system,
                                                       tp_message *message);

/* The same into the file `path`, which ends in .svg and appears whole or not at all.
 * TP_SYSTEM_FAILED where it cannot be written. */
TP_MUST_USE tp_status tp_report_block_system_animation_file(const char *path, const tp_scene *scene,
                                                            const tp_block_system *system,
                                                            tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
