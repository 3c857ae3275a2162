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

#include "topple_solid_contacts.h"
#include "topple_solid_mesh.h"
#include "topple_solid_safety.h"
#include "topple_solid_wedge.h"
#include "topple_solve.h"

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
  bool repair;         /* mend a mesh that is not closed, and say what was done */
  double repair_merge_within; /* if repair: points as near are merged, in lengths of the mesh; 0:
                                 equal ones alone */
  double repair_drop_below;   /* if repair: pieces of less than this share of the area, below 1, are
                                 dropped; 0: none */
  double below; /* instead of bands: a plane so high over the lowest point, in lengths of the
                   mesh, cuts the solid, which rests on the section; below 0: none does */
  double thin;  /* to fewer triangles, whose surface is nowhere farther than this from the mesh's,
                   in its lengths; 0: not */
} tp_solid_options;

/* The most that options may ask for, and that contacts a scene may have. */
enum { TP_SOLID_BANDS = 100, TP_SOLID_AZIMUTHS = 36000, TP_SOLID_CONTACTS = 1000 };

/* The defaults: in metres, the whole file, no weight, no friction, z upwards, 72 azimuths, no
 * repair and no thinning; `size` is the caller's. */
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
  bool has_persistence;   /* there is a pose with the centroid lower, or as low and before it: */
  tp_bounded persistence_m; /* if has_persistence: by how much the centroid has to rise at least on
                               a way to such a pose */
} tp_solid_pose;

/* As it lies, towards an azimuth. */
typedef struct tp_solid_azimuth {
  double azimuth_deg;      /* towards which the base is tilted, or the earthquake acts */
  tp_bounded toppling_deg; /* the tilt at which it topples */
  tp_bounded critical_deg; /* with friction: the tilt at which it moves, the lesser of that and the
                              friction angle; without: the same */
  tp_mechanism
      mechanism; /* topples or slides there; undecided: as far as doubles tell at one tilt */
  bool has_acceleration;               /* of a scene: it stands at its tilt, and some horizontal
                                          acceleration towards this azimuth moves it: */
  tp_bounded acceleration_g;           /* if has_acceleration: the least, static, in g */
  tp_mechanism acceleration_mechanism; /* if has_acceleration: topples or slides there */
} tp_solid_azimuth;

/* What it does at the tilt of its scene, with the earthquake that this has: by the resultant F of
 * weight and earthquake, of which N presses on the base and T pulls along it. It topples about an
 * edge with the arm a and the unit vector n outwards where H T . n > a N, with the centroid at the
 * height H, and slides where |T| > N tan(phi). */
typedef struct tp_solid_stance {
  tp_mechanism verdict;       /* stands, topples, slides, both, leaves its base, or undecided */
  tp_solid_safety safety;     /* its factor of safety, also without its earthquake */
  bool has_fos;               /* that factor is a number: */
  tp_bounded fos;             /* if has_fos: the same; the least over azimuths that the scene leaves
                                 open */
  tp_mechanism fos_mechanism; /* if has_fos: which motion it is against */
  bool has_fos_toppling;      /* something turns it over an edge */
  tp_bounded fos_toppling; /* if has_fos_toppling: the least multiple of what drives it, the part of
                              the weight along the base and the earthquake, that turns it over an
                              edge */
  bool has_fos_sliding;    /* the scene gives friction, and something pulls along the base */
  tp_bounded fos_sliding;  /* if has_fos_sliding: N tan(phi) / |T| */
  bool has_critical;       /* it stands level: */
  tp_bounded critical_deg; /* if has_critical: the tilt at which it moves without an earthquake,
                              towards the azimuth of the scene's tilt, or the least of all */
  tp_mechanism critical_mechanism; /* if has_critical: what it does there */
  bool has_acceleration;           /* it stands at its tilt without an earthquake: */
  tp_bounded acceleration_g;       /* if has_acceleration: the least static horizontal acceleration
                                      that moves it, over all azimuths, in g */
  tp_bounded acceleration_azimuth_deg; /* if has_acceleration: towards which; of sliding on a level
                                          base: any, and 0 */
  tp_mechanism acceleration_mechanism; /* if has_acceleration: what it does there */
} tp_solid_stance;

/* A corner of the support seen from above, from the foot of the centroid. */
typedef struct tp_solid_corner {
  double east_m, north_m; /* in metres */
} tp_solid_corner;

/* As it lies, where all that is no higher than the band over the lowest point touches the base, or
 * the section of a plane that cuts it. */
typedef struct tp_solid_band {
  double band;              /* in lengths of the mesh; of a scene, in its own; of a solid that a
                               plane cuts, the height of that */
  size_t touching;          /* vertices that touch; corners of the section */
  size_t lasting_poses;     /* poses that last where each point of the surface is off by the band:
                               of a persistence of more than twice that */
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
  bool has_stance;          /* of a scene, where three corners or more carry it: */
  tp_solid_stance stance;   /* if has_stance: at the scene's tilt */
} tp_solid_band;

