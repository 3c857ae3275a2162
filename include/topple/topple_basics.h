/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What every part of the public library speaks of. Included by topple.h. */

#ifndef TOPPLE_BASICS_H
#define TOPPLE_BASICS_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of these headers. What may change between versions is in docs/library.md, "Versions".
 */
#define TP_VERSION_MAJOR 0 /* rises when a program has to be changed or compiled anew */
#define TP_VERSION_MINOR 1 /* rises when calls, fields or words are added */
#define TP_VERSION_PATCH 0 /* rises when something is mended */
/* One number to compare by. */
#define TP_VERSION_NUMBER (10000 * TP_VERSION_MAJOR + 100 * TP_VERSION_MINOR + TP_VERSION_PATCH)
/* The same as text. */
#define TP_VERSION "0.1.0"

/* The version of the library that the program has loaded, as TP_VERSION. */
const char *tp_version(void);
/* The same as TP_VERSION_NUMBER. */
int tp_version_number(void);

/* Of a call whose status must be used. */
#if defined(__GNUC__)
#define TP_MUST_USE __attribute__((warn_unused_result))
#else
#define TP_MUST_USE
#endif

/* The statuses: name, number, exit status of the program, meaning. */
#define TP_STATUS_LIST(X)                                                                          \
  X(TP_OK, 0, 0, "done")                                                                           \
  X(TP_BAD_INPUT, 1, 3, "the input is wrong")                                                      \
  X(TP_NO_ANSWER, 2, 3, "no answer exists")                                                        \
  X(TP_UNDECIDED, 3, 4, "undecided at the precision allowed")                                      \
  X(TP_OUT_OF_MEMORY, 4, 5, "out of memory")                                                       \
  X(TP_SYSTEM_FAILED, 5, 5, "the system failed")                                                   \
  X(TP_DEPENDENCY_FAILED, 6, 5, "a library that Topple builds on failed")

/* Status of a call. Outputs stay untouched unless it is TP_OK. Every call that returns one can
 * return TP_BAD_INPUT: the input is wrong, an argument out of its range, a pointer NULL; and
 * TP_OUT_OF_MEMORY. What else it can return is said with the call: TP_NO_ANSWER, none exists;
 * TP_UNDECIDED at the precision allowed; TP_SYSTEM_FAILED, a file that the caller, a scene or a
 * study names cannot be read (any call that reads one), or written, or another program failed;
 * TP_DEPENDENCY_FAILED, a library that Topple builds on did. */
typedef enum tp_status {
/* An item of the list. */
#define TP_STATUS_ENUM(name, number, exit_status, meaning) name = (number),
  TP_STATUS_LIST(TP_STATUS_ENUM)
#undef TP_STATUS_ENUM
} tp_status;

/* In words, as in the list; and the exit status of the program topple. Of a number that is none of
 * the list: "unknown status", and 5. */
const char *tp_status_meaning(tp_status status);
int tp_status_exit(tp_status status);

/* Which kind of input is wrong, beside TP_BAD_INPUT. */
typedef enum tp_fault {
  TP_FAULT_NONE,   /* the input is not what went wrong */
  TP_FAULT_FORMAT, /* a file or a text is not what its format says */
  TP_FAULT_KEY, /* a key, a name, a word or an option is unknown, missing, or excluded by another */
  TP_FAULT_UNIT,     /* a unit is missing or unknown */
  TP_FAULT_RANGE,    /* a number is outside its range */
  TP_FAULT_GEOMETRY, /* the shapes are no block on a base */
  TP_FAULT_ARGUMENT  /* an argument of the call is wrong: the caller's mistake */
} tp_fault;

/* In one word: "geometry". */
const char *tp_fault_name(tp_fault fault);

/* A chart: curves and borders (topple_chart.h). */
typedef struct tp_chart tp_chart;

/* What went wrong, where (file:line:column) and what to do; always terminated. The caller's, and as
 * long: what does not fit ends in …. */
typedef struct tp_message {
  char text[1024];  /* plain, of one line, without a line end */
  char file[512];   /* where, plain; of a longer path its end; empty where it is of no file */
  int line, column; /* in the file, counted from 1; 0: not known */
  int system_error; /* errno, where the system refused a file, else 0 */
  tp_fault fault;   /* the kind of input that is wrong, else TP_FAULT_NONE */
} tp_message;

/* Has a result, which begins with its size, this member? An older library, which a program finds
 * beside newer headers, made it without those that were added since. */
