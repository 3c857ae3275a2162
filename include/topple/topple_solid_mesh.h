/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was done to the mesh of a solid, and the meshes within it (docs/solids.md). Included by
 * topple_solid.h. */

#ifndef TOPPLE_SOLID_MESH_H
#define TOPPLE_SOLID_MESH_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A gap of the surface, a loop of edges with one triangle, that was closed by triangles between its
 * own points. One that goes along a line and back has no triangles of its own: its neighbours were
 * parted at the points on that line. */
typedef struct tp_solid_gap {
  size_t corners;     /* points of the loop */
  size_t triangles;   /* that close it */
  double middle[3];   /* the mean of its points, in the coordinates of the mesh */
  tp_bounded area_m2; /* of these triangles */
} tp_solid_gap;

/* What was done to a mesh to make it that of a solid. Triangles are named by their numbers in the
 * file; below each count stands the first. */
typedef struct tp_solid_repair {
  double merge_within, drop_below; /* as asked for: lengths of the mesh, share of the area */
  size_t merged_points;            /* that became another point within that length, */
  double farthest_merged;          /* the farthest of them, in lengths of the mesh, */
  size_t merged_triangles;         /* and triangles that lost a corner by it and were dropped */
  size_t duplicate_triangles;      /* given again, and dropped */
  long first_duplicate;            /* the first of them; 0: none */
  size_t flat_triangles;           /* without area: their long sides part their neighbours */
  long first_flat;                 /* likewise */
  size_t turned_triangles;         /* whose corners now run the other way round */
  long first_turned;               /* likewise */
  size_t dropped_pieces;           /* smaller than that share, dropped */
  size_t dropped_triangles;        /* of them */
  double dropped_area_share;       /* which was this share of the area */
  size_t gap_count;                /* gaps that were closed */
  tp_solid_gap *gaps;              /* gap_count of them */
  size_t open_gaps;                /* that no triangles between their points close */
  tp_bounded closed_area_share;    /* of the area now, that of the triangles that close gaps */
  tp_bounded closed_volume_share;  /* of the volume, what lies between its middle and them */
} tp_solid_repair;

/* How a mesh was thinned. All vertices of the thinned surface are of the mesh; corners of its
 * convex hull stay. Volume, weight, centroid and inertia, and with them poses, are those of the
 * mesh as it was. */
typedef struct tp_solid_thinning {
  double length;         /* as asked for, in lengths of the mesh */
  double farthest;       /* likewise: no point of either surface is farther from the other */
  size_t scan_vertices;  /* before */
  size_t scan_triangles; /* before */
  size_t hull_corners;   /* vertices that stay as corners of the convex hull, */
  size_t left_points;    /* and as the surface would otherwise have met itself there */
  tp_bounded volume_difference_m3; /* what the thinned surface encloses more, or less, below 0 */
} tp_solid_thinning;

/* A closed mesh inside the solid: rock of another unit weight, or a hole. */
typedef struct tp_solid_part {
  TP_OUTSIDE char *file;    /* the mesh, */
  TP_OUTSIDE char *object;  /* and the one object of it that is meant; NULL: all of it */
  bool is_hole;             /* else a part: */
  double unit_weight_kn_m3; /* of a part */
  tp_bounded volume_m3;     /* within its surface */
} tp_solid_part;

#ifdef __cplusplus
}
#endif

#endif
