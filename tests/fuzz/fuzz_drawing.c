/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Drawings of every format: the first byte says which. What is read is joined and chosen from as a
 * scene does it, with a gap and without. */

#include "format/csv_drawing.h"
#include "format/dxf.h"
#include "format/geojson.h"
#include "format/reference.h"
#include "format/roles.h"
#include "format/standing.h"
#include "format/svg.h"
#include "format/wkt.h"
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>

static void expect_object(const tp_drawing_object *object) {
  const tp_polyline *line = &object->line;
  FUZZ_EXPECT(object->layer != NULL && object->name != NULL && object->kind != NULL);
  for (long k = 0; k < line->count; k++) {
    FUZZ_EXPECT(fmpq_is_canonical(line->x + k) && fmpq_is_canonical(line->y + k));
    const fmpq *bulge = tp_drawing_bulge(object, k);
    FUZZ_EXPECT(bulge == NULL || !fmpq_is_zero(bulge));
  }
}

static void choose(const tp_drawing *drawing, const char *word, bool chosen, long gap) {
  tp_drawing_choice choice;
  tp_message message = {.text = ""};
  tp_drawing_words words = {.block = word, .base = "BASE", .hole = "HOLE", .block_chosen = chosen};
  fmpq_init(words.gap);
  fmpq_set_si(words.gap, gap, 10);
  const tp_place place = {"drawing", 1, 1};
  const tp_status status = tp_drawing_choose(&choice, drawing, &words, place, &message);
  FUZZ_EXPECT(status == TP_OK || message.text[0] != '\0');
  if (status == TP_OK) {
    for (long k = 0; k < choice.chains.count; k++) {
      expect_object(choice.chains.objects + k);
      FUZZ_EXPECT((choice.chains.objects[k].closure == TP_DRAWING_OPEN) ==
                  (choice.roles[k] == TP_DRAWING_BASE));
    }
    tp_drawing_choice_clear(&choice);
  }
  fmpq_clear(words.gap);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static tp_drawing_reader *const readers[] = {tp_dxf_read, tp_svg_read, tp_wkt_read,
                                               tp_geojson_read, tp_csv_drawing_read};
  if (size == 0) return -1;
  char *text = fuzz_text(data + 1, size - 1);
  const tp_text_file file = {text, size - 1};
  tp_drawing drawing;
  tp_drawing_options options;
  tp_message message = {.text = ""};
  tp_drawing_init(&drawing, "drawing");
  tp_drawing_options_init(&options);
  fmpq_set_si(options.tolerance, 1, 8);
  const size_t format = data[0] % (sizeof readers / sizeof readers[0]);
  tp_status status = readers[format](&drawing, &file, &options, &message);
  if (status == TP_OK) {
    status = tp_standing_read(&drawing, readers[format], &file, &options, &message);
  }
  FUZZ_EXPECT(status == TP_OK || message.text[0] != '\0');
  for (long k = 0; k < drawing.count; k++) expect_object(drawing.objects + k);
  if (status == TP_OK) {
    choose(&drawing, "BLOCK", false, 0);
    choose(&drawing, drawing.count > 0 ? drawing.objects[0].layer : "", true, 1);
    options.reference = drawing.count > 0 ? "bar" : NULL;
    fmpq_one(options.length);
    if (tp_drawing_scale(&drawing, &options, &message) == TP_OK) {
      choose(&drawing, "BLOCK", false, 0);
    }
  }
  tp_drawing_options_clear(&options);
  tp_drawing_clear(&drawing);
  free(text);
  return 0;
}
