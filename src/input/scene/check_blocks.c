/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene of many blocks may hold besides its blocks: the rules of the reader of files and of
 * the calls that build one; and of these what makes a scene one of one block, or of many. */

#include "scene/anchor.h"
#include "scene/block_names.h"
#include "scene/check.h"

#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

/* ---- what a file and calls share ---------------------------------------------------------------
 */

tp_status tp_check_block_weights(const tp_scene *scene, tp_message *message) {
  const tp_block_list *many = &scene->many;
  const tp_listed_block *weighed = NULL, *other = NULL;
  for (long k = 0; k < many->count; k++) {
    const tp_listed_block *own = many->blocks + k;
    if (own->fixed) continue;
    if (tp_listed_block_unit_weight(scene, own)->given) {
      weighed = own;
    } else {
      other = own;
    }
  }
  if (weighed == NULL || other == NULL) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, other->place,
                   "block '%s' has no 'unit_weight_kn_m3', and '%s' has one: give it to each, or "
                   "to all by 'block: {unit_weight_kn_m3: 25}'",
                   tp_quote_all(other->name).text, tp_quote_all(weighed->name).text);
}

tp_status tp_check_bolt_ends(const tp_scene *scene, tp_message *message) {
  for (long k = 0; k < scene->loads.anchor_count; k++) {
    const tp_anchor_description *own = scene->loads.anchors + k;
    if (own->into >= 0 || own->to_x.given || own->length.given) continue;
    return tp_refuse(message, TP_FAULT_KEY, own->place,
                     "say where this bolt holds: its far end by 'to: [x, y]' or by its 'length', "
                     "or the block by 'into', as 'into: ground'");
  }
  return TP_OK;
}

/* On a table the tilt tells the side, and with y up there is no dip. */
tp_status tp_check_block_shaking(const tp_scene *scene, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  const bool tilts = scene->tilt_angle_deg.given || scene->towards_left != scene->towards_right;
  const bool on_table = scene->frame != TP_FRAME_WORLD && tilts;
  const tp_seismic_direction meant = on_table ? TP_SEISMIC_DOWN_DIP : TP_SEISMIC_BOTH;
  if (scene->many.count == 0 || scene->frame == TP_FRAME_SLOPE || !loads->direction_given ||
      loads->direction == meant) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_KEY, loads->seismic_place,
                   "this 'direction' is of blocks on a 'slope': %s",
                   on_table ? "on a table 'horizontal' acts towards the side that the tilt "
                              "lowers, and to both with 'towards: both'"
                            : "with y up they are shaken to both sides, or to that of "
                              "'tilt: {towards: left}'");
}

tp_status tp_check_block_water(const tp_water_description *water, const char *key, tp_place place,
                               tp_message *message) {
  static const char level[] = "water in and about many blocks has a 'level', or a 'surface' of "
                              "points from left to right";
  static const char ice[] = "give the pressure of ice as 'pressures: [{block: …, from: …, to: …, "
                            "kpa: …}]' on each block that it presses on";
  const struct {
    const char *key;
    bool applies;
    const char *what, *instead;
  } keys[] = {{"height", true, "height", level},
              {"stays_level", true, "stays_level", level},
              {"tension_crack", true, "tension_crack",
               "between many blocks water stands in every joint below the 'surface': draw that up "
               "to where it stands in the crack"},
              {"ice_kpa", true, "ice_kpa", ice},
              {"ice_thickness", true, "ice_thickness", ice},
              {"uplift", water->shape == TP_WATER_UPLIFT_TRIANGULAR, "uplift: triangular",
               "between many blocks water stands in all joints below its level or surface, "
               "'uplift: full', or in none, 'uplift: none'; draw the surface as low as it stands "
               "where joints are drained"},
              {"faces", water->faces == TP_WATER_IN_FRONT, "faces: front",
               "of many blocks water presses on the faces 'behind', from where it drives them, or "
               "on 'both', those that it holds too; where it stands the surface says"}};
  for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
    if (!keys[k].applies || strcmp(keys[k].key, key) != 0) continue;
    return tp_refuse(message, TP_FAULT_KEY, place, "'%s' is of one block on its base: %s",
                     keys[k].what, keys[k].instead);
  }
  return TP_OK;
}

/* ---- a scene that was built --------------------------------------------------------------------
 */

/* Something that is of the other kind of scene, where the scene has it. */
typedef struct stranger {
  bool has;
  tp_place place;
} stranger;

static tp_place place_of(const tp_polyline *line) {
  return line != NULL ? tp_polyline_place(line, -1) : (tp_place){0};
}

