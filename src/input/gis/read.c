/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Features in the order of the file, each taken apart into lines and rings. Of GDAL's drivers the
 * two for local files are registered and no other, so that no name of a file leads to a network or
 * to a plug-in. What GDAL complains about goes to the caller and not to the standard error. */

#include "gis/gis.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <math.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Exported by GDAL; its header that declares them is of C++. */
void RegisterOGRShape(void);      // NOLINT(readability-identifier-naming)
void RegisterOGRGeoPackage(void); // NOLINT(readability-identifier-naming)

typedef struct reader {
  tp_gis_take *take;
  void *context;
  char *why;
  tp_gis_outcome outcome;
  tp_gis_part part; /* what holds of the feature at hand */
  double *xy;
  size_t room; /* points in it */
} reader;

/* The first failure counts: what follows from it says less. */
static void CPL_STDCALL hear(CPLErr kind, CPLErrorNum number, const char *text) {
  char *why = CPLGetErrorHandlerUserData();
  (void)number;
  if (kind < CE_Failure || why[0] != '\0') return;
  snprintf(why, TP_GIS_WHY_SIZE, "%s", text);
}

/* ---- geometries --------------------------------------------------------------------------------
 */

static bool reserve(reader *r, size_t count) {
  if (count <= r->room) return true;
  double *grown = count < SIZE_MAX / 32 ? realloc(r->xy, 2 * count * sizeof *grown) : NULL;
  if (grown == NULL) {
    r->outcome = TP_GIS_NO_MEMORY;
    return false;
  }
  r->xy = grown;
  r->room = count;
  return true;
}

/* A line, or a ring of a polygon. */
static bool give_line(reader *r, OGRGeometryH line, bool polygon, bool inner) {
  const int count = OGR_G_GetPointCount(line);
  if (count <= 0) return true;
  if (!reserve(r, (size_t)count)) return false;
  const double height = OGR_G_GetZ(line, 0);
  r->part.z_changes = false;
  for (int k = 0; k < count; k++) {
    r->xy[2 * k] = OGR_G_GetX(line, k);
    r->xy[2 * k + 1] = OGR_G_GetY(line, k);
    if (OGR_G_GetZ(line, k) != height) r->part.z_changes = true;
  }
  r->part.polygon = polygon;
  r->part.inner = inner;
  r->part.count = (size_t)count;
  r->part.xy = r->xy;
  if (r->take(r->context, &r->part)) return true;
  r->outcome = TP_GIS_ENDED;
  return false;
}

static bool give_polygon(reader *r, OGRGeometryH polygon) {
  bool goes_on = true;
  for (int k = 0; k < OGR_G_GetGeometryCount(polygon) && goes_on; k++) {
    goes_on = give_line(r, OGR_G_GetGeometryRef(polygon, k), true, k > 0);
  }
  return goes_on;
}

/* One without parts of its own. Points and faces in space are no outlines. */
static bool give_simple(reader *r, OGRGeometryH geometry) {
  const OGRwkbGeometryType type = wkbFlatten(OGR_G_GetGeometryType(geometry));
  if (type == wkbLineString) return give_line(r, geometry, false, false);
  return type != wkbPolygon || give_polygon(r, geometry);
}

/* Collections hold collections, as deep as GDAL lets a file have them. */
static bool give_straight(reader *r, OGRGeometryH geometry) { // NOLINT(misc-no-recursion)
  switch (wkbFlatten(OGR_G_GetGeometryType(geometry))) {
  case wkbMultiLineString:
  case wkbMultiPolygon:
  case wkbGeometryCollection:
    break;
  default:
    return give_simple(r, geometry);
  }
  bool goes_on = true;
  for (int k = 0; k < OGR_G_GetGeometryCount(geometry) && goes_on; k++) {
    goes_on = give_straight(r, OGR_G_GetGeometryRef(geometry, k));
  }
  return goes_on;
}

