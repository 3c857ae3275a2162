/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Figures and sheets, in place of src/applications/cli/draw.c: Cairo is linked in, and there are no
 * processes to draw in. Where it breaks down, the page begins the core anew. */

#include "cli/cli.h"

tp_status tp_cli_draw(const char *path, const tp_scene *scene, const tp_solution *solution,
                      tp_figure_consent consent, tp_message *message) {
  return tp_report_figure_if(path, scene, solution, consent, message);
}

tp_status tp_cli_draw_solid(const char *path, const tp_solid *solid, tp_figure_consent consent,
                            tp_message *message) {
  return tp_report_figure_solid_if(path, solid, consent, message);
}

tp_status tp_cli_draw_system(const char *path, const tp_scene *scene, const tp_block_system *system,
                             tp_figure_consent consent, tp_message *message) {
  return tp_report_figure_block_system_if(path, scene, system, consent, message);
}

tp_status tp_cli_write_sheet(const char *path, const tp_scene *scene, const tp_solution *solution,
                             const tp_sheet_options *options, tp_message *message) {
  return tp_report_sheet(path, scene, solution, options, message);
}

tp_status tp_cli_write_system_sheet(const char *path, const tp_scene *scene,
                                    const tp_block_system *system, const tp_sheet_options *options,
                                    tp_message *message) {
  return tp_report_sheet_block_system(path, scene, system, options, message);
}

tp_status tp_cli_write_solid_sheet(const char *path, const tp_scene *scene, const tp_solid *solid,
                                   const tp_sheet_options *options, tp_message *message) {
  return tp_report_sheet_solid(path, scene, solid, options, message);
}

tp_status tp_cli_write_study_sheet(const char *path, const tp_study *study,
                                   const tp_study_result *result, const tp_sheet_options *options,
                                   tp_message *message) {
  return tp_report_sheet_study(path, study, result, options, message);
}

tp_status tp_cli_write_tilt_sheet(const char *path, const tp_scene *scene, const tp_tilt_test *test,
                                  const tp_sheet_options *options, tp_message *message) {
  return tp_report_sheet_tilt(path, scene, test, options, message);
}

tp_status tp_cli_write_batch_page(const char *path, const tp_batch *batch, size_t figures,
                                  tp_message *message) {
  return tp_report_sheet_batch(path, batch, figures, message);
}

tp_status tp_cli_write_batch_figures(const char *folder, const char *ending, const tp_batch *batch,
                                     tp_message *message) {
  return tp_report_figures_batch(folder, ending, batch, message);
}
