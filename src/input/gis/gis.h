/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines and polygons of a Shapefile or a GeoPackage, read by GDAL, as plain numbers. In a library
 * of its own, libtopple-gis, which alone needs GDAL, and nothing of Topple: the library loads it
 * where such a file is named (format/gis.c). GDAL itself ends the process where memory ends. */

#ifndef TP_GIS_GIS_H
#define TP_GIS_GIS_H

#include <stdbool.h>
#include <stddef.h>

/* What the lengths of a layer are, by its coordinate reference system. */
typedef enum tp_gis_system {
  TP_GIS_NO_SYSTEM, /* it has none, or one that says that it is undefined */
  TP_GIS_LENGTHS,   /* of a plane, in units of `metres` */
  TP_GIS_DEGREES    /* no plane: longitude and latitude, or about the centre of the earth */
} tp_gis_system;

typedef struct tp_gis_part {
  const char *layer;       /* the name of its layer */
  const char *layer_field; /* the attribute "layer" of its feature; NULL: none */
  const char *name_field;  /* likewise "name" */
  tp_gis_system system;
  double metres;    /* of a unit of length */
  bool polygon;     /* a ring of one, closed; else a line */
  bool inner;       /* an inner ring of the polygon whose outer one came last */
  bool curved;      /* the file has arcs there; what is given are chords */
  bool z_changes;   /* along it */
  long feature;     /* its number in the layer, from 1 on */
  size_t count;     /* of points, above 0 */
  const double *xy; /* x0, y0, x1, y1, ... as the file has them */
} tp_gis_part;

/* Takes each part in the order of the file; all is borrowed. False ends the reading. */
typedef bool tp_gis_take(void *context, const tp_gis_part *part);

typedef enum tp_gis_outcome {
  TP_GIS_DONE,
  TP_GIS_ENDED, /* by what takes the parts */
  TP_GIS_NO_MEMORY,
  TP_GIS_FAILED
} tp_gis_outcome;

enum { TP_GIS_WHY_SIZE = 300 };

/* Read all layers of the file `path`. Where that fails `why` is GDAL's word on it. The file, and
 * what lies beside a Shapefile, is only read. Threads may call it at the same time. */
tp_gis_outcome tp_gis_read(const char *path, tp_gis_take *take, void *context,
                           char why[TP_GIS_WHY_SIZE]);

#endif
