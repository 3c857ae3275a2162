/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas as papers print them: a tree whose parts lie within the text. */

#include "formula_names.h"
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>

/* All that a dialect may allow. */
static const tp_dialect dialect = {
    .letters = true,
    .products = true,
    .functions = true,
    .lines = true,
    .most_nodes = 10000,
    .formula = "a formula",
    .operand = "a number or a name",
    .no_operand = "is no operand",
    .continued = "a formula",
    .unknown_name = "it is not known",
    .quoted = 20,
};

static void check_tree(const tp_formula *formula, size_t size) {
  FUZZ_EXPECT(formula->count > 0);
  for (long k = 0; k < formula->count; k++) {
    const tp_formula_node *node = formula->nodes + k;
    FUZZ_EXPECT(node->left < k && node->right < k && node->left >= -1 && node->right >= -1);
    FUZZ_EXPECT(0 <= node->begin && node->begin < node->end && (size_t)node->end <= size);
    FUZZ_EXPECT(0 <= node->at && node->length >= 0 && (size_t)(node->at + node->length) <= size);
    FUZZ_EXPECT(node->kind != TP_FORMULA_NAME || (node->name >= 0 && node->name < NAMES));
    FUZZ_EXPECT(node->kind != TP_FORMULA_NUMBER || fmpq_is_canonical(&node->value));
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = fuzz_text(data, size);
  tp_formula formula;
  tp_message message = {.text = ""};
  const tp_status status =
      tp_formula_read(&formula, text, (tp_place){"text", 1, 1}, &dialect, &vocabulary, &message);
  if (status == TP_OK) {
    check_tree(&formula, strlen(text));
  } else {
    FUZZ_EXPECT(message.text[0] != '\0' && formula.count == 0);
  }
  tp_formula_clear(&formula);
  free(text);
  return 0;
}
