/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the table does with time: its tilt, and the shaking of its base. Seen from the frame of the
 * base the block feels gravity less the acceleration of the base; what the turning of the table
 * itself adds (its speed squared times a length, 1e-6 of gravity at 20 degrees a minute and a
 * metre) is left out. */

#ifndef TP_RIGID_BODY_DRIVE_H
#define TP_RIGID_BODY_DRIVE_H

#include "rigid_body/body.h"

/* The acceleration of the base at a time: along the horizontal, positive in the direction that is
 * up-dip of a table tilted towards the left (+x of level ground), and vertical, up. */
typedef struct tp_base_motion tp_base_motion;
struct tp_base_motion {
  const void *data;
  void (*acceleration)(double *horizontal_m_s2, double *vertical_m_s2, const tp_base_motion *motion,
                       double time_s);
  /* The next time after `time_s` at which it is not smooth; INFINITY: none. */
  double (*next_kink)(const tp_base_motion *motion, double time_s);
};

typedef struct tp_drive {
  double angle;                  /* of the table at time 0, radians */
  double speed;                  /* of its tilting, rad/s; 0: it is held */
  double final_angle;            /* at which it stops */
  const tp_base_motion *shaking; /* NULL: none */
} tp_drive;

double tp_drive_angle(const tp_drive *drive, double time_s);

/* Force on the body and moment about its centroid but for contacts, in the frame of the base. */
typedef struct tp_body_force {
  double x_n, y_n, moment_nm;
} tp_body_force;
tp_body_force tp_drive_force(const tp_drive *drive, const tp_rigid_body *body, double time_s);

/* The next time at which the drive is not smooth; INFINITY: none. */
double tp_drive_next_kink(const tp_drive *drive, double time_s);

#endif
