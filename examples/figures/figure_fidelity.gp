# SPDX-License-Identifier: MIT
# gnuplot -c figure_fidelity.gp figure_fidelity.csv figure_fidelity.png
height = 505
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_fidelity.gp')].'style.gp'

models = '"exact flow" "mean value q15" "mean value f32" "saturated f32" "elasto-plastic by Euler" \
          "LuGre by Euler" "Algorithm 1 as printed"'
titles = '"exact flow at the mean velocity" "mean value, q15" "mean value, f32 (and q31)" "saturated, f32" \
          "elasto-plastic by Euler" "LuGre by Euler" "Algorithm 1 as printed"'
set style line 1 linewidth 7 pointtype 7 pointsize 1.5
set style line 2 linecolor rgb '#f59e0b' linewidth 1.5 pointtype 6 pointsize 1.3
set style line 3 linecolor rgb '#c2410c' linewidth 1.5 pointtype 7 pointsize 0.9
set style line 4 linecolor rgb '#1d4ed8' linewidth 1.5 pointtype 5 pointsize 0.9
set style line 5 linecolor rgb '#15803d' linewidth 1.5 pointtype 9 pointsize 0.9
set style line 6 linecolor rgb '#404040' linewidth 1.5 pointtype 11 pointsize 0.9
set style line 7 linecolor rgb '#7e22ce' linewidth 1.5 pointtype 13 pointsize 1.0

# Column 4 is a distance (m) or a rate (Hz)
is_shown(i) = strcol(1) eq 'start and stop' && strcol(2) eq word(models, i)
distance(i) = is_shown(i) && column(4) < 1 ? 1e6*column(4) : NaN
rate(i) = is_shown(i) && column(4) >= 1 ? column(4) : NaN

set logscale xy
set yrange [2e-7:0.5]
set format y '10^{%L}'
set multiplot layout 1,2 margins 0.1, 0.985, 0.28, 0.93 spacing 0.06, 0 title 'motion: start and stop'

set ylabel 'rms error of z at the updates (z_{max})'
set xlabel 'distance between updates, D_x (µm)'
set xrange [0.007:14]
set xtics ('0.01' 0.01, '0.1' 0.1, '1' 1, '5' 5, '10' 10)
unset key
plot for [i = 1:7] data every ::1 using (distance(i)):5 with linespoints linestyle i

unset ylabel
set xlabel 'updates per second'
set xrange [70:28000]
set xtics ('100' 100, '1 k' 1000, '5 k' 5000, '20 k' 20000)
set key at screen 0.1, 0.17 left top vertical Left reverse maxrows 4 width 1
plot for [i = 1:7] data every ::1 using (rate(i)):5 with linespoints linestyle i \
    title word(titles, i)
unset multiplot
