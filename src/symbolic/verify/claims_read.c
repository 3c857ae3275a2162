/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a claims file: declared names, geometries with their scenes, and options; the list of
 * claims by claims_list.c. */

#include "verify/claims.h"

#include "common/outside.h"
#include "formula/spelling.h"

#include <stdlib.h>
#include <string.h>

/* Names with values, appended to what is declared. */
static tp_status read_declared(tp_claims *claims, const tp_node *node, bool angles,
                               tp_message *message) {
  static const tp_parameters none = {0};
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_MAPPING) {
    return tp_claims_fail(claims, node, message,
                          "this must be a map of names to values: {JCS: 120}");
  }
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    char spelt[TP_NAME_SIZE];
    const size_t used = tp_name_spell(spelt, sizeof spelt, child->key, sizeof spelt);
    if (used == 0 || child->key[used] != '\0' || strcmp(spelt, child->key) != 0) {
      return tp_claims_fail(claims, child, message,
                            "'%s' cannot be declared; names are at most %d letters, digits and _, "
                            "Greek letters spelt out",
                            tp_quote_all(child->key).text, TP_NAME_SIZE - 1);
    }
    if (child->kind != TP_NODE_SCALAR) {
      return tp_claims_fail(claims, child, message, "'%s' must be a number",
                            tp_quote_all(child->key).text);
    }
    const long k = claims->declared_count;
    tp_place place = tp_node_place(child, claims->path);
    place.column += child->text_offset;
    const tp_status status =
        tp_expression_evaluate(claims->declared_values + k, child->text, place, &none, message);
    if (status != TP_OK) return status;
    claims->declared[k] = (tp_declared){child->key, claims->declared_values + k, angles};
    claims->declared_count++;
  }
  return TP_OK;
}

static tp_status read_names(tp_claims *claims, tp_message *message) {
  const tp_node *symbols = tp_node_get(claims->root, "symbols");
  const tp_node *angles = tp_node_get(claims->root, "angles");
  const size_t count =
      (size_t)(symbols != NULL ? symbols->count : 0) + (size_t)(angles != NULL ? angles->count : 0);
  claims->declared = calloc(count + 1, sizeof *claims->declared);
  claims->declared_values = calloc(count + 1, sizeof *claims->declared_values); /* zeros */
  if (claims->declared == NULL || claims->declared_values == NULL) {
    return tp_fail_memory(message, "the claims");
  }
  for (size_t k = 0; k < count; k++) fmpq_init(claims->declared_values + k);
  const tp_status status = read_declared(claims, symbols, false, message);
  return status == TP_OK ? read_declared(claims, angles, true, message) : status;
}

/* The scene's path, relative to the claims file. */
static char *join_path(const char *file, const char *name) {
  const char *slash = strrchr(file, '/');
  const size_t folder = name[0] == '/' || slash == NULL ? 0 : (size_t)(slash - file) + 1;
  char *path = malloc(folder + strlen(name) + 1);
  if (path == NULL) return NULL;
  memcpy(path, file, folder);
  strcpy(path + folder, name);
  return path;
}

/* One of the words of a list; its index, or -1 with a complaint. */
static int read_word(const tp_claims *claims, const tp_node *node, const char *const *words,
                     const char *all, tp_message *message, tp_status *status) {
  for (int k = 0; node->kind == TP_NODE_SCALAR && words[k] != NULL; k++) {
    if (strcmp(node->text, words[k]) == 0) return k;
  }
  *status = tp_claims_fail(claims, node, message, "'%s' must be %s", node->key, all);
  return -1;
}

static tp_status read_options(tp_subject_options *o, const tp_claims *claims, const tp_node *node,
                              tp_message *message) {
  static const char *const sides[] = {"left", "right", NULL},
                           *const truths[] = {"false", "true", NULL},
                           *const parities[] = {"even", "odd", NULL};
  const tp_node *towards = tp_node_get(node, "towards"), *pivot = tp_node_get(node, "pivot");
  const tp_node *rounded = tp_node_get(node, "rounded"), *members = tp_node_get(node, "for_all");
  tp_status status = TP_OK;
  if (towards != NULL) {
    o->has_direction = true;
    o->towards = read_word(claims, towards, sides, "left or right", message, &status) == 1
                     ? TP_TOWARDS_RIGHT
                     : TP_TOWARDS_LEFT;
  }
  if (rounded != NULL && status == TP_OK) {
    o->rounded = read_word(claims, rounded, truths, "true or false", message, &status) == 1;
  }
  if (members != NULL && status == TP_OK) {
    o->members = read_word(claims, members, parities, "even or odd, the counts of teeth", message,
                           &status) == 1
                     ? TP_MEMBERS_ODD
                     : TP_MEMBERS_EVEN;
  }
  if (pivot != NULL && status == TP_OK) {
    char *end = NULL;
    const long number = pivot->kind == TP_NODE_SCALAR ? strtol(pivot->text, &end, 10) : 0;
    o->has_pivot = true;
    o->pivot = (size_t)(number - 1);
    if (end == NULL || end == pivot->text || *end != '\0' || number < 1) {
      status =
          tp_claims_fail(claims, pivot, message,
                         "'pivot' is a number from 1, counted along the contact from the left");
    }
  }
  return status;
}

