/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the keys of water need of each other: one of height, level and surface, or a crack that is
 * filled; what belongs to one of these stands beside it. */

#include "scene/check.h"

static tp_status refuse(const tp_water_description *water, const char *why, tp_message *message) {
  return tp_refuse(message, TP_FAULT_KEY, water->place, "%s", why);
}

static const char *fault_of_crack(const tp_water_description *water) {
  if (water->crack_level.given == water->crack_height.given) {
    return "a tension crack is filled to a 'level' or to a 'height', one of them";
  }
  if (water->crack_level.given && water->crack_distance.given) {
    return "'distance' of a tension crack says where the foot lies that its 'height' counts from; "
           "a "
           "'level' is an elevation wherever the crack lies: leave one of them out";
  }
  const bool in_front = water->faces == TP_WATER_IN_FRONT || water->faces == TP_WATER_ON_BOTH;
  if (in_front && !water->level.given && water->surface.count == 0) {
    return "a tension crack holds water behind the block; say where it stands in front, 'level' or "
           "'surface', or leave 'faces' out";
  }
  if (water->faces == TP_WATER_IN_FRONT) {
    return "a tension crack holds water behind the block: with water in front of it too say "
           "'faces: both'";
  }
  return NULL;
}

static const char *fault_of(const tp_scene *scene) {
  const tp_water_description *water = &scene->loads.water;
  const int told = water->height.given + water->level.given + (water->surface.count > 0);
  if (told > 1 || (water->height.given && water->cracked)) {
    return "water has a 'height' along the face behind the block, or a 'level', or a 'surface': "
           "give "
           "one of them; a 'tension_crack' stands alone or beside the last two";
  }
  if (told == 0 && !water->cracked) {
    return "water needs 'height', 'level', 'surface' or 'tension_crack', for example 'level: 2'";
  }
  if (tp_water_is_sited(&scene->loads.water)) {
    if (water->stays_level) {
      return "'stays_level' is for a 'height': a level is one whatever the tilt; leave it out";
    }
    if (water->ice_kpa.given != water->ice_thickness.given) {
      return "ice needs its pressure and its thickness, 'ice_kpa: 100' and 'ice_thickness: 0.5'";
    }
    return water->cracked ? fault_of_crack(water) : NULL;
  }
  if (water->faces != TP_WATER_FACES_UNSTATED || water->ice_kpa.given ||
      water->ice_thickness.given) {
    return "'faces' and ice are for water with a 'level', a 'surface' or a 'tension_crack'; a "
           "'height' is that behind the block";
  }
  if (water->shape == TP_WATER_UPLIFT_FULL) {
    return "under a 'height' uplift falls to nothing at the toe; for 'uplift: full' give the water "
           "as 'tension_crack: {height: …}' or as a 'level'";
  }
  return NULL;
}

tp_status tp_check_water(const tp_scene *scene, tp_message *message) {
  const tp_water_description *water = &scene->loads.water;
  const char *why = water->given ? fault_of(scene) : NULL;
  return why == NULL ? TP_OK : refuse(water, why, message);
}
