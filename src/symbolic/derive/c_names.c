/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of keywords, macros and functions of C and C++, and the tests of a name against them and
 * against the names of generated functions. */

#include "derive/c_names.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Keywords of C up to C23 and of C++ up to C++20, with their spellings of operators. */
static const char *const keywords[] = {"alignas",     "alignof",
                                       "and",         "and_eq",
                                       "asm",         "auto",
                                       "bitand",      "bitor",
                                       "bool",        "break",
                                       "case",        "catch",
                                       "char",        "char16_t",
                                       "char32_t",    "char8_t",
                                       "class",       "co_await",
                                       "co_return",   "co_yield",
                                       "compl",       "concept",
                                       "const",       "const_cast",
                                       "consteval",   "constexpr",
                                       "constinit",   "continue",
                                       "decltype",    "default",
                                       "delete",      "do",
                                       "double",      "dynamic_cast",
                                       "else",        "enum",
                                       "explicit",    "export",
                                       "extern",      "false",
                                       "float",       "for",
                                       "fortran",     "friend",
                                       "goto",        "if",
                                       "inline",      "int",
                                       "long",        "mutable",
                                       "namespace",   "new",
                                       "noexcept",    "not",
                                       "not_eq",      "nullptr",
                                       "operator",    "or",
                                       "or_eq",       "private",
                                       "protected",   "public",
                                       "register",    "reinterpret_cast",
                                       "requires",    "restrict",
                                       "return",      "short",
                                       "signed",      "sizeof",
                                       "static",      "static_assert",
                                       "static_cast", "struct",
                                       "switch",      "template",
                                       "this",        "thread_local",
                                       "throw",       "true",
                                       "try",         "typedef",
                                       "typeid",      "typename",
                                       "typeof",      "typeof_unqual",
                                       "union",       "unsigned",
                                       "using",       "virtual",
                                       "void",        "volatile",
                                       "wchar_t",     "while",
                                       "xor",         "xor_eq",
                                       NULL};

/* Macros that compilers define for a system or a processor, and those of other headers that stand
 * where C is pasted in. */
static const char *const macros[] = {
    "I",    "arm",    "assert",  "complex",  "errno",  "far",     "huge",      "hpux",
    "i386", "linux",  "mc68000", "mips",     "near",   "ns32000", "offsetof",  "pascal",
    "sgi",  "sparc",  "stderr",  "stdin",    "stdout", "sun",     "tss",       "u370",
    "unix", "va_arg", "va_end",  "va_start", "vax",    "vms",     "imaginary", "interface",
    "min",  "max",    "small",   NULL};

/* What the generated functions call their own. */
static const char *const own[] = {"alpha", "area", "main", "normal", "parallel", "phi", NULL};

/* <math.h> of C23, POSIX and the systems' own; most come with an f and an l too. */
static const char *const functions[] = {
    "acos",      "acosh",      "acospi",  "asin",        "asinh",  "asinpi",    "atan",
    "atan2",     "atan2pi",    "atanh",   "atanpi",      "cabs",   "cbrt",      "ceil",
    "compoundn", "copysign",   "cos",     "cosh",        "cospi",  "drem",      "erf",
    "erfc",      "exp",        "exp10",   "exp10m1",     "exp2",   "exp2m1",    "expm1",
    "fabs",      "fdim",       "finite",  "floor",       "fma",    "fmax",      "fmaximum",
    "fmin",      "fminimum",   "fmod",    "frexp",       "fromfp", "fromfpx",   "gamma",
    "gamma_r",   "hypot",      "ilogb",   "isinf",       "isnan",  "j0",        "j1",
    "jn",        "ldexp",      "lgamma",  "lgamma_r",    "llogb",  "llrint",    "llround",
    "log",       "log10",      "log10p1", "log1p",       "log2",   "log2p1",    "logb",
    "logp1",     "lrint",      "lround",  "modf",        "nan",    "nearbyint", "nextafter",
    "nextdown",  "nexttoward", "nextup",  "pow",         "pow10",  "pown",      "powr",
    "remainder", "remquo",     "rint",    "rootn",       "round",  "roundeven", "rsqrt",
    "scalb",     "scalbln",    "scalbn",  "significand", "sin",    "sincos",    "sinh",
    "sinpi",     "sqrt",       "tan",     "tanh",        "tanpi",  "tgamma",    "trunc",
    "ufromfp",   "ufromfpx",   "y0",      "y1",          "yn",     NULL};
