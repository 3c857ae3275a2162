/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The example scenes, studies and claims in a folder: what each shows, which files belong to it. */

#ifndef TP_CLI_EXAMPLE_LIST_H
#define TP_CLI_EXAMPLE_LIST_H

#include "topple.h"

#include <limits.h>

typedef struct tp_cli_example {
  char *name;  /* its path within the folder, without .yaml */
  char *title; /* of the file, or empty */
  char *shows; /* the first sentence of its comment, or empty */
} tp_cli_example;

typedef struct tp_cli_example_list {
  size_t count;
  tp_cli_example *items; /* by name */
} tp_cli_example_list;

/* Of the folder, and of the folders in it. */
TP_MUST_USE tp_status tp_cli_example_list_init(tp_cli_example_list *list, const char *folder,
                                               tp_message *message);
void tp_cli_example_list_free(tp_cli_example_list *list);

/* Which names of files count: those within the folder, or any. */
typedef enum tp_cli_reach { TP_CLI_WITHIN, TP_CLI_ANYWHERE } tp_cli_reach;

/* A file as the paths that it names in its text, and those that they name in turn, as far as they
 * are there. The first is the file itself. */
typedef struct tp_cli_file_group {
  size_t count;
  char **paths; /* seen from the folder */
} tp_cli_file_group;

TP_MUST_USE tp_status tp_cli_file_group_init(tp_cli_file_group *group, const char *folder,
                                             const char *path, tp_cli_reach reach,
                                             tp_message *message);
void tp_cli_file_group_free(tp_cli_file_group *group);

/* Which command takes a file of this text: "solve", "tilt", "study" or "verify"; NULL: none. */
const char *tp_cli_command_for(const char *text);

#endif
