/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of keys with name, symbol and unit; a parameter takes the label of the one quantity that it
 * stands for alone, or of a length. */

#include "chart/axis_label.h"

#include "common/outside.h"
#include "scene/unit.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { KEY_SIZE = 200 };

/* A key, with # for the number of an item of a list. */
typedef struct quantity {
  const char *key, *name, *symbol, *unit;
} quantity;

#define OF_SCENE "scene" /* a length */
#define SYMBOL(letter) "{/:Italic " letter "}"

static const quantity quantities[] = {
    {"friction_angle_deg", "Friction angle", SYMBOL("φ"), "°"},
    {"friction.basic_angle_deg", "Basic friction angle", SYMBOL("φ") "_b", "°"},
    {"friction.roughness_angle_deg", "Roughness angle", SYMBOL("i"), "°"},
    {"friction.residual_angle_deg", "Residual friction angle", SYMBOL("φ") "_r", "°"},
    {"friction.jrc", "Joint roughness coefficient JRC", NULL, NULL},
    {"friction.jcs_mpa", "Joint wall strength JCS", NULL, "MPa"},
    {"friction.tilt_test.angle_deg", "Angle of the tilt test", NULL, "°"},
    {"friction.tilt_test.normal_stress_kpa", "Normal stress of the tilt test", NULL, "kPa"},
    {"tilt.angle_deg", "Tilt angle", SYMBOL("α"), "°"},
    {"block.slab.width", "Width", SYMBOL("Δx"), OF_SCENE},
    {"block.slab.height", "Height", SYMBOL("y"), OF_SCENE},
    {"block.teeth.count", "Number of teeth", SYMBOL("N"), NULL},
    {"block.teeth.width", "Width of a tooth", SYMBOL("a"), OF_SCENE},
    {"block.teeth.height", "Height", SYMBOL("b"), OF_SCENE},
    {"block.teeth.depth", "Depth of teeth", SYMBOL("c"), OF_SCENE},
    {"block.teeth.block_width", "Width", SYMBOL("Δx"), OF_SCENE},
    {"block.teeth.mean_height", "Mean height", SYMBOL("y"), OF_SCENE},
    {"block.teeth.amplitude", "Amplitude", SYMBOL("A"), OF_SCENE},
    {"block.teeth.wavelength", "Wavelength", SYMBOL("λ"), OF_SCENE},
    {"block.ellipse.width", "Width", NULL, OF_SCENE},
    {"block.ellipse.height", "Height", NULL, OF_SCENE},
    {"block.ellipse.flat", "Width of the flat", NULL, OF_SCENE},
    {"block.rounded.corners.#.radius", "Radius of corner #", SYMBOL("r") "_c", OF_SCENE},
    {"block.thickness", "Thickness", SYMBOL("d"), OF_SCENE},
    {"block.unit_weight_kn_m3", "Unit weight", SYMBOL("γ"), "kN/m³"},
    {"block.parts.#.unit_weight_kn_m3", "Unit weight of part #", SYMBOL("γ"), "kN/m³"},
    {"base.beyond.left", "Base beyond the block, left", NULL, OF_SCENE},
    {"base.beyond.right", "Base beyond the block, right", NULL, OF_SCENE},
    {"loads.seismic.horizontal", "Horizontal seismic coefficient", SYMBOL("k") "_h", NULL},
    {"loads.seismic.vertical", "Vertical seismic coefficient", SYMBOL("k") "_v", NULL},
    {"loads.water.height", "Height of water", SYMBOL("h") "_w", OF_SCENE},
    {"loads.water.unit_weight_kn_m3", "Unit weight of water", SYMBOL("γ") "_w", "kN/m³"},
    {"loads.water.level", "Level of water", SYMBOL("z") "_w", OF_SCENE},
    {"loads.water.tension_crack.level", "Level of water in the crack", SYMBOL("z") "_c", OF_SCENE},
    {"loads.water.tension_crack.height", "Height of water in the crack", SYMBOL("h") "_c",
     OF_SCENE},
    {"loads.water.tension_crack.distance", "Distance of the crack", NULL, OF_SCENE},
    {"loads.water.ice_kpa", "Pressure of ice", SYMBOL("p"), "kPa"},
    {"loads.water.ice_thickness", "Thickness of ice", NULL, OF_SCENE},
    {"loads.cohesion_kpa", "Cohesion", SYMBOL("c"), "kPa"},
    {"loads.bond_kpa", "Tensile bond", NULL, "kPa"},
    {"loads.anchors.#.force_kn", "Force of anchor #", SYMBOL("T"), "kN"},
    {"loads.anchors.#.direction_deg", "Direction of anchor #", NULL, "°"},
    {"loads.pressures.#.kpa", "Pressure #", SYMBOL("p"), "kPa"},
    {"loads.pressures.#.kpa.1", "Pressure #, beginning", SYMBOL("p") "_0", "kPa"},
    {"loads.pressures.#.kpa.2", "Pressure #, end", SYMBOL("p") "_1", "kPa"},
    {"loads.surcharges.#.kpa", "Surcharge #", SYMBOL("p"), "kPa"},
};

