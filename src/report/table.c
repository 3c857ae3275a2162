/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Several solutions in one table: in Markdown to be read, in CSV for other programs. */

#include "host.h"
#include "output/encode.h"
#include "report/onset.h"
#include "report/words.h"

static void add_angle(tp_text *t, bool known, tp_bounded angle) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, " | %s%s", known ? tp_text_fixed(n, angle, 3) : "-", known ? "°" : "");
}

static void add_limit(tp_text *t, const tp_limit *l) {
  add_angle(t, l->kind == TP_LIMIT_AT_ANGLE, l->critical_angle_deg);
  const bool nowhere = l->kind == TP_LIMIT_NOWHERE || l->kind == TP_LIMIT_NOT_ASKED;
  tp_text_add(t, " | %s", nowhere ? "-" : tp_mechanism_name(l->mechanism));
  if (l->tie) tp_text_add(t, ", %s", tp_mechanism_name(l->tied_with));
}

/* The governing factor and what it is against. */
static void add_fos(tp_text *t, const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  char n[TP_NUMBER_SIZE];
  const bool number = g->fos.state == TP_FOS_NUMBER;
  tp_text_add(t, " | %s%s | ", number && g->sliding_judged && !g->complete ? "≤ " : "",
              number                                  ? tp_text_fixed(n, g->fos.value, 3)
              : g->fos.state == TP_FOS_UNDEFINED      ? "none"
              : g->fos.state == TP_FOS_UNDECIDED      ? "undecided"
              : g->fos.state == TP_FOS_NO_OVERTURNING ? "unbounded"
                                                      : "-");
  if (!g->has_factor) {
    tp_text_add(t, g->up_dip ? "lets go up-dip" : g->beyond ? "lets go before" : "-");
    return;
  }
  const tp_mechanism mechanism = g->factors[g->factor].mechanism;
  tp_text_add(t, "%s",
              mechanism == TP_MECHANISM_UNDECIDED ? "moves" : tp_mechanism_name(mechanism));
  tp_text_add(t, " (%s)", tp_fos_definition_name(g->factors[g->factor].definition));
}

/* Up to which tilt it is certain to stand. */
static void add_onset(tp_text *t, const tp_onset *o) {
  if (o->kind == TP_ONSET_NEVER) {
    tp_text_add(t, " | 90°");
  } else {
    add_angle(t, o->kind == TP_ONSET_AT_ANGLE, o->critical_angle_deg);
  }
}

static const tp_pivot *governing_pivot(const tp_case *c) {
  return c->has_governing ? c->pivots + c->governing : NULL;
}

static void add_case(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_pivot *pivot = governing_pivot(c);
  const bool goes_on = c->limit.base_beyond_toe;
  tp_text_add(t, "| ");
  tp_encode_markdown(t, s->title != NULL ? s->title : "a scene");
  tp_text_add(t, " | %s", tp_text_direction(c->towards));
  add_angle(t, s->has_tilt_angle, s->tilt_angle_deg);
  tp_text_add(t, " | ");
  if (s->has_tilt_angle) {
    tp_text_verdict(t, c);
  } else {
    tp_text_add(t, "-");
  }
  add_fos(t, c);
  add_onset(t, &c->onset);
  tp_text_add(t, " | %s", pivot != NULL ? tp_text_pivot_kind(pivot->kind) : "-");
  add_angle(t, pivot != NULL && !pivot->never && !pivot->always,
            pivot != NULL ? pivot->critical_angle_deg : (tp_bounded){0});
  add_angle(t, c->sliding.known && !c->sliding.never && !c->sliding.always,
            c->sliding.critical_angle_deg);
  add_limit(t, goes_on ? &c->limit_otherwise : &c->limit);
  add_limit(t, goes_on ? &c->limit : &c->limit_otherwise);
  tp_text_add(t, " |\n");
}

typedef void (*row)(tp_text *text, const tp_solution *solution, const tp_case *own);

/* A head and a row for each case. */
static void write(tp_text *t, const char *head, row add, const tp_solution *const *solutions,
                  size_t count) {
  tp_text_add(t, "%s", head);
  for (size_t k = 0; k < count; k++) {
    for (size_t c = 0; c < solutions[k]->case_count; c++) {
      add(t, solutions[k], solutions[k]->cases + c);
    }
  }
}

