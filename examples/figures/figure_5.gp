# SPDX-License-Identifier: MIT
# gnuplot -c figure_5.gp figure_5.csv figure_5.png
height = 450
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_5.gp')].'style.gp'

set xlabel 'deflection z (µm)' offset 0, -0.5
set ylabel 'plastic share α(z, v), of 1'
set xrange [-16:16]
set yrange [-0.05:1.15]
set xtics ("-15\n-z_{max}" -15, "-10\n-z_c" -10, "-8\n-z_{ba}" -8, '0' 0, "8\nz_{ba}" 8, "10\nz_c" 10, "15\nz_{max}" 15)
set label 'elastic' at 0, 0.06 center textcolor rgb '#606060'
set label 'mixed' at 12.6, 0.5 textcolor rgb '#606060'
set label 'plastic' at 15.4, 1.06 center textcolor rgb '#606060'
set key at graph 0.5, 0.85 center top spacing 1.7
plot data every ::1 using 1:2 with lines linestyle 2 title 'v > 0, slow: z_{ss} near z_{max}', \
     data every ::1 using 1:3 with lines linestyle 3 title 'v = v_s', \
     data every ::1 using 1:4 with lines linestyle 4 title 'fast: z_{ss} near z_c', \
     data every ::1 using 1:5 with lines linestyle 5 title 'v < 0, slow'
