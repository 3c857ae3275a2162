/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One function a rule: ranges, angles, counts, Patton's sum below 90 degrees, Barton's parameters
 * (Eqs. (8) to (10)), combinations of base, joint, friction and loads. */

#include "scene/check.h"

#include "scene/anchor.h"
#include "scene/check_tilt_test.h"

#include "common/budget.h"
#include "common/outside.h"
#include "number/ratio.h"

tp_status tp_check_range(const fmpq_t value, const char *name, tp_place place,
                         tp_message *message) {
  const double size = fmpq_get_d(value);
  if (fmpq_is_zero(value) ||
      (size <= 1e308 && size >= -1e308 && (size >= 1e-308 || size <= -1e-308))) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_RANGE, place, "%s is outside the range of 1e-308 to 1e308",
                   tp_quote_all(name).text);
}

static tp_status check_angle(bool excluded, const fmpq_t angle, const char *name, tp_place place,
                             tp_message *message) {
  const int side = fmpq_cmp_ui(angle, 90);
  if (fmpq_sgn(angle) >= 0 && (side < 0 || (side == 0 && !excluded))) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place, "%s must lie in [0°, 90°%s", name,
                   excluded ? ")" : "]");
}

static tp_status check_above_zero(const fmpq_t value, const char *name, tp_place place,
                                  tp_message *message) {
  if (fmpq_sgn(value) > 0) return TP_OK;
  char text[80];
  tp_ratio_text(text, sizeof text, value);
  return tp_refuse(message, TP_FAULT_RANGE, place, "%s must be above zero, not %s", name, text);
}

tp_status tp_check_rule(tp_rule rule, const fmpq_t value, const char *name, tp_place place,
                        tp_message *message) {
  const int sign = fmpq_sgn(value);
  switch (rule) {
  case TP_RULE_ANY:
    return TP_OK;
  case TP_RULE_ABOVE_ZERO:
    return check_above_zero(value, name, place, message);
  case TP_RULE_NOT_NEGATIVE:
    if (sign >= 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must not be negative", name);
  case TP_RULE_ANGLE_BELOW_90:
    return check_angle(true, value, name, place, message);
  case TP_RULE_ANGLE_TO_90:
    return check_angle(false, value, name, place, message);
  case TP_RULE_AZIMUTH:
    if (sign >= 0 && fmpq_cmp_ui(value, 360) <= 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must lie in [0, 360]", name);
  case TP_RULE_JRC:
    if (sign >= 0 && fmpq_cmp_ui(value, 100) <= 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must lie in [0, 100]", name);
  case TP_RULE_UNIT_WEIGHT:
    if (sign > 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must be above zero; a void is a hole",
                     name);
  case TP_RULE_BEYOND:
    if (sign >= 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_GEOMETRY, place,
                     "the base cannot end inside the block here; to let only a part of the "
                     "underside rest on it, say 'between' or give a 'profile'");
  case TP_RULE_SHARE:
    if (sign >= 0 && fmpq_cmp_ui(value, 1) <= 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must lie in [0, 1]", name);
  case TP_RULE_DIP:
    if (fmpq_cmp_si(value, -90) >= 0 && fmpq_cmp_si(value, 90) <= 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "%s must lie in [-90°, 90°], above 0 down into the rock", name);
  case TP_RULE_COUNT:
    if (fmpz_is_one(fmpq_denref(value)) && sign > 0 && fmpq_cmp_si(value, TP_BUDGET_ROWS) <= 0) {
      return TP_OK;
    }
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must be a whole number from 1 to %d", name,
                     TP_BUDGET_ROWS);
  case TP_RULE_BULGE:
    if (sign != 0) return TP_OK;
    return tp_refuse(message, TP_FAULT_GEOMETRY, place,
                     "a bulge of 0 is a straight edge; leave the arc out");
  }
  return TP_OK;
}

tp_status tp_check_tooth_count(long *count, const fmpq_t value, const char *what, tp_place place,
                               tp_message *message) {
  char text[80];
  tp_ratio_text(text, sizeof text, value);
  if (!fmpz_is_one(fmpq_denref(value)) || fmpq_sgn(value) <= 0) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "%s must be a whole number of teeth, at least 1; it is %s", what, text);
  }
  if (fmpz_cmp_si(fmpq_numref(value), TP_BUDGET_TEETH) > 0) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "%s is %s; at most 500 000 teeth are taken, two points each: take fewer, or "
                     "give the points in a file",
                     what, text);
  }
  *count = fmpz_get_si(fmpq_numref(value));
  return TP_OK;
}

tp_status tp_check_amplitude(const fmpq_t height, tp_place place, tp_message *message) {
  if (fmpq_sgn(height) > 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place,
                   "the amplitude must be less than twice mean_height");
}

