/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Complaints and progress on stderr. What complaints quote of the command line is made plain
 * (tp_plain_text), so they are written by these alone. */

#ifndef TP_CLI_WORDS_H
#define TP_CLI_WORDS_H

#include <argp.h>
#include <stdbool.h>

/* "topple: …" and the end of the line. */
void tp_cli_complain(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* What goes on, in words of our own. */
void tp_cli_tell(const char *what);
/* Before most of the work is done, where it will exceed the budget of a command, 10 s or 1 GB
 * (docs/budgets.md): `what`, as "samples", `count` of them. */
void tp_cli_tell_forecast(size_t count, const char *what, double seconds, double bytes);

/* A question, whose answer follows on its line. */
void tp_cli_ask(const char *question);

/* How far work is, over the line before, in numbers alone: so many done, at a rate a second. */
void tp_cli_tell_progress(size_t done, size_t of, double rate);
/* Of a tilt test: the bracket after so many runs. */
void tp_cli_tell_bracket(size_t runs, double least_deg, double most_deg);
/* Clears that line. */
void tp_cli_clear_progress(void);
/* What it cost: seconds of computing by doubles with bounds, and by the ladder. */
void tp_cli_tell_cost(double doubles_seconds, double ladder_seconds);

/* argp_error in plain text: complain, name --help and end, unless the parser's flags keep it. */
void tp_cli_refuse(const struct argp_state *state, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Files that options of a command name to be written: refused where two are one, by whatever names,
 * as the second would take the place of the first. */
typedef struct tp_cli_written {
  const char *option, *file; /* NULL: not given */
} tp_cli_written;
void tp_cli_refuse_same_files(const tp_cli_written *files, int count,
                              const struct argp_state *state);

/* The one file that a command takes, into `*file`; a second one is refused. `what` it is of, as
 * "scene". */
void tp_cli_take_file(const char **file, const char *argument, const char *what,
                      const struct argp_state *state);

/* Numbers between commas; how many, or one more than `most`. -1: one is none. */
int tp_cli_numbers(double *numbers, int most, const char *text);

/* The first word of the command line that argp would quote as it is, as no option is spelt so;
 * NULL where there is none. */
const char *tp_cli_strange_option(const struct argp *parser, int argc, char *const *argv);

#ifndef TP_WORDS_OWN
#pragma GCC poison argp_error argp_failure
#endif

#endif
