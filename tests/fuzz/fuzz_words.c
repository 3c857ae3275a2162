/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words of the command line: the options of a chart, names of results and of files, keys of a
 * scene. A line of the input is a word. */

#include "cli/chart_options.h"
#include "fuzz.h"
#include "scene_reading/key.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_WORDS = 16 };

static const char scene[] = "parameters: {a: 30, b: 1}\n"
                            "block: {outline: [[0, 0], [a, 0], [0, b]], thickness: 20}\n"
                            "tilt: {angle_deg: 20}\n";

/* Figures go there, charts do not. */
static bool is_for_cad(const char *word) {
  const char *ending = strrchr(word, '.');
  return ending != NULL && (strcasecmp(ending, ".dxf") == 0 || strcasecmp(ending, ".glb") == 0);
}

static void read_words(char *text) {
  char program[] = "topple chart", *words[MOST_WORDS + 2] = {program};
  int count = 1;
  for (char *word = strtok(text, "\n"); word != NULL && count <= MOST_WORDS;
       word = strtok(NULL, "\n")) {
    tp_find_target target = TP_FIND_FOS;
    tp_chart_format format = TP_CHART_SVG;
    if (tp_find_target_read(&target, word)) {
      FUZZ_EXPECT(strcmp(tp_find_target_name(target), word) == 0);
    }
    FUZZ_EXPECT(!tp_figure_is_file_name(word) || is_for_cad(word) ||
                tp_chart_format_read(&format, word));
    words[count++] = word;
  }
  /* help would be printed for every input that asks for it */
  const unsigned silent = ARGP_NO_EXIT | ARGP_NO_ERRS | ARGP_NO_HELP;
  tp_chart_arguments arguments = {.fos = tp_chart_fos_options_default(),
                                  .mechanisms = tp_chart_mechanisms_options_default()};
  (void)argp_parse(&tp_chart_parser, count, words, silent, NULL, &arguments);
  FUZZ_EXPECT(arguments.fos.inverse_slenderness.count <= TP_CHART_LIST_MAX);
  FUZZ_EXPECT(arguments.fos.sub_blocks.count <= TP_CHART_LIST_MAX);
}

static void find_key(const char *key) {
  tp_node *root = NULL;
  const tp_node *node = NULL;
  tp_message message = {.text = ""};
  FUZZ_EXPECT(tp_node_read_text(&root, scene, "scene", &message) == TP_OK);
  const tp_status status = tp_key_find(&node, root, key, "scene", &message);
  fuzz_judge(status, node, &message);
  FUZZ_EXPECT(node == NULL || node->kind == TP_NODE_SCALAR);
  tp_node_free(root);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = fuzz_text(data, size);
  find_key(text);
  read_words(text);
  free(text);
  return 0;
}
