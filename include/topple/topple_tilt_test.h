/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A simulated tilt test of a scene, or the shaking of its base: what a scene in memory is given for
 * it, the call that runs it, its result and reports (docs/tilt.md). Included by topple.h. */

#ifndef TOPPLE_TILT_TEST_H
#define TOPPLE_TILT_TEST_H

#include "topple_scene.h"
#include "topple_tilt.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the test of a scene in memory -------------------------------------------------------------
 */

/* The test: by which engine, by which protocol; where `set_down`, the block is set down at each
 * angle, else it is placed level and tilted. The path engine takes a ramp, or steps at which the
 * block is set down, or a ramp from the scene's tilt angle, where it is; a release is at that. */
TP_MUST_USE tp_status tp_scene_set_tilt_test(tp_scene *scene, tp_tilt_engine engine,
                                             tp_tilt_protocol protocol, bool set_down,
                                             tp_message *message);

/* Of contacts that are springs: stiffness of the contact per unit of its area, both above 0. All
 * other numbers of a test are set by tp_scene_set_number, as "tilt_test.until_deg". */
TP_MUST_USE tp_status tp_scene_set_tilt_test_stiffness_gpa_m(tp_scene *scene, tp_exact normal_gpa_m,
                                                             tp_exact shear_gpa_m,
                                                             tp_message *message);

/* Of the path: stress locked in on a facet of the base before the start, in kilopascal; on all of
 * the contact that lies on that facet. Normal stress, linear from the facet's left end to its right
 * one, pressing above 0; shear stress, above 0 where it pushes the block to the right. A facet that
 * is given twice, or bears none of the block, is refused where the test is run. */
TP_MUST_USE tp_status tp_scene_add_tilt_test_traction(tp_scene *scene, size_t facet,
                                                      tp_exact first_kpa, tp_exact last_kpa,
                                                      tp_exact shear_kpa, tp_message *message);

/* Along what the base shakes: the horizontal, positive up-dip of a table tilted to the left; or
 * the vertical, positive upwards. */
typedef enum tp_shaking_axis { TP_SHAKES_HORIZONTALLY, TP_SHAKES_VERTICALLY } tp_shaking_axis;

/* Half a period of a sine, or a whole one. */
typedef enum tp_pulse_shape { TP_PULSE_HALF_SINE, TP_PULSE_FULL_SINE } tp_pulse_shape;

/* The base shakes along that axis: by a pulse of `peak_g` of standard gravity, with `frequency_hz`
 * above 0, which begins at once; or by a record of points (seconds, acceleration as a share of
 * gravity) at even steps, times `scale`. The last one set for an axis is taken. */
TP_MUST_USE tp_status tp_scene_set_shaking_pulse(tp_scene *scene, tp_shaking_axis axis,
                                                 tp_pulse_shape shape, tp_exact peak_g,
                                                 tp_exact frequency_hz, tp_message *message);
TP_MUST_USE tp_status tp_scene_set_shaking_record(tp_scene *scene, tp_shaking_axis axis,
                                                  tp_coordinates record, tp_exact scale,
                                                  tp_message *message);

/* ---- the test that is run ----------------------------------------------------------------------
 */

/* What is asked of a test beyond what the scene says. */
typedef struct tp_tilt_options {
  size_t size;      /* of this struct, as `…_default()` has it */
  size_t moments;   /* of the history of the motion, about so many at most, 2 to 1 000 000 */
  bool overturning; /* of a block whose base shakes: which factors on that of the scene overturn it,
                       or throw it off its base, of those of a grid */
  bool (*stop)(void *context); /* asked now and then, or NULL: true ends the test with what is known
                                  by then */
  void (*progress)(void *context, size_t runs, double least_deg, double most_deg); /* after each
                                  run, or NULL: how many there were, and the bracket by then */
  void *context;                                                                   /* of both */
  double overturning_from, overturning_to; /* the grid of factors, evenly on a logarithmic axis, */
  size_t overturning_count; /* and how many, 2 to 100 000; 0: 65 from 1/16 to 16, and by 0.5 % the
                               octave below the least found to overturn it */
  size_t smaller_count;     /* of a block on rigid contacts whose base shakes, and which is not
                               overturned: the number of smaller factors that are tried, evenly on a
                               logarithmic axis over the octave below 1, at most 100 000; 0: none */
} tp_tilt_options;

