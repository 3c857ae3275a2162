/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _GNU_SOURCE
#include "cli/new_scene.h"

#include "cli/new_drawing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- what may be answered ----------------------------------------------------------------------
 */

/* The length of the number, a decimal or a fraction of two, that the text begins with; 0: none. */
static size_t number_length(const char *text) {
  static const char digits[] = "0123456789";
  size_t length = strspn(text, "+-");
  if (length > 1) return 0;
  for (int part = 0; part < 2; part++) {
    const size_t whole = strspn(text + length, digits);
    const size_t point = text[length + whole] == '.' ? 1 : 0;
    const size_t rest = point == 1 ? strspn(text + length + whole + 1, digits) : 0;
    if (whole + rest == 0) return 0;
    length += whole + point + rest;
    if (part == 1 || text[length] != '/') break;
    length++;
  }
  return length;
}

const char *tp_cli_wrong_unit(const char *text) {
  static const char *const units[] = {"mm", "cm", "m", "km", "in", "ft"};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(text, units[k]) == 0) return NULL;
  }
  return "the length unit is one of mm, cm, m, km, in, ft";
}

/* Where the second number begins; NULL: the text is no two numbers. */
static const char *second_of(const char *text, size_t *first) {
  *first = number_length(text);
  const char *second = text + *first + strspn(text + *first, " x");
  const size_t length = number_length(second);
  return *first > 0 && second > text + *first && length > 0 && second[length] == '\0' ? second
                                                                                      : NULL;
}

const char *tp_cli_wrong_size(const char *text) {
  size_t first = 0;
  return second_of(text, &first) != NULL ? NULL
                                         : "a block is its width and height, as 2x4 or 0.5x1.25";
}

const char *tp_cli_wrong_number(const char *text) {
  const size_t length = number_length(text);
  return *text == '\0' || (length > 0 && text[length] == '\0')
             ? NULL
             : "a number has digits and a decimal point, as 26 or 25.8; no unit, no comma";
}

