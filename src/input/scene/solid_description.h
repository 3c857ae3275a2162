/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid rock as a scene gives it: the key solid. Included by scene/scene.h. */

#ifndef TP_SCENE_SOLID_DESCRIPTION_H
#define TP_SCENE_SOLID_DESCRIPTION_H

/* A place where the ground touches the solid. */
typedef struct tp_contact_description {
  tp_place place;
  fmpq at[3];      /* in the coordinates of the mesh */
  bool has_normal; /* else across the surface there */
  fmpq normal[3];  /* if has_normal: out of the ground, into the solid, of any length */
  tp_quantity friction_angle_deg; /* not given: the scene's */
} tp_contact_description;

/* A closed mesh inside the solid: rock of another unit weight, or a hole. */
typedef struct tp_solid_part_description {
  tp_place place;
  const tp_mesh *mesh; /* of the scene's file, in the axes and lengths of the solid's, */
  long object;         /* one object of it; below zero: all */
  bool is_hole;
  tp_quantity unit_weight_kn_m3; /* of a part */
} tp_solid_part_description;

/* A mesh that the solid rests on, in its axes. */
typedef struct tp_ground_description {
  tp_place place;         /* no file: a plane, or contacts */
  const tp_mesh *mesh;    /* of the scene's file, */
  long object;            /* one object of it; below zero: all */
  fmpq_t metres_per_unit; /* of the mesh */
} tp_ground_description;

/* A plane of a wedge: its dip and the azimuth of that. */
typedef struct tp_wedge_plane {
  tp_quantity dip_deg, dip_direction_deg;
} tp_wedge_plane;

/* A wedge between two joints, a face and the ground above, as Hoek and Bray have it: instead of a
 * mesh. */
typedef struct tp_wedge_description {
  tp_place place; /* no file: there is none */
  tp_quantity height;
  tp_wedge_plane planes[5]; /* the joints A and B, the face, the ground above, the crack */
  tp_quantity friction_deg[2], cohesion_kpa[2]; /* of A and B */
  bool has_crack;
  tp_quantity crack_distance; /* if has_crack: from the crest, along A on the ground above */
  bool has_water;
  tp_quantity water_kn_m3; /* if has_water: the unit weight of the water that fills it */
} tp_wedge_description;

enum { TP_WEDGE_A, TP_WEDGE_B, TP_WEDGE_FACE, TP_WEDGE_UPPER, TP_WEDGE_CRACK, TP_WEDGE_PLANES };

typedef struct tp_solid_description {
  tp_place place;         /* no file: the scene is of a section */
  const tp_mesh *mesh;    /* of the scene's file, */
  long object;            /* one object of it; below zero: all */
  fmpq_t metres_per_unit; /* of the mesh, by its unit or by a known length */
  long part_count;        /* holes, then parts */
  tp_solid_part_description *parts;
  fmpq up[3]; /* across the base, in the axes of the mesh: not zero */
  tp_quantity unit_weight_kn_m3, azimuths;
  tp_quantity dip_deg, dip_direction_deg; /* of the base, where `up` is the vertical instead */
  long band_count;
  fmpq *bands;       /* in scene lengths */
  tp_quantity below; /* instead: a plane so high over the lowest point, in scene lengths, cuts it */
  long contact_count; /* 0: what touches is by bands */
  tp_contact_description *contacts;
  tp_ground_description ground; /* instead of a plane: what is within a band of it touches */
  bool repair;                  /* mend the mesh: */
  double repair_merge_within;   /* in lengths of the mesh; 0: equal points alone */
  double repair_drop_below;     /* pieces of less than this share of the area; 0: none */
  double thin;                  /* by this length, in those of the mesh; 0: not */
  tp_wedge_description wedge;   /* instead of the mesh and what touches */
} tp_solid_description;

#endif
