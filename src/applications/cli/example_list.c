/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scans a folder of examples for YAML files: command by the first key, title, first sentence of the
 * leading comment, and the files that each names. */

#define _GNU_SOURCE
#include "cli/example_list.h"

#include "cli/files.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- what a file says of itself ----------------------------------------------------------------
 */

/* The line of the text that begins with the key, from after it on; NULL: there is none. */
static const char *line_of(const char *text, const char *key) {
  const size_t length = strlen(key);
  for (; text != NULL && *text != '\0'; text = strchr(text, '\n')) {
    text += *text == '\n';
    if (strncmp(text, key, length) == 0) return text + length;
  }
  return NULL;
}

const char *tp_cli_command_for(const char *text) {
  if (line_of(text, "topple_study:") != NULL) return "study";
  if (line_of(text, "topple_claims:") != NULL) return "verify";
  if (line_of(text, "topple:") == NULL) return NULL;
  return line_of(text, "tilt_test:") != NULL || line_of(text, "shaking:") != NULL ? "tilt"
                                                                                  : "solve";
}

static char *title_of(const char *text) {
  const char *title = line_of(text, "title:");
  if (title == NULL) return strdup("");
  title += strspn(title, " \"'");
  size_t length = strcspn(title, "\r\n");
  while (length > 0 && strchr(" \"'", title[length - 1]) != NULL) length--;
  return strndup(title, length);
}

/* The end of the first sentence: a full stop, which a capital letter follows (not so in "Fig. 6"),
 * or the end. */
static size_t sentence_length(const char *text) {
  for (const char *stop = strstr(text, ". "); stop != NULL; stop = strstr(stop + 1, ". ")) {
    if (isupper((unsigned char)stop[2]) != 0) return (size_t)(stop + 1 - text);
  }
  return strlen(text);
}

/* Of the comment at the head; lines that are commands are left out. */
static char *first_sentence(const char *text) {
  char *sentence = calloc(1, strlen(text) + 2);
  size_t length = 0;
  for (; sentence != NULL && *text == '#'; text += *text == '\n') {
    const char *line = text + 1 + (text[1] == ' ');
    const size_t own = strcspn(line, "\r\n");
    text = line + strcspn(line, "\n");
    if (*line == ' ' || strncmp(line, "topple ", 7) == 0 || own == 0) continue;
    if (length > 0) sentence[length++] = ' ';
    memcpy(sentence + length, line, own);
    sentence[length += own] = '\0';
  }
  if (sentence != NULL) sentence[sentence_length(sentence)] = '\0';
  return sentence;
}

/* ---- the list ----------------------------------------------------------------------------------
 */

static bool ends_in_yaml(const char *name) {
  const size_t length = strlen(name);
  return length > 5 && strcmp(name + length - 5, ".yaml") == 0;
}

static tp_status add(tp_cli_example_list *list, const char *within, const char *text) {
  tp_cli_example *grown = realloc(list->items, (list->count + 1) * sizeof *grown);
  if (grown == NULL) return TP_OUT_OF_MEMORY;
  list->items = grown;
  tp_cli_example *own = grown + list->count++;
  *own =
      (tp_cli_example){strndup(within, strlen(within) - 5), title_of(text), first_sentence(text)};
  return own->name != NULL && own->title != NULL && own->shows != NULL ? TP_OK : TP_OUT_OF_MEMORY;
}

static tp_status add_file(tp_cli_example_list *list, const char *folder, const char *within,
                          tp_message *message) {
  char path[PATH_MAX];
  char *text = NULL;
  size_t length = 0;
  if (!tp_cli_join(path, folder, within)) return TP_OK;
  tp_status status = tp_cli_read_file(&text, &length, path, message);
  if (status == TP_OK && tp_cli_command_for(text) != NULL) status = add(list, within, text);
  free(text);
  return status;
}

static bool is_folder(const char *folder, const char *name) {
  char path[PATH_MAX];
  struct stat own;
  return tp_cli_join(path, folder, name) && stat(path, &own) == 0 && S_ISDIR(own.st_mode);
}

/* The folder itself where `part` is empty, else the one of that name in it. */
static tp_status add_folder(tp_cli_example_list *list, const char *folder, const char *part,
                            tp_message *message) {
  char path[PATH_MAX], within[PATH_MAX];
  struct dirent **entries = NULL;
  const int count = tp_cli_join(path, folder, part) ? scandir(path, &entries, NULL, NULL) : 0;
  tp_status status = TP_OK;
  if (count < 0) {
    snprintf(message->text, sizeof message->text, "cannot read the folder %.400s: %s", path,
             strerror(errno));
    return TP_SYSTEM_FAILED;
  }
  for (int k = 0; k < count; k++) {
    const char *name = entries[k]->d_name;
    const int written =
        snprintf(within, sizeof within, "%s%s%s", part, *part != '\0' ? "/" : "", name);
    if (status == TP_OK && written < PATH_MAX && name[0] != '.') {
      if (ends_in_yaml(name)) {
        status = add_file(list, folder, within, message);
      } else if (*part == '\0' && is_folder(folder, name)) {
        status = add_folder(list, folder, name, message);
      }
    }
    free(entries[k]);
  }
  free(entries);
  return status;
}

