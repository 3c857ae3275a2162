/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chain as path data: a letter and a point for each step, three points for a curve. */

#include "report/path_json.h"

#include <math.h>

/* Above so many steps a chain is thinned, to steps of so much of the block's size: finer than a
 * screen shows. */
enum { MANY_STEPS = 20000 };
#define FINEST_STEP 5e-5

static bool is_too_near(const tp_chain *chain, size_t k, tp_spot last) {
  const tp_chain_node *node = chain->nodes + k;
  return chain->count > MANY_STEPS && node->step == TP_STEP_LINE && k + 1 < chain->count &&
         chain->nodes[k + 1].step != TP_STEP_JUMP &&
         hypot(node->at.x - last.x, node->at.y - last.y) < FINEST_STEP;
}

static void add_spot(tp_text *path, const char *letter, tp_spot at, double unit_m) {
  tp_text_add(path, "%s%.9g %.9g", letter, at.x * unit_m, at.y * unit_m);
}

static void add_chain(tp_text *path, const tp_chain *chain, double unit_m) {
  tp_spot last = {0, 0};
  for (size_t k = 0; k < chain->count; k++) {
    const tp_chain_node *node = chain->nodes + k;
    if (is_too_near(chain, k, last)) continue;
    if (node->step == TP_STEP_JUMP && k > 0 && chain->closed) tp_text_add(path, "Z");
    if (node->step == TP_STEP_CURVE) {
      add_spot(path, "C", node->control[0], unit_m);
      add_spot(path, " ", node->control[1], unit_m);
      add_spot(path, " ", node->at, unit_m);
    } else {
      add_spot(path, node->step == TP_STEP_JUMP ? "M" : "L", node->at, unit_m);
    }
    last = node->at;
  }
  if (chain->closed && chain->count > 0) tp_text_add(path, "Z");
}

void tp_json_path(tp_json *j, const char *key, const tp_chain *chain, double unit_m) {
  tp_text path = {0};
  add_chain(&path, chain, unit_m);
  if (path.failed) j->text.failed = true;
  tp_json_string(j, key, path.data != NULL ? path.data : "");
  tp_text_drop(&path);
}
