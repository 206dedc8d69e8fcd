# SPDX-License-Identifier: MIT
# Draws a result of epf_replay: gnuplot -c plot.gp replay.csv replay.png

data = ARG1
set encoding utf8
set datafile separator ','
set terminal pngcairo size 1200,1000 font 'DejaVu Sans,13' linewidth 1.5 rounded
set output ARG2

# Columns: time_s, displacement_m, z_m, force_N, and measured_N, residual_N if force was measured
stats data every ::1 using 2 nooutput
measured = STATS_columns >= 5

# Displacement in the unit that suits its range
range = STATS_max - STATS_min
scale = range < 2e-3 ? 1e6 : range < 2 ? 1e3 : 1
unit = range < 2e-3 ? 'µm' : range < 2 ? 'mm' : 'm'

set style line 1 linecolor rgb '#b8c4d0' linewidth 3.5 # measured: broad and pale, behind
set style line 2 linecolor rgb '#c2410c' linewidth 1.2 # estimated: fine and strong, in front
set border 3 linecolor rgb '#606060'
set tics nomirror out textcolor rgb '#303030'
set grid linecolor rgb '#d8d8d8' linewidth 0.6 dashtype 1
set key outside top right horizontal samplen 2
set ylabel 'friction force (N)'
set offsets graph 0.01, graph 0.01, graph 0.05, graph 0.05
set autoscale xfix

set multiplot layout 2,1 margins 0.08, 0.97, 0.07, 0.95 spacing 0, 0.12

set xlabel 'displacement ('.unit.')'
if (measured) {
    plot data every ::1 using (scale*$2):5 with lines linestyle 1 title 'measured', \
         data every ::1 using (scale*$2):4 with lines linestyle 2 title 'estimated'
} else {
    plot data every ::1 using (scale*$2):4 with lines linestyle 2 title 'estimated'
}

set xlabel 'time (s)'
unset key # once is enough
if (measured) {
    plot data every ::1 using 1:5 with lines linestyle 1 title 'measured', \
         data every ::1 using 1:4 with lines linestyle 2 title 'estimated'
} else {
    plot data every ::1 using 1:4 with lines linestyle 2 title 'estimated'
}

unset multiplot
