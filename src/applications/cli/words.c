/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formats complaints as plain text on the standard error, and progress on one line that is
 * overwritten; progress is suppressed by --quiet. */

#define TP_WORDS_OWN
#define _GNU_SOURCE

#include "cli/words.h"

#include "cli/manner.h"
#include "topple.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { COMPLAINT_SIZE = 1200 };

static void write_plain(char plain[COMPLAINT_SIZE], const char *format, va_list arguments) {
  char text[4 * COMPLAINT_SIZE];
  vsnprintf(text, sizeof text, format, arguments);
  tp_plain_text(plain, COMPLAINT_SIZE, text);
}

void tp_cli_complain(const char *format, ...) {
  char plain[COMPLAINT_SIZE];
  va_list arguments;
  va_start(arguments, format);
  write_plain(plain, format, arguments);
  va_end(arguments);
  const bool coloured = tp_cli_colours(STDERR_FILENO);
  fprintf(stderr, "%stopple:%s %s\n", coloured ? "\033[1;31m" : "", coloured ? "\033[0m" : "",
          plain);
}

void tp_cli_tell(const char *what) {
  if (!tp_cli_is_quiet()) fprintf(stderr, "%s\n", what);
}

void tp_cli_tell_forecast(size_t count, const char *what, double seconds, double bytes) {
  static const double most_seconds = 10, most_bytes = 1e9, minute = 60, hour = 3600, few = 10;
  const bool in_hours = seconds >= 2 * hour, in_minutes = seconds >= 2 * minute;
  const double unit = in_hours ? hour : in_minutes ? minute : 1;
  char text[160], memory[60] = "";
  if (seconds < most_seconds && bytes < most_bytes) return;
  if (bytes >= most_bytes) snprintf(memory, sizeof memory, " and %.2g GB of memory", bytes / 1e9);
  snprintf(text, sizeof text,
           "the %zu remaining %s will take about %.*f %s%s, judged by the first ones", count, what,
           seconds / unit < few ? 1 : 0, seconds / unit,
           in_hours     ? "hours"
           : in_minutes ? "minutes"
                        : "seconds",
           memory);
  tp_cli_tell(text);
}

void tp_cli_ask(const char *question) {
  fputs(question, stderr);
}

void tp_cli_tell_progress(size_t done, size_t of, double rate) {
  if (tp_cli_is_quiet()) return;
  fprintf(stderr, "\r%zu of %zu samples, %.3g a second, %.3g s to go   ", done, of, rate,
          (double)(of - done) / rate);
}

void tp_cli_tell_bracket(size_t runs, double least_deg, double most_deg) {
  if (tp_cli_is_quiet()) return;
  fprintf(stderr, "\r%zu runs, stands at %.6f, begins to move at %.6f degrees   ", runs, least_deg,
          most_deg);
}

void tp_cli_clear_progress(void) {
  if (tp_cli_is_quiet()) return;
  fprintf(stderr, "\r%70s\r", "");
}

void tp_cli_tell_cost(double doubles_seconds, double ladder_seconds) {
  if (tp_cli_is_quiet()) return;
  fprintf(stderr, "%.3g s of computing in doubles with proven bounds, %.3g s in higher precision\n",
          doubles_seconds, ladder_seconds);
}

void tp_cli_refuse(const struct argp_state *state, const char *format, ...) {
  char plain[COMPLAINT_SIZE];
  va_list arguments;
  va_start(arguments, format);
  write_plain(plain, format, arguments);
  va_end(arguments);
  argp_error(state, "%s", plain);
}

void tp_cli_take_file(const char **file, const char *argument, const char *what,
                      const struct argp_state *state) {
  if (*file != NULL) tp_cli_refuse(state, "one %s at a time; '%s' is one too many", what, argument);
  *file = argument;
}

/* The folder of a file that need not be there, and its name there. */
static bool split_path(struct stat *folder, const char **name, const char *path) {
  const char *slash = strrchr(path, '/');
  char *own = slash == NULL ? strdup(".") : strndup(path, (size_t)(slash - path) + 1);
  *name = slash != NULL ? slash + 1 : path;
  const bool found = own != NULL && stat(own, folder) == 0;
  free(own);
  return found;
}

static bool is_same_inode(const struct stat *one, const struct stat *other) {
  return one->st_dev == other->st_dev && one->st_ino == other->st_ino;
}

/* Where a link leads that leads nowhere yet, and its links in turn; else the path: freed by the
 * caller. */
