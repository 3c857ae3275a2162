/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Messages with a place in the claims file, and texts of its nodes. */

#include "verify/claims.h"

#include <stdarg.h>
#include <stdio.h>

tp_status tp_claims_fail(const tp_claims *claims, const tp_node *node, tp_message *message,
                         const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return tp_refuse(message, TP_FAULT_FORMAT, tp_node_place(node, claims->path), "%s", text);
}

tp_status tp_claims_text(const char **text, const tp_claims *claims, const tp_node *mapping,
                         const char *key, bool needed, tp_message *message) {
  const tp_node *node = tp_node_get(mapping, key);
  *text = NULL;
  if (node == NULL && !needed) return TP_OK;
  if (node == NULL) return tp_claims_fail(claims, mapping, message, "'%s' is missing here", key);
  if (node->kind != TP_NODE_SCALAR) {
    return tp_claims_fail(claims, node, message, "'%s' must be text", key);
  }
  *text = node->text;
  return TP_OK;
}
