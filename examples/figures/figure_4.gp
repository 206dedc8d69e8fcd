# SPDX-License-Identifier: MIT
# gnuplot -c figure_4.gp figure_4.csv figure_4.png
height = 560
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_4.gp')].'style.gp'

set multiplot
set lmargin at screen 0.09
set rmargin at screen 0.64
set tmargin at screen 0.96
set bmargin at screen 0.61
set ylabel 'position seen (µm)'
set yrange [-35:35]
set xrange [0:1400]
set title '±0.15 µm/s, 100 looks per second' offset 0, -0.7
plot data every ::1 using 1:2 with lines linestyle 5 notitle

# A second of it, look by look
set lmargin at screen 0.76
set rmargin at screen 0.97
set title 'a second of it, noise ±5 nm' offset -1, -0.7
set xrange [300:301]
set xtics ('300' 300, '300.5' 300.5, '301' 301)
set yrange [14.84:15.01]
set ytics 0.05
set format y '%.2f'
set ylabel offset 1, 0
plot data every ::1 using ($1 >= 300 && $1 <= 301 ? $1 : NaN):2 with linespoints linestyle 5 \
    pointtype 7 pointsize 0.3 notitle
unset title

set lmargin at screen 0.09
set tmargin at screen 0.48
set bmargin at screen 0.1
set xrange [0:1400]
set xtics autofreq
set ytics autofreq
set format y '%g'
set xlabel 'time (s)'
set ylabel 'friction σ_0 z (N)' offset 0, 0
set yrange [-1.3:1.75]
set key top right horizontal
plot data every ::1 using 1:3 with lines linestyle 1 title 'contact', \
     data every ::1 using 1:4 with lines linestyle 2 title 'estimate, f32', \
     data every ::1 using 1:5 with lines linestyle 3 title 'LuGre'
unset multiplot
