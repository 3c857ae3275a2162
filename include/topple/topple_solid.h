/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid rock, given by a closed mesh: its moments, the poses in which it rests on a plane, and
 * the tilt at which it topples or slides in each direction (docs/solids.md). Included by topple.h.
 *
 *     tp_solid *solid = NULL;
 *     tp_solid_options options = tp_solid_options_default();
 *     options.friction_angle_deg = 35;
 *     status = tp_solid_of_file(&solid, "boulder.stl", &options, &message);
 *
 * Coordinates are those of the mesh. Azimuths are clockwise from y (north) to x (east), seen from
 * above; where up is another direction than z, in the frame that the least turn brings upright. */

#ifndef TOPPLE_SOLID_H
#define TOPPLE_SOLID_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of what the solid is, and what is asked. Doubles stand for the shortest decimals that name them:
 * 0.1 is one tenth. */
typedef struct tp_solid_options {
  size_t size;               /* of this struct, as `…_default()` has it */
  const char *length_unit;   /* of the mesh: mm, cm, m, km, in or ft */
  const char *object;        /* the name of a solid, o or g in the file; NULL: all of it */
  double unit_weight_kn_m3;  /* 0: not given */
  double friction_angle_deg; /* on the base, 0 to below 90; below 0: not given */
  double up[3];              /* upwards, across the base as the solid lies; of any length */
  const double *bands; /* of survey noise, in lengths of the mesh, 0 or more; NULL: 0 and three
                          powers of ten below a hundredth of the height */
  size_t band_count;   /* of them, at most TP_SOLID_BANDS */
  size_t azimuths;     /* of the rose, evenly from 0 on, at most TP_SOLID_AZIMUTHS */
} tp_solid_options;

/* The most that options may ask for. */
enum { TP_SOLID_BANDS = 100, TP_SOLID_AZIMUTHS = 36000 };

/* The defaults: in metres, the whole file, no weight, no friction, z upwards, 72 azimuths; `size`
 * is the caller's. */
void tp_solid_options_init(tp_solid_options *options, size_t size);
static inline tp_solid_options tp_solid_options_default(void) {
  tp_solid_options options;
  tp_solid_options_init(&options, sizeof options);
  return options;
}

/* About an edge of the support. */
typedef struct tp_solid_tilt {
  tp_bounded tilt_deg;             /* at which it topples about the edge */
  tp_bounded azimuth_deg;          /* towards which: across the edge */
  double edge_from[3], edge_to[3]; /* the ends of the edge, in the coordinates of the mesh */
} tp_solid_tilt;

/* How the solid can rest on a plane by itself: on a facet of its convex hull that has the foot of
 * the centroid within, which is decided exactly. */
typedef struct tp_solid_pose {
  double down[3];         /* unit vector out of the facet, which points down in this pose */
  size_t corners;         /* of the facet */
  tp_bounded height_m;    /* of the centroid over the base */
  tp_bounded facet_share; /* of all directions from the centroid, those through the facet */
  tp_bounded share;       /* with those through facets from which the solid rolls into this pose */
  tp_solid_tilt least;    /* the least critical tilt; of equal ones the first that was found */
} tp_solid_pose;

/* As it lies, tilted towards an azimuth. */
typedef struct tp_solid_azimuth {
  double azimuth_deg;      /* towards which the base is tilted */
  tp_bounded toppling_deg; /* the tilt at which it topples */
  tp_bounded critical_deg; /* with friction: the tilt at which it moves, the lesser of that and the
                              friction angle; without: the same */
  tp_mechanism
      mechanism; /* topples or slides there; undecided: as far as doubles tell at one tilt */
} tp_solid_azimuth;

/* A corner of the support seen from above, from the foot of the centroid. */
typedef struct tp_solid_corner {
  double east_m, north_m; /* in metres */
} tp_solid_corner;

/* As it lies, where all that is no higher than the band over the lowest point touches the base. */
typedef struct tp_solid_band {
  double band;              /* in lengths of the mesh */
  size_t touching;          /* vertices that touch */
  size_t corner_count;      /* of their convex hull seen from above: the support; below 3: a point
                               or a line */
  tp_solid_corner *support; /* corner_count of them: counter-clockwise */
  tp_bounded height_m;      /* of the centroid over the lowest point */
  bool stands;              /* is the foot of the centroid within the support? decided exactly */
  tp_solid_tilt least;      /* if stands: the least critical tilt */
  tp_bounded critical_deg;  /* if stands: with friction, the least tilt at which it moves */
  tp_mechanism mechanism;   /* if stands: what it does there, as in the rose */
  size_t rose_count;        /* the azimuths, where it stands; else 0 */
  tp_solid_azimuth *rose;   /* rose_count of them: the critical tilt towards each azimuth */
} tp_solid_band;

/* A solid; owns what it points to. */
typedef struct tp_solid {
  size_t size;               /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *file;     /* the mesh */
  const char *length_unit;   /* a static string */
  double metres_per_unit;    /* of that */
  tp_notes notes;            /* on what was read */
  size_t vertices;           /* that the triangles have */
  size_t triangles;          /* of the surface */
  tp_level level;            /* of the moment sums: double, or exact where these did not tell */
  bool has_weight;           /* a unit weight is given */
  tp_bounded weight_n;       /* if has_weight: its weight */
  tp_bounded volume_m3;      /* within the surface */
  tp_bounded centroid_m[3];  /* in the axes of the mesh, in metres */
  tp_bounded inertia_m5[6];  /* integrals about the centroid of x x, y y, z z, y z, z x, x y */
  bool has_friction;         /* a friction angle is given */
  double friction_angle_deg; /* if has_friction: on the base */
  double up[3];              /* as in the options */
  size_t facets;             /* of the convex hull */
  size_t pose_count;         /* of the poses */
  tp_solid_pose *poses;      /* pose_count of them: the greatest share first */
  size_t band_count;         /* of the bands */
  tp_solid_band *bands;      /* band_count of them: in the order of the options */
} tp_solid;

/* The solid of a mesh: an STL, PLY or OBJ by the ending of its name, taken exactly. Refused, by the
 * number of a triangle: a surface that is open, that meets itself, of which triangles have no area
 * or are oriented against each other or inwards, or that has several pieces. */
TP_MUST_USE tp_status tp_solid_of_file(tp_solid **solid, const char *path,
                                       const tp_solid_options *options, tp_message *message);

/* NULL is allowed. */
void tp_solid_free(tp_solid *solid);

/* A page; JSON (docs/json.md); CSV, a row for every azimuth of every band. */
TP_MUST_USE tp_status tp_report_solid(char **text, const tp_solid *solid);
TP_MUST_USE tp_status tp_report_solid_json(char **text, const tp_solid *solid);
TP_MUST_USE tp_status tp_report_solid_csv(char **text, const tp_solid *solid);

#ifdef __cplusplus
}
#endif

#endif
