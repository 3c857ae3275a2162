/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solved scene as a figure. A solution holds no geometry: the problem is prepared again. */

#include "figure/figure.h"
#include "common/host.h"
#include "common/message.h"
#include "figure/name.h"
#include "figure/version.h"

/* What is done with the figure of a solution. */
typedef struct task {
  const tp_solution *solution;
  tp_figure_work *work;
  void *context;
} task;

static tp_status work_on(const tp_problem *problem, const tp_shape *shape, void *context,
                         tp_message *message) {
  const task *own = context;
  tp_figure figure = {.problem = problem, .solution = own->solution, .shape = *shape};
  for (size_t k = 0; k < own->solution->case_count; k++) {
    if (!tp_state_init(figure.states + figure.panel_count++, &figure, own->solution->cases + k)) {
      return tp_fail_memory(message, "the figure");
    }
  }
  return own->work(&figure, own->context, message);
}

tp_status tp_figure_prepare(const tp_scene *scene, const tp_solution *solution,
                            tp_figure_work *work, void *context, tp_message *message) {
  task own = {solution, work, context};
  return tp_shape_work_on(scene, solution, work_on, &own, message);
}

/* A file to draw into, and who is asked. */
typedef struct file {
  const char *path;
  tp_figure_consent consent;
} file;

static tp_status write_file(const tp_figure *figure, void *context, tp_message *message) {
  const file *own = context;
  return tp_figure_write(own->path, figure, own->consent, message);
}

tp_status tp_report_figure(const char *path, const tp_scene *scene, const tp_solution *solution,
                           tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, solution);
  TP_REFUSE_OTHER_VERSION(message);
  return tp_report_figure_if(path, scene, solution, (tp_figure_consent){0}, message);
}

tp_status tp_report_figure_if(const char *path, const tp_scene *scene, const tp_solution *solution,
                              tp_figure_consent consent, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, solution);
  TP_REFUSE_OTHER_VERSION(message);
  if (!tp_figure_is_of_blocks(path)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "the ending of a figure's name is its format: .svg, .pdf, .png or .dxf");
  }
  file own = {path, consent};
  return tp_figure_prepare(scene, solution, write_file, &own, message);
}
