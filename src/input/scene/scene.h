/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene describes: exact numbers in scene lengths and degrees, each group with the place in
 * the file, or the call, that called for it. Only what can be said without geometry is checked
 * here. */

#ifndef TP_SCENE_SCENE_H
#define TP_SCENE_SCENE_H

#include "common/message.h"
#include "common/notes.h"
#include "plane/polyline.h"
#include "scene/drawn.h"
#include "scene/expression.h"
#include "scene/letterhead.h"
#include "scene/node.h"
#include "scene/profile_rule.h"
#include "scene/scene_file.h"
#include "scene/tilt_test.h"

#include <flint/fmpq.h>

typedef enum tp_outline_form {
  TP_OUTLINE_VERTICES,
  TP_OUTLINE_TEETH,
  TP_OUTLINE_SLAB,
  TP_OUTLINE_ELLIPSE,
  TP_OUTLINE_OF_EACH, /* of a scene of many blocks, which have their own */
  TP_OUTLINE_OF_SOLID /* none: the scene is of a solid */
} tp_outline_form;

/* An ellipse of a width and a height, cut off below where it is `flat` wide: it rests on that flat,
 * from (-flat / 2, 0) to (flat / 2, 0). `height` is of the whole ellipse. */
typedef struct tp_ellipse {
  tp_quantity width, height, flat;
  const fmpq *cosine, *sine; /* turned about the middle of its flat, the origin: (x, y) to
                                (c x + s y, c y - s x); borrowed, NULL: as given, along x */
} tp_ellipse;

/* N sub-blocks of width a; b the smaller and b + c the larger of their heights (Fig. 5). */
typedef struct tp_teeth {
  long count;
  fmpq_t width, height, depth;
  bool left_end_valley;
  tp_quantity block_width, mean_height; /* in memory, given over a width: dx and y (section 5.1) */
} tp_teeth;

typedef struct tp_part {
  tp_polyline outline;
  tp_quantity unit_weight_kn_m3;
} tp_part;

/* An edge of the outline that is an arc: from a vertex to the next one, through a point or with a
 * bulge, the tangent of a quarter of its angle, negative inwards. */
typedef struct tp_arc_description {
  tp_place place;
  tp_quantity x, y; /* the vertex that it begins in */
  tp_quantity through_x, through_y;
  tp_quantity bulge; /* given: instead of the point */
} tp_arc_description;

/* A corner of the outline that is rounded by a radius. */
typedef struct tp_corner_description {
  tp_place place;
  enum { TP_CORNER_LEFT_END, TP_CORNER_RIGHT_END, TP_CORNER_VERTEX } at;
  tp_quantity x, y; /* of a TP_CORNER_VERTEX */
  tp_quantity radius;
} tp_corner_description;

typedef struct tp_rounded_description {
  tp_place place;
  bool keeps_mass; /* model `paper`: the axis moves, the mass is kept; else `exact` */
  long count;
  tp_corner_description *corners;
} tp_rounded_description;

typedef struct tp_block_description {
  tp_place place;
  tp_outline_form form;
  tp_polyline outline; /* TP_OUTLINE_VERTICES */
  tp_teeth teeth;      /* TP_OUTLINE_TEETH; a slab is one tooth of depth 0 */
  tp_ellipse ellipse;  /* TP_OUTLINE_ELLIPSE */
  long hole_count;
  tp_polyline *holes;
  long part_count;
  tp_part *parts;
  long arc_count;
  tp_arc_description *arcs;
  tp_quantity arc_tolerance; /* given: chords stand for them that leave them by no more */
  tp_rounded_description rounded;
  bool repair;           /* move vertices where rings meet themselves by less than a last digit */
  tp_place repair_place; /* that says so */
  tp_quantity thickness; /* scene lengths; 1 m where not given */
  tp_quantity unit_weight_kn_m3;
} tp_block_description;

#include "scene/block_list.h"
#include "scene/solid_description.h"

typedef struct tp_base_description {
  tp_place place;
  bool mated;          /* the base is the counterpart of the underside; else `profile` */
  bool whole;          /* mated with all of the underside, walls included */
  tp_polyline between; /* of a mated base: empty, or the two vertices where the contact ends */
  tp_place between_place;
  tp_quantity below, left_of, right_of; /* or where its vertices lie */
  tp_quantity beyond_left, beyond_right;
  const fmpq *beyond_cosine,
      *beyond_sine; /* borrowed: it goes on in this direction; NULL: along x */
  tp_polyline profile;
  tp_profile_rule rule; /* that the profile is made by, where there is one */
  bool rests;     /* the block is set down on its profile and comes to rest; else it is as given */
  bool all_poses; /* it `rests`, and all resting poses are asked for */
  tp_place rests_place; /* that says so */
  tp_quantity start_x;  /* it `rests`, shifted along x by that before it is set down */
  tp_quantity within;   /* what lies closer than that to its contact is moved there */
  tp_quantity smooth;   /* facets of a mated sole that are shorter are levelled */
  tp_quantity shift;    /* the block is shifted along its mated base by that, and comes to rest */
  tp_quantity matching; /* or by the least at which so much of its underside at most is closed: */
  bool shift_left;      /* to this side, */
  tp_quantity closure;  /* with gaps up to that */
} tp_base_description;

