// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// Area and centroid of the same polygons by Topple's sums and by other libraries.
//
//     bench_peers [MOST_VERTICES] > peers.csv
//
// Polygons: rough squares of unit edges with whole coordinates, at the origin and 10^9 away from it
// on both axes. Methods: a plain loop; Topple's sums in double, about the middle
// of the polygon (as its program sums), in pairs and exactly;
// Boost.Geometry; CGAL's Polygon_2 with double and with rational coordinates (area alone); GEOS
// where it is installed. Every library holds the polygon in its own container before the clock
// starts, and each method returns doubles.
// To be read: ns_per_vertex is time of the processor, the median of 9 samples, the methods in turn;
// ratio_to_read sets it beside a sum over the coordinates, which does nothing but read them.
// Topple's times contain the proven bounds. The error of the area is relative; that of the centroid
// is its distance from the truth over the square root of the area. A double near 10^9 cannot say
// where a centroid is more closely than 6e-8, which that error contains. The truth is rational.
// Rational arithmetic is left out beyond 10^5 vertices.

#include "peers_libraries.hpp"

#include <arb.h>
#include <flint/fmpq.h>

extern "C" {
#include "bench.h"

#include "block/ring_sums.h"
}

#include <algorithm>
#include <cmath>
#include <vector>

using namespace peers;

namespace {

constexpr long SAMPLES = 9, MOST_SLOW = 100000;

Answer read_only(const Polygon &p) {
  double u[8] = {}, v[8] = {};
  size_t k = 0;
  for (; k + 8 <= p.u.size(); k += 8) {
    for (size_t lane = 0; lane < 8; lane++) {
      u[lane] += p.u[k + lane];
      v[lane] += p.v[k + lane];
    }
  }
  Answer answer = {NONE, 0, 0};
  for (; k < p.u.size(); k++) answer.x += p.u[k] + p.v[k];
  for (size_t lane = 0; lane < 8; lane++) answer.x += u[lane] + v[lane];
  return answer;
}

Answer from_sums(double area2, double x6, double y6) {
  return {area2 / 2, x6 / (3 * area2), y6 / (3 * area2)};
}

Answer plain_loop(const Polygon &p) {
  double area = 0, x = 0, y = 0;
  for (size_t k = 0, before = p.u.size() - 1; k < p.u.size(); before = k++) {
    const double c = p.u[before] * p.v[k] - p.u[k] * p.v[before];
    area += c;
    x += (p.u[before] + p.u[k]) * c;
    y += (p.v[before] + p.v[k]) * c;
  }
  return from_sums(area, x, y);
}

constexpr tp_sums_plan AREA = {TP_AREA_SUM_COUNT, TP_INSTRUCTIONS_BEST, 1};

Answer topple_double(const Polygon &p) {
  double sums[TP_AREA_SUM_COUNT], bounds[TP_AREA_SUM_COUNT];
  tp_ring_sums_double_first(sums, bounds, p.u.data(), p.v.data(), long(p.u.size()), true, AREA);
  return from_sums(sums[TP_A2], sums[TP_X6], sums[TP_Y6]);
}

// As the program does it: about the middle, to which whole numbers move without a rounding.
Answer topple_centred(const Polygon &p) {
  static std::vector<double> u, v;
  const auto centre = [](const std::vector<double> &of, std::vector<double> &moved) {
    const auto [least, most] = std::minmax_element(of.begin(), of.end());
    const double middle = std::floor((*least + *most) / 2);
    moved.resize(of.size());
    for (size_t k = 0; k < of.size(); k++) moved[k] = of[k] - middle;
    return middle;
  };
  const double x = centre(p.u, u), y = centre(p.v, v);
  double sums[TP_AREA_SUM_COUNT], bounds[TP_AREA_SUM_COUNT];
  tp_ring_sums_double_first(sums, bounds, u.data(), v.data(), long(u.size()), true, AREA);
  const Answer about = from_sums(sums[TP_A2], sums[TP_X6], sums[TP_Y6]);
  return {about.area, about.x + x, about.y + y};
}

Answer topple_pairs(const Polygon &p) {
  tp_double_pair sums[TP_AREA_SUM_COUNT];
  double bounds[TP_AREA_SUM_COUNT];
  tp_ring_sums_compensated_first(sums, bounds, p.u.data(), p.v.data(), long(p.u.size()), AREA);
  const auto value = [](tp_double_pair pair) { return (long double)pair.high + pair.low; };
  const long double area2 = value(sums[TP_A2]);
  return {double(area2 / 2), double(value(sums[TP_X6]) / (3 * area2)),
          double(value(sums[TP_Y6]) / (3 * area2))};
}

// To the nearest double, but for a quotient within 2^-128 of half way between two.
double rounded_quotient(const fmpz_t a, const fmpz_t b) {
  arb_t quotient;
  arb_init(quotient);
  arb_fmpz_div_fmpz(quotient, a, b, 128);
  const double value = arf_get_d(arb_midref(quotient), ARF_RND_NEAR);
  arb_clear(quotient);
  return value;
}

Answer topple_exact(const Polygon &p) {
  fmpz sums[TP_AREA_SUM_COUNT] = {};
  tp_ring_sums_exact_first(sums, p.x.data(), p.y.data(), long(p.u.size()), TP_AREA_SUM_COUNT);
  const fmpz two = 2;
  Answer answer = {rounded_quotient(sums + TP_A2, &two), 0, 0};
  fmpz_mul_ui(sums + TP_A2, sums + TP_A2, 3);
  answer.x = rounded_quotient(sums + TP_X6, sums + TP_A2);
  answer.y = rounded_quotient(sums + TP_Y6, sums + TP_A2);
  for (fmpz &sum : sums) fmpz_clear(&sum);
  return answer;
}

std::vector<Named> methods_for(const Polygon &p) {
  std::vector<Named> all = {{"read", [&p] { return read_only(p); }},
                            {"plain loop", [&p] { return plain_loop(p); }},
                            {"Topple double", [&p] { return topple_double(p); }},
                            {"Topple centred", [&p] { return topple_centred(p); }},
                            {"Topple pairs", [&p] { return topple_pairs(p); }},
                            {"Boost.Geometry", boost_method(p)},
                            {"CGAL double", cgal_method<double>(p)}};
#ifdef HAVE_GEOS
  all.push_back({"GEOS", geos_method(p)});
#endif
  if (long(p.u.size()) <= MOST_SLOW) {
    all.push_back({"Topple exact", [&p] { return topple_exact(p); }});
    all.push_back({"CGAL rational", cgal_method<CGAL::Exact_rational>(p)});
  }
  return all;
}

volatile double sink; // what the compiler must not leave out

double seconds_of(const Method &method, long repeats) {
  const double began = bench_computed();
  for (long k = 0; k < repeats; k++) sink = method().x;
  return bench_computed() - began;
}

// Median nanoseconds per vertex of every method, each sample at least 5 ms.
std::vector<double> measure(const std::vector<Named> &methods, size_t count) {
  std::vector<std::vector<double>> samples(methods.size());
  std::vector<long> repeats(methods.size(), 1);
  for (size_t m = 0; m < methods.size(); m++) {
    while (seconds_of(methods[m].run, repeats[m]) < 5e-3) repeats[m] *= 2;
  }
  for (long s = 0; s < SAMPLES; s++) {
    for (size_t m = 0; m < methods.size(); m++) {
      const double seconds = seconds_of(methods[m].run, repeats[m]);
      samples[m].push_back(1e9 * seconds / (double(repeats[m]) * double(count)));
    }
  }
  std::vector<double> medians;
  for (auto &of_one : samples) medians.push_back(gsl_stats_median(of_one.data(), 1, of_one.size()));
  return medians;
}

// |value - truth|, to 53 bits.
double distance_from(double value, const fmpq_t truth) {
  arb_t error, exact;
  arb_init(error);
  arb_init(exact);
  arb_set_fmpq(exact, truth, 400);
  arb_set_d(error, value);
  arb_sub(error, error, exact, 400);
  const double distance = std::fabs(arf_get_d(arb_midref(error), ARF_RND_NEAR));
  arb_clear(error);
  arb_clear(exact);
  return distance;
}

struct Truth {
  fmpq_t area, x, y;

