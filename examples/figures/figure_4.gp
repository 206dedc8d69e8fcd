# SPDX-License-Identifier: MIT
# gnuplot -c figure_4.gp figure_4.csv figure_4.png
height = 560
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_4.gp')].'style.gp'

set multiplot layout 2,1 margins 0.09, 0.97, 0.10, 0.96 spacing 0, 0.12
set ylabel 'position seen (µm)'
set yrange [-35:35]
set label 1 '±0.15 µm/s, noise ±5 nm, 100 looks per second' at graph 0.43, 0.93 center
plot data every ::1 using 1:2 with lines linestyle 5 notitle
unset label 1

set xlabel 'time (s)'
set ylabel 'friction σ_0 z (N)'
set yrange [-1.3:1.75]
set key top right horizontal
plot data every ::1 using 1:3 with lines linestyle 1 title 'contact', \
     data every ::1 using 1:4 with lines linestyle 2 title 'estimate, f32', \
     data every ::1 using 1:5 with lines linestyle 3 title 'LuGre'
unset multiplot