/* A pressure or a surcharge along a line of the outline, in kPa at its two ends; or an anchor at
 * the first point. */
typedef struct tp_line_load {
  tp_place place;
  tp_quantity x0, y0, x1, y1;
  tp_quantity first_kpa, last_kpa;
  bool passive; /* of a support: counts as resistance; else takes from what overturns */
  long block;   /* of many blocks: which it acts on; -1: that is not said */
} tp_line_load;

/* The side that a bolt runs to: into the slope, or the one that is said. */
typedef enum tp_bolt_side { TP_BOLT_UP_DIP, TP_BOLT_LEFT, TP_BOLT_RIGHT } tp_bolt_side;

/* An anchor pulls in a direction of the scene's frame. A bolt has a dip instead, and may have a
 * length, a capacity, a spacing out of the drawing and rows (scene/anchor.h). */

typedef struct tp_anchor_description {
  tp_place place;
  tp_quantity x, y;
  tp_quantity direction_deg; /* of its pull on the block, from x towards y */
  tp_quantity dip_deg;       /* given: instead, below the horizontal */
  tp_bolt_side side;
  tp_quantity azimuth_deg;           /* of a wedge, beside dip_deg: towards which it pulls */
  tp_quantity force_kn, capacity_kn; /* of one bolt */
  tp_quantity length, spacing;       /* scene lengths; no spacing: one on the whole thickness */
  tp_quantity rows, step_x, step_y;  /* from the first on; none given: one */
  bool passive;                      /* counts as resistance; else takes from what overturns */
  tp_quantity to_x, to_y;            /* of many blocks, given: its far end instead of a direction */
  long block, into; /* of many blocks: which its head holds, and which its far end holds in; -1:
                       that is not said */
} tp_anchor_description;

/* Water about the block. To a height over the up-dip end of the base joint it stands behind the
 * block, on a face normal to the base; or it is sited: a level, a surface or a crack filled with it
 * tells how deep each point of the outline lies below it (load/wetted.h). */
typedef struct tp_water_description {
  bool given;
  tp_place place;
  tp_quantity height;            /* scene lengths, along the face */
  tp_quantity unit_weight_kn_m3; /* 9.81 where not given */
  bool stays_level;              /* the height is vertical, whatever the tilt */
  bool uplift;                   /* along the base, of a shape; of a height triangular */
  bool lifts_alone;  /* what it pushes down-dip is left out: the block goes up-dip (problem/world.h)
                      */
  tp_quantity level; /* an elevation */
  tp_polyline surface; /* or points of it, from left to right */
  tp_water_faces faces;
  tp_water_uplift shape;
  bool cracked; /* behind the block it stands in a crack, to a level of its own, */
  tp_quantity crack_level, crack_height, crack_distance; /* or to a height over its foot */
  tp_quantity ice_kpa, ice_thickness;                    /* 0: there is none */
} tp_water_description;

typedef struct tp_loads_description {
  tp_place place;
  tp_place seismic_place;
  tp_quantity horizontal, vertical; /* k_h towards down-dip, k_v up, shares of the weight */
  tp_quantity azimuth_deg;          /* of a solid: towards which k_h acts; not given: any */
  bool direction_given;
  tp_seismic_direction direction; /* where the block lies on a slope: which way k_h acts */
  tp_water_description water;
  long pressure_count, surcharge_count, support_count, anchor_count;
  tp_line_load *pressures, *surcharges, *supports;
  tp_anchor_description *anchors;
  long force_count;                   /* of many blocks: */
  tp_anchor_description *forces;      /* from outside, on one of them each */
  tp_quantity bond_kpa, cohesion_kpa; /* of the contact */
} tp_loads_description;

/* Facets of the base with a friction angle of their own: from one number to another, counted from 1
 * from left to right; or, where x0 is given, all between two abscissas. */
typedef struct tp_facet_friction_description {
  tp_place place;
  long first, last;
  tp_quantity x0, x1, angle_deg;
} tp_facet_friction_description;

/* Friction by a law. Patton's phi_b + i (Eq. 6) is one angle, the scene's friction_angle_deg; by
 * Barton's law (Eq. 8) the angle depends on the normal stress, and friction_angle_deg is its
 * residual part. JRC is given, or follows from a tilt test (Eq. 9), or from i (Eq. 10). */
