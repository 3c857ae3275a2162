/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study: one scene solved many times, with some of its numbers drawn at random, listed or taken
 * from a table, as a study file says (docs/study.md). Included by topple.h.
 *
 * Every sample is what tp_solve says of the scene with the sample's numbers, each a decimal that
 * the scene takes exactly. What is undecided, what depends on loading history, and a sample of
 * which there is no scene are counted as such; none is left out. */

#ifndef TOPPLE_STUDY_H
#define TOPPLE_STUDY_H

#include <stdint.h>

#include "topple_governing.h"
#include "topple_scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A study that was read, with its scene. Opaque. */
typedef struct tp_study tp_study;

/* Read the study in `path`, to be freed by tp_study_free. The files that it names are looked for
 * beside it. */
TP_MUST_USE tp_status tp_study_read(tp_study **study, const char *path, tp_message *message);

/* The same from text in memory; `name` is what messages call it, and the files that it names are
 * looked for beside a file of that name. Its rows go on by an interrupted study of a file with the
 * same text. */
TP_MUST_USE tp_status tp_study_read_text(tp_study **study, const char *text, const char *name,
                                         tp_message *message);

/* Free it with all that it holds; NULL is allowed. */
void tp_study_free(tp_study *study);

/* Outcome of a sample. */
typedef enum tp_study_outcome {
  TP_STUDY_STANDS,
  TP_STUDY_SLIDES,
  TP_STUDY_TOPPLES,
  TP_STUDY_SLIDES_AND_TOPPLES,
  TP_STUDY_LEAVES_BASE, /* every contact opens */
  TP_STUDY_INTERLOCKED, /* stands at every tilt */
  TP_STUDY_MAY_MOVE,    /* some forces would hold it, but a motion can begin: depends on loading
                           history */
  TP_STUDY_UNDECIDED,   /* at the precision allowed */
  TP_STUDY_INVALID      /* the numbers make no scene that can be solved */
} tp_study_outcome;

/* How many there are. */
enum { TP_STUDY_OUTCOMES = TP_STUDY_INVALID + 1 };

/* stands, slides, topples, slides and topples, leaves its base, interlocked, may move, undecided or
 * invalid. */
const char *tp_study_outcome_name(tp_study_outcome outcome);

/* A share of the samples, with Wilson's interval of 95 %. */
typedef struct tp_study_share {
  size_t samples;   /* of the samples */
  double share;     /* of all samples */
  double low, high; /* of the probability */
} tp_study_share;

/* Outcomes of the samples at a tilt. Its shares of outcomes add up to 1. */
typedef struct tp_study_tilt {
  bool of_scene;    /* at the scene's tilt; where it has none, what happens first as it is tilted */
  bool as_it_lies;  /* of a scene in the frame of the world: at the dip of its mean plane; of a
                       solid: as its base or its joints dip */
  bool has_tilt;    /* false: the scene has none, or lies as it lies */
  bool tilt_varies; /* it is the scene's, and has no one value */
  double tilt_deg;  /* the tilt; where it varies, that of the scene file */
  tp_study_share outcomes[TP_STUDY_OUTCOMES]; /* by outcome */
  tp_study_share certain_to_stand;            /* certain to stand: stands and interlocked */
  tp_study_share certain_to_move; /* certain to move: slides, topples, both, leaves its base */
  tp_study_share neither;         /* neither is certain, of valid samples */
} tp_study_tilt;

/* The numbers that a sample has; in rows and columns infinity where it holds at every tilt, or
 * nothing overturns, minus infinity where it holds at none, NaN where there is no number; of a
 * support 0 where none is needed, infinity where no such force is enough. */
typedef enum tp_study_quantity {
  TP_STUDY_MOMENTS_DEG,      /* the critical angle of toppling by moments */
  TP_STUDY_ONSET_DEG,        /* the onset of motion: certain to stand below */
  TP_STUDY_LIMIT_DEG,        /* the static limit: certain to move beyond */
  TP_STUDY_FOS,              /* the governing factor of safety at the scene's tilt */
  TP_STUDY_FOS_GOODMAN_BRAY, /* of columns in a row, of a scene of many blocks alone, as the next */
  TP_STUDY_ACCELERATION_G,   /* the critical horizontal acceleration */
  TP_STUDY_SUPPORT_N_M       /* the least force of the support that the scene asks for */
} tp_study_quantity;

/* How many there are, and how many quantiles each has. */
enum { TP_STUDY_QUANTITIES = TP_STUDY_SUPPORT_N_M + 1, TP_STUDY_QUANTILES = 7 };

/* moments_deg, onset_deg, limit_deg, fos, fos_goodman_bray, critical_acceleration_g or support_n_m.
 */
const char *tp_study_quantity_name(tp_study_quantity quantity);