/* Those of the folder itself before those of folders in it. */
static int by_name(const void *one, const void *other) {
  const char *a = ((const tp_cli_example *)one)->name, *b = ((const tp_cli_example *)other)->name;
  const bool a_deep = strchr(a, '/') != NULL, b_deep = strchr(b, '/') != NULL;
  return a_deep != b_deep ? (int)a_deep - (int)b_deep : strcmp(a, b);
}

tp_status tp_cli_example_list_init(tp_cli_example_list *list, const char *folder,
                                   tp_message *message) {
  *list = (tp_cli_example_list){0};
  const tp_status status = add_folder(list, folder, "", message);
  if (status != TP_OK) {
    tp_cli_example_list_free(list);
    return status;
  }
  if (list->count > 0) qsort(list->items, list->count, sizeof *list->items, by_name);
  return TP_OK;
}

void tp_cli_example_list_free(tp_cli_example_list *list) {
  for (size_t k = 0; k < list->count; k++) {
    free(list->items[k].name);
    free(list->items[k].title);
    free(list->items[k].shows);
  }
  free(list->items);
  *list = (tp_cli_example_list){0};
}

/* ---- files that belong together ----------------------------------------------------------------
 */

static bool holds(const tp_cli_file_group *group, const char *path) {
  for (size_t k = 0; k < group->count; k++) {
    if (strcmp(group->paths[k], path) == 0) return true;
  }
  return false;
}

static tp_status append(tp_cli_file_group *group, const char *path) {
  char **grown = realloc(group->paths, (group->count + 1) * sizeof *grown);
  if (grown == NULL) return TP_OUT_OF_MEMORY;
  group->paths = grown;
  grown[group->count] = strdup(path);
  return grown[group->count++] != NULL ? TP_OK : TP_OUT_OF_MEMORY;
}

static bool is_of_name(char c) {
  return isalnum((unsigned char)c) != 0 || c == '_' || c == '-' || c == '.' || c == '/';
}

/* A file of some bytes. */
static bool is_file(const char *path) {
  struct stat own;
  return stat(path, &own) == 0 && S_ISREG(own.st_mode) && own.st_size > 0;
}

/* The files that a text names, as they are gathered. */
typedef struct gathering {
  tp_cli_file_group *group;
  const char *folder;
  const char *from; /* the file whose text it is */
  tp_cli_reach reach;
} gathering;

/* A word of a text, where it is the name of a file: appended. */
static tp_status append_word(const gathering *own, const char *word, size_t length) {
  char seen[PATH_MAX], path[PATH_MAX];
  const bool leads_out = word[0] == '/' || memmem(word, length, "..", 2) != NULL;
  if (memchr(word, '.', length) == NULL || (leads_out && own->reach == TP_CLI_WITHIN)) {
    return TP_OK;
  }
  const size_t start = word[0] == '/' ? 0 : tp_cli_folder_length(own->from);
  if (start + length >= sizeof seen) return TP_OK;
  memcpy(seen, own->from, start);
  memcpy(seen + start, word, length);
  seen[start + length] = '\0';
  const bool fits = seen[0] == '/' || tp_cli_join(path, own->folder, seen);
  if (!fits || !is_file(seen[0] == '/' ? seen : path) || holds(own->group, seen)) return TP_OK;
  return append(own->group, seen);
}

/* All words of a text that are not in comments, and all texts in quotes. */
static tp_status append_named(const gathering *own, const char *text) {
  tp_status status = TP_OK;
  while (*text != '\0' && status == TP_OK) {
    size_t length = 0;
    if (*text == '"' || *text == '\'') {
      const char quote[] = {*text++, '\n', '\0'};
      length = strcspn(text, quote);
    } else {
      while (is_of_name(text[length])) length++;
    }
    if (length > 0) status = append_word(own, text, length);
    text += length;
    if (*text == '#') text += strcspn(text, "\n");
    if (*text != '\0' && !is_of_name(*text)) text++;
  }
  return status;
}

tp_status tp_cli_file_group_init(tp_cli_file_group *group, const char *folder, const char *path,
                                 tp_cli_reach reach, tp_message *message) {
  *group = (tp_cli_file_group){0};
  tp_status status = append(group, path);
  for (size_t k = 0; k < group->count && status == TP_OK; k++) {
    char whole[PATH_MAX];
    char *text = NULL;
    size_t length = 0;
    const char *own = group->paths[k];
    if (k > 0 && !ends_in_yaml(own)) continue;
    if (own[0] != '/' && !tp_cli_join(whole, folder, own)) continue;
    status = tp_cli_read_file(&text, &length, own[0] == '/' ? own : whole, message);
    if (status == TP_OK) status = append_named(&(gathering){group, folder, own, reach}, text);
    free(text);
  }
  if (status != TP_OK) tp_cli_file_group_free(group);
  return status;
}

void tp_cli_file_group_free(tp_cli_file_group *group) {
  for (size_t k = 0; k < group->count; k++) free(group->paths[k]);
  free(group->paths);
  *group = (tp_cli_file_group){0};
}
