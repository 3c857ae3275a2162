/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How rough is a profile: docs/profile.md has every number with its formula. Included by
 * topple.h.
 *
 * Lengths are in the profile's length unit. A profile is a chain of points from left to right, with
 * one height at each x, straight in between; x lies along the mean plane and y rises from it. A
 * tp_bounded has a proven bound, from the coordinates on (from the resampled ones by a spline,
 * whose course between the points is a choice); what is estimated from one sample of a rough
 * surface has none, and comes with the range that its spread gives. */

#ifndef TOPPLE_PROFILE_H
#define TOPPLE_PROFILE_H

#include "topple_scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Between the points: straight, or a natural cubic spline. */
typedef enum tp_profile_resampling { TP_RESAMPLE_LINEAR, TP_RESAMPLE_SPLINE } tp_profile_resampling;

/* The line that is taken off all heights: none, the one of least squares, or through both ends; or
 * the profile is turned onto its mean plane, before anything else but the scale. */
typedef enum tp_profile_detrend {
  TP_DETREND_NONE,
  TP_DETREND_LINE,
  TP_DETREND_ENDS,
  TP_DETREND_TURN
} tp_profile_detrend;

/* Of the spectrum. */
typedef enum tp_profile_window { TP_WINDOW_HANN, TP_WINDOW_NONE } tp_profile_window;

/* How a profile is sampled, and what JRC by Eq. (10) rests on. */
typedef struct tp_profile_options {
  size_t size;                      /* of this struct, as `…_default()` has it */
  double step;                      /* 0: the points as they are; else resampled at this distance */
  tp_profile_resampling resampling; /* between the points, where there is a step */
  tp_profile_detrend detrend;       /* the line to take off, or to turn it onto */
  tp_profile_window window;         /* of the spectrum */
  bool mirrored;                    /* left and right exchanged */
  double scale;                     /* by which all lengths are multiplied before anything else */
  double jcs_mpa, normal_stress_kpa; /* for Eq. (10); 0: not given */
} tp_profile_options;

/* The points as they are, no line taken off, a Hann window, scale 1; `size` is the caller's. */
void tp_profile_options_init(tp_profile_options *options, size_t size);
static inline tp_profile_options tp_profile_options_default(void) {
  tp_profile_options options;
  tp_profile_options_init(&options, sizeof options);
  return options;
}

/* linear or spline; none, line, ends or turn; hann or none. False for another name. */
bool tp_profile_resampling_read(tp_profile_resampling *resampling, const char *name);
const char *tp_profile_resampling_name(tp_profile_resampling resampling);
bool tp_profile_detrend_read(tp_profile_detrend *detrend, const char *name);
const char *tp_profile_detrend_name(tp_profile_detrend detrend);
bool tp_profile_window_read(tp_profile_window *window, const char *name);
const char *tp_profile_window_name(tp_profile_window window);

/* An estimate from one sample, with the range of 95 % where its spread is known. */
typedef struct tp_profile_estimate {
  bool found;       /* else there is none */
  bool has_range;   /* else its spread is not known */
  double value;     /* if found: the estimate */
  double low, high; /* if has_range: the range */
} tp_profile_estimate;

/* The facets that face a block sliding to one side: those that it must climb. */
typedef struct tp_profile_facing {
  size_t facets;           /* their number */
  tp_bounded share;        /* of the length along the profile */
  tp_bounded angle_deg;    /* i of these: atan of their rise over their run */
  tp_bounded steepest_deg; /* theta*max */
  double exponent;         /* C of (share)(1 - theta / theta*max)^C, by least squares */
  double fit_rms;          /* of what that leaves, a share */
  double roughness_deg;    /* theta*max / (C + 1); 0 where no facet faces that side */
} tp_profile_facing;

/* At one distance: the mean square of the difference of two heights (the structure function), and
 * their autocorrelation, of so many pairs of points. */
typedef struct tp_profile_lag {
  double distance;    /* along x */
  double structure;   /* the mean square */
  double correlation; /* 1 for heights that agree */
  size_t pairs;       /* that there are */
} tp_profile_lag;

/* One-sided power spectral density, length^3, at a frequency in cycles per length. */
typedef struct tp_profile_density {
  double frequency; /* of the wave */
  double density;   /* its mean square height, per frequency */
} tp_profile_density;

/* Why there is no autocorrelation, structure function and spectrum. */
typedef enum tp_profile_series {
  TP_SERIES_GIVEN,
  TP_SERIES_UNEVEN, /* points at uneven distances: a step is to be given */
  TP_SERIES_SHORT   /* fewer points than TP_PROFILE_SERIES_LEAST */
} tp_profile_series;

/* Points that a series of heights takes at least. */
enum { TP_PROFILE_SERIES_LEAST = 16 };

/* Is a correlation meant for this profile? The first reason why not. */
typedef enum tp_jrc_state {
  TP_JRC_MEANT,
  TP_JRC_OTHER_STEP,   /* than the one that it was fitted at */
  TP_JRC_OTHER_LENGTH, /* of the profile than those that it was fitted to */
  TP_JRC_OFF_SCALE,    /* a JRC beyond those that it was fitted to */
  TP_JRC_NO_NUMBER     /* the logarithm of nothing */
} tp_jrc_state;

/* JRC by one correlation; the texts are static. */
typedef struct tp_profile_jrc {
  const char *source;         /* and year, or the equation of Alejano et al. */
  const char *equation;       /* as text */
  const char *meant_for_step; /* that it is meant for, as text; empty: any */
  double own_step;            /* at which its input was measured: 0, the profile's points */
  tp_bounded input;           /* Z2, A, A/L or theta*max / (C + 1) in degrees */
  tp_bounded jrc;             /* its value */
  tp_jrc_state state;         /* is it meant for the profile? */
} tp_profile_jrc;

