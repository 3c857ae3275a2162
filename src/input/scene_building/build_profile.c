/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene in memory: a base that is made by rule. Every call changes the base of a copy, makes its
 * profile anew, and exchanges the two where all of that went well. */

#include "common/host.h"
#include "common/options.h"
#include "number/word.h"
#include "scene/profile_make.h"
#include "scene_building/build.h"

TP_OPTIONS_END(tp_base_teeth_options, seed);
TP_OPTIONS_END(tp_base_self_affine_options, seed);

void tp_base_teeth_options_init(tp_base_teeth_options *options, size_t size) {
  const tp_base_teeth_options defaults = {.size = sizeof defaults, .left_end = TP_LEFT_END_VALLEY};
  tp_options_fill(options, size, &defaults);
}

void tp_base_self_affine_options_init(tp_base_self_affine_options *options, size_t size) {
  const tp_base_self_affine_options defaults = {.size = sizeof defaults,
                                                .by = TP_ROUGHNESS_RMS_HEIGHT};
  tp_options_fill(options, size, &defaults);
}

/* A call under way: the copy that it changes. */
typedef struct change {
  tp_build build;
  tp_scene *scene, *copy;
  tp_base_description *base; /* of the copy */
  tp_profile_rule *rule;
} change;

static tp_status begin(change *c, tp_scene *scene, const char *call, tp_message *message) {
  *c = (change){.scene = scene};
  const tp_status status = tp_build_begin(&c->build, scene, call, message);
  if (status != TP_OK) return status;
  c->copy = tp_scene_copy(scene);
  if (c->copy == NULL) return tp_fail_memory(message, "the scene");
  c->base = &c->copy->base;
  c->rule = &c->base->rule;
  return TP_OK;
}

/* A base of another kind. */
static void begin_rule(change *c, tp_made_of made) {
  tp_base_drop(c->base);
  c->base->mated = c->base->whole = false;
  c->base->place = c->rule->place = c->rule->first_place = c->build.place;
  c->rule->made = made;
}

static tp_status end(change *c, tp_status status) {
  if (status == TP_OK) status = tp_build_profile(c->copy, c->build.message);
  if (status == TP_OK) {
    const tp_base_description before = c->scene->base;
    c->scene->base = *c->base;
    *c->base = before;
  }
  tp_scene_free(c->copy);
  return status;
}

static tp_status put(change *c, tp_quantity *quantity, tp_exact value, const char *name) {
  const tp_build *build = &c->build;
  const tp_status status =
      tp_exact_read(quantity->value, value, name, build->place.file, build->message);
  quantity->given = true;
  quantity->place = build->place;
  return status;
}

static void put_whole(change *c, tp_quantity *quantity, long long value) {
  fmpq_one(quantity->value);
  tp_word_set(fmpq_numref(quantity->value), value);
  quantity->given = true;
  quantity->place = c->build.place;
}

static tp_status put_start(change *c, tp_exact x, tp_exact y) {
  const tp_status status = put(c, &c->rule->start_x, x, "start_x");
  return status == TP_OK ? put(c, &c->rule->start_y, y, "start_y") : status;
}

static tp_status put_roughness(change *c, tp_quantity *by, tp_roughness_by kind, tp_exact value) {
  if ((int)kind < TP_ROUGHNESS_RMS_HEIGHT || (int)kind > TP_ROUGHNESS_JRC) {
    return tp_refuse(c->build.message, TP_FAULT_ARGUMENT, c->build.place,
                     "'by' must be the RMS height, Z2 or JRC");
  }
  return put(c, by + kind, value, "roughness");
}

tp_status tp_build_profile(tp_scene *scene, tp_message *message) {
  tp_polyline line = {0};
  const tp_status status =
      tp_profile_make(&line, &scene->base.rule, scene->metres_per_unit, message);
  if (status != TP_OK) return status;
  tp_polyline_clear(&scene->base.profile);
  scene->base.profile = line;
  return TP_OK;
}

/* ---- what a profile begins with ----------------------------------------------------------------
 */

static tp_status put_teeth(change *c, const tp_base_teeth_options *o) {
  tp_profile_rule *rule = c->rule;
  if (o->left_end != TP_LEFT_END_VALLEY && o->left_end != TP_LEFT_END_PEAK) {
    return tp_refuse(c->build.message, TP_FAULT_ARGUMENT, c->build.place,
                     "left_end must be valley or peak");
  }
  const struct {
    tp_quantity *quantity;
    tp_exact value;
    const char *name;
  } all[] = {{&rule->wavelength, o->wavelength, "wavelength"},
             {&rule->amplitude, o->amplitude, "amplitude"},
             {&rule->skew, o->skew, "skew"},
             {rule->scatter, o->wavelength_scatter, "wavelength_scatter"},
             {rule->scatter + 1, o->amplitude_scatter, "amplitude_scatter"},
             {rule->scatter + 2, o->skew_scatter, "skew_scatter"}};
  tp_status status = TP_OK;
  for (size_t k = 0; k < sizeof all / sizeof all[0] && status == TP_OK; k++) {
    status = put(c, all[k].quantity, all[k].value, all[k].name);
  }
  rule->left_end_valley = o->left_end == TP_LEFT_END_VALLEY;
  put_whole(c, &rule->count, o->count);
  put_whole(c, &rule->seed, o->seed);
  return status == TP_OK ? put_start(c, o->start_x, o->start_y) : status;
}