typedef struct tp_friction_description {
  bool load_dependent;
  tp_quantity basic_angle_deg; /* of Patton's law */
  tp_quantity jrc, jcs_mpa, roughness_angle_deg, test_angle_deg, test_stress_kpa;
  tp_quantity contact_width; /* that carries the mean normal stress; not given: as it touches */
  long facet_count;
  tp_facet_friction_description *facets;
} tp_friction_description;

/* What x and y of a scene lie along: the mean plane of the base and its normal, said or taken so,
 * on a table or on a slope that dips; or the horizontal and the vertical, with the block as it
 * lies. */
typedef enum tp_frame { TP_FRAME_UNSTATED, TP_FRAME_BASE, TP_FRAME_SLOPE, TP_FRAME_WORLD } tp_frame;

/* A slope that the base lies on. */
typedef struct tp_slope_description {
  tp_quantity dip_deg;                       /* 0 <= value <= 90 */
  tp_quantity dip_direction_deg, strike_deg; /* azimuths: which way that is, at most one given */
  bool left;                                 /* the side that it dips towards */
} tp_slope_description;

/* A number that a scene has instead of the one that stands in its file, or in memory instead of the
 * one that it was built with: there it is in its place, and what was set is kept to be told. */
typedef struct tp_override {
  const tp_node *node; /* NULL: in memory */
  fmpq_t value;
  bool used;     /* it was read as a number */
  char *setting; /* "key=formula": the formula is evaluated whenever the file is read; NULL: `value`
                  */
} tp_override;

/* What a unit of reports is of, in the order of the keys of result_units. */
typedef enum tp_unit_kind {
  TP_UNIT_LENGTH,
  TP_UNIT_FORCE,
  TP_UNIT_MOMENT,
  TP_UNIT_STRESS,
  TP_UNIT_KINDS
} tp_unit_kind;

/* A unit that reports print in: one of it is `si` of m, N, N m or Pa, rounded once. */
typedef struct tp_unit {
  tp_unit_kind kind;
  const char *name;
  double si;
} tp_unit;

/* Factors of a design check (scene/partial_factors.h). */
typedef struct tp_partial_factors tp_partial_factors;

/* Its numbers, chains and lists are listed once more in scene/members.c, and the keys of what a
 * scene in memory can be given in scene_varying/slot_table.c. */
struct tp_scene {
  const char *path; /* of its file, or what it is called; outlives it */
  char *title;
  const char *length_unit;
  fmpq_t metres_per_unit;
  const tp_unit *result_units[TP_UNIT_KINDS]; /* NULL: reports choose */
  tp_letterhead letterhead;                   /* of its calculation sheet */
  tp_parameters parameters;
  tp_block_description block; /* of many blocks: what those have that do not say so themselves */
  tp_block_list many;
  tp_solid_description solid; /* instead of block and base */
  tp_base_description base;
  tp_frame frame;
  tp_place frame_place;       /* of frame or slope */
  tp_slope_description slope; /* TP_FRAME_SLOPE */
  tp_polyline mean_plane;     /* TP_FRAME_WORLD: two points of it, or none: fitted to the contact */
  tp_bolt_side up_dip;        /* likewise: of that plane, once it is known; else TP_BOLT_UP_DIP */
  tp_loads_description loads;
  tp_quantity friction_angle_deg;      /* 0 <= value < 90 */
  tp_quantity required_fos;            /* that the governing factor is held against */
  tp_partial_factors *partial_factors; /* NULL: none */
  bool factored;                       /* they are applied to its numbers, and: */
  const fmpq *friction_divisor;        /* borrowed, of tan(phi); NULL: 1 */
  const tp_node *load_cases;           /* its list of cases, none of them chosen; NULL: none */
  const char *load_case;               /* the file's: of the case that it is of; NULL: none */
  tp_friction_description friction;
  bool friction_is_basic, friction_is_apparent; /* as the scene says; neither: it does not */
  tp_place friction_is_place;
  bool towards_left, towards_right;
  tp_place tilt_place;
  tp_quantity tilt_angle_deg;   /* 0 <= value <= 90 */
  tp_quantity tilt_azimuth_deg; /* of a solid: towards which; not given: any */
  tp_tilt_test_description tilt_test;
  tp_place shaking_place; /* no file: its base does not shake */
  tp_shaking_component shaking[TP_SHAKING_AXES];
  tp_scene_file *file;   /* NULL: built in memory */
  const tp_drawn *drawn; /* what a drawing gave it; NULL: nothing */
  tp_drawn *own_drawn;   /* its own, where it is not that of the file */
  const tp_node *source; /* the nodes of the file, for what is derived with symbols */
  long override_count;
  tp_override *overrides;
  tp_notes notes; /* on what was read */
};

