# SPDX-License-Identifier: MIT
# gnuplot -c figure_8.gp figure_8.csv figure_8.png
height = 1000
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_8.gp')].'style.gp'

set xrange [0:1.2]
set yrange [-17:17]
set ytics 5
set ylabel 'z (µm)'
set format x ''
array rules[2] = ['saturated (published)', 'mean value']
set multiplot layout 4,1 margins 0.09, 0.97, 0.06, 0.96 spacing 0, 0.04

# The first of the seeds. A column of each rule comes five after that of the other.
set key at screen 0.53, 0.995 center top horizontal width 1 # for all panels
do for [rule = 0:1] {
    set label 1 'noise ±0.5 µm, '.rules[rule + 1] at graph 0.99, 0.93 right
    plot data every ::1 using 1:2 with lines linestyle 1 title 'continuous', \
         data every ::1 using 1:(column(3 + 5*rule)) with steps linestyle 12 title 'D_x = 0.5 µm', \
         data every ::1 using 1:(column(4 + 5*rule)) with steps linestyle 13 title '1 µm', \
         data every ::1 using 1:(column(5 + 5*rule)) with steps linestyle 14 title '2 µm'
    unset key
}
do for [rule = 0:1] {
    if (rule == 1) {
        set format x '%g'
        set xlabel 'time (s)'
    }
    set label 1 'noise ±1 µm, '.rules[rule + 1]
    plot data every ::1 using 1:2 with lines linestyle 1, \
         data every ::1 using 1:(column(6 + 5*rule)) with steps linestyle 13, \
         data every ::1 using 1:(column(7 + 5*rule)) with steps linestyle 14
}
unset multiplot