tp_status tp_check_flat(const fmpq_t flat, const fmpq_t width, tp_place place,
                        tp_message *message) {
  if (fmpq_cmp(flat, width) < 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place, "the flat must be narrower than the ellipse");
}

tp_status tp_check_mean_plane(const tp_polyline *plane, tp_place place, tp_message *message) {
  if (fmpq_cmp(plane->x, plane->x + 1) < 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place,
                   "the mean plane runs from left to right: its second point must lie right of the "
                   "first");
}

tp_status tp_check_patton(const fmpq_t sum, tp_place place, tp_message *message) {
  if (fmpq_cmp_ui(sum, 90) < 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place,
                   "basic_angle_deg + roughness_angle_deg must lie below 90°");
}

/* Eq. (9) divides by log10(JCS / sigma): a test at JCS has no answer, one above it a negative JRC.
 */
tp_status tp_check_tilt_test(const fmpq_t angle_deg, const fmpq_t stress_kpa,
                             const fmpq_t residual_deg, const fmpq_t jcs_mpa, tp_place place,
                             tp_message *message) {
  if (fmpq_cmp(angle_deg, residual_deg) < 0) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "a tilt test slides at residual_angle_deg or above");
  }
  fmpq_t strength_kpa;
  fmpq_init(strength_kpa);
  fmpq_mul_ui(strength_kpa, jcs_mpa, 1000);
  const bool below = fmpq_cmp(stress_kpa, strength_kpa) < 0;
  fmpq_clear(strength_kpa);
  if (below) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, place,
                   "the normal stress of a tilt test must be below jcs_mpa");
}

tp_status tp_check_facet_number(long *number, const fmpq_t value, tp_place place,
                                tp_message *message) {
  enum { MOST_FACETS = 1000000000 };
  if (fmpz_is_one(fmpq_denref(value)) && fmpq_sgn(value) > 0 &&
      fmpz_cmp_si(fmpq_numref(value), MOST_FACETS) <= 0) {
    *number = fmpz_get_si(fmpq_numref(value));
    return TP_OK;
  }
  char text[80];
  tp_ratio_text(text, sizeof text, value);
  return tp_refuse(
      message, TP_FAULT_RANGE, place,
      "facets of the base are counted from 1, from left to right, up to %d; there is no "
      "facet %s",
      MOST_FACETS, text);
}

tp_status tp_check_facet_range(const tp_facet_friction_description *facets, tp_message *message) {
  if (facets->x0.given && fmpq_cmp(facets->x0.value, facets->x1.value) >= 0) {
    return tp_refuse(message, TP_FAULT_RANGE, facets->place,
                     "the x of facets run from left to right: the second must be the larger");
  }
  if (!facets->x0.given && facets->first > facets->last) {
    return tp_refuse(message, TP_FAULT_RANGE, facets->place,
                     "facets are counted from left to right: the first of them comes before the "
                     "last");
  }
  return TP_OK;
}

tp_status tp_check_parts_weighed(const tp_scene *scene, tp_place place, tp_message *message) {
  if (scene->block.unit_weight_kn_m3.given) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "parts of another density need the block's 'unit_weight_kn_m3' too");
}

tp_status tp_check_one_block(const tp_block_description *block, tp_message *message) {
  if (block->form == TP_OUTLINE_OF_SOLID) {
    return tp_refuse(message, TP_FAULT_KEY, block->place,
                     "this scene is of a solid, which 'topple solve', 'topple sweep' and 'topple "
                     "study' take, without options of one block in a section");
  }
  if (block->form != TP_OUTLINE_OF_EACH) return TP_OK;
  return tp_refuse(
      message, TP_FAULT_KEY, block->place,
      "this scene has many blocks, which 'topple solve', 'sweep', 'study' and 'chart map' "
      "take, without options of one block; all else is of one");
}

tp_status tp_check_loads_weighed(const tp_scene *scene, tp_place place, tp_message *message) {
  if (scene->block.unit_weight_kn_m3.given || scene->many.count > 0 ||
      scene->solid.place.file != NULL) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "loads are weighed against the block: give its 'unit_weight_kn_m3'");
}

tp_status tp_check_law_weighed(const tp_scene *scene, tp_place place, tp_message *message) {
  if (scene->block.unit_weight_kn_m3.given) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "the law barton depends on the normal stress: give the block its "
                   "unit_weight_kn_m3");
}

tp_status tp_check_contact_width(const tp_scene *scene, tp_message *message) {
  const tp_quantity *width = &scene->friction.contact_width;
  if (!width->given || scene->friction.load_dependent) return TP_OK;
  return tp_refuse(
      message, TP_FAULT_KEY, width->place,
      "a width of the contact is for the law barton, which takes the mean normal stress "
      "on it; no other friction depends on it");
}