tp_status tp_scene_set_base_teeth(tp_scene *scene, const tp_base_teeth_options *options,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_base_teeth_options taken = tp_base_teeth_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  change c;
  tp_status status = begin(&c, scene, __func__, message);
  if (status == TP_OK) {
    begin_rule(&c, TP_MADE_OF_TEETH);
    status = put_teeth(&c, options);
  }
  return end(&c, status);
}

/* One that is not given is zero. */
static tp_status put_wavelength(change *c, tp_quantity *quantity, tp_exact value,
                                const char *name) {
  const tp_status status = put(c, quantity, value, name);
  if (status == TP_OK && fmpq_is_zero(quantity->value)) quantity->given = false;
  return status;
}

static tp_status put_self_affine(change *c, const tp_base_self_affine_options *o) {
  tp_profile_rule *rule = c->rule;
  tp_status status = put(c, &rule->length, o->length, "length");
  if (status == TP_OK) status = put(c, &rule->step, o->step, "step");
  if (status == TP_OK) status = put(c, &rule->hurst, o->hurst, "hurst");
  if (status == TP_OK) status = put_wavelength(c, &rule->shortest, o->shortest, "shortest");
  if (status == TP_OK) status = put_wavelength(c, &rule->longest, o->longest, "longest");
  if (status == TP_OK) status = put_roughness(c, rule->roughness, o->by, o->roughness);
  put_whole(c, &rule->seed, o->seed);
  return status == TP_OK ? put_start(c, o->start_x, o->start_y) : status;
}

tp_status tp_scene_set_base_self_affine(tp_scene *scene, const tp_base_self_affine_options *options,
                                        tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_base_self_affine_options taken = tp_base_self_affine_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  change c;
  tp_status status = begin(&c, scene, __func__, message);
  if (status == TP_OK) {
    begin_rule(&c, TP_MADE_SELF_AFFINE);
    status = put_self_affine(&c, options);
  }
  return end(&c, status);
}

tp_status tp_scene_set_base_jrc_profile(tp_scene *scene, long number, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  change c;
  const tp_status status = begin(&c, scene, __func__, message);
  if (status == TP_OK) {
    begin_rule(&c, TP_MADE_LIKE_STANDARD);
    put_whole(&c, &c.rule->standard, number);
  }
  return end(&c, status);
}

/* ---- what changes it ---------------------------------------------------------------------------
 */

/* Points that were given are measured ones now. */
static tp_status begin_change(change *c, tp_scene *scene, const char *call, const char *what,
                              tp_message *message) {
  const tp_status status = begin(c, scene, call, message);
  if (status != TP_OK) return status;
  if (c->base->mated) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, c->build.place,
                     "%s is of a base profile, and the base is mated; set its profile first", what);
  }
  if (c->rule->made != TP_MADE_OF_POINTS) return TP_OK;
  c->rule->made = TP_MADE_OF_MEASURED;
  c->rule->place = c->rule->first_place = c->base->place;
  c->rule->measured = tp_polyline_share(&c->base->profile);
  return TP_OK;
}

tp_status tp_scene_set_base_noise(tp_scene *scene, tp_exact deviation, long long seed,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  change c;
  tp_status status = begin_change(&c, scene, __func__, "noise", message);
  if (status == TP_OK) {
    put_whole(&c, &c.rule->noise_seed, seed);
    status = put(&c, &c.rule->deviation, deviation, "deviation");
  }
  return end(&c, status);
}

tp_status tp_scene_set_base_scaled(tp_scene *scene, tp_roughness_by by, tp_exact roughness,
                                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  change c;
  tp_status status = begin_change(&c, scene, __func__, "scaling", message);
  if (status == TP_OK) {
    for (int k = 0; k < TP_ROUGHNESS_KINDS; k++) c.rule->scaled[k].given = false;
    status = put_roughness(&c, c.rule->scaled, by, roughness);
  }
  return end(&c, status);
}

tp_status tp_scene_set_base_worn(tp_scene *scene, tp_wear wear, tp_exact depth,
                                 tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  change c;
  tp_status status = begin_change(&c, scene, __func__, "wear", message);
  if (status == TP_OK && ((int)wear < TP_WEAR_CUT || (int)wear > TP_WEAR_ABRADED)) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, c.build.place,
                       "'wear' must be cut, rounded or abraded");
  }
  if (status == TP_OK) {
    for (int k = 0; k < TP_WEAR_KINDS; k++) c.rule->worn[k].given = false;
    status = put(&c, c.rule->worn + wear, depth, "depth");
  }
  return end(&c, status);
}