/* The defaults: 400 moments, 128 smaller factors; nothing stops it. `size` is that of the struct as
 * the caller knows it.
 */
void tp_tilt_options_init(tp_tilt_options *options, size_t size);
static inline tp_tilt_options tp_tilt_options_default(void) {
  tp_tilt_options options;
  tp_tilt_options_init(&options, sizeof options);
  return options;
}

/* The settings of a test, given or by default; those of other engines are 0. */
typedef struct tp_tilt_settings {
  tp_tilt_engine engine;     /* by which it is simulated */
  tp_tilt_protocol protocol; /* how the table is moved */
  bool set_down;             /* at each angle; else placed level and tilted */
  double speed_deg_min;      /* of the table */
  double until_deg;          /* of the table, at most */
  double release_deg;        /* where the block is released */
  double from_deg;           /* of a ramp: where it starts, level or set down */
  double tolerance_deg;      /* wanted width of the bracket */
  double duration_s;         /* of a run at a steady tilt, at most */
  double normal_stiffness_pa_m, shear_stiffness_pa_m; /* of the contact */
  bool stiffness_given;  /* by the scene; else the paper's 1000 and 10 GPa/m */
  double damping;        /* of springs, local */
  double rounding_m;     /* of corners */
  double time_step_s;    /* 0: chosen by the method */
  double restitution;    /* of impacts */
  size_t traction_count; /* facets with stress locked in before the start */
} tp_tilt_settings;

/* How the block ended. */
typedef enum tp_tilt_end {
  TP_TILT_STANDS,     /* where it began, up to the last tilt */
  TP_TILT_COLLAPSES,  /* no equilibrium is left: what follows is not simulated (path) */
  TP_TILT_RESTS,      /* it moved, and rests again */
  TP_TILT_MOVES,      /* it was still in motion when the run ended */
  TP_TILT_OVERTURNED, /* by more than a quarter of a turn */
  TP_TILT_LEFT_BASE,  /* no part of it is above the base any more */
  TP_TILT_OPEN,       /* the bound on steps or events was reached before any of these was sure */
  TP_TILT_STOPPED     /* options.stop said so */
} tp_tilt_end;

/* As one word or a few: "stands", "still moves". */
const char *tp_tilt_end_name(tp_tilt_end end);

/* And of an engine ("path", "dynamics by events", "dynamics by springs"), a protocol, an event. */
const char *tp_tilt_engine_name(tp_tilt_engine engine);
const char *tp_tilt_protocol_name(tp_tilt_protocol protocol);
const char *tp_tilt_event_name(tp_tilt_event_kind kind);

/* Where a simulated angle lies against the tilts of statics (topple_onset.h, topple_limit.h). */
typedef enum tp_tilt_place {
  TP_PLACE_UNKNOWN, /* one of them is not known */
  TP_PLACE_WITHIN,  /* not below the onset nor beyond the limit, but for the tolerance
                     */
  TP_PLACE_BELOW,   /* below the onset, where the block is certain to stand from rest */
  TP_PLACE_BEYOND   /* beyond the limit, where it is certain to move */
} tp_tilt_place;

/* A vertex, in metres in the frame of the base. */
typedef struct tp_tilt_point {
  double x_m, y_m; /* the coordinates */
} tp_tilt_point;

/* A facet of the base that events or reactions name, from its left end to its right one. */
typedef struct tp_tilt_facet {
  long facet;     /* as they count it: of the base, from 1, from left to right */
  size_t contact; /* as the page of tp_solve counts the facets of the contact, from 1 (their index
                     in its results is one less): the first on it; 0: the block does not rest on it
                     at the start */
  double x0_m, y0_m, x1_m, y1_m; /* its ends */
} tp_tilt_facet;

/* Factors on the shaking of the scene that were tried, evenly on a logarithmic axis. */
typedef struct tp_overturning_grid {
  double least, most; /* of them */
  size_t count;       /* how many */
} tp_overturning_grid;

/* An island of these, at all of which the block is overturned, or thrown off its base. What lies
 * between two factors that were tried may be otherwise. */
typedef struct tp_overturning_range {
  double
      spared_below;   /* the next lower one tried does not overturn it; NaN: none was tried there */
  double least, most; /* of those that were tried */
  double
      spared_above; /* the next higher one tried does not overturn it; NaN: none was tried there */
} tp_overturning_range;