/* Of one block on its base. */
static tp_status refuse_of_one(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  const tp_base_description *base = &scene->base;
  const tp_friction_description *law = &scene->friction;
  const stranger all[] = {
      {block->form != TP_OUTLINE_OF_EACH, block->place},
      {block->hole_count > 0, place_of(block->holes)},
      {block->part_count > 0, place_of(block->part_count > 0 ? &block->parts->outline : NULL)},
      {block->arc_count > 0, block->arc_count > 0 ? block->arcs->place : block->place},
      {block->rounded.count > 0, block->rounded.place},
      {block->arc_tolerance.given, block->arc_tolerance.place},
      {block->repair, block->repair_place},
      {block->thickness.given, block->thickness.place},
      {base->place.file != NULL, base->place},
      {base->rests, base->rests_place},
      {base->smooth.given, base->smooth.place},
      {base->closure.given, base->closure.place},
      {tp_scene_is_shifted(scene), tp_scene_shift_place(scene)},
      {law->load_dependent || law->basic_angle_deg.given, scene->friction_angle_deg.place},
      {law->contact_width.given, law->contact_width.place},
      {law->facet_count > 0, law->facet_count > 0 ? law->facets->place : block->place},
      {scene->tilt_test.place.file != NULL, scene->tilt_test.place},
      {scene->shaking_place.file != NULL, scene->shaking_place}};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
    if (!all[k].has) continue;
    return tp_refuse(message, TP_FAULT_KEY, all[k].place,
                     "this is of a scene of one block, and this one has many, by "
                     "tp_scene_add_block: leave one of them out");
  }
  return TP_OK;
}

static tp_status check_water(const tp_scene *scene, tp_message *message) {
  const tp_water_description *water = &scene->loads.water;
  const struct {
    const char *key;
    bool has;
  } keys[] = {{"height", water->height.given},
              {"tension_crack", water->cracked},
              {"ice_kpa", water->ice_kpa.given},
              {"uplift", true},
              {"faces", true}};
  tp_status status = TP_OK;
  for (size_t k = 0; k < sizeof keys / sizeof keys[0] && water->given && status == TP_OK; k++) {
    if (keys[k].has) status = tp_check_block_water(water, keys[k].key, water->place, message);
  }
  return status == TP_OK ? tp_check_water(scene, message) : status;
}

static tp_status check_support(const tp_scene *scene, tp_message *message) {
  const tp_support_description *own = &scene->many.support;
  const tp_quantity *first = own->direction_deg.given ? &own->direction_deg : &own->fos;
  if (own->place.file != NULL || !first->given) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, first->place,
                   "the support has no block and no point: set them by tp_scene_set_support");
}

static tp_status check_names(const tp_scene *scene, tp_message *message) {
  tp_block_name *names = NULL;
  const tp_status status = tp_block_names_sort(&names, scene, message);
  if (status == TP_OK) free(names);
  return status;
}

tp_status tp_check_built_blocks(const tp_scene *scene, tp_message *message) {
  tp_status status = refuse_of_one(scene, message);
  if (status == TP_OK) status = check_names(scene, message);
  if (status == TP_OK) status = tp_check_block_weights(scene, message);
  if (status == TP_OK) status = check_water(scene, message);
  if (status == TP_OK) status = tp_check_bolt_ends(scene, message);
  if (status == TP_OK) status = tp_check_block_shaking(scene, message);
  if (status == TP_OK) status = tp_anchors_check(scene, message);
  return status == TP_OK ? check_support(scene, message) : status;
}

tp_status tp_check_built_alone(const tp_scene *scene, tp_message *message) {
  const tp_block_list *many = &scene->many;
  const tp_loads_description *loads = &scene->loads;
  tp_place place = {0};
  if (many->count > 0 && scene->block.form == TP_OUTLINE_OF_EACH) {
    return tp_refuse(message, TP_FAULT_KEY, many->place,
                     "this scene has many blocks, which tp_solve_block_system takes (in Python "
                     "solve_block_system), sweeps and maps; all else is of one");
  }
  if (many->count > 0) {
    place = scene->block.place;
  } else if (loads->force_count > 0) {
    place = loads->forces->place;
  } else if (many->support.direction_deg.given) {
    place = many->support.direction_deg.place;
  } else if (many->support.fos.given) {
    place = many->support.fos.place;
  }
  for (long k = 0; k < loads->anchor_count && place.file == NULL; k++) {
    if (loads->anchors[k].to_x.given) place = loads->anchors[k].place;
  }
  if (place.file == NULL) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "a scene has one block on its base, or many by tp_scene_add_block: leave out "
                   "what is of the other");
}