/* A quantile, with a range that holds it with 95 % certainty whatever the distribution. */
typedef struct tp_study_quantile {
  double probability;      /* 0.01, 0.05, 0.25, 0.5, 0.75, 0.95 or 0.99 */
  double value, low, high; /* may be infinite; `low` minus infinity, `high` infinity where the
                              samples are too few for a statement */
} tp_study_quantile;

/* How a quantity is distributed. */
typedef struct tp_study_spread {
  size_t samples; /* of the samples kept that have it; 0: no quantiles */
  tp_study_quantile quantiles[TP_STUDY_QUANTILES]; /* if samples > 0: by rising probability */
} tp_study_spread;

/* The factors of safety of samples that one definition governs at the scene's tilt. Each tells in
 * its own way how far a block is from 1, so that they are no one distribution: just beyond toppling
 * the one by moments is little below 1, and strength reduction, where it governs, far below. */
typedef struct tp_study_factor {
  tp_fos_definition definition; /* by which the governing factor is computed */
  tp_study_share governs;       /* of all samples */
  size_t below_1;               /* of these, with a factor below 1 */
  tp_study_spread spread;       /* of the factors of the samples kept */
} tp_study_factor;

/* Spearman's rank correlation of a number that varies with a quantity. */
typedef struct tp_study_rank {
  bool known;              /* three samples at least, and neither is the same for all */
  double value, low, high; /* if known: -1 to 1, with its interval of 95 % */
} tp_study_rank;

/* Sobol' indices of a number for a quantity: the share of its variance that the number has by
 * itself, and with all in which it takes part, with their intervals of 95 %. */
typedef struct tp_study_index {
  bool known;                          /* they were asked for, and every point has the quantity */
  double first, first_low, first_high; /* if known: by itself */
  double total, total_low, total_high; /* if known: with all in which it takes part */
} tp_study_index;

/* A probability by samples drawn where it fails: around the design points (importance), or step by
 * step towards where it fails (subset). */
typedef struct tp_study_rare {
  bool asked;                    /* the study asks for it */
  bool known;                    /* it has an answer */
  double probability, low, high; /* if known: with its interval of 95 % */
  double variation;              /* if known: its deviation over itself */
  size_t scenes;                 /* if known: scenes solved for it */
  char *why;                     /* where it is not known: plain; else NULL */
} tp_study_rare;

/* A design point: of the points at which an angle is the tilt, or a factor of safety 1, one that is
 * more likely than all around it. Each way to fail has one or several. */
typedef struct tp_study_design_point {
  double beta;        /* its distance in deviations, below 0 where the means fail */
  double probability; /* Phi(-beta) */
  size_t value_count; /* as many as variables */
  double *values;     /* the number of each variable there */
} tp_study_design_point;

/* Reliability of first order at the scene's tilt: of the nearest design point, the most likely. */
typedef struct tp_study_reliability {
  bool known;                 /* it was asked for */
  tp_study_quantity quantity; /* if known: of which */
  bool converged;             /* if known: a design point was found; else there is no number */
  const char *state;          /* if known: how the search ended, in words; a static string */
  double beta;        /* if known: the index: the distance of the design point in deviations */
  double probability; /* if known: of first order, Phi(-beta), that the quantity is not above; both
                         NaN where there is no design point */
  size_t scenes;      /* if known: scenes solved for it */
  tp_study_rare importance, subset;     /* sampling of rare events, where asked for */
  size_t design_point_count;            /* of the design points */
  tp_study_design_point *design_points; /* the nearest first */
} tp_study_reliability;

/* The design value of one number: put into the scene, with all other numbers as they stand there,
 * it gives what samples have with the probability wanted; so one solve stands where so many samples
 * do. */
typedef struct tp_study_design {
  size_t variable;            /* which of the variables */
  double probability;         /* wanted: */
  tp_study_quantity quantity; /* that this is not above `quantity_value` */
  bool known;                 /* there is one */
  double value, low, high;    /* if known: the number, with its interval of 95 %; an end may be
                                 infinite, where the samples, or the range, do not reach it */
  bool
      low_is_safe; /* if known: of the interval, else the high one: there is less of the quantity */
  double quantity_value; /* if known: of the scene with it */
  double scene_value;    /* the number as it stands in the scene */
  size_t scenes;         /* scenes solved for it */
  char *why;             /* where it is not known: plain; else NULL */
} tp_study_design;

/* A number that varies. */
typedef struct tp_study_variable {
  TP_OUTSIDE char *key;   /* the scene's */
  const char *kind;       /* normal, list and so on; a static string */
  const char *unit;       /* deg, m, kPa and so on, or NULL; likewise */
  char *law;              /* "mean 36, deviation 3, between 25 and 50" */
  double least, greatest; /* of the samples kept */
  tp_study_rank rank_correlations[TP_STUDY_QUANTITIES]; /* with each quantity */
  tp_study_index sobol_indices[TP_STUDY_QUANTITIES];    /* for each quantity */
  double design_value; /* where reliability is known: at the nearest design point; NaN: none */
  double importance;   /* its share of the variance there, as if all were independent */
} tp_study_variable;

