/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that add loads to a scene in memory: earthquake, water, pressures, surcharges, anchors,
 * bond and cohesion. */

#include "common/host.h"
#include "scene_building/build.h"

tp_status tp_scene_set_seismic_horizontal(tp_scene *scene, tp_exact coefficient,
                                          tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "loads.seismic.horizontal", coefficient, message);
}

tp_status tp_scene_set_seismic_vertical(tp_scene *scene, tp_exact coefficient,
                                        tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "loads.seismic.vertical", coefficient, message);
}

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

tp_status tp_scene_add_surcharge(tp_scene *scene, tp_exact x0, tp_exact y0, tp_exact x1,
                                 tp_exact y1, tp_exact kpa, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given everywhere = {"kpa", kpa, TP_RULE_NOT_NEGATIVE};
  return add_line(scene, __func__, (tp_exact[]){x0, y0, x1, y1},
                  (tp_given[]){everywhere, everywhere}, &scene->loads.surcharges,
                  &scene->loads.surcharge_count, message);
}

tp_status tp_scene_add_anchor(tp_scene *scene, tp_exact x, tp_exact y, tp_exact direction_deg,
                              tp_exact force_kn, bool passive, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"x", x, TP_RULE_ANY},
                            {"y", y, TP_RULE_ANY},
                            {"direction_deg", direction_deg, TP_RULE_ANY},
                            {"force_kn", force_kn, TP_RULE_NOT_NEGATIVE}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 4);
  if (status == TP_OK) {
    tp_loads_description *loads = &scene->loads;
    void *anchors = loads->anchors;
    status = tp_build_grow(&build, &anchors, loads->anchor_count, sizeof *loads->anchors);
    loads->anchors = anchors;
  }
  if (status == TP_OK) {
    tp_anchor_description *anchor = scene->loads.anchors + scene->loads.anchor_count++;
    tp_build_note_load(&build);
    tp_anchor_init(anchor);
    anchor->place = build.place;
    anchor->passive = passive;
    tp_build_put(&build, &anchor->x, 0);
    tp_build_put(&build, &anchor->y, 1);
    tp_build_put(&build, &anchor->direction_deg, 2);
    tp_build_put(&build, &anchor->force_kn, 3);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_bond_kpa(tp_scene *scene, tp_exact bond_kpa, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "loads.bond_kpa", bond_kpa, message);
}

tp_status tp_scene_set_cohesion_kpa(tp_scene *scene, tp_exact cohesion_kpa, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "loads.cohesion_kpa", cohesion_kpa, message);
}