static tp_status read_geometry(tp_geometry *g, const tp_claims *claims, const tp_node *node,
                               tp_message *message) {
  static const char *const keys[] = {"scene", "towards", "pivot", "rounded", "for_all", NULL};
  *g = (tp_geometry){.name = node->key, .place = tp_node_place(node, claims->path)};
  tp_status status = tp_node_expect_keys(node, keys, "a geometry", claims->path, message);
  const char *scene = NULL;
  if (status == TP_OK) status = tp_claims_text(&scene, claims, node, "scene", true, message);
  if (status == TP_OK) status = read_options(&g->options, claims, node, message);
  if (status != TP_OK || scene == NULL) return status;
  g->scene = join_path(claims->path, scene);
  if (g->scene == NULL) return tp_fail_memory(message, "the claims");
  g->options.scene = g->scene;
  g->options.declared_count = claims->declared_count;
  g->options.declared = claims->declared;
  return TP_OK;
}

static tp_status read_geometries(tp_claims *claims, tp_message *message) {
  const tp_node *node = tp_node_get(claims->root, "geometries");
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_MAPPING) {
    return tp_claims_fail(claims, node, message,
                          "geometries are a map: {block_e: {scene: block_e.yaml}}");
  }
  claims->geometries = calloc((size_t)node->count + 1, sizeof *claims->geometries);
  if (claims->geometries == NULL) return tp_fail_memory(message, "the claims");
  tp_status status = TP_OK;
  for (const tp_node *child = node->first; child != NULL && status == TP_OK; child = child->next) {
    status = read_geometry(claims->geometries + claims->geometry_count++, claims, child, message);
  }
  return status;
}

static tp_status read_root(tp_claims *claims, tp_message *message) {
  static const char *const keys[] = {"topple_claims", "title",      "source", "symbols", "angles",
                                     "with",          "geometries", "claims", "domain",  NULL};
  const tp_node *root = claims->root, *list = NULL;
  const tp_node *version =
      root->kind == TP_NODE_MAPPING ? tp_node_get(root, "topple_claims") : NULL;
  if (version == NULL) {
    return tp_claims_fail(claims, root, message,
                          "this is not a claims file: 'topple_claims: 1' is missing");
  }
  if (version->kind != TP_NODE_SCALAR || strcmp(version->text, "1") != 0) {
    return tp_claims_fail(claims, version, message,
                          "this program reads claims of version 1: 'topple_claims: 1'");
  }
  tp_status status = tp_node_expect_keys(root, keys, "the claims file", claims->path, message);
  if (status == TP_OK)
    status = tp_claims_text(&claims->title, claims, root, "title", false, message);
  if (status == TP_OK)
    status = tp_claims_text(&claims->source, claims, root, "source", false, message);
  if (status == TP_OK) status = read_names(claims, message);
  if (status == TP_OK) status = read_geometries(claims, message);
  if (status != TP_OK) return status;
  claims->with = tp_node_get(root, "with");
  claims->domain = tp_node_get(root, "domain");
  list = tp_node_get(root, "claims");
  if (list == NULL || list->kind != TP_NODE_SEQUENCE || list->count == 0) {
    return tp_claims_fail(claims, list != NULL ? list : root, message,
                          "'claims' must be a list with a claim at least");
  }
  return tp_claims_read_list(claims, list, message);
}

tp_status tp_claims_read(tp_claims *claims, const char *path, const char *text,
                         tp_message *message) {
  memset(claims, 0, sizeof *claims);
  claims->path = strdup(path);
  if (claims->path == NULL) return tp_fail_memory(message, "the claims");
  tp_status status = text != NULL ? tp_node_read_text(&claims->root, text, claims->path, message)
                                  : tp_node_read(&claims->root, claims->path, message);
  if (status == TP_OK) status = read_root(claims, message);
  if (status != TP_OK) tp_claims_clear(claims);
  return status;
}

void tp_claims_clear(tp_claims *claims) {
  for (long k = 0; k < claims->claim_count; k++) free(claims->claims[k].id);
  free(claims->claims);
  for (long k = 0; k < claims->geometry_count; k++) free(claims->geometries[k].scene);
  free(claims->geometries);
  for (long k = 0; claims->declared_values != NULL && k < claims->declared_count; k++) {
    fmpq_clear(claims->declared_values + k);
  }
  free(claims->declared_values);
  free(claims->declared);
  if (claims->root != NULL) tp_node_free(claims->root);
  free(claims->path);
  memset(claims, 0, sizeof *claims);
}
