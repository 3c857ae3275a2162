// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The forces with which the base holds the block at its static limit, in their friction cones, and what then begins. */

import { balancedBy } from "./balance.js";
import { element, table } from "./element.js";
import { certainText, degreesText, certainDigits } from "./certain.js";
import { lengthText, lengthUnit, pointText } from "./lengths.js";
import { cones } from "./friction_cones.js";
import { forcesFigure } from "./forces_figure.js";
import { Panel } from "./panel.js";
import { directionText } from "./words.js";
import { numeral, parts, say } from "../words/language.js";

export class ForcesPanel extends Panel {
  draw(solution) {
    this.body.replaceChildren(...solution.cases.map((each) => this.#direction(each, solution.outlines)));
  }

  #direction(theCase, outlines) {
    const { limit } = theCase;
    const heading = element("h3", {}, directionText(theCase, null));
    if (!limit?.reactions || limit.reactions.length === 0) {
      return element("section", {}, heading, element("p", {}, noForces(limit)));
    }
    const found = outlines === undefined ? [] : cones(theCase, outlines);
    return element(
      "section",
      { "data-towards": theCase.towards },
      heading,
      element("p", {}, this.#balance(theCase)),
      found.length === 0 ? null : forcesFigure(theCase, outlines, found),
      table(say("Reactions at the limit") + ", " + directionText(theCase, null), this.#heads(), limit.reactions.map((each, index) => this.#row(each, found[index], theCase))),
      this.#centre(limit),
      motions(theCase),
    );
  }

  #balance(theCase) {
    const { limit } = theCase;
    const words = [this.terms.word("static limit", "static limit"), degreesText(limit.critical_angle_deg), this.terms.word("reactions", "reaction")];
    const friction = degreesText(limit.friction_angle_deg);
    const balanced = balancedBy(theCase);
    if (balanced === null) return parts("At the %s, %s, the base exerts these %s; φ = %s.", ...words, friction);
    if (balanced.weight) return parts("At the %s, %s, these %s just balance the weight; φ = %s.", ...words, friction);
    const others = balanced.others.map((name) => say(name)).join(", ");
    return parts("At the %s, %s, these %s are in balance with the weight and with: %s; φ = %s.", ...words, others, friction);
  }

  #heads() {
    const unit = lengthUnit(this.store).name;
    return [
      "x (" + unit + ")", "y (" + unit + ")", say("along"), say("normal"), say("force (N)"),
      this.terms.word("from the normal", "friction cone"),
    ];
  }

  #row(reaction, cone, theCase) {
    const unit = lengthUnit(this.store);
    const share = Math.hypot(reaction.share_x.value, reaction.share_y.value);
    const weight = theCase.block.weight_n;
    const bound = Math.hypot(reaction.share_x.error, reaction.share_y.error);
    const size = weight
      ? { value: share * weight.value, error: bound * weight.value + (share + bound) * weight.error + 1e-15 * share * weight.value }
      : null;
    return {
      cells: [
        lengthText(reaction.x_m, unit), lengthText(reaction.y_m, unit),
        certainText(reaction.share_x, 4), certainText(reaction.share_y, 4), certainDigits(size, 5),
        cone?.angle === null || cone === undefined ? "—" : numeral(cone.angle.toFixed(2)) + "°",
      ],
    };
  }

  #centre(limit) {
    if (!limit.centre_x_m || !limit.centre_y_m) return null;
    const unit = lengthUnit(this.store);
    const point = pointText(limit.centre_x_m, limit.centre_y_m, unit) + " " + unit.name;
    return element("p", {}, parts("Then it %s about the centre of rotation %s.", say(limit.mechanism), element("strong", {}, point)));
  }
}

function noForces(limit) {
  if (limit === undefined) return say("The scene gives no friction angle: contact forces are not judged.");
  return say("There is no limit to show: %s.", say(limit.mechanism));
}

/** What can begin at the scene's own tilt, with its accelerations. */
function motions(theCase) {
  const listed = theCase.motions ?? [];
  if (listed.length === 0) return null;
  return element(
    "section",
    {},
    element("h4", {}, say("What can begin at %s", degreesText(theCase.tilt_angle_deg))),
    table(say("Motions") + ", " + directionText(theCase, null), ["motion", "along (g)", "normal (g)", "turning (g/m)"].map((head) => say(head)), listed.map((motion) => ({
      cells: [
        say(motion.mechanism), certainText(motion.acceleration_x_g, 4), certainText(motion.acceleration_y_g, 4),
        certainDigits(motion.angular_g_per_m, 5),
      ],
    }))),
  );
}