static char *follow_links(const char *path) {
  enum { MOST = 40 };
  char *own = strdup(path);
  for (int k = 0; own != NULL && k < MOST; k++) {
    char target[PATH_MAX];
    const ssize_t length = readlink(own, target, sizeof target - 1);
    if (length < 0) break;
    target[length] = '\0';
    const char *slash = strrchr(own, '/');
    const bool beside = target[0] != '/' && slash != NULL;
    char *next = NULL;
    const int wrote = beside ? asprintf(&next, "%.*s/%s", (int)(slash - own), own, target)
                             : asprintf(&next, "%s", target);
    free(own);
    own = wrote >= 0 ? next : NULL;
  }
  return own;
}

/* Two names of one file, which is there or is to be made. */
static bool are_one_file(const char *one, const char *other) {
  struct stat a, b;
  const bool there = stat(one, &a) == 0, other_there = stat(other, &b) == 0;
  if (there && other_there) return S_ISREG(a.st_mode) && is_same_inode(&a, &b);
  if (there || other_there) return false;
  char *first = follow_links(one), *second = follow_links(other);
  const char *name, *other_name;
  const bool same = first != NULL && second != NULL && split_path(&a, &name, first) &&
                    split_path(&b, &other_name, second) && is_same_inode(&a, &b) &&
                    strcmp(name, other_name) == 0;
  const bool alike = strcmp(one, other) == 0;
  free(first);
  free(second);
  return same || alike;
}

void tp_cli_refuse_same_files(const tp_cli_written *files, int count,
                              const struct argp_state *state) {
  for (int k = 0; k < count; k++) {
    for (int j = k + 1; j < count && files[k].file != NULL; j++) {
      if (files[j].file == NULL || !are_one_file(files[k].file, files[j].file)) continue;
      tp_cli_refuse(state, "%s and %s take different files; '%s' and '%s' are one", files[k].option,
                    files[j].option, files[k].file, files[j].file);
    }
  }
}

static bool is_plain(const char *text) {
  char plain[COMPLAINT_SIZE];
  tp_plain_text(plain, sizeof plain, text);
  return strcmp(plain, text) == 0;
}

/* Is the word --NAME or --NAME=VALUE of an option? */
static bool is_own_long_option(const struct argp *parser, const char *name) {
  const size_t length = strcspn(name, "=");
  for (const struct argp_option *o = parser->options; o->name != NULL || o->doc != NULL; o++) {
    if (o->name != NULL && strlen(o->name) == length && strncmp(o->name, name, length) == 0) {
      return true;
    }
  }
  return false;
}

static bool is_long_option(const struct argp *parser, const char *name) {
  if (is_own_long_option(parser, name)) return true;
  const struct argp_child *child = parser->children;
  for (; child != NULL && child->argp != NULL; child++) {
    if (is_own_long_option(child->argp, name)) return true;
  }
  return false;
}

/* The option of a letter; NULL: there is none. */
static const struct argp_option *option_of(const struct argp *parser, char letter) {
  const struct argp_option *o = parser->options;
  while ((o->name != NULL || o->doc != NULL) && o->key != letter) o++;
  if (o->name != NULL) return o;
  const struct argp_child *child = parser->children;
  for (o = NULL; child != NULL && child->argp != NULL && o == NULL; child++) {
    o = option_of(child->argp, letter);
  }
  return o;
}

/* Of letters, as -jo, the first may take the rest for its value. */
static bool are_letters(const struct argp *parser, const char *letters) {
  for (; *letters != '\0'; letters++) {
    const struct argp_option *o = option_of(parser, *letters);
    if (o == NULL) return false;
    if (o->arg != NULL) return true;
  }
  return true;
}

const char *tp_cli_strange_option(const struct argp *parser, int argc, char *const *argv) {
  for (int k = 1; k < argc && strcmp(argv[k], "--") != 0; k++) {
    const char *word = argv[k];
    if (word[0] != '-' || is_plain(word)) continue;
    const bool is_long = word[1] == '-';
    if (!(is_long ? is_long_option(parser, word + 2) : are_letters(parser, word + 1))) return word;
  }
  return NULL;
}

int tp_cli_numbers(double *numbers, int most, const char *text) {
  int count = 0;
  for (;;) {
    char *end = NULL;
    const double number = strtod(text, &end);
    if (end == text || !isfinite(number)) return -1;
    if (count == most) return most + 1;
    numbers[count++] = number;
    if (*end == '\0') return count;
    if (*end != ',') return -1;
    text = end + 1;
  }
}
