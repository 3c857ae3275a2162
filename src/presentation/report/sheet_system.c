/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Order of the sheet of many blocks: page 1, then of each direction the collapse with its forces
 * and columns, what the methods assume, and an appendix of blocks, contacts and files. */

#include "report/sheet_system.h"

#include "terms/names.h"

static void add_front(tp_system_sheet *s, const tp_sheet_head *head, tp_picture picture) {
  tp_document *d = &s->document;
  tp_sheet_add_persons(d, head);
  tp_document_sketch(d, picture,
                     "The blocks as they lie, how they begin to move, and the forces between them "
                     "just before that.",
                     "Drawing of the blocks. Their verdict, motions and forces are given in the "
                     "text and the tables of this report.");
  tp_system_sheet_add_inputs(s);
  tp_system_sheet_add_governing(s);
  for (size_t k = 0; k < s->system->case_count; k++) {
    tp_system_sheet_add_conclusion(s, s->system->cases + k);
  }
  tp_sheet_count_cautions(d, &s->system->notes,
                          s->scene->letterhead.brief
                              ? "Cautions on the input: %zu. They stand below the account."
                              : "Cautions on the input: %zu. They stand at the head of the "
                                "appendix.");
  tp_sheet_add_signatures(d, head);
}

static void add_account(tp_system_sheet *s, const tp_system_case *c) {
  tp_document *d = &s->document;
  tp_document_heading(d, 2, "Account, towards the %s",
                      tp_document_say(d, tp_direction_name(c->towards)));
  tp_system_sheet_add_loads(s, c);
  tp_system_sheet_add_support(s, c);
  tp_system_sheet_add_columns(s, c);
  tp_system_sheet_add_motions(s, c);
  tp_system_sheet_add_forces(s, c);
}

static void add_assumptions(tp_system_sheet *s) {
  tp_document *d = &s->document;
  bool columns = false;
  for (size_t k = 0; k < s->system->case_count; k++) {
    columns = columns || s->system->cases[k].goodman_bray.applies;
  }
  tp_document_heading(d, 2, "Assumptions");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Rigid blocks in a plane section, per metre of thickness, which touch exactly "
                  "where their edges coincide; joints resist by friction, cohesion and tensile "
                  "strength alone.");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Strength reduction is limit analysis (Livesley 1978): below the factor some "
                  "forces within the strength of all joints hold every block, above it none do. "
                  "Each limit is proven from both sides, to 1e-6 of itself. That forces can hold "
                  "the blocks does not exclude that a motion begins: where joints do not dilate as "
                  "they slip, the true factor may be less.");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Driving loads: the same for the number by which all that drives the blocks to a "
                  "side is multiplied while what rests on the base stays: of weights and "
                  "surcharges the part along x, the earthquake, and water, pressures and forces "
                  "that push to the side or off the base. Columns that topple do so however rough "
                  "their joints are; this factor counts that.");
  if (!columns) return;
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Goodman and Bray (1976): from the last column down, each passes on to the next "
                  "what it needs against toppling about the lower end of its base or against "
                  "sliding, whichever is more. These forces act at the top of each contact, with "
                  "the friction there fully mobilised. These numbers have no proven bound.");
}

static void add_appendix(tp_system_sheet *s, const tp_sheet_files *files) {
  tp_document *d = &s->document;
  tp_document_page(d);
  tp_document_heading(d, 2, "Appendix");
  tp_sheet_add_notes(d, &s->system->notes);
  tp_system_sheet_add_blocks(s);
  tp_system_sheet_add_contacts(s);
  tp_sheet_add_origin(d, files, s->options);
  tp_sheet_add_files(d, files, s->options);
}

void tp_sheet_build_system(tp_document *document, const tp_system_sheet *sheet,
                           const tp_sheet_files *files, tp_sheet_head *head, tp_picture picture) {
  tp_system_sheet s = *sheet;
  tp_document *d = &s.document;
  d->language = head->language;
  d->comma = head->comma;
  tp_sheet_set_letterhead(d, head);
  tp_sheet_add_title(d, s.system->title, "Stability of rock blocks in contact");
  tp_sheet_add_foot(d, files, s.options);
  add_front(&s, head, picture);
  tp_document_page(d);
  for (size_t k = 0; k < s.system->case_count; k++) add_account(&s, s.system->cases + k);
  add_assumptions(&s);
  if (s.scene->letterhead.brief) {
    tp_sheet_add_notes(d, &s.system->notes);
  } else {
    add_appendix(&s, files);
  }
  *document = s.document;
}
