/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Keys of a scene that go with its solid, or with no solid: azimuths of tilt and earthquake, loads,
 * the dip of its base. */

#include "scene_reading/read.h"

#include <string.h>

static tp_status refuse_azimuth(const tp_reader *reader, const tp_quantity *azimuth,
                                const char *instead) {
  return !azimuth->given
             ? TP_OK
             : tp_refuse(reader->message, TP_FAULT_KEY, azimuth->place,
                         "'azimuth_deg' is of a scene of a 'solid'; this one has %s", instead);
}

/* Of loads a solid has an earthquake. */
static tp_status check_loads(const tp_reader *reader, const tp_node *loads) {
  const tp_node *seismic = tp_node_get(loads, "seismic");
  for (const tp_node *n = loads->first; n != NULL; n = n->next) {
    if (n == seismic) continue;
    if (reader->scene->solid.wedge.place.file != NULL && strcmp(n->key, "anchors") == 0) continue;
    return tp_read_fail(
        reader, TP_FAULT_KEY, n,
        "of the loads a solid takes 'seismic', and a wedge 'anchors': leave out '%s'", n->key);
  }
  const tp_node *direction = tp_node_get(seismic, "direction");
  return direction == NULL ? TP_OK
                           : tp_read_fail(reader, TP_FAULT_KEY, direction,
                                          "an earthquake on a solid acts towards an 'azimuth_deg', "
                                          "or towards any where none is given");
}

/* A bolt in a wedge pulls along a line in space, at no point: the wedge does not turn. */
static tp_status check_bolt(const tp_reader *reader, const tp_node *bolt,
                            const tp_anchor_description *own) {
  static const char *const keys[] = {"dip_deg", "azimuth_deg", "force_kn", "capacity_kn",
                                     "passive"};
  for (const tp_node *n = bolt->first; n != NULL; n = n->next) {
    bool known = false;
    for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
      known = known || strcmp(n->key, keys[k]) == 0;
    }
    if (known) continue;
    return tp_read_fail(reader, TP_FAULT_KEY, n,
                        "a bolt in a wedge has 'dip_deg', 'azimuth_deg', 'force_kn' and "
                        "'capacity_kn', and each entry its whole force: leave out '%s'",
                        n->key);
  }
  if (own->passive) {
    return tp_read_fail(reader, TP_FAULT_KEY, tp_node_get(bolt, "passive"),
                        "bolts in a wedge are active, and count with the force that they are "
                        "locked off at: leave out 'passive'");
  }
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, bolt, "dip_deg", "dip_deg: 10");
  return status == TP_OK ? tp_read_required(reader, &node, bolt, "azimuth_deg", "azimuth_deg: 340")
                         : status;
}

static tp_status check_bolts(const tp_reader *reader, const tp_node *loads) {
  const tp_node *list = loads != NULL ? tp_node_get(loads, "anchors") : NULL;
  const tp_anchor_description *own = reader->scene->loads.anchors;
  tp_status status = TP_OK;
  if (list == NULL) return TP_OK;
  for (const tp_node *n = list->first; n != NULL && status == TP_OK; n = n->next) {
    status = check_bolt(reader, n, own++);
  }
  return status;
}

static tp_status check_ways(const tp_reader *reader, const tp_node *root) {
  const tp_scene *scene = reader->scene;
  const tp_node *tilt = tp_node_get(root, "tilt");
  const tp_node *towards = tilt != NULL ? tp_node_get(tilt, "towards") : NULL;
  if (towards != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, towards,
                        "a solid is tilted towards an 'azimuth_deg', or towards any where none is "
                        "given");
  }
  if (scene->solid.dip_deg.given && tilt != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, tilt,
                        "the base of this solid has its dip, which is its tilt: leave one out");
  }
  const bool any = scene->tilt_angle_deg.given && !scene->tilt_azimuth_deg.given;
  return any && scene->loads.azimuth_deg.given
             ? tp_refuse(reader->message, TP_FAULT_KEY, scene->loads.azimuth_deg.place,
                         "the earthquake has an azimuth, and the tilt none: give it "
                         "'tilt.azimuth_deg' too")
             : TP_OK;
}

/* A wedge slides under its weight, its water and an earthquake. */
static tp_status check_wedge(const tp_reader *reader, const tp_node *root) {
  static const char *const keys[] = {"tilt", "friction_angle_deg", NULL};
  const tp_node *node = tp_node_first_of(root, keys);
  if (node != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "a 'wedge' lies as its planes dip, with their friction, under its weight "
                        "and its water: leave out '%s'",
                        node->key);
  }
  return TP_OK;
}

static tp_status check_one_way(const tp_reader *reader) {
  const tp_scene *scene = reader->scene;
  const char *on = scene->solid.contact_count > 0 ? "'contacts'" : "a mesh of the ground";
  if (scene->tilt_angle_deg.given && !scene->tilt_azimuth_deg.given) {
    return tp_refuse(reader->message, TP_FAULT_KEY, scene->tilt_angle_deg.place,
                     "a rock on %s is tilted one way: give the tilt its 'azimuth_deg'", on);
  }
  return !scene->loads.horizontal.given || scene->loads.azimuth_deg.given
             ? TP_OK
             : tp_refuse(reader->message, TP_FAULT_KEY, scene->loads.horizontal.place,
                         "a rock on %s is shaken one way: give 'seismic' its 'azimuth_deg'", on);
}

/* Contacts have friction, and are tilted and shaken one way. */
static tp_status check_contacts(const tp_reader *reader) {
  const tp_scene *scene = reader->scene;
  for (long k = 0; k < scene->solid.contact_count; k++) {
    const tp_contact_description *own = scene->solid.contacts + k;
    if (own->friction_angle_deg.given || scene->friction_angle_deg.given) continue;
    return tp_refuse(reader->message, TP_FAULT_KEY, own->place,
                     "this contact has no friction: give it a 'friction_angle_deg', or the scene "
                     "one for all");
  }
  const bool is_on_ground = scene->solid.ground.place.file != NULL;
  if (is_on_ground && !scene->friction_angle_deg.given) {
    return tp_refuse(reader->message, TP_FAULT_KEY, scene->solid.ground.place,
                     "a rock on a mesh of the ground needs friction: give the scene its "
                     "'friction_angle_deg'");
  }
  return scene->solid.contact_count > 0 || is_on_ground ? check_one_way(reader) : TP_OK;
}

tp_status tp_check_solid_keys(const tp_reader *reader, const tp_node *root) {
  const tp_scene *scene = reader->scene;
  if (scene->solid.place.file == NULL) {
    const tp_status status =
        refuse_azimuth(reader, &scene->tilt_azimuth_deg, "'towards: left', right or both");
    return status == TP_OK
               ? refuse_azimuth(reader, &scene->loads.azimuth_deg, "'direction' on a slope")
               : status;
  }
  const tp_node *loads = tp_node_get(root, "loads");
  tp_status status = loads != NULL ? check_loads(reader, loads) : TP_OK;
  if (status == TP_OK && scene->solid.wedge.place.file != NULL) {
    status = check_wedge(reader, root);
    return status == TP_OK ? check_bolts(reader, loads) : status;
  }
  if (status == TP_OK) status = check_ways(reader, root);
  return status == TP_OK ? check_contacts(reader) : status;
}
