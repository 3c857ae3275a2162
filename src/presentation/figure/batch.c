/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a survey as a page with figures, and as figures in a folder. A row keeps no
 * geometry: its scene is read from its text and solved again. */

#include "report/batch.h"
#include "common/host.h"
#include "common/message.h"
#include "figure/blocks.h"
#include "figure/figure.h"
#include "figure/name.h"
#include "figure/sheet_name.h"
#include "figure/small_svg.h"
#include "figure/version.h"
#include "output/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

typedef struct bytes {
  const char *ending; /* of the file; NULL: it is for a page */
  char *text;
  size_t length;
} bytes;

static tp_status draw(const tp_figure *figure, void *context, tp_message *message) {
  bytes *own = context;
  if (own->ending == NULL) return tp_figure_small_svg(&own->text, &own->length, figure, message);
  return tp_figure_bytes(&own->text, &own->length, own->ending, figure, message);
}

/* Its scene, or that of the load case that is told of. */
static tp_status read_row(tp_scene **scene, const tp_batch_row *row, tp_message *message) {
  tp_scene *all = NULL;
  tp_status status = tp_scene_read_text(&all, row->scene, row->scene_name, message);
  if (status != TP_OK || row->load_case == NULL) {
    *scene = all;
    return status;
  }
  status = tp_scene_load_case(scene, all, row->load_case, message);
  tp_scene_free(all);
  return status;
}

/* Many blocks have one figure, for a page too. */
static tp_status draw_blocks(bytes *own, const tp_scene *scene, const tp_solve_options *options,
                             tp_message *message) {
  tp_block_system *system = NULL;
  tp_blocks_figure figure;
  char name[16];
  snprintf(name, sizeof name, "x%s", own->ending != NULL ? own->ending : ".svg");
  tp_status status = tp_solve_block_system(&system, scene, options, message);
  if (status == TP_OK) {
    status = tp_blocks_figure_init(&figure, scene, system, message);
    if (status == TP_OK) {
      status = tp_blocks_figure_bytes(&own->text, &own->length, name, &figure, scene, message);
      tp_blocks_figure_clear(&figure);
    }
  }
  tp_block_system_free(system);
  return status;
}

/* A figure of the row, to be freed. */
static tp_status draw_row(bytes *own, const tp_batch_row *row, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.pivots = TP_PIVOTS_ALL;
  tp_status status = read_row(&scene, row, message);
  if (status == TP_OK && tp_scene_block_count(scene) > 0) {
    status = draw_blocks(own, scene, &options, message);
  } else if (status == TP_OK) {
    status = tp_solve(&solution, scene, &options, message);
    if (status == TP_OK) status = tp_figure_prepare(scene, solution, draw, own, message);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
  return status;
}

/* ---- the page ----------------------------------------------------------------------------------
 */

static tp_status draw_first(tp_picture *pictures, const tp_batch *batch, size_t figures,
                            tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < batch->row_count && figures > 0 && status == TP_OK; k++) {
    if (!batch->rows[k].has_case) continue;
    bytes own = {.ending = NULL};
    status = draw_row(&own, batch->rows + k, message);
    pictures[k] = (tp_picture){.svg = own.text, .svg_length = own.length};
    figures--;
  }
  return status;
}

static tp_status write_page(const char *path, const tp_batch *batch, tp_picture *pictures,
                            tp_message *message) {
  tp_document document = {0};
  char *html = NULL;
  tp_batch_build_page(&document, batch, pictures);
  tp_status status = tp_document_html(&html, &document);
  tp_document_clear(&document);
  if (status != TP_OK) return tp_fail_memory(message, "the page");
  const tp_file_sources sources = {batch->source_count, (const char *const *)batch->sources};
  status = tp_file_write(path, html, strlen(html), sources, message);
  free(html);
  return status;
}

tp_status tp_report_sheet_batch(const char *path, const tp_batch *batch, size_t figures,
                                tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, batch);
  TP_REFUSE_OTHER_VERSION(message);
  if (tp_sheet_kind_of(path) != TP_SHEET_HTML) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "a page of blocks ends in .html or .htm");
  }
  tp_picture *pictures = calloc(batch->row_count + 1, sizeof *pictures);
  if (pictures == NULL) return tp_fail_memory(message, "the page");
  tp_status status = draw_first(pictures, batch, figures, message);
  if (status == TP_OK) status = write_page(path, batch, pictures, message);
  for (size_t k = 0; k < batch->row_count; k++) free(pictures[k].svg);
  free(pictures);
  return status;
}

/* ---- the folder --------------------------------------------------------------------------------
 */

/* FOLDER/LINE_NAME.ENDING, to be freed; NULL when memory is exhausted. */
static char *make_path(const char *folder, const char *ending, const tp_batch_row *row) {
  const size_t size = strlen(folder) + strlen(row->name) + strlen(ending) + 40;
  char *path = malloc(size);
  if (path == NULL) return NULL;
  size_t length = (size_t)snprintf(path, size, "%s/%zu_", folder, row->line);
  static const char kept[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  enum { LONGEST = 80 };
  for (size_t k = 0; row->name[k] != '\0' && k < LONGEST; k++) {
    path[length++] = (char)(strchr(kept, row->name[k]) != NULL ? row->name[k] : '_');
  }
  strcpy(path + length, ending);
  return path;
}

static tp_status write_row(const char *folder, const char *ending, const tp_batch *batch,
                           const tp_batch_row *row, tp_message *message) {
  bytes own = {.ending = ending};
  char name[24];
  snprintf(name, sizeof name, "x%s", ending);
  own.ending = name;
  char *path = make_path(folder, ending, row);
  tp_status status =
      path != NULL ? draw_row(&own, row, message) : tp_fail_memory(message, "a figure");
  if (status == TP_OK) {
    const tp_file_sources sources = {batch->source_count, (const char *const *)batch->sources};
    status = tp_file_write(path, own.text, own.length, sources, message);
  }
  free(own.text);
  free(path);
  return status;
}

tp_status tp_report_figures_batch(const char *folder, const char *ending, const tp_batch *batch,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, folder);
  TP_REFUSE_NULL(message, ending);
  TP_REFUSE_NULL(message, batch);
  TP_REFUSE_OTHER_VERSION(message);
  char name[16];
  snprintf(name, sizeof name, "x%s", ending);
  if (!tp_figure_is_of_blocks(name)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "a figure is of the kind that its name ends in: .svg, .pdf, .png or .dxf");
  }
  if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
    return tp_fail_file(message, folder, "made", errno);
  }
  tp_status status = TP_OK;
  for (size_t k = 0; k < batch->row_count && status == TP_OK; k++) {
    if (!batch->rows[k].has_case) continue;
    status = write_row(folder, ending, batch, batch->rows + k, message);
  }
  return status;
}