/* A scene with nothing given; NULL when memory is exhausted. `path` is what places refer to, and
 * outlives it. */
tp_scene *tp_scene_make(const char *path);
/* A copy of a scene that was built in memory, which shares its chains of points; NULL when memory
 * is exhausted. */
tp_scene *tp_scene_copy(const tp_scene *scene);
/* Is its block shifted along the mated base, and what says so? */
bool tp_scene_is_shifted(const tp_scene *scene);
tp_place tp_scene_shift_place(const tp_scene *scene);
/* Does the block lie at its place, on a slope or in the frame of the world; else on a table? */
bool tp_scene_lies_in_place(const tp_scene *scene);

/* A block with nothing given but its place. */
void tp_listed_block_init(tp_listed_block *listed, tp_place place);
/* Its unit weight, or the one that all have which do not say so themselves. */
const tp_quantity *tp_listed_block_unit_weight(const tp_scene *scene,
                                               const tp_listed_block *listed);
/* The next block of the list, of which there is room, with nothing given but its place; and that of
 * the scene has this place and this unit weight. */
tp_listed_block *tp_scene_next_block(tp_scene *scene, tp_place place,
                                     const tp_quantity *unit_weight);
/* The block that was read becomes one of the list, and the scene's has nothing given again. */
void tp_scene_list_block(tp_scene *scene, tp_listed_block *listed);

/* Is its water told by a level, a surface or a crack? */
bool tp_water_is_sited(const tp_water_description *water);

/* What the scene has instead of the number at a node; NULL: nothing. */
const tp_override *tp_scene_override(const tp_scene *scene, const tp_node *node);

/* The files that it was read from: the scene's own, by what it is called, and those named in it. */
size_t tp_scene_source_count(const tp_scene *scene);
const char *tp_scene_source(const tp_scene *scene, size_t index);

/* Names of them all, for a result to own. Where memory is exhausted, `names` and `count` hold those
 * that were copied by then. */
TP_MUST_USE tp_status tp_scene_copy_sources(char ***names, size_t *count, const tp_scene *scene,
                                            tp_message *message);

/* The metres of a unit of length by its name, which becomes a static text; false: there is none. */
bool tp_unit_find(fmpq_t metres, const char **unit);
TP_MUST_USE tp_status tp_scene_use_unit(tp_scene *scene, const char *length_unit, tp_place place,
                                        tp_message *message);

/* A block of teeth over a width, of a mean height and an amplitude: `width` becomes that of a
 * tooth, `height` the lesser one, a = dx / N and b = y - A / 2. */
void tp_teeth_over(fmpq_t width, fmpq_t height, const fmpq_t amplitude, long count);

/* The numbers of what a scene holds several of, and that no block is named; the rest is zero
 * already. */
void tp_line_load_init(tp_line_load *load);
void tp_line_load_clear(tp_line_load *load);
void tp_anchor_init(tp_anchor_description *anchor);
void tp_joint_init(tp_joint_description *joint);
void tp_arc_init(tp_arc_description *arc);
void tp_corner_init(tp_corner_description *corner);
void tp_facet_friction_description_init(tp_facet_friction_description *facets);

/* Notes on numbers of the scene that look as if they stood in another unit. */
TP_MUST_USE tp_status tp_scene_cautions(tp_notes *notes, const tp_scene *scene,
                                        tp_message *message);

/* What the scene is told with: its notes, which a scene built in memory gathers now. */
TP_MUST_USE tp_status tp_scene_notes(tp_notes *notes, const tp_scene *scene, tp_message *message);

/* The scene of a file that was read already, with other numbers than stand there: `overrides`, an
 * array that becomes the scene's, whatever the outcome. */
TP_MUST_USE tp_status tp_scene_read_again(tp_scene **scene, tp_scene_file *file,
                                          tp_override *overrides, long count, tp_message *message);
/* The scene of a root that was made or read; `root` and `overrides` become its, whatever the
 * outcome. */
TP_MUST_USE tp_status tp_scene_read_nodes(tp_scene **scene, const char *path, tp_node *root,
                                          tp_override *overrides, long count, tp_message *message);
/* Those of the scene, behind the others of a list that has room for them; false when memory is
 * exhausted. */
TP_MUST_USE bool tp_overrides_append(tp_override *overrides, long *count, const tp_scene *scene);
/* Put a value (NULL: none yet), or a setting, which is copied, in place of what the list has for
 * the node, in memory for the key, or behind the others; false when memory is exhausted. */
TP_MUST_USE bool tp_overrides_put(tp_override *overrides, long *count, const tp_node *node,
                                  const fmpq *value, const char *setting);
/* Give the overrides back. */
void tp_overrides_free(tp_override *overrides, long count);

#endif
