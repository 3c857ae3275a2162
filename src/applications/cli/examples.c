/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple examples [NAME]: lists the example scenes, or writes one with the files that it names, all
 * or none. */

#include "cli/cli.h"
#include "cli/example_list.h"
#include "cli/files.h"
#include "cli/manner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct arguments {
  const char *name, *output; /* NULL: not given */
} arguments;

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "Write it into FILE; else NAME.yaml in this folder", 0}, {0}};

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'o':
    tp_cli_take_file(&a->output, argument, "--output", state);
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->name, argument, "example", state);
    return 0;
  case ARGP_KEY_END:
    if (a->output != NULL && a->name == NULL) {
      tp_cli_refuse(state, "--output goes with the NAME of an example");
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "[NAME]",
    .doc =
        "List the example scenes, studies and claims that come with Topple, or write the one "
        "of that NAME.\v"
        "Files that an example refers to come along, into the same folder. Existing files "
        "are never overwritten. Exit status: 0 done, 2 wrong usage, 3 no such example or a file in "
        "the way, 5 system failed."};

/* ---- the list ----------------------------------------------------------------------------------
 */

enum { WIDTH = 78, INDENT = 4 };

/* Words of a text from a file, made plain, in lines of at most WIDTH columns. */
static void print_wrapped(const char *text) {
  char plain[1200];
  tp_plain_text(plain, sizeof plain, text);
  int column = 0;
  for (char *rest = NULL, *word = strtok_r(plain, " ", &rest); word != NULL;
       word = strtok_r(NULL, " ", &rest)) {
    const int length = (int)strlen(word);
    if (column > 0 && column + 1 + length > WIDTH) {
      printf("\n");
      column = 0;
    }
    column += printf("%*s%s", column == 0 ? INDENT : 1, "", word);
  }
  if (column > 0) printf("\n");
}

static void print_list(const tp_cli_example_list *list) {
  for (size_t k = 0; k < list->count; k++) {
    char name[400];
    tp_plain_text(name, sizeof name, list->items[k].name);
    printf("%s\n", name);
    print_wrapped(list->items[k].title);
    print_wrapped(list->items[k].shows);
  }
  printf("\n'topple examples NAME' writes one into this folder.\n");
}

/* ---- writing one -------------------------------------------------------------------------------
 */

/* What is written where. */
typedef struct copy {
  char target[PATH_MAX];
  char *bytes;
  size_t length;
  bool created;
} copy;

static tp_status plan(copy *own, const char *folder, const char *within, const char *output,
                      bool is_first, size_t example_folder, tp_message *message) {
  char source[PATH_MAX];
  const int written =
      is_first ? snprintf(own->target, sizeof own->target, "%s", output)
               : snprintf(own->target, sizeof own->target, "%.*s%s",
                          (int)tp_cli_folder_length(output), output, within + example_folder);
  if (written >= PATH_MAX || !tp_cli_join(source, folder, within)) {
    snprintf(message->text, sizeof message->text, "the name of the file to write is too long");
    return TP_BAD_INPUT;
  }
  const tp_status status = tp_cli_read_file(&own->bytes, &own->length, source, message);
  return status == TP_OK
             ? tp_cli_may_create(own->target, own->bytes, own->length, !is_first, message)
             : status;
}

/* All or none of them. */
static tp_status write_all(copy *copies, size_t count, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = tp_cli_create_file(copies[k].target, copies[k].bytes, copies[k].length, k > 0,
                                &copies[k].created, message);
  }
  for (size_t k = 0; k < count && status != TP_OK; k++) {
    if (copies[k].created) (void)unlink(copies[k].target);
  }
  return status;
}

static void tell_written(const copy *copies, size_t count) {
  char plain[PATH_MAX];
  for (size_t k = 0; k < count; k++) {
    tp_plain_text(plain, sizeof plain, copies[k].target);
    printf("%s %s\n", copies[k].created ? "Wrote" : "Left as it was:", plain);
  }
  const char *command = tp_cli_command_for(copies[0].bytes);
  tp_plain_text(plain, sizeof plain, copies[0].target);
  printf("Next: topple %s %s\n", command != NULL ? command : "solve", plain);
}

static tp_status write_group(const tp_cli_file_group *group, const char *folder, const char *output,
                             tp_message *message) {
  copy *copies = calloc(group->count, sizeof *copies);
  if (copies == NULL) return TP_OUT_OF_MEMORY;
  tp_status status = TP_OK;
  const size_t own_folder = tp_cli_folder_length(group->paths[0]);
  for (size_t k = 0; k < group->count && status == TP_OK; k++) {
    status = plan(copies + k, folder, group->paths[k], output, k == 0, own_folder, message);
  }
  if (status == TP_OK) status = write_all(copies, group->count, message);
  if (status == TP_OK && !tp_cli_is_quiet()) tell_written(copies, group->count);
  for (size_t k = 0; k < group->count; k++) free(copies[k].bytes);
  free(copies);
  return status;
}

static const char *find(const tp_cli_example_list *list, const char *name) {
  const size_t length = strlen(name);
  for (size_t k = 0; k < list->count; k++) {
    const char *own = list->items[k].name;
    if (strncmp(own, name, strlen(own)) == 0 &&
        (length == strlen(own) || strcmp(name + strlen(own), ".yaml") == 0)) {
      return own;
    }
  }
  return NULL;
}

static tp_status write_example(const arguments *a, const tp_cli_example_list *list,
                               const char *folder, tp_message *message) {
  const char *name = find(list, a->name);
  if (name == NULL) {
    snprintf(message->text, sizeof message->text,
             "there is no example '%.200s'; 'topple examples' lists them", a->name);
    return TP_BAD_INPUT;
  }
  char within[PATH_MAX];
  snprintf(within, sizeof within, "%s.yaml", name);
  tp_cli_file_group group;
  const tp_status status = tp_cli_file_group_init(&group, folder, within, TP_CLI_WITHIN, message);
  if (status != TP_OK) return status;
  const char *output = a->output != NULL ? a->output : within + tp_cli_folder_length(within);
  const tp_status written = write_group(&group, folder, output, message);
  tp_cli_file_group_free(&group);
  return written;
}

static tp_status run(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  char folder[PATH_MAX];
  (void)ended;
  if (!tp_cli_examples_folder(folder)) {
    snprintf(message->text, sizeof message->text,
             "the example scenes are not installed: they belong in %.500s", folder);
    return TP_SYSTEM_FAILED;
  }
  tp_cli_example_list list;
  tp_status status = tp_cli_example_list_init(&list, folder, message);
  if (status != TP_OK) return status;
  if (a->name != NULL) {
    status = write_example(a, &list, folder, message);
  } else if (!tp_cli_is_quiet()) {
    print_list(&list);
  }
  tp_cli_example_list_free(&list);
  return status;
}

int tp_cli_examples(int argc, char **argv) {
  arguments a = {0};
  return tp_cli_run(&parser, &a, run, argc, argv);
}
