/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The options of topple chart, as one struct for all kinds. */

#ifndef TP_CLI_CHART_OPTIONS_H
#define TP_CLI_CHART_OPTIONS_H

#include "cli/settings.h"

typedef enum tp_chart_kind {
  TP_CHART_KIND_FOS,
  TP_CHART_KIND_MECHANISMS,
  TP_CHART_KIND_RANGES,
  TP_CHART_KIND_MAP,
  TP_CHART_KINDS
} tp_chart_kind;

enum { TP_CHART_KEY_SIZE = 128 };

extern const char *const tp_chart_kinds[TP_CHART_KINDS];

typedef struct tp_chart_arguments {
  bool has_kind;
  tp_chart_kind kind;
  bool json;
  const char *output; /* NULL: to stdout */
  tp_chart_format format;
  bool has_amplitude;
  unsigned given; /* kinds that the options so far go with, a bit each */
  tp_chart_fos_options fos;
  double lists[4][TP_CHART_LIST_MAX]; /* that it and the map point to */
  tp_chart_mechanisms_options mechanisms;
  const char *scene;               /* the path of the map's scene */
  tp_chart_map_options map;        /* but for that */
  char keys[2][TP_CHART_KEY_SIZE]; /* of the map's axes */
  tp_cli_settings settings;        /* of the map's scene */
} tp_chart_arguments;

extern const struct argp tp_chart_parser;

#endif
