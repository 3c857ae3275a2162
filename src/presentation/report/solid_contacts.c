/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a solid does on contacts with friction, as text. */

#include "number/shortest.h"
#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <math.h>

enum { TILT = TP_SOLID_TILT_DIGITS, CONTACTS = 20 };

static void add_point(tp_text *t, const double point[3]) {
  tp_text_add(t, "(%.6g, %.6g, %.6g)", point[0], point[1], point[2]);
}

void tp_text_solid_motion(tp_text *t, const tp_solid_motion *m) {
  if (!m->turns) {
    tp_text_add(t, "%s along ", tp_mechanism_name(m->mechanism));
    add_point(t, m->axis);
    return;
  }
  tp_text_add(t, "%s about the axis along ", tp_mechanism_name(m->mechanism));
  add_point(t, m->axis);
  tp_text_add(t, " through ");
  add_point(t, m->at);
  tp_text_add(t, ", %.3g m along it a radian", m->pitch_m);
}

tp_contact_shares tp_solid_contact_shares(const tp_solid_contact *c) {
  const double *f = c->force, *n = c->normal;
  const double on = f[0] * n[0] + f[1] * n[1] + f[2] * n[2];
  const double all = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
  return (tp_contact_shares){on, sqrt(fmax(0, (all - on) * (all + on)))};
}

static void add_contact(tp_text *t, const tp_solid_contact *c, size_t number, bool held) {
  tp_text_add(t, "  %5zu  (%9.6g, %9.6g, %9.6g)  (%8.5f, %8.5f, %8.5f)  %7.4g°", number, c->at[0],
              c->at[1], c->at[2], c->normal[0], c->normal[1], c->normal[2], c->friction_angle_deg);
  if (held) {
    const tp_contact_shares shares = tp_solid_contact_shares(c);
    tp_text_add(t, " %10.4f %10.4f", shares.across, shares.along);
  }
  tp_text_add(t, "\n");
}

bool tp_solid_is_held(const tp_solid_contacts *c) {
  return c->verdict == TP_STANDS || c->verdict == TP_MAY_MOVE;
}

static void add_contacts(tp_text *t, const tp_solid_contacts *c) {
  const bool held = tp_solid_is_held(c);
  tp_text_add(t, "\n%zu contact%s%s\n", c->contact_count, c->contact_count == 1 ? "" : "s",
              held ? ", with one of the systems of forces that hold it, in shares of its weight"
                   : "");
  tp_text_add(t, "  %5s  %-33s  %-30s  %8s%s\n", "", "at", "normal into the rock", "friction",
              held ? "     normal      shear" : "");
  for (size_t k = 0; k < c->contact_count && k < CONTACTS; k++) {
    add_contact(t, c->contacts + k, k + 1, held);
  }
  if (c->contact_count > CONTACTS) {
    tp_text_add(t, "  and %zu more, which --json has\n", c->contact_count - CONTACTS);
  }
}

/* What forces hold, whether or not a motion can begin. */
static void add_upper_bounds(tp_text *t, const tp_solid_contacts *c) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  forces hold it up to these multiples, upper bounds of the factor of safety:\n");
  tp_text_add(t, "    %s what tan φ of all contacts may be divided by until no forces hold it\n",
              c->has_fos_friction ? tp_text_significant_down(n, c->fos_friction, TILT) : "none:");
  tp_text_add(t,
              "    %s what drives it along its base may be multiplied by, weight and earthquake\n",
              c->has_fos_driving       ? tp_text_significant_down(n, c->fos_driving, TILT)
              : c->fos_driving_is_open ? "undecided:"
                                       : "none:");
}

static void add_outlook(tp_text *t, const tp_solid_contacts *c) {
  const char *where = c->is_in_section ? " within the section of its contacts" : "";
  switch (c->safety.states->motion) {
  case TP_SOLID_STANDS:
    tp_text_add(t, "  stands: no motion can begin%s\n", where);
    break;
  case TP_SOLID_CAN_MOVE:
    tp_text_add(t, "  may move: a motion can begin all the same, proven\n");
    break;
  case TP_SOLID_OPEN:
    tp_text_add(t, "  whether a motion can begin all the same is not decided\n");
    break;
  case TP_SOLID_COLLAPSES:
    break;
  }
}

static const char *definition_of(const tp_solid_safety *own) {
  if (own->fos.state != TP_FOS_NUMBER || !own->has_factor) return "";
  return own->factor.definition == TP_FOS_BY_DRIVING ? ", on driving loads"
                                                     : ", by strength reduction";
}

static void add_safety(tp_text *t, const tp_solid_safety *own) {
  if (own->fos.state == TP_FOS_NO_OVERTURNING) {
    tp_text_add(t, "  no factor of safety: nothing moves it\n");
    return;
  }
  tp_text_add(t, "  factor of safety ");
  tp_text_solid_factor(t, own, TILT);
  tp_text_add(t, "%s", definition_of(own));
  if (own->has_factor && own->factor.mechanism != TP_MECHANISM_UNDECIDED) {
    tp_text_add(t, ": then it %s", tp_mechanism_name(own->factor.mechanism));
  }
  if (own->states[own->governing].is_static) tp_text_add(t, ", without its earthquake");
  if (own->states[own->governing].has_mean_normals) {
    tp_text_add(t, ", with the mean of all normals");
  }
  tp_text_add(t, "\n");
}

