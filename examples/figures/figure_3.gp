# SPDX-License-Identifier: MIT
# gnuplot -c figure_3.gp figure_3.csv figure_3.png
height = 560
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_3.gp')].'style.gp'

set xrange [-1:8]
set multiplot layout 2,1 margins 0.09, 0.97, 0.10, 0.96 spacing 0, 0.12

set ylabel 'applied force (N)'
set yrange [-0.1:1]
set arrow 1 from -1, 0.8 to 8, 0.8 nohead linecolor rgb '#909090'
set label 1 'f_{ba}' at 7.9, 0.87 right
plot data every ::1 using 1:2 with lines linestyle 5 notitle
unset arrow 1
unset label 1

set ylabel 'displacement (µm)'
set xlabel 'time (s)'
set yrange [-5:95]
set arrow 2 from -1, 22 to 8, 22 nohead linecolor rgb '#909090'
set label 2 '2 z_{max}' at -0.9, 26
set key top left
plot data every ::1 using 1:5 with lines linestyle 3 linewidth 5 linecolor rgb '#9db8f2' title 'Dahl', \
     data every ::1 using 1:4 with lines linestyle 2 title 'LuGre', \
     data every ::1 using 1:3 with lines linestyle 4 title 'elasto-plastic'
unset multiplot
