/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Documents from within: hashes and base 64 by published examples, equations sign by sign,
 * sentences by phrases. */

#include "document/html_math.h"
#include "output/encode.h"
#include "output/sha256.h"
#include "output/translate.h"
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void hashes(const char *bytes, size_t length, const char *expected) {
  uint8_t hash[TP_SHA256_SIZE];
  char text[2 * TP_SHA256_SIZE + 1];
  tp_sha256(hash, bytes, length);
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) snprintf(text + 2 * k, 3, "%02x", hash[k]);
  ck_assert_str_eq(text, expected);
}

/* The examples of FIPS 180-2, appendix B, and of an empty message. */
START_TEST(hashes_of_the_standard) {
  enum { MILLION = 1000000 };
  hashes("", 0, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  hashes("abc", 3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const char *two = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
  hashes(two, strlen(two), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  char *many = malloc(MILLION);
  ck_assert_ptr_nonnull(many);
  memset(many, 'a', MILLION);
  hashes(many, MILLION, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  free(many);
}
END_TEST

static void says(tp_text *t, const char *expected) {
  ck_assert(!t->failed);
  ck_assert_str_eq(t->data != NULL ? t->data : "", expected);
  tp_text_drop(t);
  *t = (tp_text){0};
}

/* RFC 4648, section 10. */
START_TEST(base_64_of_the_standard) {
  static const char *const pairs[][2] = {{"", ""},
                                         {"f", "Zg=="},
                                         {"fo", "Zm8="},
                                         {"foo", "Zm9v"},
                                         {"foob", "Zm9vYg=="},
                                         {"fooba", "Zm9vYmE="},
                                         {"foobar", "Zm9vYmFy"}};
  for (size_t k = 0; k < sizeof pairs / sizeof pairs[0]; k++) {
    tp_text t = {0};
    tp_encode_base64(&t, pairs[k][0], strlen(pairs[k][0]));
    says(&t, pairs[k][1]);
  }
}
END_TEST

START_TEST(text_is_no_markup) {
  tp_text t = {0};
  tp_encode_html(&t, "<b a=\"1\" c='2'>&amp;\n\x1b");
  says(&t, "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp; \\x1B");
}
END_TEST

/* Fractions, indices, functions, degrees and a second line; in LaTeX the same text. */
START_TEST(equations_sign_by_sign) {
  tp_text t = {0};
  tp_math_to_html(&t, "α_{cd} = \\frac{x}{−1.5e-07} \\\\ \\tan 30°");
  says(&t, "<math display=\"block\"><mrow><msub><mi>α</mi><mrow><mi>c</mi><mi>d</mi></mrow></msub>"
           "<mo>=</mo><mfrac><mrow><mi>x</mi></mrow><mrow><mo>−</mo><mn>1.5e-07</mn></mrow></mfrac>"
           "</mrow></math>\n<math display=\"block\"><mrow><mi>tan</mi><mspace width=\"0.17em\">"
           "</mspace><mn>30°</mn></mrow></math>\n");
  tp_math_to_markdown(&t, "\\tan 30° − 1\\\\b");
  says(&t, "$$\\tan 30^\\circ - 1$$\n\n$$b$$\n\n");
  tp_math_to_html(&t, "\\bar{x} < {y}^2");
  says(&t, "<math display=\"block\"><mrow><mover accent=\"true\"><mrow><mi>x</mi></mrow>"
           "<mo stretchy=\"false\">¯</mo></mover><mo>&lt;</mo><msup><mrow><mi>y</mi></mrow><mrow>"
           "<mn>2</mn></mrow></msup></mrow></math>\n");
}
END_TEST

/* Phrases in the order of their bytes, as make_phrases.py puts them. */
static const tp_phrase phrases[] = {{"%s%s to it", "%s%s"},
                                    {"%s, or to %s", "%s, o a %s"},
                                    {"FoS %s", "FS %s"},
                                    {"FoS %s against %s", "contra %2$s FS %1$s"},
                                    {"It can begin to %s.", "Puede empezar a %s."},
                                    {"area %s", "área %s"},
                                    {"band of 95 %%", "banda del 95 %%"},
                                    {"certain %s %%", "con certeza %s %%"},
                                    {"slide", "deslizar"},
                                    {"topple", "volcar"}};
static const tp_language spanish = {"es", true, sizeof phrases / sizeof phrases[0], phrases};

static void becomes(const char *english, const char *own) {
  tp_text t = {0};
  tp_translate(&t, &spanish, true, english);
  says(&t, own);
}

/* The phrase with most of the text in it counts; sentences and clauses apart, arguments turned
 * round and translated likewise; what no phrase has stays; a comma before decimals, but none in a
 * name. */
START_TEST(sentences_by_phrases) {
  becomes("It can begin to slide, or to topple.", "Puede empezar a deslizar, o a volcar.");
  becomes("FoS 1.5 against slide", "contra deslizar FS 1,5");
  becomes("FoS 1.5 against slide. It can begin to topple.",
          "contra deslizar FS 1,5. Puede empezar a volcar.");
  becomes("area 18.5 m², slide; topple", "área 18,5 m², deslizar; volcar");
  becomes("(slide)", "(deslizar)");
  becomes("a slide 'topple, slide' at (1.5, 2)", "a slide 'topple, slide' at (1,5; 2)");
  becomes("  FoS  2 ", " FS 2 ");
  becomes("slide to it", "slide to it");         /* where one argument ends nothing says */
  becomes("certain 9.1 %", "con certeza 9,1 %"); /* %% is one sign */
  becomes("band of 95 %", "banda del 95 %");
  becomes("", "");
}
END_TEST

/* Of any text the work is bounded, and what is not translated is told. */
START_TEST(no_text_takes_long) {
  static const size_t lengths[] = {4000, 40000};
  static const tp_phrase many[] = {{"%s a%s a%s a%s a%s a%s b", "%s%s%s%s%s%s"}};
  const tp_language hard = {"es", true, 1, many};
  for (size_t n = 0; n < sizeof lengths / sizeof lengths[0]; n++) {
    char *text = malloc(lengths[n] + 1);
    ck_assert_ptr_nonnull(text);
    for (size_t k = 0; k < lengths[n]; k++) text[k] = "a, "[k % 3];
    text[lengths[n]] = '\0';
    tp_text t = {0};
    tp_translate(&t, &hard, true, text);
    ck_assert(!t.failed);
    ck_assert_str_eq(t.data, text);
    tp_text_drop(&t);
    free(text);
  }
}
END_TEST

SUITE(document) {
  Suite *suite = suite_create("document");
  TCase *tests = tcase_create("document");
  tcase_add_test(tests, hashes_of_the_standard);
  tcase_add_test(tests, base_64_of_the_standard);
  tcase_add_test(tests, text_is_no_markup);
  tcase_add_test(tests, equations_sign_by_sign);
  tcase_add_test(tests, sentences_by_phrases);
  tcase_add_test(tests, no_text_takes_long);
  suite_add_tcase(suite, tests);
  return suite;
}