static void add_verdict(tp_text *t, const tp_solid *s) {
  const tp_solid_contacts *c = &s->contacts;
  if (tp_solid_is_held(c)) {
    tp_text_add(t, "  can stand: forces within all cones of friction hold it\n");
    add_outlook(t, c);
  } else if (c->has_motion) {
    tp_text_add(t, "  certainly moves, for no forces hold it:\n  it ");
    tp_text_solid_motion(t, &c->motion);
    tp_text_add(t, "\n");
  } else {
    tp_text_add(t, "  undecided: too close to tell\n");
  }
  add_safety(t, tp_solid_safety_of(s));
  if (c->has_fos_friction || c->has_fos_driving) add_upper_bounds(t, c);
}

static void add_onset(tp_text *t, const tp_solid_contacts *c) {
  char n[TP_NUMBER_SIZE];
  if (c->has_certain) {
    const tp_bounded least = {.value = c->certain_to_stand_deg};
    tp_text_add(t, "  no motion can begin up to a tilt of %s°, proven, and perhaps beyond\n",
                tp_text_significant_down(n, least, TILT));
  }
  if (!c->has_onset) return;
  tp_text_add(t, "  a motion can begin from a tilt of %s° ± %.1e° on\n",
              tp_text_significant(n, c->onset_deg, TILT), c->onset_deg.error);
}

static void add_critical(tp_text *t, const tp_solid *s) {
  const tp_solid_contacts *c = &s->contacts;
  char tilt[TP_NUMBER_SIZE], azimuth[TP_NUMBER_SIZE];
  if (!c->has_critical) {
    tp_text_add(t, !c->is_held_level ? "  level, no forces are proven to hold it\n"
                                     : "  no tilt below 90° is proven to move it\n");
    return;
  }
  tp_text_add(t, "  forces hold it up to a tilt of %s° ± %.1e° towards %s%s°;\n  then it ",
              tp_text_significant(tilt, c->critical_deg, TILT), c->critical_deg.error,
              s->has_tilt_azimuth ? "" : "the worst azimuth, ",
              tp_text_fixed(azimuth, c->critical_azimuth_deg, 3));
  tp_text_solid_motion(t, &c->critical);
  tp_text_add(t, "\n");
}

static void add_acceleration(tp_text *t, const tp_solid *s) {
  const tp_solid_contacts *c = &s->contacts;
  char own[TP_NUMBER_SIZE], azimuth[TP_NUMBER_SIZE];
  if (!c->has_acceleration) return;
  tp_text_add(
      t,
      "  at its tilt they hold it up to a horizontal acceleration of %s g ± %.1e g, towards "
      "%s°;\n  then it ",
      tp_text_significant(own, c->acceleration_g, TILT), c->acceleration_g.error,
      tp_text_fixed(azimuth, c->acceleration_azimuth_deg, 3));
  tp_text_solid_motion(t, &c->acceleration);
  tp_text_add(t, "\n");
  if (c->has_acceleration_ahead) {
    tp_text_add(t, "  towards %.6g°, where the earthquake acts, up to %s g ± %.1e g\n",
                s->seismic_azimuth_deg, tp_text_significant(own, c->acceleration_ahead_g, TILT),
                c->acceleration_ahead_g.error);
  }
  if (c->has_onset_acceleration) {
    tp_text_add(t, "  a motion can begin from %s g ± %.1e g on, towards where %s acts\n",
                tp_text_significant(own, c->onset_acceleration_g, TILT),
                c->onset_acceleration_g.error,
                s->has_seismic_azimuth ? "the earthquake" : "the tilt");
  }
}

static void add_ways(tp_text *t, const tp_solid_contacts *c) {
  enum { COLUMNS = 8 };
  if (c->way_count == 0) return;
  const size_t step = (c->way_count + COLUMNS - 1) / COLUMNS;
  tp_text_add(t, "\nTilt up to which forces hold it towards an azimuth; --json has all %zu\n",
              c->way_count);
  for (int row = 0; row < 2; row++) {
    tp_text_add(t, " ");
    for (size_t k = 0; k < c->way_count; k += step) {
      const tp_solid_way *own = c->ways + k;
      char n[TP_NUMBER_SIZE];
      if (row == 0) {
        tp_text_add(t, " %9.4g°", own->azimuth_deg);
      } else if (own->has_critical) {
        tp_text_add(t, " %9s°", tp_text_fixed(n, own->critical_deg, 4));
      } else {
        tp_text_add(t, " %10s", own->mechanism == TP_INTERLOCKED ? "any" : "?");
      }
    }
    tp_text_add(t, "\n");
  }
}

void tp_text_solid_contacts(tp_text *t, const tp_solid *s) {
  if (!s->has_contacts) return;
  tp_text_solid_ground(t, s);
  tp_text_solid_loads(t, s);
  add_verdict(t, s);
  add_onset(t, &s->contacts);
  add_critical(t, s);
  add_acceleration(t, s);
  tp_text_solid_required(t, s);
  if (s->contacts.verdict == TP_MAY_MOVE) {
    tp_text_add(t,
                "  Contacts that face different ways can be wedged by forces that nothing has put "
                "there, and a shock can free\n  them; on a point or a line it is balanced at "
                "best.\n");
  }
  add_contacts(t, &s->contacts);
  add_ways(t, &s->contacts);
}
