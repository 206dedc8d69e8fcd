# SPDX-License-Identifier: MIT
# gnuplot -c figure_7.gp figure_7.csv figure_7.png
height = 620
data = ARG1
picture = ARG2
load ARG0[1:strlen(ARG0)-strlen('figure_7.gp')].'style.gp'

begins = '0.20 0.65 0.98'
ends = '0.34 0.78 1.10'
lows = '-11 9 -14'
highs = '15 15 4'
array names[3] = ['the initial error goes', 'the slide gathers speed', 'released']
array rules[2] = ['saturated (published)', 'mean value']

set multiplot layout 2,3 margins 0.08, 0.985, 0.1, 0.95 spacing 0.06, 0.1
do for [rule = 0:1] {
    do for [i = 1:3] {
        set title (rule == 0 ? names[i] : '')
        set xrange [word(begins, i) + 0:word(ends, i) + 0]
        set xtics 0.05
        set yrange [word(lows, i) + 0:word(highs, i) + 0]
        set ylabel (i == 1 ? rules[rule + 1].': z (µm)' : '')
        set xlabel (rule == 1 ? 'time (s)' : '')
        if (rule == 0 && i == 2) { set key top right } else { unset key }
        first = 5 + 3*rule
        within(t) = t >= word(begins, i) && t <= word(ends, i) ? t : NaN
        plot data every ::1 using (within($1)):4 with lines linestyle 1 title 'continuous', \
             data every ::1 using (within($1)):(column(first + 2)) with steps linestyle 15 title 'D_x = 5 µm', \
             data every ::1 using (within($1)):(column(first + 1)) with steps linestyle 13 title '1 µm', \
             data every ::1 using (within($1)):(column(first)) with steps linestyle 11 title '0.1 µm'
    }
}
unset multiplot
