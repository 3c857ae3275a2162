# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Formulas made wrong on purpose, and the mends that are offered for them."""

import json
import random
import re

import notation
from harness import main
from verify_case import A1_4, Block, ClaimsCase, HEAD, SCENE


class Mends(ClaimsCase):
    # Correct formulas, from which wrong ones are made.
    RIGHT = (("critical_angle", A1_4, "e"),
             ("fos_elements", "c^2/(3b^2) + ((27ab + 14ac)/(9b^2))·tan^-1 α", "e"),
             ("overturning_moment", "(w_1 + w_2 + w_3)sinα·b/2", "e"),
             ("rounding_length", "(27ab + 14ac + (3c^2 - 9b^2)tanα)/((18b + 9c)(tanα·sin i + cos i))", "e"),
             ("fos", "(27ab + 14ac - 9r·cos i·(2b + c))/(9b^2 - 3c^2 + 9r·sin i·(2b + c))·tan^-1 α", "round"))

    @staticmethod
    def wrong_ones(printed):
        """Every number changed, every exponent changed or dropped, every sign turned, and products
        without a number given one."""
        for match in re.finditer(r"(?<![\w.])\d+", printed):
            if printed[:match.start()].endswith(("-", "tan^-")) and "^-" in printed[match.start() - 2:match.start()]:
                continue
            value = int(match.group())
            for other in {value + 1, 2 * value + 3}:
                yield printed[:match.start()] + str(other) + printed[match.end():]
        for match in re.finditer(r"\^2", printed):
            yield printed[:match.start()] + printed[match.end():]
        for match in re.finditer(r" [+-] ", printed):
            turned = " - " if "+" in match.group() else " + "
            yield printed[:match.start()] + turned + printed[match.end():]
        for match in re.finditer(r"(?<=\+ )\w", printed):
            if match.group().isalpha():
                yield printed[:match.start()] + "5*" + printed[match.start():]

    def test_wrong_on_purpose(self):
        """Formulas wrong in one coefficient, sign or exponent are refuted, every one of them, and the
        mend equals the right formula at random values by Python's rationals."""
        random.seed(42)
        claims, rights = [], []
        for quantity, right, geometry in self.RIGHT:
            for printed in self.wrong_ones(right):
                claims.append(f"- {{id: x{len(claims)}, where: here, geometry: {geometry}, quantity: "
                              f"{quantity}, printed: '{printed}'}}\n")
                rights.append(right)
        self.assertGreater(len(claims), 80)
        status, out, err = self.verify("".join(claims))
        self.assertEqual((status, err), (1, ""))
        for right, claim in zip(rights, json.loads(out)["claims"]):
            self.assertEqual(claim["verdict"], "refuted", claim["printed"])
            self.assertIsNotNone(claim["mend"], claim["printed"])
            self.assertIsNotNone(claim["difference"])
            self.assertGreater(abs(claim["printed_there"]["value"] - claim["computed_there"]["value"]),
                               claim["printed_there"]["error"] + claim["computed_there"]["error"])
            for _ in range(3):
                values = Block("e_peak").values()
                self.assertEqual(notation.evaluate(claim["mend"], values),
                                 notation.evaluate(right, values), claim["mend"])

    def test_mend_names(self):
        """A wrong letter is found too; two errors at once have no mend."""
        self.assertEqual(self.claim("critical_angle", A1_4.replace("14ac", "14bc"))["change"], "b is a")
        twice = A1_4.replace("14", "13").replace("27", "26")
        self.assertIsNone(self.claim("critical_angle", twice)["mend"])

    def test_mend_powers_of_functions(self):
        """The exponent of sin^2 x stands before what the sine is of: it is mended there, and the part that a
        change names goes on to the end of x."""
        for quantity, printed, change, mend in (
                ("a*sin(i)^3", "a sin^2 i", "the exponent of sin^2 i is 3", "a sin^3 i"),
                ("a - tan(i)", "a - tan^2 (i)", "the exponent of tan^2 (i) is 1", "a - tan^1 (i)"),
                ("a - sin(i)^2", "a + sin^2 i", "the sign before sin^2 i is -", "a - sin^2 i")):
            result = self.claim(quantity, printed)
            self.assertEqual((result["verdict"], result["change"], result["mend"]), ("refuted", change, mend))

    def test_long_names(self):
        """Names and identifiers that share any beginning are told apart as far as they go, and printed whole;
        a name beyond what a formula may have is refused, never cut to another."""
        for length in (40, 63, 64, 100, 126):
            first, second = "q" * length + "x", "q" * length + "y"
            scene = SCENE.replace("{a: 30", f"{{{first}: 7, {second}: 8, q: 3, a: 30")
            (self.path / "scene.yaml").write_text(scene)
            angles = f"angles: {{{first[1:]}_: 20, {second[1:]}_: 30}}\n"
            one = "- {id: %s, where: h, geometry: e, quantity: '%s', printed: '%s'}\n"
            claims = [(f"{first}*b", f"b*{first}"), (f"{first}*b", f"b*{second}"),
                      (f"tan({first[1:]}_)", f"2*tan({second[1:]}_)")]
            text = "".join(one % ("i" * 400 + str(k), *c) for k, c in enumerate(claims))
            status, out, err = self.verify(text, HEAD + angles)
            self.assertEqual((status, err), (1, ""))
            found = json.loads(out)["claims"]
            self.assertEqual([c["verdict"] for c in found], ["proven", "refuted", "refuted"])
            self.assertEqual([c["id"] for c in found], ["i" * 400 + str(k) for k in range(3)])
            self.assertEqual(found[1]["mend"], f"b*({first})")
            self.assertEqual(found[1]["change"].split(" is ")[1], first)
            for symbol in (first[1:], second[1:]):
                self.assertIn(f"tan({symbol}_)", found[2]["difference"])
            at = f"- {{id: x, where: h, geometry: e, at: {{{second}: 5}}, quantity: {second}, printed: 5}}\n"
            self.assertEqual(json.loads(self.verify(at)[1])["claims"][0]["verdict"], "agrees")
        for length in (127, 128, 300):
            (self.path / "scene.yaml").write_text(SCENE.replace("{a: 30", f"{{{'q' * length}x: 7, a: 30"))
            self.refuse(one % ("x", "a", "a"), "a formula has names of at most 127 letters")


if __name__ == "__main__":
    main()
