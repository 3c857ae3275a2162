/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With the velocity u = (v_x - w y, v_y + w x) of a point it opens by n . u = t_x u_y - t_y u_x and
 * slips by t . u, and forces n +- f t do work n . u +- f t . u.
 *
 * Bound (e = 2^-53): with V = |v_x| + |v_y| + |w| far no velocity is larger, but for its error;
 * each is known to within the errors of v, of w times far, |w| off, and 4 e V of rounding. A
 * component of t has an error of e of itself, and two products and a sum of up to (|t_x| + |t_y|) V
 * add 2 e of that. All of it is within (|t_x| + |t_y|) (E + 7 e V) to first order; twice E and 16 e
 * V cover what is of second order and the rounding of the bound itself. Of the work of friction,
 * another 2 e (1 + f) V (|t_x| + |t_y|) is within the same. */

#include "case_filter/contact_rest.h"

/* What a velocity times a length of one may be off. */
static double bound_of(const tp_contact_rest *rest, const tp_near twist[3]) {
  static const double unit = 0x1p-53;
  const double turn = fabs(twist[2].value);
  const double most = fabs(twist[0].value) + fabs(twist[1].value) + turn * rest->far;
  const double error =
      twist[0].error + twist[1].error + twist[2].error * (rest->far + rest->off) + turn * rest->off;
  return 2 * error + 16 * unit * most;
}

bool tp_contact_rest_opens(const tp_contact_rest *rest, const tp_near twist[3]) {
  const double vx = twist[0].value, vy = twist[1].value, turn = twist[2].value;
  const double bound = bound_of(rest, twist);
  long closed = 0; /* no way out of the loop, for a compiler that takes several at once */
  for (int k = 0; k < rest->count; k++) {
    const double ux = vx - turn * rest->y[k], uy = vy + turn * rest->x[k];
    const double open = rest->tx[k] * uy - rest->ty[k] * ux;
    const double size = fabs(rest->tx[k]) + fabs(rest->ty[k]);
    closed |= open > bound * size ? 0 : 1;
  }
  return closed == 0;
}

bool tp_contact_rest_yields(const tp_contact_rest *rest, const tp_near twist[3], tp_near friction) {
  const double vx = twist[0].value, vy = twist[1].value, turn = twist[2].value;
  const double most = fabs(friction.value) + friction.error;
  const double bound = bound_of(rest, twist) * (1 + most);
  long resists = 0;
  for (int k = 0; k < rest->count; k++) {
    const double ux = vx - turn * rest->y[k], uy = vy + turn * rest->x[k];
    const double open = rest->tx[k] * uy - rest->ty[k] * ux;
    const double slip = rest->tx[k] * ux + rest->ty[k] * uy;
    const double size = fabs(rest->tx[k]) + fabs(rest->ty[k]);
    resists |= open - most * fabs(slip) > bound * size ? 0 : 1;
  }
  return resists == 0;
}
