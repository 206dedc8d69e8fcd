# SPDX-License-Identifier: MIT
# gnuplot -c figure_8.gp figure_8.csv figure_8.png
height = 700
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_8.gp')].'style.gp'

set xrange [0:1.2]
set yrange [-17:17]
set ytics 5
set ylabel 'z (µm)'
set key bottom center horizontal
set multiplot layout 2,1 margins 0.09, 0.97, 0.08, 0.98 spacing 0, 0.08

set label 1 'noise ±0.5 µm' at graph 0.99, 0.94 right
plot data every ::1 using 1:2 with lines linestyle 1 title 'continuous', \
     data every ::1 using 1:3 with steps linestyle 3 title 'D_x = 0.5 µm', \
     data every ::1 using 1:4 with steps linestyle 2 title '1 µm', \
     data every ::1 using 1:5 with steps linestyle 4 title '2 µm'

set label 1 'noise ±1 µm'
set xlabel 'time (s)'
plot data every ::1 using 1:2 with lines linestyle 1 title 'continuous', \
     data every ::1 using 1:6 with steps linestyle 3 title 'D_x = 1 µm', \
     data every ::1 using 1:7 with steps linestyle 2 title '2 µm'
unset multiplot
