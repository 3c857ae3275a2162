/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Report or JSON of many blocks, and the exit status: 1 where the required factor is certainly not
 * met, 4 where that or the verdict is open. */

#include "cli/solve_system.h"
#include "cli/drawn_report.h"
#include "cli/sheet.h"
#include "cli/solve_judge.h"
#include "cli/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

tp_status tp_cli_check_system(const char *path, const tp_solve_words *a, bool of_many,
                              tp_message *message) {
  if (!of_many) {
    snprintf(message->text, sizeof message->text,
             "%s: --animation is of scenes of many blocks; how one block moves in time is shown by "
             "'topple tilt --animation'",
             path);
    return TP_BAD_INPUT;
  }
  const char *option = a->profile != NULL ? "--write-profile" : a->elements ? "--elements" : NULL;
  if (option == NULL) return TP_OK;
  snprintf(message->text, sizeof message->text,
           "%s: %s is of scenes of one block, and this one has many: leave it out; --json has all "
           "that is found",
           path, option);
  return TP_BAD_INPUT;
}

tp_status tp_cli_check_kinds(bool *of_many, const tp_cli_solved *solved, const char **paths,
                             size_t count, tp_message *message) {
  *of_many = count > 0 && tp_scene_block_count(solved[0].scene) > 0;
  for (size_t k = 1; k < count; k++) {
    if ((tp_scene_block_count(solved[k].scene) > 0) == *of_many) continue;
    snprintf(message->text, sizeof message->text,
             "%s: a table is of scenes of one block or of scenes of many, and '%s' is of %s: make "
             "two of them",
             paths[k], paths[0], *of_many ? "many" : "one");
    return TP_BAD_INPUT;
  }
  return TP_OK;
}

/* Why it is not known whether a factor is met: the bounds that are proven. */
static void open_words(char *text, size_t size, const tp_block_system *system) {
  static const double fifth = 1e5;
  const double least = floor(system->governing_fos.at_least * fifth) / fifth;
  const double most = ceil(system->governing_fos.at_most * fifth) / fifth;
  if (isinf(most) && least <= 0) {
    snprintf(text, size, ": nothing is proven of the factor");
  } else if (isinf(most)) {
    snprintf(text, size, ": the factor is proven to be at least %.5f, and no more is known", least);
  } else if (least <= 0) {
    snprintf(text, size, ": the factor is proven to be at most %.5f, and no less is known", most);
  } else {
    snprintf(text, size, ": the factor is proven to be between %.5f and %.5f", least, most);
  }
}

static int judge(const tp_block_system *system, const tp_solve_words *a, const char *path) {
  if (a->has_design_fos || system->has_required_fos) {
    const double required = a->has_design_fos ? a->design_fos : system->required_fos.value;
    char open[160];
    open_words(open, sizeof open, system);
    const int ended =
        tp_cli_judge_required(tp_block_system_meets(system, required), required, path, open);
    if (ended != 0) return ended;
  }
  if (!tp_block_system_is_undecided(system)) return 0;
  tp_cli_complain("%s: undecided: the tilt is too close to the critical one, or some block is held "
                  "by corners alone",
                  path);
  return tp_status_exit(TP_UNDECIDED);
}

typedef struct solved {
  const tp_block_system *system;
  const tp_scene *scene;
  const tp_solve_words *words;
} solved;

static tp_status print(const void *of, int *ended, tp_message *message) {
  const solved *own = of;
  char *text = NULL;
  const tp_status status =
      own->words->outlines
          ? tp_report_block_system_json_outlines(&text, own->scene, own->system, message)
      : own->words->json ? tp_report_block_system_json(&text, own->system)
                         : tp_report_block_system(&text, own->system);
  return tp_cli_print_report(status, text, ended);
}

static tp_status print_and_draw(const solved *own, int *ended, tp_message *message) {
  tp_cli_drawn_report report = {.print = print, .of = own, .ended = ended};
  const tp_status drawn = tp_cli_draw_system(own->words->figure, own->scene, own->system,
                                             tp_cli_drawn_report_consent(&report), message);
  return tp_cli_drawn_report_end(&report, drawn, message);
}

static tp_status write_report(const tp_scene *scene, const tp_block_system *system,
                              const tp_solve_words *a, tp_message *message) {
  tp_sheet_options options;
  tp_cli_date date;
  const tp_status status = tp_cli_sheet_options(&options, &date, message);
  options.language = a->language;
  return status == TP_OK ? tp_cli_write_system_sheet(a->report, scene, system, &options, message)
                         : status;
}

/* With --find the system is that of the scene as it is, whose notes hold for what is found. */
static tp_status print_found(const tp_scene *scene, const tp_block_system *system,
                             const tp_solve_words *a, int *ended, tp_message *message) {
  tp_found *found = NULL;
  char *text = NULL;
  tp_find_options options = a->find;
  if (a->least_force) options.least_over = options.key;
  tp_status status = tp_find(&found, scene, &options, message);
  if (status == TP_OK) {
    status = a->json ? tp_report_found_block_system_json(&text, found, system)
                     : tp_report_found(&text, found, &a->find);
  }
  status = tp_cli_print_report(status, text, ended);
  tp_found_free(found);
  return status;
}

