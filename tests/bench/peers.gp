# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
#
# What area and centroid cost, and what is lost far from the origin, by bench_peers; of the area,
# whose errors are in the same file, only the plain loop loses anything there:
#     gnuplot -e "csv='docs/figures/peers.csv'; svg='docs/figures/peers.svg'" tests/bench/peers.gp
# An error of 0 is drawn at 10^-17, below every other.

set terminal svg size 1000,430 font 'Liberation Sans,13' background '#ffffff'
set output svg
set datafile separator ','
set datafile missing NaN

# The last two find no centroid.
methods = "'Topple double' 'Topple centred' 'Topple pairs' 'Topple exact' 'plain loop' 'Boost.Geometry' 'GEOS' 'CGAL double' 'CGAL rational'"
located = "'Topple double' 'Topple centred' 'Topple pairs' 'Topple exact' 'plain loop' 'Boost.Geometry' 'GEOS'"
colours = "#b2182b #e7298a #f4a582 #67001f #888888 #2166ac #762a83 #5aae61 #1b7837"
symbols = "7 13 5 9 2 6 12 4 8"

of(name, offset, value) = (strcol(3) eq name && column(1) == offset) ? value : NaN
drawn(error) = error < 1e-17 ? 1e-17 : error

set logscale xy
set format xy '10^{%T}'
set xlabel 'vertices'
set xrange [7:1.5e6]
set grid xtics ytics lc '#dddddd' lw 0.6
set border 3 lc '#444444'
set tics nomirror
set key off

set multiplot
set tmargin at screen 0.88
set bmargin at screen 0.15

set lmargin at screen 0.06
set rmargin at screen 0.39
set title 'Nanoseconds per vertex'
set yrange [0.1:3000]
plot for [k=1:words(methods)] csv skip 1 \
  using (of(word(methods, k), 0, column(2))):4 \
  with linespoints lc rgb word(colours, k) pt int(word(symbols, k)) lw 1.6 ps 0.7, \
  csv skip 1 using (of('read', 0, column(2))):4 with lines lc '#000000' dt 2 lw 1.2

set lmargin at screen 0.46
set rmargin at screen 0.79
set title 'Error of a centroid 10⁹ edges off, over √area'
set yrange [1e-17:1e8]
plot for [k=1:words(located)] csv skip 1 \
  using (of(word(located, k), 1e9, column(2))):(drawn(column(7))) \
  with linespoints lc rgb word(colours, k) pt int(word(symbols, k)) lw 1.6 ps 0.7

set lmargin at screen 0.80
set rmargin at screen 0.99
unset title
unset border
unset tics
unset xlabel
unset grid
set key at screen 0.985,0.86 top right Left reverse samplen 2.2 spacing 1.35
plot for [k=1:words(methods)] NaN \
  with linespoints lc rgb word(colours, k) pt int(word(symbols, k)) lw 1.6 ps 0.7 title word(methods, k), \
  NaN with lines lc '#000000' dt 2 lw 1.2 title 'reading alone'
unset multiplot
