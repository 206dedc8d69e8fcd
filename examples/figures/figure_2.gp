# SPDX-License-Identifier: MIT
# gnuplot -c figure_2.gp figure_2.csv figure_2.png
height = 450
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_2.gp')].'style.gp'

set xlabel 'velocity v/v_s (v_s = 1 mm/s)'
set ylabel 'steady-state friction f_{ss} (N)'
set xzeroaxis linetype 1 linecolor rgb '#909090'
set xrange [-5:5]
set yrange [-1.7:1.7]
set ytics ('-f_{max} = -1.5' -1.5, '-f_c = -1' -1, '0' 0, 'f_c = 1' 1, 'f_{max} = 1.5' 1.5)
set key at graph 0.97, 0.35 right
plot data every ::1 using 1:4 with lines linestyle 2 title 'Lorentzian (8)', \
     data every ::1 using 1:3 with lines linestyle 3 title 'Gaussian (7)', \
     data every ::1 using 1:2 with lines linestyle 4 title 'Coulomb (6)'
