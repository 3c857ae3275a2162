/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Order of a calculation sheet: input, verdict and factors, account and formulas of each case,
 * effects, proof; the parts come from the sheet_*.c files beside this one. */

#include "report/sheet.h"

#include "common/options.h"
#include "output/encode.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdlib.h>

TP_OPTIONS_END(tp_sheet_options, load_cases);

void tp_sheet_options_init(tp_sheet_options *options, size_t size) {
  const tp_sheet_options defaults = {.size = sizeof defaults, .times = 1, .lines = 400};
  tp_options_fill(options, size, &defaults);
}

static void add_input(tp_sheet *s) {
  const tp_solution *own = s->solution;
  tp_document *d = &s->document;
  tp_page page = {.solution = own};
  char n[TP_NUMBER_SIZE];
  tp_document_heading(d, 2, "Block, base and contact");
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0,
                    "Input, and quantities that follow from its geometry");
  tp_page_add_input(&page);
  tp_sheet_facts(d, &page.text);
  if (own->has_friction) {
    tp_document_cell(d, "Friction");
    tp_document_cell(d,
                     own->friction_is_residual
                         ? "φ = %s°, residual; more at low stress (Barton's law)"
                     : own->friction_is_patton ? "φ = %s° with the roughness i (Patton's law)"
                                               : "φ = %s°",
                     tp_page_degrees(n, own->friction_angle_deg));
  } else {
    tp_document_cell(d, "Friction");
    tp_document_cell(d, "not given: sliding is not judged");
  }
  if (own->has_tilt_angle) {
    tp_document_cell(d, "Tilt");
    tp_document_cell(d, "α = %s°", tp_page_degrees(n, own->tilt_angle_deg));
  }
  tp_sheet_add_settings(d, &own->settings);
  tp_sheet_add_poses(s);
}

static void add_case_heading(tp_sheet *s, const tp_case *c, const char *table, const char *world,
                             const char *plain) {
  char n[TP_NUMBER_SIZE];
  tp_document *d = &s->document;
  const char *towards = tp_document_say(d, tp_direction_name(c->towards));
  if (s->solution->frame.world) {
    tp_document_heading(d, 2, world, towards);
  } else if (s->solution->has_tilt_angle) {
    tp_document_heading(d, 2, table, towards, tp_page_degrees(n, s->solution->tilt_angle_deg));
  } else {
    tp_document_heading(d, 2, plain, towards);
  }
}

/* Three whole phrases, for each language to put in its own words. */
#define HEADING(s, c, what)                                                                        \
  add_case_heading(s, c, what ", tilted towards the %s by %s°",                                    \
                   what ", as it lies, towards the %s", what ", tilted towards the %s")

static void add_case(tp_sheet *s, const tp_case *c) {
  HEADING(s, c, "Account");
  tp_sheet_add_factors(s, c);
  tp_sheet_add_window(s, c);
  tp_sheet_add_pivots(s, c);
  tp_sheet_add_account(s, c);
  tp_sheet_add_limit(s, c);
  tp_sheet_add_motions(s, c);
}

static void add_effects(tp_sheet *s) {
  const tp_solution *own = s->solution;
  tp_document *d = &s->document;
  const bool times = s->options->times != 0;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, times ? 4 : 3, times ? 8 : 0,
                    "Effects computed, and the input that required them");
  tp_document_cell(d, "Effect");
  tp_document_cell(d, "Required by");
  tp_document_cell(d, "Arithmetic");
  if (times) tp_document_cell(d, "Time (ms)");
  for (size_t k = 0; k < own->effect_count; k++) {
    const tp_effect *effect = own->effects + k;
    tp_document_word(d, effect->name);
    tp_document_told_cell(d, effect->called_for_by);
    tp_document_word(d, tp_level_name(effect->level));
    if (times) tp_document_cell(d, "%.3f", 1e3 * effect->seconds);
  }
}

void tp_sheet_add_proof(tp_sheet *s) {
  const tp_solution *own = s->solution;
  tp_document *d = &s->document;
  tp_document_heading(d, 2, "Proof and computing cost");
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      "Every digit printed is certain: each number has a proven bound, requested to "
      "%d digits. The cheapest arithmetic that certified all of them was %s, at %ld bits. "
      "Effects that the scene does not require were not computed.",
      own->digits, tp_document_say(d, tp_level_name(own->level)), own->bits);
  if (own->open_number) {
    tp_document_add(d, TP_PASSAGE_CAUTION,
                    "Caution: a number is not certain to the digits requested; only its certain "
                    "digits are printed.");
  }
  if (own->zero_bits != 0) {
    tp_document_add(d, TP_PASSAGE_CAUTION,
                    "Caution: a decision takes as zero what %ld bits cannot distinguish from zero.",
                    own->zero_bits);
  }
  add_effects(s);
}