#define TP_HAS_MEMBER(result, member)                                                              \
  ((const char *)(&(result)->member + 1) <= (const char *)(result) + (result)->size)

/* Frees a text that a call of the library made (a report, an explanation); NULL is allowed. */
void tp_text_free(char *text);

/* Frees the memory that calls of the library leave to later calls of the same thread (FLINT's); for
 * the end of a thread that called it. Results stay valid, and the thread may call the library
 * again. */
void tp_cleanup(void);

/* A number with a proven bound: |truth - value| <= error. An error of infinity says that the
 * truth is outside the range of a double. `digits`, where more digits were asked for than a double
 * holds, is the truth in decimals, all of them certain, and belongs to what holds the number. */
typedef struct tp_bounded {
  double value;       /* the number */
  double error;       /* not below 0 */
  const char *digits; /* or NULL */
} tp_bounded;

/* To which side the table is tilted: which side of the block, as the scene has it, goes down. */
typedef enum tp_direction { TP_TOWARDS_LEFT, TP_TOWARDS_RIGHT } tp_direction;

/* A text from outside (a title, a name of a file) as a terminal shows it on one line: white space
 * becomes blanks, what acts unseen is spelt out, as \x1B or \u202E, and so are bytes that are no
 * UTF-8. Cut before the character that no longer fits, with … for what is cut off; `size` is 4 at
 * least. Messages are plain; fields marked TP_OUTSIDE are as they came. */
void tp_plain_text(char *plain, size_t size, const char *text);

/* Of a text from outside, as it came. */
#define TP_OUTSIDE

/* What stands beside an answer. A note says what the program made of its input; a caution names
 * what may be wrong with the input, or what the answer does not cover. */
typedef enum tp_note_kind { TP_NOTE, TP_CAUTION } tp_note_kind;

/* One of them. */
typedef struct tp_note {
  tp_note_kind kind;      /* which of the two */
  TP_OUTSIDE char *place; /* file:line:column; empty where it is of no one place */
  char *text;             /* what, and what to do if it was not meant; plain */
} tp_note;

/* A list of them. */
typedef struct tp_notes {
  size_t count;   /* of the items */
  tp_note *items; /* owned by what holds the list, as their texts are */
} tp_notes;

/* "note" or "caution". */
const char *tp_note_kind_name(tp_note_kind kind);

/* The arithmetic of the moment sums, by rising cost: double with a proven bound, compensated
 * double, balls, exact integers. */
typedef enum tp_level {
  TP_LEVEL_DOUBLE,
  TP_LEVEL_COMPENSATED,
  TP_LEVEL_BALL,
  TP_LEVEL_EXACT
} tp_level;

/* How many there are. */
enum { TP_LEVELS = TP_LEVEL_EXACT + 1 };

/* The level of that name: double, compensated, ball or exact; false for another one. */
bool tp_level_read(tp_level *level, const char *name);

/* And its name. */
const char *tp_level_name(tp_level level);

/* What the block does. */
typedef enum tp_mechanism {
  TP_STANDS,
  TP_SLIDES,
  TP_TOPPLES, /* turns about a point of its contact */
  TP_SLIDES_AND_TOPPLES,
  TP_INTERLOCKED, /* neither slides nor topples at any tilt below 90 degrees */
  TP_MAY_MOVE, /* some forces would hold it, but a motion can begin: depends on loading history */
  TP_LEAVES_BASE, /* every contact opens */
  TP_MECHANISM_UNDECIDED
} tp_mechanism;

/* stands, slides, topples, slides and topples, interlocked, may move, leaves its base, undecided */
const char *tp_mechanism_name(tp_mechanism mechanism);

/* Why a factor of safety is a number, or is none. */
typedef enum tp_fos_state {
  TP_FOS_NUMBER,
  TP_FOS_UNDEFINED, /* the weight lies past the pivot, and its resultant overturns nothing else */
  TP_FOS_NO_TILT,   /* the scene gives no tilt angle */
  TP_FOS_NO_OVERTURNING, /* nothing overturns or drives: the factor is unbounded */
  TP_FOS_UNDECIDED,      /* at the precision allowed */
  TP_FOS_NOT_ASKED       /* elements form of a large block without the elements option */
} tp_fos_state;

/* A factor of safety: what it is, or why it is none. */
typedef struct tp_fos {
  tp_fos_state state; /* is it a number? */
  tp_bounded value;   /* if state == TP_FOS_NUMBER */
} tp_fos;

#ifdef __cplusplus
}
#endif

#endif