/* One direction of tilt. Simulated numbers: no bound is proven; what was reached is stated. */
typedef struct tp_tilt_case {
  tp_direction towards;  /* which */
  bool has_bracket;      /* it stands at one tilt, and begins to move at another: */
  double stands_at_deg;  /* it stands there; if it never moves, the last tilt tried; NaN: no run
                        stood */
  double lets_go_at_deg; /* if has_bracket: it begins to move there */
  bool converged;        /* the bracket is as narrow as was asked */
  bool has_softening;    /* of a path on contacts whose stiffness the scene gives: */
  double softening_deg; /* by which it begins to move sooner on these very springs than in the limit
                           of stiff ones, which the bracket is for */
  size_t jumps;         /* times that a path gave way and came to rest at the same tilt */
  double first_jump_deg;         /* the tilt of the first of these */
  bool has_mechanism;            /* and it begins to move so: */
  tp_mechanism mechanism;        /* by the velocity with which it moves off */
  bool has_centre;               /* of rotation */
  double centre_x_m, centre_y_m; /* where it is */
  bool has_onset, has_limit;     /* statics knows: */
  double onset_deg, limit_deg;   /* alpha_s, certain to stand up to it; alpha_w, certain to move
                                    beyond */
  tp_tilt_place place;           /* of the bracket against these */
  tp_tilt_end end;               /* how it ended */
  double ended_s, ended_deg;     /* when, and at which tilt */
  double run_out_m;              /* of the centroid along the base, down-dip */
  double turned_deg;             /* counter-clockwise */
  double kinetic_energy_j;       /* the greatest */
  double energy_balance_j;       /* the largest of moments, in absolute value; NaN of a path */
  double energy_scale_j;         /* weight times extent, for comparison */
  bool overturning_scanned;      /* it was asked which factors on its shaking overturn it */
  bool has_overturning;          /* some factor that was tried does: */
  double spared_by;     /* if has_overturning: the next below the least of these, which spares
                                   it; 0: none tried */
  double overturned_by; /* if has_overturning: the least that was found */
  size_t overturning_tried_count;           /* of the grids that were tried */
  tp_overturning_grid overturning_tried[2]; /* all the range; below the least that was found */
  size_t overturning_range_count;           /* of the ranges */
  tp_overturning_range *overturning_ranges; /* upwards */
  size_t event_count;                       /* of the events */
  tp_tilt_event *events;             /* in their order; lengths in the frame of the scene's base */
  size_t moment_count;               /* of the moments */
  tp_tilt_moment *moments;           /* in their order */
  size_t reaction_count;             /* of the reactions */
  tp_tilt_reaction *reactions;       /* by moment, then by facet */
  size_t facet_count;                /* of the facets */
  tp_tilt_facet *facets;             /* by their numbers */
  size_t outline_count;              /* of the block's outline where it began, arcs by chords */
  tp_tilt_point *outline;            /* counter-clockwise */
  size_t base_count;                 /* of the ring of the base */
  tp_tilt_point *base;               /* counter-clockwise */
  double centroid_x_m, centroid_y_m; /* of the block where it began */
  size_t runs;                       /* of the engine */
  double seconds;                    /* that they took */
  bool has_peak_turn;                /* of a block whose base shakes, where it turned: */
  double peak_turn_deg, peak_turn_s; /* the turn that came nearest to its balance, or the greatest,
                                        counter-clockwise; and when */
  bool has_balance_turn;             /* of straight edges and weight alone: */
  double balance_turn_deg;           /* the turn to that side at which its centroid is over the
                                        outermost contact of its start */
  double peak_over_balance;          /* the peak as a share of that, not below 0 */
} tp_tilt_case;

/* The shaking of the base along one axis. */
typedef struct tp_tilt_shaking {
  bool given;               /* by the scene */
  double peak_m_s2;         /* if given: PGA */
  double peak_velocity_m_s; /* if given: PGV */
  double last_velocity_m_s; /* if given: what its baseline leaves at the end */
  double duration_s;        /* if given: of the shaking */
} tp_tilt_shaking;

/* The result of a test. */
typedef struct tp_tilt_test {
  size_t size;                /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;     /* of the scene; NULL: none */
  const char *length_unit;    /* of the scene; a static string */
  double metres_per_unit;     /* of it */
  tp_tilt_settings settings;  /* by which it was run */
  tp_tilt_shaking shaking[2]; /* horizontal, vertical */
  size_t case_count;          /* of the cases */
  tp_tilt_case *cases;        /* a direction each */
  tp_notes notes;             /* beside the answer */
} tp_tilt_test;