/* Does the key match, the # of a pattern being a number that `number` takes? */
static bool matches(const char *pattern, const char *key, long *number) {
  for (; *pattern != '\0'; pattern++) {
    if (*pattern != '#') {
      if (*pattern != *key++) return false;
      continue;
    }
    if (!isdigit((unsigned char)*key)) return false;
    for (*number = 0; isdigit((unsigned char)*key) && *number < 100000000; key++) {
      *number = 10 * *number + (*key - '0');
    }
  }
  return *key == '\0';
}

/* "Force of anchor 2 T (kN)"; a parameter has its own name for a symbol. */
static void write_known(char *label, size_t size, const quantity *q, long number,
                        const char *length_unit, const char *parameter) {
  const char *hash = strchr(q->name, '#');
  const bool of_scene = q->unit != NULL && strcmp(q->unit, OF_SCENE) == 0;
  const char *symbol = parameter != NULL ? parameter : q->symbol;
  char name[80], unit[40] = "";
  if (hash != NULL) {
    snprintf(name, sizeof name, "%.*s%ld%s", (int)(hash - q->name), q->name, number, hash + 1);
  } else {
    snprintf(name, sizeof name, "%s", q->name);
  }
  if (q->unit != NULL) snprintf(unit, sizeof unit, " (%.24s)", of_scene ? length_unit : q->unit);
  snprintf(label, size, "%s%s%s%s", name, symbol != NULL ? " " : "", symbol != NULL ? symbol : "",
           unit);
}

static const quantity *known(const char *key, long *number) {
  for (size_t k = 0; k < sizeof quantities / sizeof quantities[0]; k++) {
    if (matches(quantities[k].key, key, number)) return quantities + k;
  }
  return NULL;
}

/* What a parameter stands for, if it is one thing. */
typedef struct use {
  char key[KEY_SIZE]; /* where it stands alone; empty: nowhere yet */
  bool lengths;       /* it stands alone for lengths, */
  bool others;        /* for other things, */
  bool several;       /* for more quantities than one */
} use;

static void look_at(void *context, const char *key) {
  use *u = context;
  long number = 0;
  const quantity *q = known(key, &number);
  const bool length = tp_key_is_length(key);
  u->several = u->several || q == NULL || u->key[0] != '\0';
  *(length ? &u->lengths : &u->others) = true;
  snprintf(u->key, sizeof u->key, "%s", key);
}

/* "Depth of teeth c (mm)" where the parameter is that and nothing else; "Parameter c (mm)" where it
 * is lengths; else "Parameter c". */
static void write_parameter(char *label, size_t size, const char *name, int shown,
                            const tp_scene *scene) {
  enum { MOST_OF_SYMBOL = 60 };
  use u = {.several = false};
  long number = 0;
  tp_parameter_uses(scene, name, look_at, &u);
  if (u.key[0] != '\0' && !u.several && strlen(name) <= MOST_OF_SYMBOL) {
    const quantity *q = known(u.key, &number);
    write_known(label, size, q, number, scene->length_unit, name);
  } else if (u.lengths && !u.others) {
    snprintf(label, size, "Parameter %.*s (%.20s)", shown, name, scene->length_unit);
  } else {
    snprintf(label, size, "Parameter %.*s", shown, name);
  }
}

static bool is_parameter(const tp_scene *scene, const char *name) {
  bool is = false;
  for (long k = 0; k < scene->parameters.count; k++) {
    is = is || strcmp(scene->parameters.names[k], name) == 0;
  }
  return is;
}

void tp_axis_label(char *label, size_t size, bool *plain, const char *key, const tp_scene *scene) {
  enum { MOST_SHOWN = 140 };
  static const char parameters[] = "parameters.";
  const char *unit = scene->length_unit;
  long number = 0;
  const quantity *q = known(key, &number);
  if (strcmp(key, "tilt.angle_deg") == 0 && tp_scene_lies_in_place(scene)) {
    *plain = true;
    snprintf(label, size, "Steepened by (°)");
    return;
  }
  *plain = q == NULL;
  if (q != NULL) {
    write_known(label, size, q, number, unit, NULL);
    return;
  }
  const size_t prefix = strlen(parameters);
  const char *name = strncmp(key, parameters, prefix) == 0 ? key + prefix : key;
  const int shown = (int)tp_whole_characters(name, MOST_SHOWN);
  if (is_parameter(scene, name)) {
    write_parameter(label, size, name, shown, scene);
  } else if (tp_key_is_length(key)) {
    snprintf(label, size, "%.*s (%.20s)", shown, name, unit);
  } else {
    snprintf(label, size, "%.*s", shown, name);
  }
}