void tp_sheet_set_letterhead(tp_document *d, tp_sheet_head *head) {
  tp_document_set_letterhead(d, head->texts[TP_LETTERHEAD_COMPANY], head->logo);
  head->logo = (tp_logo){0};
}

/* As high as one page of A4, with whatever room there is for the sketch. */
static void add_front(tp_sheet *s, tp_picture picture) {
  tp_document *d = &s->document;
  tp_sheet_add_persons(d, s->head);
  tp_document_sketch(
      d, picture, "The block on its base, with pivots, forces and their labels.",
      "Drawing of the block on its base. Its verdict, pivots and forces are given in "
      "the text and the tables of this page.");
  tp_sheet_add_inputs(s);
  if (s->options->load_cases != NULL) {
    tp_sheet_add_load_cases(s);
  } else {
    tp_sheet_add_governing(s);
  }
  for (size_t k = 0; k < s->solution->case_count; k++) {
    tp_sheet_add_conclusion(s, s->solution->cases + k);
  }
  tp_sheet_count_cautions(d, &s->solution->notes,
                          s->scene->letterhead.brief
                              ? "Cautions on the input: %zu. They stand below the hand check."
                              : "Cautions on the input: %zu. They stand at the head of the "
                                "appendix.");
  tp_sheet_add_signatures(d, s->head);
}

/* The second page, or as many as it takes. */
static void add_hand_check(tp_sheet *s) {
  tp_document_page(&s->document);
  for (size_t k = 0; k < s->solution->case_count; k++) {
    const tp_case *c = s->solution->cases + k;
    HEADING(s, c, "Hand check");
    tp_sheet_add_loads(s, c);
    tp_sheet_add_formulas(s, c);
  }
}

/* What must not be missed of an appendix that is left out. */
static void add_in_brief(tp_sheet *s) {
  tp_sheet_add_notes(&s->document, &s->solution->notes);
  tp_sheet_add_load_case_details(s);
}

static void add_appendix(tp_sheet *s, const tp_sheet_files *files) {
  tp_document *d = &s->document;
  const tp_solution *own = s->solution;
  tp_document_page(d);
  tp_document_heading(d, 2, "Appendix");
  for (size_t k = 0; k < own->case_count; k++) {
    HEADING(s, own->cases + k, "Verdict");
    tp_sheet_add_verdict(s, own->cases + k);
  }
  tp_sheet_add_notes(d, &own->notes);
  tp_sheet_add_load_case_details(s);
  add_input(s);
  for (size_t k = 0; k < own->case_count; k++) add_case(s, own->cases + k);
  tp_sheet_add_proof(s);
  tp_sheet_add_origin(d, files, s->options);
  tp_sheet_add_files(d, files, s->options);
}

/* With the load case that it is of. */
static void add_title(tp_document *d, const tp_scene *scene, const tp_solution *solution) {
  tp_text own = {0}, load_case = {0}, title = {0};
  if (solution->load_case != NULL && scene->title != NULL) {
    tp_encode_plain(&own, scene->title);
    tp_encode_plain(&load_case, solution->load_case);
    tp_text_add(&title, tp_document_say(d, "%s, case %s"), own.data != NULL ? own.data : "",
                load_case.data != NULL ? load_case.data : "");
  } else if (solution->title != NULL) {
    tp_encode_plain(&title, solution->title);
  }
  tp_sheet_add_title(d, title.data, "Stability of a rock block on its base");
  d->failed = d->failed || own.failed || load_case.failed || title.failed;
  tp_text_drop(&own);
  tp_text_drop(&load_case);
  tp_text_drop(&title);
}

void tp_sheet_build(tp_document *document, const tp_scene *scene, const tp_solution *solution,
                    const tp_sheet_files *files, const tp_sheet_options *options,
                    tp_sheet_head *head, tp_picture picture) {
  tp_sheet s = {.scene = scene, .solution = solution, .options = options, .head = head};
  tp_document *d = &s.document;
  d->language = head->language;
  d->comma = head->comma;
  tp_sheet_set_letterhead(d, head);
  add_title(d, scene, solution);
  tp_sheet_add_foot(d, files, options);
  add_front(&s, picture);
  add_hand_check(&s);
  if (scene->letterhead.brief) {
    add_in_brief(&s);
  } else {
    add_appendix(&s, files);
  }
  *document = s.document;
}
