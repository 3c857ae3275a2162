/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study as its file says it: a scene, the numbers that vary, and how they are drawn.
 *
 * Lists, grids and columns are crossed: each combination is a cell. All columns go together, row by
 * row. What is drawn is drawn anew in each cell, by a seed of its own; sample s is draw s / cells
 * of cell s % cells, so that the first samples hold all cells alike. Without anything drawn each
 * cell is one sample. */

#ifndef TP_STUDY_STUDY_H
#define TP_STUDY_STUDY_H

#include "case_filter/keyed_filter.h"
#include "sampling/distribution.h"
#include "sampling/draws.h"
#include "scene_varying/vary.h"
#include "topple_study.h"

/* Most that a study may have: what it holds in memory for each is bounded by these. */
enum { TP_STUDY_VARIABLES = 200, TP_STUDY_TILTS = 200, TP_STUDY_LISTED = 1000000 };
/* So many columns and steps of the convergence are kept, of no more samples. */
enum { TP_STUDY_KEPT = 1 << 18 };
#define TP_STUDY_SAMPLES (UINT64_C(1) << 40)

typedef enum tp_variable_source {
  TP_VARIABLE_DRAWN,
  TP_VARIABLE_LISTED,
  TP_VARIABLE_COLUMN
} tp_variable_source;

typedef struct tp_variable {
  const tp_node *node; /* of the study, whose key names the number */
  tp_scene_key key;
  tp_variable_source source;
  const char *kind;             /* in words */
  tp_distribution distribution; /* drawn, */
  size_t dimension;             /* and as which */
  double *values;               /* listed, of a column, or of an empirical distribution */
  size_t count;
  char *file; /* that the numbers are read from, or NULL */
} tp_variable;

/* Of the base of a sample (study/roughness.h), the first five by a study's choice. */
typedef enum tp_study_measure_kind {
  TP_MEASURE_AMPLITUDE,
  TP_MEASURE_RMS_HEIGHT,
  TP_MEASURE_Z2,
  TP_MEASURE_INCLINATION,
  TP_MEASURE_JRC,
  TP_MEASURE_PEAK,   /* Eq. (15), */
  TP_MEASURE_VALLEY, /* and Eq. (16) */
  TP_MEASURES
} tp_study_measure_kind;

/* A design value that is asked for. */
typedef struct tp_wanted_design {
  size_t variable;
  double probability;
  tp_study_quantity quantity;
  bool ranged; /* it is looked for there; else in the range of the samples */
  double from, to;
} tp_wanted_design;

struct tp_study {
  char *path;
  tp_node *root;
  char *scene_path;
  tp_scene *scene;
  size_t variable_count, drawn, tilt_count;
  tp_variable *variables;
  const char **drawn_names; /* of the drawn ones, by their dimension */
  double *correlation;      /* of the drawn ones; NULL: independent */
  tp_draw_method method;
  uint64_t seed;
  uint64_t cells, rows; /* rows: of the columns; 0: there are none */
  uint64_t samples;     /* of all cells */
  size_t chunk;
  bool tilt_varies; /* the scene's own */
  double *tilts;
  tp_scene_key tilt_key;       /* where there are tilts */
  double half_width;           /* wanted; 0: none */
  uint64_t sensitivity;        /* samples of Sobol' indices; 0: none are asked for */
  bool relies;                 /* reliability is asked for, */
  tp_study_quantity relied;    /* of that, */
  uint64_t importance, subset; /* with samples of rare events; 0: none */
  tp_keyed_filter *filter;     /* tells samples in doubles; NULL: none */
  size_t measure_count;        /* in each row; 0: roughness is not asked for */
  tp_study_measure_kind measures[TP_MEASURES];
  size_t design_count;
  tp_wanted_design *designs;
  uint64_t hash_of_file;  /* a fingerprint of the study's own file, */
  uint64_t hash_of_scene; /* of that and those of its scene, */
  uint64_t hash;          /* and of all files that they name */
};

/* The number of a variable in a cell, and that of one that is drawn. */
double tp_variable_listed(const tp_study *study, size_t variable, uint64_t cell);
double tp_variable_drawn(const tp_variable *variable, const double *scores);

/* The numbers of `count` samples from `first` on, one sample after another. */
TP_MUST_USE tp_status tp_study_draw(double *values, const tp_study *study, uint64_t first,
                                    size_t count, tp_message *message);

/* Chunks of the study, and the samples of one. */
uint64_t tp_study_chunks(const tp_study *study);
size_t tp_study_chunk_size(const tp_study *study, uint64_t chunk);
/* The first chunk of a shard; that of the one beyond the last is the end of the study. */
uint64_t tp_shard_chunk(const tp_study *study, size_t shard, size_t shards);
/* The samples before a chunk. */
uint64_t tp_chunk_sample(const tp_study *study, uint64_t chunk);

#endif
