/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that add loads to a scene in memory: earthquake, water, pressures, surcharges, anchors,
 * bond and cohesion. */

#include "common/host.h"
#include "scene_building/build.h"

tp_status tp_scene_set_seismic_direction(tp_scene *scene, tp_seismic_direction direction,
                                         tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK && ((int)direction < 0 || direction > TP_SEISMIC_UP_DIP)) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place, "there is no such direction");
  }
  if (status == TP_OK) {
    scene->loads.direction_given = true;
    scene->loads.direction = direction;
    scene->loads.seismic_place = build.place;
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_water(tp_scene *scene, tp_exact height, tp_exact unit_weight_kn_m3,
                             bool stays_level, bool uplift, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"height", height, TP_RULE_NOT_NEGATIVE},
                            {"unit_weight_kn_m3", unit_weight_kn_m3, TP_RULE_NOT_NEGATIVE}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_water_description *water = &scene->loads.water;
    tp_build_note_load(&build);
    water->given = true;
    water->place = build.place;
    water->stays_level = stays_level;
    water->uplift = uplift;
    water->faces = TP_WATER_FACES_UNSTATED;
    water->shape = TP_WATER_UPLIFT_UNSTATED;
    water->cracked = water->level.given = false;
    water->crack_level.given = water->crack_height.given = water->crack_distance.given = false;
    water->ice_kpa.given = water->ice_thickness.given = false;
    tp_polyline_clear(&water->surface);
    tp_build_put(&build, &water->height, 0);
    tp_build_put(&build, &water->unit_weight_kn_m3, 1);
  }
  tp_build_end(&build);
  return status;
}

/* A load along a line: its ends, and what it has there, each by the name of its argument. */
static tp_status add_line(tp_scene *scene, const char *call, const tp_exact ends[4],
                          const tp_given kpa[2], tp_line_load **loads, long *count,
                          tp_message *message) {
  const tp_given given[] = {{"x0", ends[0], TP_RULE_ANY},
                            {"y0", ends[1], TP_RULE_ANY},
                            {"x1", ends[2], TP_RULE_ANY},
                            {"y1", ends[3], TP_RULE_ANY},
                            kpa[0],
                            kpa[1]};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, call, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 6);
  void *items = *loads;
  if (status == TP_OK) status = tp_build_grow(&build, &items, *count, sizeof **loads);
  *loads = items;
  if (status == TP_OK) {
    tp_line_load *load = *loads + (*count)++;
    tp_build_note_load(&build);
    tp_line_load_init(load);
    load->place = build.place;
    tp_quantity *const quantities[] = {&load->x0, &load->y0,        &load->x1,
                                       &load->y1, &load->first_kpa, &load->last_kpa};
    for (long k = 0; k < 6; k++) tp_build_put(&build, quantities[k], k);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_pressure(tp_scene *scene, tp_exact x0, tp_exact y0, tp_exact x1, tp_exact y1,
                                tp_exact first_kpa, tp_exact last_kpa, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return add_line(scene, __func__, (tp_exact[]){x0, y0, x1, y1},
                  (tp_given[]){{"first_kpa", first_kpa, TP_RULE_NOT_NEGATIVE},
                               {"last_kpa", last_kpa, TP_RULE_NOT_NEGATIVE}},
                  &scene->loads.pressures, &scene->loads.pressure_count, message);
}

tp_status tp_scene_add_support_pressure(tp_scene *scene, tp_exact x0, tp_exact y0, tp_exact x1,
                                        tp_exact y1, tp_exact first_kpa, tp_exact last_kpa,
                                        bool passive, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_loads_description *loads = &scene->loads;
  const tp_status status = add_line(scene, __func__, (tp_exact[]){x0, y0, x1, y1},
                                    (tp_given[]){{"first_kpa", first_kpa, TP_RULE_NOT_NEGATIVE},
                                                 {"last_kpa", last_kpa, TP_RULE_NOT_NEGATIVE}},
                                    &loads->supports, &loads->support_count, message);
  if (status == TP_OK) loads->supports[loads->support_count - 1].passive = passive;
  return status;
}

tp_status tp_scene_add_surcharge(tp_scene *scene, tp_exact x0, tp_exact y0, tp_exact x1,
                                 tp_exact y1, tp_exact kpa, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given everywhere = {"kpa", kpa, TP_RULE_NOT_NEGATIVE};
  return add_line(scene, __func__, (tp_exact[]){x0, y0, x1, y1},
                  (tp_given[]){everywhere, everywhere}, &scene->loads.surcharges,
                  &scene->loads.surcharge_count, message);
}

tp_status tp_build_pull(tp_scene *scene, const char *call, tp_list_kind list, const tp_pull *pull,
                        tp_message *message) {
  const tp_given given[] = {{"x", pull->x, TP_RULE_ANY},
                            {"y", pull->y, TP_RULE_ANY},
                            {"force_kn", pull->force_kn, TP_RULE_NOT_NEGATIVE},
                            pull->way[0],
                            pull->way[1]};
  const long ways = pull->way[1].name != NULL ? 2 : 1;
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, call, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 3 + ways);
  const long count = tp_member_count(scene, list);
  if (status == TP_OK) {
    void *items = tp_member_items(scene, list);
    status = tp_build_grow(&build, &items, count, sizeof(tp_anchor_description));
    tp_member_set_items(scene, list, items);
  }
  if (status == TP_OK) {
    tp_anchor_description *anchor =
        (tp_anchor_description *)(void *)tp_member_items(scene, list) + count;
    tp_member_set_count(scene, list, count + 1);
    tp_build_note_load(&build);
    tp_anchor_init(anchor);
    anchor->place = build.place;
    anchor->passive = pull->passive;
    tp_build_put(&build, &anchor->x, 0);
    tp_build_put(&build, &anchor->y, 1);
    tp_build_put(&build, &anchor->force_kn, 2);
    for (long k = 0; k < ways; k++) {
      tp_build_put(&build, (tp_quantity *)(void *)((char *)anchor + pull->members[k]), 3 + k);
    }
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_anchor(tp_scene *scene, tp_exact x, tp_exact y, tp_exact direction_deg,
                              tp_exact force_kn, bool passive, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_pull pull = {.x = x,
                        .y = y,
                        .force_kn = force_kn,
                        .passive = passive,
                        .way = {{"direction_deg", direction_deg, TP_RULE_ANY}},
                        .members = {offsetof(tp_anchor_description, direction_deg)}};
  return tp_build_pull(scene, __func__, TP_LIST_ANCHORS, &pull, message);
}

/* ---- bolts -------------------------------------------------------------------------------------
 */

tp_status tp_scene_add_bolt(tp_scene *scene, tp_exact x, tp_exact y, tp_exact dip_deg,
                            tp_exact force_kn, bool passive, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_pull pull = {.x = x,
                        .y = y,
                        .force_kn = force_kn,
                        .passive = passive,
                        .way = {{"dip_deg", dip_deg, TP_RULE_DIP}},
                        .members = {offsetof(tp_anchor_description, dip_deg)}};
  return tp_build_pull(scene, __func__, TP_LIST_ANCHORS, &pull, message);
}

/* One that was added, which the call gives more; a message where there is none of the number. */
static tp_status find_bolt(tp_anchor_description **bolt, const tp_build *build, size_t number) {
  const tp_loads_description *loads = &build->scene->loads;
  const tp_status status = tp_build_find(build, number, loads->anchor_count, "bolt");
  if (status == TP_OK) *bolt = loads->anchors + (number - 1);
  return status;
}

tp_status tp_scene_set_bolt_towards(tp_scene *scene, size_t number, tp_direction towards,
                                    tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_anchor_description *bolt = NULL;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = find_bolt(&bolt, &build, number);
  if (status == TP_OK && towards != TP_TOWARDS_LEFT && towards != TP_TOWARDS_RIGHT) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place, "there is no such direction");
  }
  if (status == TP_OK) bolt->side = towards == TP_TOWARDS_LEFT ? TP_BOLT_LEFT : TP_BOLT_RIGHT;
  tp_build_end(&build);
  return status;
}