/* A solid; owns what it points to. */
typedef struct tp_solid {
  size_t size;               /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *file;     /* the mesh, */
  TP_OUTSIDE char *object;   /* and the one object of it that is meant; NULL: all of it */
  const char *length_unit;   /* a static string: of the mesh; of a scene, its own */
  double metres_per_unit;    /* of a length of the mesh */
  tp_notes notes;            /* on what was read */
  size_t vertices;           /* that the triangles have */
  size_t triangles;          /* of the surface */
  tp_level level;            /* of the moment sums: double, or exact where these did not tell */
  bool has_weight;           /* a unit weight is given */
  tp_bounded weight_n;       /* if has_weight: its weight */
  tp_bounded volume_m3;      /* within the surface, without holes */
  tp_bounded centroid_m[3];  /* of the weight, in the axes of the mesh, in metres */
  tp_bounded inertia_m5[6];  /* integrals about the centroid of x x, y y, z z, y z, z x, x y,
                                weighted by unit weight over mean unit weight */
  bool has_friction;         /* a friction angle is given */
  double friction_angle_deg; /* if has_friction: on the base */
  double up[3];              /* as in the options */
  size_t facets;             /* of the convex hull */
  size_t pose_count;         /* of the poses */
  tp_solid_pose *poses;      /* pose_count of them: the greatest share first */
  size_t band_count;         /* of the bands */
  tp_solid_band *bands;      /* band_count of them: in the order of the options */
  bool of_scene;             /* it is that of a scene, which has: */
  TP_OUTSIDE char *title;    /* NULL: none */
  TP_OUTSIDE char *scene;    /* if of_scene: its file */
  bool has_tilt_angle;       /* a tilt, or a base that dips: */
  double tilt_angle_deg;     /* if has_tilt_angle: of the base */
  bool has_tilt_azimuth;     /* and towards which, else the worst: */
  double tilt_azimuth_deg;   /* if has_tilt_azimuth: that */
  bool is_on_slope;          /* the base has that dip and dip direction as the mesh lies */
  bool has_seismic;          /* an earthquake: */
  double seismic_horizontal, seismic_vertical; /* if has_seismic: shares of the weight */
  bool has_seismic_azimuth;                    /* and towards which, else the worst: */
  double seismic_azimuth_deg;                  /* if has_seismic_azimuth: that */
  bool has_required_fos;                       /* a factor of safety that it must have: */
  double required_fos;                         /* if has_required_fos: that */
  tp_settings settings;                        /* what was set in it, or varied */
  size_t governing;  /* if of_scene: the band that governs, by its number from 0: the least */
  bool has_contacts; /* its scene gives contacts instead of bands: */
  tp_solid_contacts contacts; /* if has_contacts: what it does on them */
  bool has_wedge;             /* its scene gives a wedge instead of a mesh: */
  tp_solid_wedge wedge;       /* if has_wedge: how safe it is against sliding */
  size_t part_count;          /* of what its scene puts inside: */
  tp_solid_part *parts;       /* part_count of them: holes, then parts, in the order of the scene */
  bool has_repair;            /* repair was asked for: */
  tp_solid_repair repair;     /* if has_repair: what was done to the mesh */
  bool has_below;             /* a plane cuts it, and all results are of what lies above: */
  double below;               /* if has_below: so high over the lowest point, in lengths of the
                                 mesh; of a scene, in its own */
  bool has_thinning; /* thinning was asked for, and vertices and triangles are what is left */
  tp_solid_thinning thinning; /* if has_thinning: how it was done */
  bool has_ground;            /* it rests on a mesh of the ground, which gives its contacts: */
  tp_solid_ground ground;     /* if has_ground: that */
} tp_solid;

/* The solid of a mesh: an STL, PLY or OBJ by the ending of its name, taken exactly. Refused, by the
 * number of a triangle: a surface that is open, that meets itself, of which triangles have no area
 * or are oriented against each other or inwards, or that has several pieces. */
TP_MUST_USE tp_status tp_solid_of_file(tp_solid **solid, const char *path,
                                       const tp_solid_options *options, tp_message *message);

/* Is the scene one of a solid: has it the key solid? */
bool tp_scene_is_solid(const tp_scene *scene);

/* The solid of such a scene, as it lies at the scene's tilt. */
TP_MUST_USE tp_status tp_solve_solid(tp_solid **solid, const tp_scene *scene, tp_message *message);

/* Is it undecided whether it stands, in the band that governs? Of NULL too. */
bool tp_solid_is_undecided(const tp_solid *solid);

/* Its factor of safety, in the band that governs; NULL: it does not stand, or it is of no scene. */
const tp_solid_safety *tp_solid_safety_of(const tp_solid *solid);

/* Is a factor of safety met in the band that governs, and without the earthquake? */
tp_design tp_solid_meets(const tp_solid *solid, double required);

/* NULL is allowed. */
void tp_solid_free(tp_solid *solid);

/* A page; JSON (docs/json.md); CSV, a row for every azimuth of every band; and of a scene a row of
 * the band that governs, below a head of names. */
TP_MUST_USE tp_status tp_report_solid(char **text, const tp_solid *solid);
TP_MUST_USE tp_status tp_report_solid_json(char **text, const tp_solid *solid);
TP_MUST_USE tp_status tp_report_solid_csv(char **text, const tp_solid *solid);
TP_MUST_USE tp_status tp_report_solid_row_csv(char **text, const tp_solid *solid);

/* The upright section through the centroid at an azimuth as a scene of a block, of which the path
 * of the mesh is that of the solid; what touches is as high over its own lowest point as the band
 * that governs. Comments at its head say at which tilt it topples both ways, and at which the solid
 * does. Bad input: a mesh that has no unit by name, or neither z nor y upwards, or whose section is
 * none. */
TP_MUST_USE tp_status tp_report_solid_section(char **text, const tp_solid *solid,
                                              double azimuth_deg, tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
