/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads libtopple-gis, which alone needs GDAL. */

#include "format/gis_library.h"

#include <dlfcn.h>
#include <string.h>

tp_gis_read_function *tp_gis_library(tp_library_why *why) {
  void *library = tp_library_beside(TP_GIS_LIBRARY, why),
       *found = library != NULL ? dlsym(library, "tp_gis_read") : NULL;
  tp_gis_read_function *read = NULL;
  memcpy(&read, &found, sizeof read);
  return read;
}