/* One number more of a bolt: that at an offset in it. */
static tp_status set_bolt(tp_scene *scene, const char *call, size_t number, tp_given given,
                          size_t offset, tp_message *message) {
  tp_build build;
  tp_anchor_description *bolt = NULL;
  tp_status status = tp_build_begin(&build, scene, call, message);
  if (status == TP_OK) status = find_bolt(&bolt, &build, number);
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) {
    tp_build_put(&build, (tp_quantity *)(void *)((char *)bolt + offset), 0);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_bolt_length(tp_scene *scene, size_t number, tp_exact length,
                                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_bolt(scene, __func__, number, (tp_given){"length", length, TP_RULE_ABOVE_ZERO},
                  offsetof(tp_anchor_description, length), message);
}

tp_status tp_scene_set_bolt_capacity_kn(tp_scene *scene, size_t number, tp_exact capacity_kn,
                                        tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_bolt(scene, __func__, number,
                  (tp_given){"capacity_kn", capacity_kn, TP_RULE_ABOVE_ZERO},
                  offsetof(tp_anchor_description, capacity_kn), message);
}

tp_status tp_scene_set_bolt_spacing(tp_scene *scene, size_t number, tp_exact spacing,
                                    tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_bolt(scene, __func__, number, (tp_given){"spacing", spacing, TP_RULE_ABOVE_ZERO},
                  offsetof(tp_anchor_description, spacing), message);
}

tp_status tp_scene_set_bolt_rows(tp_scene *scene, size_t number, long rows, tp_exact dx,
                                 tp_exact dy, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"rows", tp_exact_of((double)rows), TP_RULE_COUNT},
                            {"dx", dx, TP_RULE_ANY},
                            {"dy", dy, TP_RULE_ANY}};
  tp_build build;
  tp_anchor_description *bolt = NULL;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = find_bolt(&bolt, &build, number);
  if (status == TP_OK) status = tp_build_read(&build, given, 3);
  if (status == TP_OK) {
    tp_build_put(&build, &bolt->rows, 0);
    tp_build_put(&build, &bolt->step_x, 1);
    tp_build_put(&build, &bolt->step_y, 2);
  }
  tp_build_end(&build);
  return status;
}
