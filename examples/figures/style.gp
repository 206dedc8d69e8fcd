# SPDX-License-Identifier: MIT
# What all pictures have in common. Wants `picture`, the file to make, and `height`, in pixels.

set encoding utf8
set datafile separator ','
set terminal png size 800,height font 'DejaVu Sans,10' linewidth 1.2 # of few colours, and small
set output picture

# The continuous model is broad and pale and lies behind what is compared with it
set style line 1 linecolor rgb '#b0bcc8' linewidth 4
set style line 2 linecolor rgb '#c2410c' linewidth 1.5
set style line 3 linecolor rgb '#1d4ed8' linewidth 1.5
set style line 4 linecolor rgb '#15803d' linewidth 1.5
set style line 5 linecolor rgb '#404040' linewidth 1.2 # forces, and what is no friction

set border 3 linecolor rgb '#606060'
set tics nomirror out textcolor rgb '#303030'
set grid linecolor rgb '#e0e0e0' linewidth 0.6 dashtype 1
set key samplen 2 spacing 1.15
