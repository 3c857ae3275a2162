# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Claims files that are wrong, and formulas and numbers beyond all bounds."""

import json

from harness import main, run
from verify_case import A1_4, ClaimsCase, HEAD, SCENE


class Refused(ClaimsCase):
    def test_wrong_files(self):
        one = "- {id: x, where: here, geometry: e, quantity: %s, printed: %s}\n"
        for printed, message in (
                ("a + q", "claims.yaml:4:76: unknown name 'q'"),
                ("(a + b", "claims.yaml:4:72: this '(' is not closed"),
                ("a + b)", "claims.yaml:4:77: ')' does not continue a formula"),
                ("a/(b - b)", "claims.yaml:4:73: division by zero, whatever the values"),
                ("a/(sin(i)^2 + cos(i)^2 - 1)", "division by zero, whatever the values"),
                ("a/2b", "is this factor above or below the stroke?"),
                ("9^9^9", "an exponent may be at most 1000 here"),
                ("'((9^1000)^1000)^1000'", "the formula grows beyond what can be derived here"),
                ("'((a^1000)^1000)^1000'", "the formula grows beyond what can be derived here"),
                ("'(a + b + c + r + i)^1000'", "the formula grows beyond what can be derived here"),
                ("'" + "(" * 1000 + "a'", "nested deeper than 200 levels"),
                ("'" + "a + " * 20000 + "a'", "a formula of more than 10000"),
                ("sin^-1(a)", "what does sin^-1 mean?"), ("sin", "sin of what? Write sin(x)"),
                ("log(a)", "write log10 for the decimal logarithm"), ("1/0*a", "division by zero"),
                ("'12,5'", "does not continue a formula"), ("a b 3", "'3' does not continue a formula"),
                ("tan(90)*a", "it is infinite, whatever the values"), ("''", "a formula belongs here")):
            self.refuse(one % ("critical_angle", printed), message)
        self.refuse(one % ("fos", "1.5"), "this needs a value of 'alpha': 'at: {alpha: …}'")
        self.refuse(one % ("nonsense", "1.5"), "unknown name 'nonsense'")
        self.refuse(one % ("log10(a - b)", "1.5"), "this has no finite value at the claim's values")
        self.refuse(2 * (one % ("fos", "a")), "claims.yaml:5:61: the claim 'x' is given twice")
        self.refuse("- {id: x, where: here, geometry: f, quantity: fos, printed: a}\n",
                    "no geometry is called 'f'; did you mean 'e'?")
        self.refuse("- {id: x, where: here, quantity: fos, printed: a}\n", "unknown name 'fos'")
        for text, message in (
                ("claims: []\n", "'topple_claims: 1' is missing"),
                ("topple_claims: 2\n", "this program reads claims of version 1"),
                ("topple_claims: 1\nclaims: []\n", "'claims' must be a list with a claim at least"),
                ("topple_claims: 1\nclaim: []\n", "claim"),
                (HEAD + "claims:\n- x\n", "a claim is a map"),
                (HEAD + "claims:\n- {id: x}\n", "'where' is missing here"),
                (HEAD + "claims:\n- {id: x, where: here, quantity: a}\n", "'printed' is missing here"),
                (HEAD + "symbols: {a: 1}\nclaims:\n- {id: x, where: h, geometry: e, quantity: a, printed: a}\n",
                 "rename the parameter 'a' of this geometry"),
                (HEAD + "symbols: {alpha: 1}\nclaims:\n- {id: x, where: h, geometry: e, quantity: a, printed: a}\n",
                 "'alpha' is a name that claims use for something else"),
                (HEAD.replace("rounded: true", "pivot: 9") + "claims:\n- {id: x, where: h, geometry: round, "
                 "quantity: a, printed: a}\n", "the scene has no such pivot"),
                (HEAD.replace("rounded: true", "pivot: 0") + "claims:\n- {id: x, where: h, geometry: round, "
                 "quantity: a, printed: a}\n", "'pivot' is a number from 1"),
                (HEAD.replace("rounded: true", "towards: up") + "claims: []\n", "'towards' must be left or right"),
                (HEAD.replace("rounded: true", "towards: right") + "claims:\n- {id: x, where: h, geometry: "
                 "round, quantity: a, printed: a}\n", "the scene does not tilt this way"),
                (HEAD + "with: {q: q}\nclaims:\n- {id: x, where: h, quantity: q, printed: 1}\n", "unknown name 'q'"),
                (HEAD + "claims:\n- {id: x, where: h, geometry: e, at: {area: 1}, quantity: a, printed: 1}\n",
                 "'area' is not a symbol that takes a value")):
            (self.path / "claims.yaml").write_text(text)
            status, out, err = run("verify", "claims.yaml", folder=self.path)
            self.assertEqual((status, out), (3, ""), text)
            self.assertIn(message, err)

    def test_long_formulas(self):
        """The search for a mend of 400 terms took half a minute: it is given up within its budget, in
        words, and a change that comes early is still found."""
        terms = "+".join(f"{k}*a^{k % 7}*b^{k % 5}*c^{k % 3}" for k in range(1, 400))
        result = self.claim("area", terms)
        self.assertEqual((result["verdict"], result["mend"]), ("refuted", None))
        self.assertEqual(result["condition"], "the search for a correction was stopped: the formula is long")
        result = self.claim(terms, terms.replace("+7*", "-7*", 1))
        self.assertEqual((result["verdict"], result["change"]), ("refuted", "the sign before 7*a^0*b^2*c^1 is +"))

    def test_numbers_beyond_all_bounds(self):
        """Towers of powers and the like end in a verdict or a complaint, never in an abort."""
        for quantity in ("2^(2^(2^100))", "(1+1e-300)^(9^500)", "(-2)^(1e300)", "sin(2^(2^60))",
                         "sqrt(2)^(2^80)", "9^9^9^9", "(1/3)^(9^9^9)", "tan(1e308*1e308*1e308)",
                         "0^0", "0^-1", "(-1)^0.5", "cot(0)", "log10(2^(2^70))", "log10(2) + 3^(2^(2^42))",
                         "log10(2) + (1/3 - 1/3)^(2^(2^42))", "log10(2) + 0.1^-(2^(2^60))"):
            status, _, err = self.verify(f"- {{id: x, where: here, quantity: '{quantity}', printed: 1}}\n")
            self.assertIn(status, (0, 1, 3), quantity)
            self.assertEqual(err.count("\n"), 1 if status == 3 else 0, err)

    def test_many_names(self):
        """As many parameters as a scene may have are no burden, 10 000 are refused; definitions that
        double 200 times are evaluated once each."""
        many = lambda count: ", ".join(f"p{k}: {k + 1}" for k in range(count))
        (self.path / "scene.yaml").write_text(SCENE.replace("{a: 30", "{" + many(10_000) + ", a: 30"))
        self.refuse("- {id: x, where: here, geometry: e, quantity: a, printed: a}\n",
                    "more than 1000 keys in one place")
        (self.path / "scene.yaml").write_text(SCENE.replace("{a: 30", "{" + many(990) + ", a: 30"))
        one = "- {id: x, where: here, geometry: e, quantity: critical_angle, printed: '%s'}\n" % A1_4
        status, out, err = self.verify(one)
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(json.loads(out)["claims"][0]["verdict"], "proven")
        (self.path / "scene.yaml").write_text(SCENE)
        doubling = ", ".join(f"d{k + 1}: d{k} + d{k}" for k in range(200))
        result = self.claim("a*2^200", "d200", f"geometry: e, with: {{d0: a, {doubling}}}")
        self.assertEqual(result["verdict"], "proven")
        logs = doubling.replace("d0 + d0", "log10(d0)")
        result = self.claim("log10(a)*2^199", "d200", f"geometry: e, with: {{d0: a, {logs}}}")
        self.assertEqual(result["verdict"], "agrees")


if __name__ == "__main__":
    main()