static const char *const more_of_math[] = {
    "canonicalize",     "double_t",    "exception",     "float_t",    "fpclassify",
    "getpayload",       "iscanonical", "isfinite",      "isgreater",  "isgreaterequal",
    "isless",           "islessequal", "islessgreater", "isnormal",   "issignaling",
    "issubnormal",      "isunordered", "iszero",        "iseqsig",    "matherr",
    "math_errhandling", "signbit",     "signgam",       "totalorder", NULL};

static bool is_among(const char *name, size_t length, const char *const *words) {
  for (; *words != NULL; words++) {
    if (strlen(*words) == length && strncmp(*words, name, length) == 0) return true;
  }
  return false;
}

static bool is_function(const char *name, size_t length) {
  if (is_among(name, length, functions) || is_among(name, length, more_of_math)) return true;
  const bool typed = length > 1 && (name[length - 1] == 'f' || name[length - 1] == 'l');
  return typed && is_among(name, length - 1, functions);
}

/* tan_critical_angle_1 and the like. */
static bool is_generated(const char *name) {
  static const char *const beginnings[] = {
      "tan_critical_angle_", "fos_elements_",  "tan_limit_", "is_limit_",
      "rounding_length_",    "corner_radius_", NULL};
  for (int k = 0; beginnings[k] != NULL; k++) {
    if (strncmp(name, beginnings[k], strlen(beginnings[k])) == 0) return true;
  }
  return false;
}

static bool is_capitals(const char *name) {
  int letters = 0;
  for (; *name != '\0'; name++) {
    if (islower((unsigned char)*name)) return false;
    letters += isupper((unsigned char)*name) != 0;
  }
  return letters > 1;
}

bool tp_c_name_is_reserved(const char *name) {
  const size_t length = strlen(name);
  return name[0] == '_' || is_capitals(name) || is_among(name, length, keywords) ||
         is_among(name, length, macros) || is_among(name, length, own) ||
         is_function(name, length) || is_generated(name);
}

static bool is_taken(const tp_field *field, const char *name) {
  for (long k = 0; k < field->parameters->count; k++) {
    if (strcmp(field->parameters->names[k], name) == 0) return true;
  }
  for (long k = 0; k < field->symbol_count; k++) {
    if (strcmp(field->names[k], name) == 0) return true;
  }
  return false;
}

bool tp_c_names_set(tp_field *field) {
  static const char before[] = "p_";
  const size_t step = strlen(before), most = (size_t)field->symbol_count + 1;
  const long count = field->parameters->count;
  field->renamed = calloc((size_t)count + 1, sizeof *field->renamed);
  if (field->renamed == NULL) return false;
  for (long k = 0; k < count; k++) {
    const char *name = field->names[k];
    if (!tp_c_name_is_reserved(name)) continue;
    /* with p_ before it as often as there are symbols, and once more, it is free for certain */
    const size_t size = most * step + strlen(name) + 1;
    char *all = malloc(size);
    if (all == NULL) return false;
    field->renamed[k] = all;
    for (size_t j = 0; j < most; j++) snprintf(all + j * step, size - j * step, "%s", before);
    snprintf(all + most * step, size - most * step, "%s", name);
    const char *free_name = all + (most - 1) * step;
    while (free_name > all && is_taken(field, free_name)) free_name -= step;
    field->names[k] = free_name;
  }
  return true;
}
