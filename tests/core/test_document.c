/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Documents from within: hashes and base 64 by published examples, equations sign by sign. */

#include "document/html_math.h"
#include "output/encode.h"
#include "output/sha256.h"
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

SUITE(document) {
  Suite *suite = suite_create("document");
  TCase *tests = tcase_create("document");
  tcase_add_test(tests, hashes_of_the_standard);
  tcase_add_test(tests, base_64_of_the_standard);
  tcase_add_test(tests, text_is_no_markup);
  tcase_add_test(tests, equations_sign_by_sign);
  suite_add_tcase(suite, tests);
  return suite;
}
