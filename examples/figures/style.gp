# SPDX-License-Identifier: MIT
# What all pictures have in common. Wants `picture`, the file to make, and `height`, in pixels.

set encoding utf8
set datafile separator ','
set terminal png size 800,height font 'DejaVu Sans,10' linewidth 1.2 # of few colours, and small
set output picture

# The continuous model is broad and pale and lies behind what is compared with it
set style line 1 linecolor rgb '#b0bcc8' linewidth 4
# Where they differ in the rule, 2 is mean value and 3 saturated
set style line 2 linecolor rgb '#c2410c' linewidth 1.5
set style line 3 linecolor rgb '#1d4ed8' linewidth 1.5
set style line 4 linecolor rgb '#15803d' linewidth 1.5
set style line 5 linecolor rgb '#404040' linewidth 1.2 # forces, and what is no friction

# One colour for each distance between updates, in all pictures where curves differ in that
set style line 11 linecolor rgb '#7e22ce' linewidth 1.5 # D_x = 0.1 µm
set style line 12 linecolor rgb '#f59e0b' linewidth 1.5 # 0.5 µm
set style line 13 linecolor rgb '#0d9488' linewidth 1.5 # 1 µm
set style line 14 linecolor rgb '#db2777' linewidth 1.5 # 2 µm
set style line 15 linecolor rgb '#854d0e' linewidth 1.5 # 5 µm

set border 3 linecolor rgb '#606060'
set tics nomirror out textcolor rgb '#303030'
set grid linecolor rgb '#e0e0e0' linewidth 0.6 dashtype 1
set key samplen 2 spacing 1.3