  explicit Truth(const Polygon &p) {
    fmpz sums[TP_AREA_SUM_COUNT] = {};
    tp_ring_sums_exact_first(sums, p.x.data(), p.y.data(), long(p.u.size()), TP_AREA_SUM_COUNT);
    fmpq_init(area);
    fmpq_init(x);
    fmpq_init(y);
    fmpz_mul_ui(sums + TP_A2, sums + TP_A2, 3);
    fmpq_set_fmpz_frac(x, sums + TP_X6, sums + TP_A2);
    fmpq_set_fmpz_frac(y, sums + TP_Y6, sums + TP_A2);
    fmpq_set_fmpz(area, sums + TP_A2);
    fmpq_div_2exp(area, area, 1);
    fmpz_set_ui(sums, 3);
    fmpq_div_fmpz(area, area, sums);
    for (fmpz &sum : sums) fmpz_clear(&sum);
  }

  ~Truth() {
    fmpq_clear(area);
    fmpq_clear(x);
    fmpq_clear(y);
  }
};

void print_number(double value) {
  if (std::isnan(value)) {
    std::printf(",");
  } else {
    std::printf(",%.4g", value);
  }
}

void print_rows(long wanted, long offset) {
  Polygon p;
  make_rough_square(p, wanted, offset);
  const Truth truth(p);
  const std::vector<Named> methods = methods_for(p);
  const std::vector<double> nanoseconds = measure(methods, p.u.size());
  const double area = distance_from(0, truth.area);
  for (size_t m = 0; m < methods.size(); m++) {
    const Answer answer = methods[m].run();
    const bool knows = methods[m].name != "read";
    std::printf("%ld,%zu,%s", offset, p.u.size(), methods[m].name.c_str());
    print_number(nanoseconds[m]);
    print_number(nanoseconds[m] / nanoseconds[0]);
    print_number(knows ? distance_from(answer.area, truth.area) / area : NONE);
    print_number(knows && !std::isnan(answer.x) ? std::hypot(distance_from(answer.x, truth.x),
                                                             distance_from(answer.y, truth.y)) /
                                                      std::sqrt(area)
                                                : NONE);
    std::printf("\n");
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv) {
  const long most = argc > 1 ? bench_count(argv[1], 10) : 1000000;
  if (argc > 2 || most == 0) {
    std::fprintf(stderr, "usage: bench_peers [MOST_VERTICES, at least 10]\n");
    return 2;
  }
  std::printf("offset,vertices,method,ns_per_vertex,ratio_to_read,area_relative_error,"
              "centroid_relative_error\n");
  for (const long offset : {0L, 1000000000L}) {
    for (long wanted = 10; wanted <= most; wanted *= 10) print_rows(wanted, offset);
  }
  flint_cleanup();
  return 0;
}