tp_status tp_check_facet_friction(const tp_scene *scene, tp_place place, tp_message *message) {
  if (!scene->friction_angle_deg.given) {
    return tp_refuse(
        message, TP_FAULT_KEY, place,
        "some facets have a separate friction angle: give the friction_angle_deg of all "
        "others too");
  }
  if (!scene->friction.load_dependent) return TP_OK;
  return tp_refuse(
      message, TP_FAULT_KEY, place,
      "the law barton is for the contact as a whole, by its mean normal stress; facets "
      "with a separate friction angle go with friction_angle_deg, or with the law "
      "patton");
}

tp_status tp_check_arcs_on_outline(const tp_scene *scene, tp_place place, tp_message *message) {
  if (scene->block.form == TP_OUTLINE_VERTICES) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place, "arcs belong to an 'outline' of vertices");
}

tp_status tp_check_repair(const tp_scene *scene, tp_place place, tp_message *message) {
  if (!scene->block.repair || scene->block.arc_count == 0) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "an outline with arcs cannot be repaired; leave out 'repair' or the arcs");
}

tp_status tp_check_ellipse_plain(bool plain, tp_place place, tp_message *message) {
  if (plain) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "an ellipse takes no holes, parts, arcs or rounded corners");
}

tp_status tp_check_base_is_mated(const tp_scene *scene, const char *key, tp_place place,
                                 tp_message *message) {
  if (scene->base.mated) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "'%s' belongs to a mated base; a profile says itself where the base ends", key);
}

tp_status tp_check_base_not_whole(const tp_scene *scene, tp_place place, tp_message *message) {
  if (!scene->base.whole) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "'mated: whole' takes in all of the underside, and 'between' a part of it; "
                   "drop one of them");
}

tp_status tp_check_joint(const tp_scene *scene, tp_place place, tp_message *message) {
  const tp_base_description *base = &scene->base;
  const char *wrong = NULL;
  if (!base->mated) {
    wrong = "'joint' shifts a block along the mated base that it fits; on a 'profile' shift the "
            "block itself, with 'place: rest'";
  } else if (base->within.given) {
    wrong = "a shifted joint touches where it comes to rest, and 'contact: {within: …}' would move "
            "it there; for what is nearly closed say 'joint: {closure: …}'";
  } else if (base->all_poses) {
    wrong = "a shifted block is set down where the shift says, and 'place: all' asks for all other "
            "places: give its base as a 'profile' for that";
  } else if (base->rests_place.file != NULL && !base->rests) {
    wrong = "a shifted block is set down until it rests; leave out 'place: as_given'";
  } else if (base->shift.given == base->matching.given) {
    wrong = "'joint' needs one of 'shift', by how much the block is shifted along its base, and "
            "'matching', which share of it is closed after that";
  } else if (base->matching.given && !base->closure.given) {
    wrong = "'matching' needs a 'closure', up to which gap the joint counts as closed: straight "
            "edges that are shifted touch only in points, or leap from all to nothing";
  }
  return wrong == NULL ? TP_OK : tp_refuse(message, TP_FAULT_KEY, place, "%s", wrong);
}

tp_status tp_check_built(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  if (block->place.file == NULL) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){scene->path, 0, 0},
                     "the scene has no block; set its outline, slab, teeth or ellipse");
  }
  tp_status status = tp_check_built_alone(scene, message);
  if (status == TP_OK && block->form == TP_OUTLINE_ELLIPSE) {
    status = tp_check_ellipse_plain(block->hole_count == 0 && block->part_count == 0 &&
                                        block->arc_count == 0 && block->rounded.count == 0,
                                    block->place, message);
  }
  if (status == TP_OK && block->part_count > 0) {
    status =
        tp_check_parts_weighed(scene, tp_polyline_place(&block->parts[0].outline, -1), message);
  }
  if (status == TP_OK && block->arc_count > 0) {
    status = tp_check_arcs_on_outline(scene, block->arcs[0].place, message);
  }
  if (status == TP_OK) status = tp_check_repair(scene, block->repair_place, message);
  if (status == TP_OK && (tp_scene_is_shifted(scene) || scene->base.closure.given)) {
    const bool shifted = tp_scene_is_shifted(scene);
    status = tp_check_joint(
        scene, shifted ? tp_scene_shift_place(scene) : scene->base.closure.place, message);
  }
  if (status == TP_OK && scene->loads.place.file != NULL) {
    status = tp_check_loads_weighed(scene, scene->loads.place, message);
  }
  if (status == TP_OK) status = tp_check_water(scene, message);
  if (status == TP_OK) status = tp_anchors_check(scene, message);
  if (status == TP_OK && scene->friction.load_dependent) {
    status = tp_check_law_weighed(scene, scene->friction_angle_deg.place, message);
  }
  if (status == TP_OK) status = tp_check_contact_width(scene, message);
  if (status == TP_OK && scene->friction.facet_count > 0) {
    status = tp_check_facet_friction(scene, scene->friction.facets[0].place, message);
  }
  return status == TP_OK ? tp_check_simulation(scene, message) : status;
}
