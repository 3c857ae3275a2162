/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Recognises drawings by their ending or by the columns of a CSV file, and writes the key drawing
 * from layers, parts, holes and reference. */

#define _GNU_SOURCE
#include "cli/new_drawing.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/* ---- which files are drawings ------------------------------------------------------------------
 */

/* Does a line name a column that only drawings have? */
static bool names_objects(char *line) {
  static const char *const columns[] = {"layer", "name", "bulge"};
  char *rest = NULL;
  for (char *word = strtok_r(line, ",;\t \"\r\n", &rest); word != NULL;
       word = strtok_r(NULL, ",;\t \"\r\n", &rest)) {
    for (size_t k = 0; k < sizeof columns / sizeof columns[0]; k++) {
      if (strcasecmp(word, columns[k]) == 0) return true;
    }
  }
  return false;
}

/* The names of columns stand in the first line that is no comment. */
static bool has_objects(const char *path) {
  struct stat state; /* of a pipe or a device the first line is not awaited */
  const bool regular = stat(path, &state) == 0 && S_ISREG(state.st_mode);
  FILE *file = regular ? fopen(path, "r") : NULL;
  if (file == NULL) return false; /* that it is not there is told where it is read */
  char *line = NULL;
  size_t size = 0;
  bool found = false;
  while (getline(&line, &size, file) >= 0) {
    const char *first = line + strspn(line, " \t\r\n");
    if (*first == '\0' || *first == '#') continue;
    found = names_objects(line);
    break;
  }
  free(line);
  fclose(file);
  return found;
}

bool tp_cli_is_drawing(const char *path) {
  static const char *const endings[] = {".dxf",  ".svg", ".wkt", ".geojson",
                                        ".json", ".shp", ".gpkg"};
  const char *ending = strrchr(path, '.');
  if (ending == NULL) return false;
  for (size_t k = 0; k < sizeof endings / sizeof endings[0]; k++) {
    if (strcasecmp(ending, endings[k]) == 0) return true;
  }
  return strcasecmp(ending, ".csv") == 0 && has_objects(path);
}

bool tp_cli_says_of_drawing(const tp_cli_new_scene *scene) {
  const tp_cli_new_scene *s = scene;
  return s->block_layer[0] != '\0' || s->base_layer[0] != '\0' || s->hole_layer[0] != '\0' ||
         s->reference[0] != '\0' || s->gap[0] != '\0' || s->part_count > 0;
}

/* ---- what is said of one -----------------------------------------------------------------------
 */

/* Both sides of the last '='; false: there are not two. */
static bool is_pair(const char *text) {
  const char *equals = strrchr(text, '=');
  return equals != NULL && equals > text && equals[1] != '\0' &&
         tp_cli_wrong_number(equals + 1) == NULL;
}

const char *tp_cli_wrong_part(const char *text) {
  return is_pair(text) ? NULL : "a part is its layer and its unit weight in kN/m3, as CLAY=20";
}

const char *tp_cli_wrong_reference(const char *text) {
  return is_pair(text) ? NULL : "a reference is an object and its true length, as scale_bar=2";
}

/* ---- the key -----------------------------------------------------------------------------------
 */

static void write_layer(FILE *out, const char *key, const char *layer) {
  if (layer[0] == '\0') return;
  fprintf(out, "  %s: ", key);
  tp_cli_write_quoted(out, layer);
  fprintf(out, "\n");
}

/* "{layer: "CLAY", unit_weight_kn_m3: 20}" of "CLAY=20". */
static void write_pair(FILE *out, const char *first, const char *second, const char *pair) {
  char word[TP_CLI_ANSWER];
  const char *equals = strrchr(pair, '=');
  snprintf(word, sizeof word, "%.*s", (int)(equals - pair), pair);
  fprintf(out, "{%s: ", first);
  tp_cli_write_quoted(out, word);
  fprintf(out, ", %s: %s}", second, equals + 1);
}

void tp_cli_write_drawing(FILE *out, const tp_cli_new_scene *scene) {
  fprintf(out, "drawing:                   # layers BLOCK, BASE, HOLE unless named here as block, "
               "base, hole\n  file: ");
  tp_cli_write_quoted(out, scene->drawing);
  if (scene->length_unit[0] != '\0') {
    fprintf(out, "\n  unit: %s                 # of its lengths, and of this file's\n",
            scene->length_unit);
  } else {
    fprintf(out, "\n  # unit: mm               # of its lengths, and of this file's: stated in "
                 "the drawing\n");
  }
  write_layer(out, "block", scene->block_layer);
  write_layer(out, "base", scene->base_layer);
  write_layer(out, "hole", scene->hole_layer);
  for (int k = 0; k < scene->part_count; k++) {
    fprintf(out, k == 0 ? "  part:\n  - " : "  - ");
    write_pair(out, "layer", "unit_weight_kn_m3", scene->parts[k]);
    fprintf(out, "\n");
  }
  if (scene->reference[0] != '\0') {
    fprintf(out, "  reference: ");
    write_pair(out, "id", "length", scene->reference);
    fprintf(out, " # of true length: all is scaled by it\n");
  }
  if (scene->gap[0] != '\0') {
    fprintf(out, "  gap: %s                  # largest gap between ends of pieces\n", scene->gap);
  }
}
