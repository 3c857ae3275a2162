/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In place of json_events.cpp, where Topple is built without RapidJSON. */

#include "geom/json_events.h"

bool tp_json_events_are_there(void) {
  return false;
}

tp_geom_status tp_json_visit(const char *text, size_t length, tp_json_visitor visitor,
                             void *context, const char **problem, size_t *at) {
  (void)text;
  (void)length;
  (void)visitor;
  (void)context;
  (void)problem;
  (void)at;
  return TP_GEOM_FAILED;
}
