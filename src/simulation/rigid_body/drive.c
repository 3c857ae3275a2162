/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tilt at a time, the force of gravity, shaking and loads in the frame of the base, and the next
 * time at which one of these has a kink. */

#include "rigid_body/drive.h"

#include <math.h>

/* The table may be tilted to either side of its angle at the start. */
static double stops_after(const tp_drive *drive) {
  return drive->speed == 0 ? 0 : fmax(0, (drive->final_angle - drive->angle) / drive->speed);
}

double tp_drive_angle(const tp_drive *drive, double time_s) {
  if (drive->speed == 0) return drive->angle;
  return time_s >= stops_after(drive) ? drive->final_angle : drive->angle + drive->speed * time_s;
}

/* The sum of a load over the functions of the tilt. */
static double at_tilt(const double of[TP_BASIS], double sine, double cosine) {
  return of[TP_COS] * cosine + of[TP_SIN] * sine + of[TP_ONE] +
         (of[TP_SEC] + of[TP_SEC2] / cosine) / cosine;
}

tp_body_force tp_drive_force(const tp_drive *drive, const tp_rigid_body *body, double time_s) {
  const double angle = tp_drive_angle(drive, time_s);
  const double sine = sin(angle), cosine = cos(angle);
  /* of the x axis over the horizontal: a table that goes down to the left rises to the right */
  const double rise = body->towards == TP_TOWARDS_LEFT ? sine : -sine;
  double along_m_s2 = 0, up_m_s2 = TP_GRAVITY_M_S2;
  if (drive->shaking != NULL) {
    drive->shaking->acceleration(&along_m_s2, &up_m_s2, drive->shaking, time_s);
    up_m_s2 += TP_GRAVITY_M_S2;
  }
  tp_body_force force = {.x_n = -body->mass_kg * (cosine * along_m_s2 + rise * up_m_s2),
                         .y_n = -body->mass_kg * (cosine * up_m_s2 - rise * along_m_s2)};
  if (body->loads.given) {
    force.x_n += at_tilt(body->loads.x_n, sine, cosine);
    force.y_n += at_tilt(body->loads.y_n, sine, cosine);
    force.moment_nm = at_tilt(body->loads.moment_nm, sine, cosine);
  }
  return force;
}

double tp_drive_next_kink(const tp_drive *drive, double time_s) {
  double next = INFINITY;
  const double stop = stops_after(drive);
  if (stop > time_s) next = stop;
  if (drive->shaking != NULL) {
    next = fmin(next, drive->shaking->next_kink(drive->shaking, time_s));
  }
  return next;
}
