/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Asks one question after another on the terminal until each answer passes its check. */

#include "cli/new_ask.h"

#include "cli/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct question {
  const char *text; /* with what an empty answer means */
  char *answer;     /* of TP_CLI_ANSWER bytes */
  const char *unless_given;
  const char *(*wrong)(const char *);
} question;

/* A line of the standard input without its end, into an answer of that size; false: there is none,
 * or memory is exhausted. A longer one is cut, and then refused by what is asked. */
static bool read_answer(char answer[TP_CLI_ANSWER]) {
  char *line = NULL;
  size_t size = 0;
  const ssize_t length = getline(&line, &size, stdin);
  if (length >= 0) {
    const char *text = line + strspn(line, " \t");
    size_t own = strcspn(text, "\r\n");
    while (own > 0 && (text[own - 1] == ' ' || text[own - 1] == '\t')) own--;
    snprintf(answer, TP_CLI_ANSWER, "%.*s", (int)(own < TP_CLI_ANSWER ? own : TP_CLI_ANSWER), text);
  }
  free(line);
  return length >= 0;
}

/* Each until it is answered; false: the input ended. */
static bool ask(const question *questions, int count) {
  for (int k = 0; k < count;) {
    const question *q = questions + k;
    char text[128];
    snprintf(text, sizeof text, "%d of %d. %s? ", k + 1, count, q->text);
    tp_cli_ask(text);
    if (!read_answer(q->answer)) return false;
    if (q->answer[0] == '\0') strcpy(q->answer, q->unless_given);
    const char *complaint = q->wrong(q->answer);
    if (complaint == NULL) {
      k++;
    } else {
      tp_cli_complain("%s", complaint);
    }
  }
  return true;
}

/* A size, or a file that can be read. */
static const char *wrong_block(const char *text) {
  return access(text, R_OK) == 0 || tp_cli_wrong_size(text) == NULL
             ? NULL
             : "a block is its width and height, as 2x4, or the name of a file that is there";
}

/* Empty: metres, or what a drawing says. */
static const char *wrong_unit(const char *text) {
  return *text == '\0' ? NULL : tp_cli_wrong_unit(text);
}

/* "20", "20 left", or nothing. */
static const char *wrong_tilt(const char *text) {
  char angle[TP_CLI_ANSWER];
  strcpy(angle, text);
  char *blank = strchr(angle, ' ');
  if (blank != NULL) *blank = '\0';
  if (tp_cli_wrong_number(angle) != NULL || (blank != NULL && angle[0] == '\0') ||
      (blank != NULL && tp_cli_wrong_towards(blank + 1 + strspn(blank + 1, " ")) != NULL)) {
    return "a tilt is an angle, and may name the lowered side, as 20 or 20 left";
  }
  return NULL;
}

/* "20 left" into both. */
static void take_tilt(tp_cli_new_scene *scene, char *tilt) {
  char *blank = strchr(tilt, ' ');
  if (blank != NULL) {
    strcpy(scene->towards, blank + 1 + strspn(blank + 1, " "));
    *blank = '\0';
  }
  strcpy(scene->tilt, tilt);
}

#define UNIT_WEIGHT "Unit weight of the rock in kN/m3 [not known]"
#define FRICTION "Friction angle of the contact in degrees [not known: sliding is not judged]"
#define TILT "Tilt of the base in degrees, and the lowered side, as 20 left [both]"

bool tp_cli_ask_scene(tp_cli_new_scene *scene) {
  char block[TP_CLI_ANSWER], tilt[TP_CLI_ANSWER];
  const question questions[] = {
      {"Length unit (mm, cm, m, km, in, ft) [m]", scene->length_unit, "", wrong_unit},
      {"The block: width and height, as 2x4, or the file of its outline", block, "", wrong_block},
      {UNIT_WEIGHT, scene->unit_weight, "", tp_cli_wrong_number},
      {FRICTION, scene->friction, "", tp_cli_wrong_number},
      {TILT, tilt, "", wrong_tilt}};
  if (!ask(questions, sizeof questions / sizeof questions[0])) return false;
  strcpy(tp_cli_wrong_size(block) == NULL ? scene->block : scene->outline, block);
  take_tilt(scene, tilt);
  return true;
}

bool tp_cli_ask_of_file(tp_cli_new_scene *scene, bool drawing) {
  char tilt[TP_CLI_ANSWER];
  const question questions[] = {
      {drawing ? "Unit of its lengths (mm, cm, m, km, in, ft) [as stated in the drawing]"
               : "Unit of its lengths (mm, cm, m, km, in, ft) [m]",
       scene->length_unit, "", wrong_unit},
      {UNIT_WEIGHT, scene->unit_weight, "", tp_cli_wrong_number},
      {FRICTION, scene->friction, "", tp_cli_wrong_number},
      {TILT, tilt, "", wrong_tilt}};
  if (!ask(questions, sizeof questions / sizeof questions[0])) return false;
  take_tilt(scene, tilt);
  return true;
}