/* Below the table: the notes and cautions of each scene, by its name. */
static void add_notes(tp_text *t, const tp_solution *s) {
  for (size_t k = 0; k < s->notes.count; k++) {
    const tp_note *note = s->notes.items + k;
    tp_text_add(t, "- ");
    tp_encode_markdown(t, s->title != NULL ? s->title : "a scene");
    tp_text_add(t, ", %s: ", tp_note_kind_name(note->kind));
    tp_encode_markdown(t, note->text);
    if (note->place[0] != '\0') {
      tp_text_add(t, " (");
      tp_encode_markdown(t, note->place);
      tp_text_add(t, ")");
    }
    tp_text_add(t, "\n");
  }
}

static void add_all_notes(tp_text *t, const tp_solution *const *solutions, size_t count) {
  bool any = false;
  for (size_t k = 0; k < count; k++) any = any || solutions[k]->notes.count > 0;
  if (any) tp_text_add(t, "\n");
  for (size_t k = 0; k < count; k++) add_notes(t, solutions[k]);
}

static const char *const columns =
    "| scene | towards | tilt | verdict | FoS | against | certain to stand up to | toe | moments | "
    "φ + i | base ends at the toe: limit | mechanism | base goes on: limit | mechanism |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

tp_status tp_report_table(char **text, const tp_solution *const *solutions, size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solutions);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, solutions[k]);
  tp_text t = {0};
  write(&t, columns, add_case, solutions, count);
  add_all_notes(&t, solutions, count);
  return tp_text_finish(&t, text);
}

/* A number in full, or an empty field. */
static void add_field(tp_text *t, bool known, tp_bounded number) {
  if (known) tp_text_add(t, "%.17g", number.value);
  tp_text_add(t, ",");
  if (known) tp_text_add(t, "%.17g", number.error);
  tp_text_add(t, ",");
}

static void add_fields(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_pivot *pivot = governing_pivot(c);
  const tp_governing_fos *g = &c->governing_fos;
  const bool counts = g->fos.state == TP_FOS_NUMBER && (g->complete || !g->sliding_judged);
  tp_encode_csv(t, s->title != NULL ? s->title : "");
  tp_text_add(t, ",%s,", tp_text_direction(c->towards));
  add_field(t, s->has_tilt_angle, s->tilt_angle_deg);
  tp_text_add(t, "%s,", s->has_tilt_angle ? tp_mechanism_name(c->mechanism) : "");
  add_field(t, counts, g->fos.value);
  const tp_factor *factor = g->has_factor ? g->factors + g->factor : NULL;
  tp_text_add(t, "%s,%s,", factor != NULL ? tp_mechanism_name(factor->mechanism) : "",
              factor != NULL ? tp_fos_definition_name(factor->definition) : "");
  add_field(t, c->onset.kind == TP_ONSET_AT_ANGLE, c->onset.critical_angle_deg);
  add_field(t, pivot != NULL && !pivot->never && !pivot->always,
            pivot != NULL ? pivot->critical_angle_deg : (tp_bounded){0});
  add_field(t, c->sliding.known && !c->sliding.never && !c->sliding.always,
            c->sliding.critical_angle_deg);
  add_field(t, c->limit.kind == TP_LIMIT_AT_ANGLE, c->limit.critical_angle_deg);
  tp_text_add(t, "%s,",
              c->limit.kind == TP_LIMIT_NOT_ASKED ? ""
              : c->limit.kind == TP_LIMIT_NOWHERE ? "holds nowhere"
                                                  : tp_mechanism_name(c->limit.mechanism));
  tp_text_beginnings(t, &c->onset);
  tp_text_add(t, "\n");
}

static const char *const fields =
    "scene,towards,tilt_deg,tilt_error,verdict,fos,fos_error,fos_mechanism,fos_definition,"
    "certain_to_stand_deg,certain_to_stand_error,moments_deg,moments_error,sliding_deg,"
    "sliding_error,limit_deg,limit_error,limit_mechanism,can_begin\n";

tp_status tp_report_csv(char **text, const tp_solution *const *solutions, size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solutions);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, solutions[k]);
  tp_text t = {0};
  write(&t, fields, add_fields, solutions, count);
  return tp_text_finish(&t, text);
}
