/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JSON by RapidJSON behind a C face: what comes one after another, numbers as the text that they
 * are. Nothing that is thrown crosses this face; depth costs no stack. */

#ifndef TP_GEOM_JSON_EVENTS_H
#define TP_GEOM_JSON_EVENTS_H

#include "geom/geom.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tp_json_event_kind {
  TP_JSON_EVENT_NUMBER,
  TP_JSON_EVENT_STRING,
  TP_JSON_EVENT_KEY,
  TP_JSON_EVENT_OTHER, /* true, false, null */
  TP_JSON_EVENT_OBJECT,
  TP_JSON_EVENT_OBJECT_END,
  TP_JSON_EVENT_ARRAY,
  TP_JSON_EVENT_ARRAY_END
} tp_json_event_kind;

typedef struct tp_json_event {
  tp_json_event_kind kind;
  const char *text; /* of a number, a string or a key, with a NUL behind it */
  size_t length;
  size_t at; /* where it ends, in bytes of the file */
} tp_json_event;

/* Receives them in their order; false ends the reading. */
typedef bool (*tp_json_visitor)(void *context, const tp_json_event *event);

/* Was Topple built with RapidJSON? */
bool tp_json_events_are_there(void);

/* `*problem` is NULL, or what is wrong with the text, which is static, at the byte `*at`; NULL too
 * where the visitor ended it. */
tp_geom_status tp_json_visit(const char *text, size_t length, tp_json_visitor visitor,
                             void *context, const char **problem, size_t *at);

#ifdef __cplusplus
}
#endif

#endif