/* Run the test that the scene calls for by tilt_test or shaking; bad input where it calls for none.
 * `*test` is the caller's, to be freed by tp_tilt_test_free. TP_NO_ANSWER where the block does not
 * fit its base. The same scene gives the same numbers each time, but for seconds. */
TP_MUST_USE tp_status tp_tilt_test_run(tp_tilt_test **test, const tp_scene *scene,
                                       const tp_tilt_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_tilt_test_free(tp_tilt_test *test);

/* Reports, as `topple tilt` prints them: the page; JSON (docs/json.md); the moments as CSV. Of each
 * `*text` is allocated with malloc and is the caller's to free; UTF-8, ended by a line end. */
TP_MUST_USE tp_status tp_report_tilt(char **text, const tp_tilt_test *test);
TP_MUST_USE tp_status tp_report_tilt_json(char **text, const tp_tilt_test *test);
TP_MUST_USE tp_status tp_report_tilt_csv(char **text, const tp_tilt_test *test);

/* Drawings of the block on its table, as SVG: some frames side by side, and one that moves. */
TP_MUST_USE tp_status tp_report_tilt_frames(char **text, const tp_tilt_test *test);
TP_MUST_USE tp_status tp_report_tilt_animation(char **text, const tp_tilt_test *test);

/* The same into the file `path`, which appears whole or not at all: frames as .svg; or where
 * `moving` the one that moves, as .svg, or as .webm or .gif, made by gnuplot and ffmpeg.
 * TP_SYSTEM_FAILED where one of these is not installed or fails, or the file cannot be written;
 * TP_NO_ANSWER where there is nothing to draw. */
TP_MUST_USE tp_status tp_report_tilt_file(const char *path, const tp_tilt_test *test, bool moving,
                                          tp_message *message);

/* Charts of it, to be freed by tp_chart_free, written by tp_report_chart_file (topple_chart.h). The
 * reactions of the facets, normal and along each, against the tilt up to where the block begins to
 * move; where the table stands still against time. And the phase portraits of what moves: turn
 * against angular velocity, displacement of the centroid along the base against its speed.
 * TP_NO_ANSWER where there is none to draw: nothing moves, or no reaction is known. */
TP_MUST_USE tp_status tp_chart_tilt_reactions(tp_chart **chart, const tp_tilt_test *test,
                                              tp_message *message);
TP_MUST_USE tp_status tp_chart_tilt_phase(tp_chart **chart, const tp_tilt_test *test,
                                          tp_message *message);

/* The frequencies of an overturning spectrum, evenly on a logarithmic axis. */
typedef struct tp_overturning_options {
  size_t size; /* of this struct, as `…_default()` has it */
  double from,
      to;           /* of a pulse its frequency in hertz, of a record how many times as fast as it
                       was recorded; above 0, from < to; both 0: an eighth to eight times the scene's */
  size_t count;     /* of them, 2 to 200 */
  double tolerance; /* of brackets, as a share; 1e-6 to 0.1 */
  bool (*stop)(void *context); /* asked now and then, or NULL: true ends with what is known */
  void (*progress)(void *context, size_t done, size_t of); /* after each frequency, or NULL */
  void *context;                                           /* of both */
} tp_overturning_options;

/* The defaults: 25 frequencies, brackets of 1e-3; nothing stops it. `size` is that of the struct as
 * the caller knows it. */
void tp_overturning_options_init(tp_overturning_options *options, size_t size);
static inline tp_overturning_options tp_overturning_options_default(void) {
  tp_overturning_options options;
  tp_overturning_options_init(&options, sizeof options);
  return options;
}

/* The overturning spectrum of a scene whose base shakes horizontally: the least shaking of its form
 * found that overturns the block, or throws it off its base, at one frequency after the other, as
 * PGA against frequency and against PGV; each between two runs, one spared and one overturned. PGA
 * are tried from 1/64 to 64 g upwards by 2^(1/8), and for two octaves beyond the first that
 * overturns it: where stronger shaking spares it again, that stretch is on the chart as an island.
 * To be freed by tp_chart_free. TP_NO_ANSWER where no shaking that was tried overturns it;
 * TP_UNDECIDED where it was stopped before anything was known. */
TP_MUST_USE tp_status tp_chart_overturning(tp_chart **chart, const tp_scene *scene,
                                           const tp_overturning_options *options,
                                           tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
