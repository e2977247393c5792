# Draws H2_ternary.svg and H2_ternary.png:  gnuplot H2_ternary.gp
# One of them:  gnuplot -e "formats='svg'" H2_ternary.gp
if (!exists('formats')) formats = 'svg png'
set encoding utf8

# x, y, lower and upper end of the error bar
$series_1 << END
0 4.714596417 4.714596417 4.714596417
1 3.487457727 3.487457727 3.487457727
2 3.89264253 3.89264253 3.89264253
3 4.221040638 4.221040638 4.221040638
4 4.63624849 4.63624849 4.63624849
END
$curve_1 << END
0 4.714596417 4.714596417 4.714596417
1 3.487457727 3.487457727 3.487457727
2 3.89264253 3.89264253 3.89264253
3 4.221040638 4.221040638 4.221040638
4 4.63624849 4.63624849 4.63624849
END
$guide_1 << END
0 4.8 4.8 4.8
5 4.8 4.8 4.8
END
$series_2 << END
0 4.448963092 4.448963092 4.448963092
1 3.147611175 3.147611175 3.147611175
2 3.174619605 3.174619605 3.174619605
3 3.154917688 3.154917688 3.154917688
4 3.21481787 3.21481787 3.21481787
5 3.479145426 3.479145426 3.479145426
END
$curve_2 << END
0 4.448963092 4.448963092 4.448963092
1 3.147611175 3.147611175 3.147611175
2 3.174619605 3.174619605 3.174619605
3 3.154917688 3.154917688 3.154917688
4 3.21481787 3.21481787 3.21481787
5 3.479145426 3.479145426 3.479145426
END
$guide_2 << END
0 3.19 3.19 3.19
5 3.19 3.19 3.19
END
$series_3 << END
0 5.026026727 5.026026727 5.026026727
1 3.982279937 3.982279937 3.982279937
2 5.215432839 5.215432839 5.215432839
3 4.633761649 4.633761649 4.633761649
END
$curve_3 << END
0 5.026026727 5.026026727 5.026026727
1 3.982279937 3.982279937 3.982279937
2 5.215432839 5.215432839 5.215432839
3 4.633761649 4.633761649 4.633761649
END
$guide_3 << END
0 7.05 7.05 7.05
5 7.05 7.05 7.05
END
$series_4 << END
0 4.763768184 4.763768184 4.763768184
1 3.496160004 3.496160004 3.496160004
2 3.953533686 3.953533686 3.953533686
3 3.274099241 3.274099241 3.274099241
4 3.084089191 3.084089191 3.084089191
END
$curve_4 << END
0 4.763768184 4.763768184 4.763768184
1 3.496160004 3.496160004 3.496160004
2 3.953533686 3.953533686 3.953533686
3 3.274099241 3.274099241 3.274099241
4 3.084089191 3.084089191 3.084089191
END
$guide_4 << END
0 3.19 3.19 3.19
5 3.19 3.19 3.19
END

set lmargin at screen 0.0980
set rmargin at screen 0.9720
set bmargin at screen 0.1094
set tmargin at screen 0.8266
set border 3 lc rgb '#555555' lw 1
set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'
set grid xtics ytics lt 1 lw 1 lc rgb '#E6E6E6'
set errorbars small
set xrange [-0.15:5.15]
set format x '%.10g'
set xtics 1
set yrange [2.84613:7.28795]
set format y '%.10g'
set label 1 'Ternary trees of p = 1/R: their stream ratios' at screen 0.0980,0.9437 left font ',22' textcolor rgb '#111111'
set label 2 'expected counts at n = 1000, exact; dashed: R = 1/p' at screen 0.0980,0.9031 left font ',15' textcolor rgb '#555555'
set label 3 'order k (leaf order 0)' at screen 0.5350,0.0312 center font ',16' textcolor rgb '#333333'
set label 4 'M_k / M_(k+1)' at screen 0.0200,0.4688 center rotate font ',16' textcolor rgb '#333333'
set key at screen 0.0880,0.8484 left bottom horizontal Left reverse samplen 2.5 maxcols 4 font ',15' textcolor rgb '#333333'

do for [f in formats] {
  if (f eq 'svg') {
    set terminal svg noenhanced size 1000,640 background rgb 'white' font 'sans-serif,14'
  } else {
    set terminal pngcairo noenhanced size 1000,640 background rgb 'white' fontscale 0.75 font 'DejaVu Sans,14'
  }
  set output 'H2_ternary.'.f
  plot $curve_1 using 1:2 with lines lc rgb '#0072B2' lw 2 notitle, \
       $guide_1 using 1:2 with lines lc rgb '#0072B2' lw 2 dt (9,6) notitle, \
       $curve_2 using 1:2 with lines lc rgb '#D55E00' lw 2 notitle, \
       $guide_2 using 1:2 with lines lc rgb '#D55E00' lw 2 dt (9,6) notitle, \
       $curve_3 using 1:2 with lines lc rgb '#009E73' lw 2 notitle, \
       $guide_3 using 1:2 with lines lc rgb '#009E73' lw 2 dt (9,6) notitle, \
       $curve_4 using 1:2 with lines lc rgb '#CC79A7' lw 2 notitle, \
       $guide_4 using 1:2 with lines lc rgb '#CC79A7' lw 2 dt (9,6) notitle, \
       $series_1 using 1:2:3:4 with yerrorbars lc rgb '#0072B2' lw 1.5 pt 7 ps 1 notitle, \
       $series_2 using 1:2:3:4 with yerrorbars lc rgb '#D55E00' lw 1.5 pt 5 ps 0.85 notitle, \
       $series_3 using 1:2:3:4 with yerrorbars lc rgb '#009E73' lw 1.5 pt 9 ps 1.1 notitle, \
       $series_4 using 1:2:3:4 with yerrorbars lc rgb '#CC79A7' lw 1.5 pt 13 ps 1.15 notitle, \
       keyentry with linespoints lc rgb '#0072B2' lw 2 pt 7 ps 1 title 'white_fir', \
       keyentry with linespoints lc rgb '#D55E00' lw 2 pt 5 ps 0.85 title 'maple_forest', \
       keyentry with linespoints lc rgb '#009E73' lw 2 pt 9 ps 1.1 title 'maple_open', \
       keyentry with linespoints lc rgb '#CC79A7' lw 2 pt 13 ps 1.15 title 'maple_varying'
  unset output
}