/* Two numbers that are drawn with a correlation of their normal scores. */
typedef struct tp_study_correlation {
  size_t one, other; /* of the variables */
  double value;      /* between -1 and 1, not 0 */
} tp_study_correlation;

/* A number of roughness of the base of a sample, or an angle of Eqs. (15) and (16). */
typedef struct tp_study_measure {
  const char *name;       /* amplitude, rms_height, z2, effective_angle_deg, jrc; last peak_deg,
                             Eq. (15), and valley_deg, Eq. (16); a static string */
  const char *unit;       /* mm, deg and so on; NULL: none */
  size_t samples;         /* of the samples kept that have it */
  double least, greatest; /* if samples > 0: of these */
  tp_study_rank rank_correlations[TP_STUDY_QUANTITIES]; /* with each quantity */
} tp_study_measure;

/* The estimate as samples came in. */
typedef struct tp_study_step {
  size_t of_samples;              /* the first so many */
  tp_study_share certain_to_move; /* as in the first tilt */
} tp_study_step;

/* A sample of which there is no scene. */
typedef struct tp_study_bad {
  size_t sample;             /* its number, from 0 */
  TP_OUTSIDE char *settings; /* its numbers: KEY=VALUE KEY=VALUE */
  char *why;                 /* plain */
} tp_study_bad;

/* Why a study ended. */
typedef enum tp_study_end {
  TP_STUDY_COMPLETE,    /* all samples */
  TP_STUDY_CERTAIN,     /* every interval is as narrow as was asked */
  TP_STUDY_INTERRUPTED, /* options.stop said so */
  TP_STUDY_SHARD        /* all samples of its shard */
} tp_study_end;

/* A number of the samples, one value each; of what has a name its number in the list of these. */
typedef struct tp_study_column {
  TP_OUTSIDE char *header; /* as in the header of the rows */
  double *values;          /* `kept` of them */
} tp_study_column;

/* The summary of a study. Quantiles, ranks, ranges and columns are of the first `kept` samples, 262
 * 144 at most, all else is of all. */
typedef struct tp_study_result {
  size_t size;             /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;  /* of the study, else of the scene, or NULL */
  TP_OUTSIDE char *scene;  /* the file */
  const char *method;      /* monte carlo, latin hypercube, sobol, or none: nothing is drawn */
  size_t seed;             /* of the draws */
  size_t planned, samples; /* of the study, and done */
  size_t kept;             /* as explained above */
  tp_study_end end;        /* why no more */
  size_t shard, shards;    /* of several, from 1; 1 of 1 */
  double half_width;       /* asked of every interval; 0: none was asked for */
  size_t open; /* solved samples with a number less certain than to 9 digits, or a limit or factor
                  undecided */
  size_t
      by_doubles; /* samples solved in doubles with proven bounds; the others in higher precision */
  double doubles_seconds, ladder_seconds;          /* of computing, of those solved in this run */
  size_t tilt_count;                               /* 1 at least */
  tp_study_tilt *tilts;                            /* that of the scene, then those of the study */
  size_t variable_count;                           /* of the numbers that vary */
  tp_study_variable *variables;                    /* as the study lists them */
  size_t correlation_count;                        /* of the correlations */
  tp_study_correlation *correlations;              /* of the variables, in their order */
  tp_study_spread quantities[TP_STUDY_QUANTITIES]; /* of each quantity */
  tp_study_factor governing_factors[TP_FOS_DEFINITIONS]; /* by tp_fos_definition */
  size_t sensitivity_samples;       /* of Sobol' indices; 0: none were asked for */
  tp_study_reliability reliability; /* where asked for, and the study was not interrupted */
  size_t roughness_count;           /* of what is measured of the base; 0: it is not asked for */
  tp_study_measure *roughness;      /* in the order of the rows */
  size_t bracketed, within;  /* samples kept that have both angles of Eqs. (15) and (16), and of
                                these those whose critical angle by moments lies between */
  size_t design_value_count; /* of the design values asked for; as reliability */
  tp_study_design *design_values; /* as the study lists them */
  size_t convergence_count;       /* of the steps */
  tp_study_step *convergence;     /* at each power of two from 16 on, and at the end */
  bool of_many_blocks;            /* the scene is of many blocks: */
  bool has_required_fos;          /* of these, and of a solid: it requires a factor of safety: */
  tp_study_share below_required;  /* if has_required_fos: samples that certainly lack it, */
  tp_study_share meets_required;  /* if has_required_fos: certainly have it, */
  tp_study_share open_required;   /* if has_required_fos: and of which neither is certain */
  size_t invalid_count;           /* of the first invalid samples, 5 at most */
  tp_study_bad *invalid;          /* these */
  size_t column_count;            /* of the columns */
  tp_study_column *columns;       /* the numbers that vary, the quantities (of one block up to
                                     TP_STUDY_FOS), outcomes at each tilt,
                                     tp_fos_definition of the governing factor (NaN: none), the factors
                                     by moments and of sliding, and what is measured of the base */
  size_t source_count;            /* of the sources */
  TP_OUTSIDE char **sources; /* files that it was read from, and those of its rows: no chart of it
                                is written over them */
  bool of_solid;             /* the scene is of a solid, */
  bool of_wedge;             /* of a wedge, by the assumptions of Hoek and Bray */
} tp_study_result;

