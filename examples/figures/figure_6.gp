# SPDX-License-Identifier: MIT
# gnuplot -c figure_6.gp figure_6.csv figure_6.png
height = 800
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_6.gp')].'style.gp'

set xrange [0:1.2]
set multiplot layout 4,1 margins 0.09, 0.97, 0.07, 0.95 spacing 0, 0.045
set ylabel 'force (N)'
set yrange [-2.2:2.2]
set ytics 1
set format x ''
set key at screen 0.53, 0.995 center top horizontal maxrows 1 width -4 # for all panels
plot data every ::1 using 1:2 with lines linestyle 5 notitle, \
     NaN with lines linestyle 1 title 'continuous', \
     NaN with lines linestyle 3 title 'saturated (published)', \
     NaN with lines linestyle 2 title 'mean value'
unset key

set yrange [-16:16]
set ytics 5
spacings = '0.1 1 5'
do for [i = 1:3] {
    set ylabel 'z (µm)'
    if (i == 3) {
        set format x '%g'
        set xlabel 'time (s)'
    }
    set label 1 'D_x = '.word(spacings, i).' µm' at graph 0.99, 0.92 right
    plot data every ::1 using 1:4 with lines linestyle 1, \
         data every ::1 using 1:(column(4 + i)) with steps linestyle 3, \
         data every ::1 using 1:(column(7 + i)) with steps linestyle 2
}
unset multiplot