/* What is of one case, where the scene has several. */
tp_status tp_cli_check_cases_of_many(const char *path, const tp_solve_words *a,
                                     tp_message *message) {
  const char *option = a->find.key != NULL    ? "--find"
                       : a->json              ? "--json"
                       : a->figure != NULL    ? "--figure"
                       : a->report != NULL    ? "--report"
                       : a->animation != NULL ? "--animation"
                                              : NULL;
  return tp_cli_refuse_one_case(path, option, message);
}

/* Before the work begins: walls and jointed slopes of n blocks take some 25 s (n / 10^4)^1.5 of a
 * core, and of memory up to 25 kB a block (docs/blocks_in_contact.md). */
static void tell_cost(const tp_scene *scene) {
  static const double told = 5000, ten_thousand = 1e4, seconds = 25, minute = 60, bytes = 25e3;
  const double count = (double)tp_scene_block_count(scene);
  if (count < told) return;
  const double time = seconds * pow(count / ten_thousand, 1.5);
  const bool in_minutes = time >= 2 * minute;
  char text[160];
  snprintf(text, sizeof text,
           "%.0f blocks: limits and factors of so many take some %.2g %s of one core and up to "
           "%.2g GB of memory",
           count, in_minutes ? time / minute : time, in_minutes ? "minutes" : "seconds",
           count * bytes / 1e9);
  tp_cli_tell(text);
}

tp_status tp_cli_solve_system(const tp_scene *scene, const tp_solve_words *a, int *ended,
                              tp_message *message) {
  tp_block_system *system = NULL;
  tell_cost(scene);
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_solve_block_system(&system, scene, &options, message);
  if (status == TP_OK && a->find.key != NULL) {
    status = print_found(scene, system, a, ended, message);
    tp_block_system_free(system);
    return status;
  }
  if (status == TP_OK) {
    const solved own = {system, scene, a};
    status = a->figure != NULL ? print_and_draw(&own, ended, message) : print(&own, ended, message);
  }
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_report(scene, system, a, message);
  }
  if (status == TP_OK && *ended == 0 && a->animation != NULL) {
    status = tp_report_block_system_animation_file(a->animation, scene, system, message);
  }
  if (status == TP_OK && *ended == 0) *ended = judge(system, a, a->scene);
  tp_block_system_free(system);
  return status;
}

/* Systems, and what each is judged by: its path, or the name of its case. */
typedef struct solving {
  tp_block_system **systems;
  const char **names;
  size_t done;
  int *ended;
  tp_message *message;
} solving;

/* By itself: what is wrong with one is told, and the others go on. */
static tp_status solve_one(solving *s, const tp_scene *scene, const char *name) {
  tell_cost(scene);
  const tp_solve_options options = tp_solve_options_default();
  const tp_status status = tp_solve_block_system(s->systems + s->done, scene, &options, s->message);
  if (status == TP_OK) s->names[s->done++] = name;
  if (status != TP_BAD_INPUT && status != TP_NO_ANSWER && status != TP_UNDECIDED) return status;
  *s->ended = tp_cli_graver(*s->ended, tp_cli_end(status, s->message, 0));
  s->message->text[0] = '\0';
  return TP_OK;
}

static tp_status solve_cases(solving *s, const tp_scene *scene, const char *path,
                             const tp_solve_words *a) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < tp_scene_load_case_count(scene) && status == TP_OK; k++) {
    tp_cli_settings settings = a->settings;
    tp_scene *own = NULL;
    settings.load_case = tp_scene_load_case_name(scene, k);
    status = tp_cli_read_scene(&own, path, &settings, s->message);
    if (status == TP_OK) status = solve_one(s, own, settings.load_case);
    tp_scene_free(own);
  }
  return status;
}

static size_t count_rows(const tp_cli_solved *scenes, size_t count) {
  size_t rows = 0;
  for (size_t k = 0; k < count; k++) rows += 1 + tp_scene_load_case_count(scenes[k].scene);
  return rows;
}

tp_status tp_cli_solve_systems(const tp_cli_solved *scenes, const char **paths, size_t count,
                               const tp_solve_words *a, int *ended, tp_message *message) {
  const size_t rows = count_rows(scenes, count);
  solving s = {.systems = calloc(rows + 1, sizeof *s.systems),
               .names = calloc(rows + 1, sizeof *s.names),
               .ended = ended,
               .message = message};
  char *text = NULL;
  tp_status status = s.systems != NULL && s.names != NULL ? TP_OK : TP_OUT_OF_MEMORY;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    const tp_scene *scene = scenes[k].scene;
    status = tp_scene_load_case_count(scene) > 0 ? solve_cases(&s, scene, paths[k], a)
                                                 : solve_one(&s, scene, paths[k]);
  }
  if (status == TP_OK && s.done > 0) {
    const tp_block_system *const *all = (const tp_block_system *const *)s.systems;
    status = a->csv ? tp_report_block_systems_csv(&text, all, s.done)
                    : tp_report_block_systems_table(&text, all, s.done);
    if (status == TP_OK) *ended = tp_cli_graver(*ended, tp_cli_print(text));
  }
  for (size_t k = 0; k < s.done && status == TP_OK; k++) {
    *ended = tp_cli_graver(*ended, judge(s.systems[k], a, s.names[k]));
  }
  for (size_t k = 0; k < s.done; k++) tp_block_system_free(s.systems[k]);
  free(text);
  free(s.names);
  free(s.systems);
  return status;
}