static bool give_geometry(reader *r, OGRGeometryH geometry) {
  r->part.curved = OGR_G_HasCurveGeometry(geometry, TRUE) != 0;
  if (OGR_G_HasCurveGeometry(geometry, FALSE) == 0) return give_straight(r, geometry);
  OGRGeometryH chords = OGR_G_GetLinearGeometry(geometry, 0, NULL);
  const bool goes_on = chords == NULL || give_straight(r, chords);
  OGR_G_DestroyGeometry(chords);
  return goes_on;
}

/* ---- layers ------------------------------------------------------------------------------------
 */

static const char *field(OGRFeatureH feature, const char *name) {
  const int index = OGR_F_GetFieldIndex(feature, name);
  if (index < 0 || !OGR_F_IsFieldSetAndNotNull(feature, index)) return NULL;
  const char *text = OGR_F_GetFieldAsString(feature, index);
  return text[0] != '\0' ? text : NULL;
}

/* GeoPackage has a system of "undefined" lengths, for which GDAL says metres. */
static bool is_undefined(OGRSpatialReferenceH system) {
  static const char undefined[] = "Undefined Cartesian";
  const char *name = OSRGetName(system);
  return name != NULL && strncasecmp(name, undefined, sizeof undefined - 1) == 0;
}

static void look_at_system(reader *r, OGRSpatialReferenceH system) {
  r->part.system = TP_GIS_NO_SYSTEM;
  r->part.metres = 0;
  if (system == NULL || is_undefined(system)) return;
  if (OSRIsGeographic(system) || OSRIsGeocentric(system)) {
    r->part.system = TP_GIS_DEGREES;
  } else if (OSRIsProjected(system) || OSRIsLocal(system)) {
    r->part.system = TP_GIS_LENGTHS;
    r->part.metres = OSRGetLinearUnits(system, NULL);
  }
}

static bool read_layer(reader *r, OGRLayerH layer) {
  OGRFeatureH feature = NULL;
  bool goes_on = true;
  r->part.layer = OGR_L_GetName(layer);
  r->part.feature = 0;
  look_at_system(r, OGR_L_GetSpatialRef(layer));
  OGR_L_ResetReading(layer);
  while (goes_on && r->why[0] == '\0' && (feature = OGR_L_GetNextFeature(layer)) != NULL) {
    OGRGeometryH geometry = OGR_F_GetGeometryRef(feature);
    r->part.feature++;
    r->part.layer_field = field(feature, "layer");
    r->part.name_field = field(feature, "name");
    if (geometry != NULL) goes_on = give_geometry(r, geometry);
    OGR_F_Destroy(feature);
  }
  return goes_on;
}

static void read_layers(reader *r, const char *path) {
  static const char *const drivers[] = {"ESRI Shapefile", "GPKG", NULL};
  RegisterOGRShape();
  RegisterOGRGeoPackage();
  GDALDatasetH file = GDALOpenEx(path, GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, NULL, NULL);
  if (file == NULL) {
    if (r->why[0] == '\0') snprintf(r->why, TP_GIS_WHY_SIZE, "it is none by what it holds");
    return;
  }
  bool goes_on = true;
  for (int k = 0; k < GDALDatasetGetLayerCount(file) && goes_on; k++) {
    goes_on = read_layer(r, GDALDatasetGetLayer(file, k));
  }
  GDALClose(file);
}

tp_gis_outcome tp_gis_read(const char *path, tp_gis_take *take, void *context,
                           char why[TP_GIS_WHY_SIZE]) {
  reader r = {.take = take, .context = context, .why = why};
  why[0] = '\0';
  CPLPushErrorHandlerEx(hear, why);
  read_layers(&r, path);
  CPLPopErrorHandler();
  free(r.xy);
  return r.outcome == TP_GIS_DONE && why[0] != '\0' ? TP_GIS_FAILED : r.outcome;
}