/* The ranks of a program that runs a study as several processes, by MPI or otherwise: each makes
 * the same call, of the same study and options, and what the ranks say to one another goes through
 * these calls, in the same order on all. Their cost for each rank does not grow with the number of
 * ranks but for what the first receives, which the columns of the result bound. False of any of
 * them ends the study: nothing more is said. The thread that runs the study calls them. */
typedef struct tp_study_ranks {
  size_t rank, count; /* this one, from 0, and how many; 1: no call is made */
  void *context;      /* of the calls below */
  bool (*sum)(void *context, uint64_t *before, uint64_t *all, const uint64_t *own,
              size_t count); /* of `count` whole numbers of each rank the sums modulo 2^64: over the
                                ranks before this one, unless that is NULL, and over all */
  bool (*send)(void *context, const void *bytes, size_t size); /* to the first rank, of which none
                                                                  may be */
  bool (*receive)(void *context, size_t rank, void **bytes,
                  size_t *size); /* on the first, what `rank` sent, in the order in which it did:
                                    allocated with malloc, NULL of none */
} tp_study_ranks;

/* How a study is run. */
typedef struct tp_study_options {
  size_t size;          /* of this struct, as `…_default()` has it */
  size_t threads;       /* that compute; 0: as many as the process may run on; 1: none is started */
  size_t shard, shards; /* the part of the study, from 1, and of how many; 1 of 1 */
  const char *rows;     /* a CSV file for a row of each sample, or NULL. Beside it a file of that
                           name and .progress says how far it is: a study that was interrupted goes
                           on from there. Of a name that ends in .h5 or .hdf5 the CSV has that name
                           and .csv, and HDF5 is made of it once the study is whole */
  bool restart;         /* do not go on, begin anew, over rows of any study */
  void *context;        /* of the calls below */
  bool (*stop)(void *context); /* asked in any thread before each sample, or NULL: true ends it */
  void (*progress)(void *context, size_t done, size_t of); /* called by the thread that runs it
                                                              after each chunk, or NULL */
  const tp_study_ranks *ranks; /* that run it together, or NULL: this process alone */
  void (*forecast)(void *context, size_t samples,
                   double seconds); /* called once, in any thread, after the samples of the first
                                       second, or NULL: how long the other `samples` will take by
                                       these */
} tp_study_options;

/* All of it, by as many threads as there are, without rows. `size` is that of the struct as the
 * caller knows it. */
void tp_study_options_init(tp_study_options *options, size_t size);
static inline tp_study_options tp_study_options_default(void) {
  tp_study_options options;
  tp_study_options_init(&options, sizeof options);
  return options;
}

/* Run it. `*result` is to be freed by tp_study_result_free. By ranks it is that of the first, and
 * NULL with TP_OK on the others; where one of them fails, the first has its status and message.
 * Rows and result are those of one process, to the byte. TP_SYSTEM_FAILED where rows cannot be
 * written; TP_DEPENDENCY_FAILED where HDF5 is asked for and not built. Bad input where the file of
 * rows belongs to another study, or its scene or the rows themselves have changed since, or is no
 * file of rows. */
TP_MUST_USE tp_status tp_study_run(tp_study_result **result, const tp_study *study,
                                   const tp_study_options *options, tp_message *message);

/* The `count` files of rows of all shards of the study, in any order, as one study: the same result
 * and rows as of one run. Of the options `rows` alone is taken. */
TP_MUST_USE tp_status tp_study_merge(tp_study_result **result, const tp_study *study,
                                     const char *const *shards, size_t count,
                                     const tp_study_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_study_result_free(tp_study_result *result);

/* The result as `topple study` prints it, and as JSON (docs/json.md). `*text` is allocated with
 * malloc and is the caller's to free. */
TP_MUST_USE tp_status tp_report_study(char **text, const tp_study_result *result);
TP_MUST_USE tp_status tp_report_study_json(char **text, const tp_study_result *result);

#ifdef __cplusplus
}
#endif

#endif
