/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Unit by the ending of a key's last word, by tables of keys without dimension and of groups that
 * hold lengths; a parameter is traced to the keys where it stands alone. */

#include "scene/unit.h"

#include <stdio.h>
#include <string.h>

/* The last word of the key that is no number of an item. */
static size_t last_word(const char **word, const char *key) {
  const char *end = key + strlen(key);
  for (;;) {
    const char *begin = end;
    while (begin > key && begin[-1] != '.') begin--;
    const size_t length = (size_t)(end - begin);
    *word = begin;
    if (begin == key || strspn(begin, "0123456789") < length) return length;
    end = begin - 1;
  }
}

static bool ends_in(const char *word, size_t length, const char *ending) {
  const size_t own = strlen(ending);
  return length >= own && strncmp(word + length - own, ending, own) == 0;
}

/* The unit that a word ends in. */
static const char *own_unit(const char *word, size_t length) {
  static const struct {
    const char *ending, *unit;
  } units[] = {{"_deg", "deg"},         {"_kpa", "kPa"},     {"kpa", "kPa"},
               {"_mpa", "MPa"},         {"_kn_m3", "kN/m3"}, {"_kn", "kN"},
               {"_deg_min", "deg/min"}, {"_gpa_m", "GPa/m"}, {"_s", "s"}};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    const bool whole = units[k].ending[0] != '_'; /* the word itself */
    if (whole ? length == strlen(units[k].ending) && strncmp(word, units[k].ending, length) == 0
              : ends_in(word, length, units[k].ending)) {
      return units[k].unit;
    }
  }
  return NULL;
}

/* Of no dimension, or in a unit of its own. */
static bool is_other(const char *word, size_t length) {
  static const char *const others[] = {
      "count",       "jrc",         "bulge",       "seed",     "hurst",      "z2",
      "skew",        "horizontal",  "vertical",    "matching", "facet",      "damping",
      "restitution", "below_crest", "above_crest", "fos",      "persistence"};
  bool is = own_unit(word, length) != NULL;
  for (size_t k = 0; k < sizeof others / sizeof others[0]; k++) {
    is = is || (length == strlen(others[k]) && strncmp(word, others[k], length) == 0);
  }
  return is;
}

bool tp_key_is_length(const char *key) {
  static const char *const begins[] = {"block.",
                                       "base.",
                                       "contact.",
                                       "frame.",
                                       "loads.",
                                       "joint.",
                                       "friction.facets.",
                                       "tilt_test.",
                                       "section.",
                                       "blocks.",
                                       "columns.",
                                       "support.",
                                       "jointed_slope.",
                                       "solid.bands",
                                       "solid.scale.length",
                                       "solid.wedge.height",
                                       "solid.wedge.crack.distance"};
  const char *word = NULL;
  const size_t length = last_word(&word, key);
  for (size_t k = 0; k < sizeof begins / sizeof begins[0]; k++) {
    if (strncmp(key, begins[k], strlen(begins[k])) != 0) continue;
    return !is_other(word, length) && strstr(key, ".scatter.") == NULL; /* which is in shares */
  }
  return false;
}

/* `way` is that of the node. */
static void look_below(const tp_node *node, const char *way, const char *parameter,
                       void (*look)(void *context, const char *way), void *context) {
  enum { KEY_SIZE = 200 };
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, parameter) == 0) look(context, way);
  long index = 0;
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    char key[KEY_SIZE], item[24];
    snprintf(item, sizeof item, "%ld", ++index);
    const char *name = node->kind == TP_NODE_MAPPING ? child->key : item;
    const int written = snprintf(key, sizeof key, "%s%s%s", way, *way != '\0' ? "." : "", name);
    if (written < (int)sizeof key && strcmp(key, "parameters") != 0) {
      look_below(child, key, parameter, look, context);
    }
  }
}

void tp_parameter_uses(const tp_scene *scene, const char *parameter,
                       void (*look)(void *context, const char *way), void *context) {
  if (scene->source != NULL) look_below(scene->source, "", parameter, look, context);
}

typedef struct use {
  bool lengths, others;
} use;

static void look_at(void *context, const char *way) {
  use *own = context;
  *(tp_key_is_length(way) ? &own->lengths : &own->others) = true;
}

const char *tp_scene_unit(const tp_scene *scene, const char *key) {
  static const char parameters[] = "parameters.";
  const size_t prefix = strlen(parameters);
  const char *name = strncmp(key, parameters, prefix) == 0 ? key + prefix : key;
  use own = {.lengths = false};
  if (strchr(name, '.') != NULL) return tp_key_is_length(key) ? scene->length_unit : NULL;
  tp_parameter_uses(scene, name, look_at, &own);
  return own.lengths && !own.others ? scene->length_unit : NULL;
}

const char *tp_key_unit(const tp_scene *scene, const char *key) {
  const char *unit = scene != NULL ? tp_scene_unit(scene, key) : NULL, *word = NULL;
  if (unit != NULL) return unit;
  const size_t length = last_word(&word, key);
  return own_unit(word, length);
}