const char *tp_cli_wrong_towards(const char *text) {
  return strcmp(text, "left") == 0 || strcmp(text, "right") == 0 || strcmp(text, "both") == 0
             ? NULL
             : "the block is tilted towards left, right or both";
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

void tp_cli_write_quoted(FILE *out, const char *text) {
  char plain[4 * TP_CLI_ANSWER];
  tp_plain_text(plain, sizeof plain, text);
  fputc('"', out);
  for (const char *at = plain; *at != '\0'; at++) {
    if (*at == '"' || *at == '\\') fputc('\\', out);
    fputc(*at, out);
  }
  fputc('"', out);
}

static void write_drawn_block(FILE *out, const tp_cli_new_scene *scene) {
  if (scene->unit_weight[0] != '\0') {
    fprintf(out,
            "block:                     # its outline is the drawing's\n"
            "  unit_weight_kn_m3: %s     # weight per volume, for forces; angles need none\n"
            "  # thickness: 1           # of the section; 1 m where not given\n",
            scene->unit_weight);
  } else {
    fprintf(out, "# block:                   # its outline is the drawing's\n"
                 "#   unit_weight_kn_m3: 26  # weight per volume: forces and loads need it, angles "
                 "do not\n"
                 "#   thickness: 1           # of the section; 1 m where not given\n");
  }
}

static void write_block(FILE *out, const tp_cli_new_scene *scene) {
  if (scene->drawing[0] != '\0') {
    write_drawn_block(out, scene);
    return;
  }
  fprintf(out, "block:\n");
  if (scene->outline[0] != '\0') {
    fprintf(out, "  outline: ");
    tp_cli_write_quoted(out, scene->outline);
    fprintf(out, "\n  # its vertices: a file of x and y, or here: [[0, 0], [2, 0], [1, 3]]\n");
  } else {
    size_t first = 0;
    const char *second = second_of(scene->block, &first);
    fprintf(out,
            "  slab: {width: %.*s, height: %s}\n"
            "  # a rectangle. Any other block: outline: my_outline.csv, or outline: [[0, 0], [2, "
            "0], [1, 3]]\n",
            (int)first, scene->block, second);
  }
  if (scene->unit_weight[0] != '\0') {
    fprintf(out, "  unit_weight_kn_m3: %s     # weight per volume, for forces; angles need none\n",
            scene->unit_weight);
  } else {
    fprintf(out, "  # unit_weight_kn_m3: 26  # weight per volume: forces and loads need it, angles "
                 "do not\n");
  }
  fprintf(out, "  # thickness: 1           # of the section; 1 m where not given\n");
}

static void write_base(FILE *out, const tp_cli_new_scene *scene) {
  if (scene->drawn_base) {
    fprintf(out, "# The base is the drawing's profile. base: {place: rest} would set a block of "
                 "straight edges\n# down on it, wherever it is drawn.\n");
    return;
  }
  fprintf(out,
          "base:\n"
          "  mated: true              # the counterpart of the underside. NOT cautious where the "
          "joint has\n"
          "                           # opened or worn: give its measured profile: my_base.csv "
          "instead\n"
          "  beyond: {left: 0, right: 0}\n"
          "  # how far the base goes on past the block; neither 0 nor more is always the safer "
          "side, and\n"
          "  # the report says where the other one is less safe\n");
}

static void write_friction(FILE *out, const tp_cli_new_scene *scene) {
  if (scene->friction[0] != '\0') {
    fprintf(out, "friction_angle_deg: %s       # of the contact, from tests; take a low one\n",
            scene->friction);
  } else {
    fprintf(out, "# friction_angle_deg: 30     # of the contact. Left out: sliding is not judged, "
                 "and the block\n"
                 "#                            # meets no design factor; no friction is assumed\n");
  }
}

static void write_tilt(FILE *out, const tp_cli_new_scene *scene) {
  fprintf(out,
          "tilt:\n  towards: %s            # left lowers the side of small x; both is "
          "cautious\n",
          scene->towards[0] != '\0' ? scene->towards : "both");
  if (scene->tilt[0] != '\0') {
    fprintf(out, "  angle_deg: %s            # of the mean plane from level, today\n", scene->tilt);
  } else {
    fprintf(out, "  # angle_deg: 20          # of the mean plane from level, today: factors of "
                 "safety need it\n");
  }
}

static void write_rest(FILE *out, const tp_cli_new_scene *scene) {
  if (scene->frame[0] != '\0') {
    fprintf(out, "frame: %s               # base: x runs along its mean plane; world: y is up\n",
            scene->frame);
  } else if (scene->outline[0] != '\0' || scene->drawing[0] != '\0') {
    fprintf(out, "# frame: world             # for coordinates as the block lies, y upwards\n");
  }
  fprintf(out, "# Nothing else acts unless it is named, which is NOT cautious where there is water "
               "or an\n"
               "# earthquake; each needs unit_weight_kn_m3:\n"
               "# loads:\n"
               "#   water: {height: 1, uplift: true}\n"
               "#   seismic: {horizontal: 0.1, vertical: 0}\n");
}

tp_status tp_cli_new_scene_text(char **text, const tp_cli_new_scene *scene) {
  char *own = NULL;
  size_t length = 0;
  FILE *out = open_memstream(&own, &length);
  if (out == NULL) return TP_OUT_OF_MEMORY;
  fprintf(out, "# Begun by 'topple new'. docs/scene.md tells of every key that a scene may have.\n"
               "topple: 1                  # the version of this format\n"
               "title: ");
  tp_cli_write_quoted(out, scene->title[0] != '\0' ? scene->title : "A new block");
  if (scene->drawing[0] != '\0') {
    fprintf(out, "\n");
    tp_cli_write_drawing(out, scene);
  } else {
    fprintf(out, "\nlength_unit: %s             # of every length in this file\n",
            scene->length_unit);
  }
  write_block(out, scene);
  write_base(out, scene);
  write_friction(out, scene);
  write_tilt(out, scene);
  write_rest(out, scene);
  const bool failed = ferror(out) != 0;
  if (fclose(out) != 0 || failed) {
    free(own);
    return TP_OUT_OF_MEMORY;
  }
  *text = own;
  return TP_OK;
}
