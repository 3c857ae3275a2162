/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Prints the scene key by key into a memory stream, each with a comment, those without an answer
 * commented out. */

#define _GNU_SOURCE
#include "cli/new_scene.h"

#include "cli/new_drawing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    const size_t first = strcspn(scene->block, " x"); /* two numbers, as it passed its check */
    const char *second = scene->block + first + strspn(scene->block + first, " x");
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
          "  mated: true              # the counterpart of the underside. NOT conservative if the "
          "joint has\n"
          "                           # opened or worn: give its measured profile: my_base.csv "
          "instead\n"
          "  beyond: {left: 0, right: 0}\n"
          "  # how far the base extends past the block; neither 0 nor more is always "
          "safer;\n"
          "  # the report says if the other choice is less safe\n");
}

static void write_friction(FILE *out, const tp_cli_new_scene *scene) {
  if (scene->friction[0] != '\0') {
    fprintf(out, "friction_angle_deg: %s       # of the contact, from tests; use a low estimate\n",
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
          "conservative\n",
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
  fprintf(out,
          "# No other load acts unless it is given, which is NOT conservative where there is water "
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
  fprintf(out, "# Begun by 'topple new'. docs/scene.md describes every key of a scene.\n"
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
