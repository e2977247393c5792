# Draws C20_bst_order_residual.svg and C20_bst_order_residual.png:  gnuplot C20_bst_order_residual.gp
# One of them:  gnuplot -e "formats='svg'" C20_bst_order_residual.gp
if (!exists('formats')) formats = 'svg png'
set encoding utf8

# x, y, lower and upper end of the error bar
$series_1 << END
300 0 -0.004030471815 0.004030471815
913 -0.01190384749 -0.01594907944 -0.007858615543
2779 -0.0262507329 -0.03029606429 -0.02220540151
8460 -0.03730685466 -0.04136226326 -0.03325144606
25751 -0.05069957876 -0.05538247964 -0.04601667788
78383 -0.0665841179 -0.07317583384 -0.05999240197
238584 -0.07353449255 -0.08638257435 -0.06068641076
726209 -0.07032003934 -0.09190744675 -0.04873263192
END
$series_2 << END
300 0 -0.004030471815 0.004030471815
913 0.001295970852 -0.002749261099 0.005341202802
2779 0.0001507675362 -0.003894563854 0.004196098926
8460 0.002298076928 -0.001757331671 0.006353485528
25751 0.002107197861 -0.002575703015 0.006790098737
78383 -0.0005753857365 -0.007167101669 0.006016330196
238584 0.005675967172 -0.007172114622 0.01852404897
726209 0.0220921719 0.0005047644838 0.04367957931
END

set lmargin at screen 0.0980
set rmargin at screen 0.9720
set bmargin at screen 0.1094
set tmargin at screen 0.7937
set border 3 lc rgb '#555555' lw 1
set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'
set grid xtics ytics lt 1 lw 1 lc rgb '#E6E6E6'
set errorbars small
set xrange [237.467:917445]
set format x '%.10g'
set logscale x
set xtics ('' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10³' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10⁴' 1e4, '' 2e4 1, '' 3e4 1, '' 4e4 1, '' 5e4 1, '' 6e4 1, '' 7e4 1, '' 8e4 1, '' 9e4 1, '10⁵' 1e5, '' 2e5 1, '' 3e5 1, '' 4e5 1, '' 5e5 1, '' 6e5 1, '' 7e5 1, '' 8e5 1, '' 9e5 1)
set yrange [-0.100043:0.0518148]
set format y '%.10g'
set label 1 'Horton-Strahler number of random binary search trees' at screen 0.0980,0.9437 left font ',22' textcolor rgb '#111111'
set label 2 'sampled mean minus the law through the first point; a law that holds stays level (two standard errors)' at screen 0.0980,0.9031 left font ',15' textcolor rgb '#555555'
set label 3 'n (internal nodes)' at screen 0.5350,0.0312 center font ',16' textcolor rgb '#333333'
set label 4 'mean S_n minus law' at screen 0.0200,0.4516 center rotate font ',16' textcolor rgb '#333333'
set key at screen 0.0880,0.8156 left bottom horizontal Left reverse samplen 2.5 maxcols 1 font ',15' textcolor rgb '#333333'

do for [f in formats] {
  if (f eq 'svg') {
    set terminal svg noenhanced size 1000,640 background rgb 'white' font 'sans-serif,14'
  } else {
    set terminal pngcairo noenhanced size 1000,640 background rgb 'white' fontscale 0.75 font 'DejaVu Sans,14'
  }
  set output 'C20_bst_order_residual.'.f
  plot $series_1 using 1:2 with lines lc rgb '#0072B2' lw 2 pt 7 ps 1 notitle, \
       $series_2 using 1:2 with lines lc rgb '#D55E00' lw 2 pt 5 ps 0.85 notitle, \
       $series_1 using 1:2:3:4 with yerrorbars lc rgb '#0072B2' lw 2 pt 7 ps 1 notitle, \
       $series_2 using 1:2:3:4 with yerrorbars lc rgb '#D55E00' lw 2 pt 5 ps 0.85 notitle, \
       keyentry with linespoints lc rgb '#0072B2' lw 2 pt 7 ps 1 title 'minus log n / log 3: the thesis', \
       keyentry with linespoints lc rgb '#D55E00' lw 2 pt 5 ps 0.85 title 'minus log n / log 3.0438: Kovchegov and Zaliapin’s ratio'
  unset output
}