/* As reports have it: "meant for it"; "unknown" where it is none. */
const char *tp_jrc_state_name(tp_jrc_state state);

/* What a profile was taken from. */
typedef enum tp_profile_origin {
  TP_PROFILE_POINTS,
  TP_PROFILE_FILE,
  TP_PROFILE_BASE,      /* the scene's base profile */
  TP_PROFILE_MATED_BASE /* the part of the block's underside that its mated base touches */
} tp_profile_origin;

/* How rough a profile is; owns what it points to. */
typedef struct tp_profile {
  size_t size;                /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *title;     /* of the scene, or the name of the file; NULL: of points */
  tp_profile_origin origin;   /* what it was taken from */
  const char *length_unit;    /* a static string */
  double metres_per_unit;     /* of that */
  tp_profile_options options; /* as they were taken */
  tp_notes notes;             /* on what was read, and on what it may be wrong with */
  size_t source_count;        /* of the sources */
  TP_OUTSIDE char **sources;  /* files that it was read from */

  size_t given_points; /* before resampling */
  size_t point_count;  /* of the profile that is measured: */
  double *x,
      *y; /* point_count of them: from its left end on; heights above the first point, detrended */
  bool even;                       /* the points lie at equal distances, but for a millionth */
  double step;                     /* mean distance along x */
  double least_step, largest_step; /* the least and the largest of them */

  tp_bounded length;       /* along x */
  tp_bounded length_along; /* along the profile */
  tp_bounded amplitude;    /* from the lowest to the highest point */
  tp_bounded rms_height;   /* about the mean height */
  tp_bounded trend_deg; /* of the line of least squares, before any is taken off; or by which it was
                           turned */
  tp_bounded mean_slope;          /* from end to end */
  tp_bounded mean_absolute_slope; /* mean of the slopes' sizes */
  tp_bounded z2;                  /* root mean square of the slope: Eq. (13) with its root */
  tp_bounded effective_angle_deg; /* i: atan of the mean size of the slope; Eq. (7) of teeth */
  tp_bounded rp;                  /* along / length */
  bool has_sf;                    /* the points are even */
  tp_bounded sf;                  /* structure function at the step */
  tp_profile_facing facing[2]; /* by tp_direction: of a block that slides to the left, the right */

  tp_profile_series series;               /* are there series of heights? */
  size_t lag_count;                       /* of the lags */
  tp_profile_lag *lags;                   /* 8 in a tenfold distance, up to half the length */
  tp_profile_estimate correlation_length; /* at which the autocorrelation has fallen to 1 / e */
  size_t density_count;                   /* of the densities */
  tp_profile_density *densities;          /* from frequency 0 on, evenly */
  tp_profile_estimate hurst_by_structure; /* Hurst exponent, by the structure function */
  tp_profile_estimate hurst_by_spectrum;  /* Hurst exponent, by the spectrum */
  double structure_fit[2];                /* the least and the largest distance of the first fit */
  double spectrum_fit[2];                 /* the least and the largest frequency of the second */

  size_t correlation_count;     /* of the correlations */
  tp_profile_jrc *correlations; /* each of them */
  size_t jrc_meant;             /* so many are meant for this profile: */
  tp_bounded jrc_low, jrc_high; /* if jrc_meant > 0: the least and the largest JRC by these */
  tp_bounded jrc_median;        /* if jrc_meant > 0: and their median */
  bool has_eq_10;               /* JCS and a normal stress are known: */
  double jcs_mpa;               /* if has_eq_10: joint wall compressive strength */
  double normal_stress_kpa;     /* if has_eq_10: across the contact */
  tp_bounded jrc_eq_10;         /* if has_eq_10: i / log10(JCS / normal stress) */
} tp_profile;

/* The profile in a CSV file of x, y. `length_unit` is mm, cm, m, km, in or ft. */
TP_MUST_USE tp_status tp_profile_of_file(tp_profile **profile, const char *path,
                                         const char *length_unit, const tp_profile_options *options,
                                         tp_message *message);

/* The profile through points from memory. */
TP_MUST_USE tp_status tp_profile_of_points(tp_profile **profile, tp_coordinates points,
                                           const char *length_unit,
                                           const tp_profile_options *options, tp_message *message);

/* The base of a scene: its profile, or of a mated base the part that the block touches. Where JCS
 * is known, by the options or by Barton's law in the scene, but no normal stress, Eq. (10) has the
 * block's weight on the contact's area on the mean plane, at the scene's tilt where it gives one.
 */
TP_MUST_USE tp_status tp_profile_of_scene(tp_profile **profile, const tp_scene *scene,
                                          const tp_profile_options *options, tp_message *message);

/* NULL is allowed. */
void tp_profile_free(tp_profile *profile);

/* A page; JSON (docs/json.md), with every facet, lag and ordinate of the spectrum where
 * `all`; CSV, a row for every facet. */
TP_MUST_USE tp_status tp_report_profile(char **text, const tp_profile *profile);
TP_MUST_USE tp_status tp_report_profile_json(char **text, const tp_profile *profile, bool all);
TP_MUST_USE tp_status tp_report_profile_csv(char **text, const tp_profile *profile);

/* The profile, its facets coloured by slope; its structure function; its spectrum; the rose of its
 * slopes (topple_chart.h). */
TP_MUST_USE tp_status tp_chart_profile(tp_chart **chart, const tp_profile *profile,
                                       tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
