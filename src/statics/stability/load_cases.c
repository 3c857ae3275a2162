/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All load cases of a scene: read, solved one after the other, and put in order. */

#include "common/host.h"
#include "common/outside.h"
#include "scene/scene.h"
#include "stability/severity.h"

#include <stdlib.h>
#include <string.h>

/* The message of a case, behind its name. */
static tp_status name_case(tp_status status, const char *name, const tp_message *why,
                           tp_message *message) {
  if (message == NULL) return status;
  *message = *why;
  const tp_quote quoted = tp_quote_all(name);
  const size_t length = strlen(quoted.text) + strlen("case '': ");
  if (strlen(why->text) + length + 1 > sizeof message->text) return status;
  memmove(message->text + length, why->text, strlen(why->text) + 1);
  memcpy(message->text, "case '", strlen("case '"));
  memcpy(message->text + strlen("case '"), quoted.text, strlen(quoted.text));
  memcpy(message->text + length - strlen("': "), "': ", strlen("': "));
  return status;
}

static tp_status read_scene(tp_scene **own, const tp_scene *scene, const char *name,
                            const char *const *settings, size_t count, tp_message *message) {
  tp_scene *read = NULL;
  const tp_status status = tp_scene_load_case(&read, scene, name, message);
  if (status != TP_OK || count == 0) {
    *own = read;
    return status;
  }
  const tp_status set = tp_scene_with_settings(own, read, settings, count, message);
  tp_scene_free(read);
  return set;
}

/* The solution becomes the case's. */
static bool describe(tp_load_case *own, const char *name, tp_solution *solution) {
  const size_t direction = tp_severity_worst(solution);
  const tp_case *c = solution->cases + direction;
  const tp_governing_fos *g = &c->governing_fos;
  *own = (tp_load_case){.name = strdup(name),
                        .towards = c->towards,
                        .mechanism = c->mechanism,
                        .fos = g->fos,
                        .has_factor = g->has_factor,
                        .against = g->has_factor ? g->factors[g->factor].mechanism : c->mechanism,
                        .has_utilisation = g->has_utilisation,
                        .utilisation = g->utilisation,
                        .has_required_fos = g->has_required_fos,
                        .required_fos = g->required_fos,
                        .meets_required = g->meets_required,
                        .has_design_utilisation = g->has_design_utilisation,
                        .design_utilisation = g->design_utilisation,
                        .solution = solution,
                        .direction = direction};
  return own->name != NULL;
}

static int by_severity(const void *a, const void *b) {
  const tp_load_case *one = a, *other = b;
  const int order = tp_severity_compare(tp_severity_of(one->solution->cases + one->direction),
                                        tp_severity_of(other->solution->cases + other->direction));
  return order != 0 ? order : strcmp(one->name, other->name);
}

static tp_status solve_all(tp_load_cases *cases, tp_scene *const *scenes,
                           const tp_solve_options *options, tp_message *message) {
  for (size_t k = 0, count = cases->count; k < count; k++) {
    const char *name = scenes[k]->load_case;
    tp_solution *solution = NULL;
    tp_message why = {.text = ""};
    cases->count = k;
    const tp_status status = tp_solve(&solution, scenes[k], options, &why);
    if (status != TP_OK) return name_case(status, name, &why, message);
    cases->count = k + 1;
    if (!describe(cases->cases + k, name, solution)) return tp_fail_memory(message, "the cases");
    cases->count = count;
  }
  qsort(cases->cases, cases->count, sizeof *cases->cases, by_severity);
  return TP_OK;
}

static tp_status read_all(tp_scene **scenes, size_t count, const tp_scene *scene,
                          const char *const *settings, size_t set, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    const char *name = tp_scene_load_case_name(scene, k);
    tp_message why = {.text = ""};
    status = read_scene(scenes + k, scene, name, settings, set, &why);
    if (status != TP_OK) return name_case(status, name, &why, message);
  }
  return status;
}

tp_status tp_solve_load_cases(tp_load_cases **cases, const tp_scene *scene,
                              const char *const *settings, size_t count,
                              const tp_solve_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, cases);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  if (count > 0) TP_REFUSE_NULL(message, settings);
  const size_t own = tp_scene_load_case_count(scene);
  if (own == 0) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                     "the scene has no cases: give it 'cases: [{name: static}, …]', or solve it as "
                     "it is");
  }
  tp_load_cases *made = calloc(1, sizeof *made);
  tp_scene **scenes = calloc(own, sizeof *scenes);
  if (made != NULL) made->cases = calloc(own, sizeof *made->cases);
  tp_status status = made != NULL && scenes != NULL && made->cases != NULL
                         ? read_all(scenes, own, scene, settings, count, message)
                         : tp_fail_memory(message, "the cases");
  if (status == TP_OK) {
    made->size = sizeof *made;
    made->count = own;
    status = solve_all(made, scenes, options, message);
  }
  for (size_t k = 0; scenes != NULL && k < own; k++) tp_scene_free(scenes[k]);
  free(scenes);
  if (status == TP_OK) {
    *cases = made;
  } else {
    tp_load_cases_free(made);
  }
  return status;
}

void tp_load_cases_free(tp_load_cases *cases) {
  if (cases == NULL) return;
  for (size_t k = 0; k < cases->count; k++) {
    free(cases->cases[k].name);
    tp_solution_free(cases->cases[k].solution);
  }
  free(cases->cases);
  free(cases);
}

tp_design tp_load_cases_meet(const tp_load_cases *cases) {
  if (cases == NULL) return TP_DESIGN_OPEN;
  tp_design all = TP_DESIGN_MET;
  for (size_t k = 0; k < cases->count; k++) {
    if (!cases->cases[k].has_required_fos) continue;
    if (cases->cases[k].meets_required == TP_DESIGN_NOT_MET) return TP_DESIGN_NOT_MET;
    if (cases->cases[k].meets_required == TP_DESIGN_OPEN) all = TP_DESIGN_OPEN;
  }
  return all;
}
