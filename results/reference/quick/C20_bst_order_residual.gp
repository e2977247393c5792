# Draws C20_bst_order_residual.svg and C20_bst_order_residual.png:  gnuplot C20_bst_order_residual.gp
# One of them:  gnuplot -e "formats='svg'" C20_bst_order_residual.gp
if (!exists('formats')) formats = 'svg png'
set encoding utf8

# x, y, lower and upper end of the error bar
$series_1 << END
300 0 -0.001809628783 0.001809628783
913 -0.01419384749 -0.01599924283 -0.01238845216
2779 -0.0279457329 -0.02974966245 -0.02614180335
8460 -0.04184685466 -0.0436509272 -0.04004278213
25751 -0.05443624543 -0.05847284689 -0.05039964397
78383 -0.0667541179 -0.07079185967 -0.06271637614
238584 -0.07965449255 -0.08777302241 -0.07153596269
726209 -0.091756706 -0.0998963884 -0.08361702361
2210456 -0.1069587859 -0.1150392471 -0.0988783247
6728249 -0.1204607261 -0.1285267959 -0.1123946563
20479631 -0.1463624374 -0.1542219782 -0.1385028966
62336473 -0.1479642056 -0.156018743 -0.1399096683
189741492 -0.1574659447 -0.1655459279 -0.1493859615
577540440 -0.1754676903 -0.1835155907 -0.1674197899
END
$series_2 << END
300 0 -0.001809628783 0.001809628783
913 -0.0009940291482 -0.002799424484 0.0008113661871
2779 -0.001544232464 -0.003348162014 0.000259697086
8460 -0.002241923072 -0.004045995605 -0.0004378505386
25751 -0.001629468805 -0.005666070266 0.002407132655
78383 -0.0007453857365 -0.004783127504 0.003292356031
238584 -0.0004440328277 -0.008562562686 0.00767449703
726209 0.0006555052326 -0.007484177159 0.008795187625
2210456 -0.001344824897 -0.009425286108 0.006735636314
6728249 -0.001645017148 -0.009711086956 0.00642105266
20479631 -0.01434498348 -0.02220452425 -0.006485442699
62336473 -0.002745005988 -0.01079954332 0.005309531339
189741492 0.0009550002908 -0.007124982915 0.009034983497
577540440 -0.00384499987 -0.01189290027 0.004202900531
END

set lmargin at screen 0.0980
set rmargin at screen 0.9720
set bmargin at screen 0.1094
set tmargin at screen 0.7937
set border 3 lc rgb '#555555' lw 1
set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'
set grid xtics ytics lt 1 lw 1 lc rgb '#E6E6E6'
set errorbars small
set xrange [194.351:8.9149e+08]
set format x '%.10g'
set logscale x
set xtics ('' 2e2 1, '' 3e2 1, '' 4e2 1, '' 5e2 1, '' 6e2 1, '' 7e2 1, '' 8e2 1, '' 9e2 1, '10³' 1e3, '' 2e3 1, '' 3e3 1, '' 4e3 1, '' 5e3 1, '' 6e3 1, '' 7e3 1, '' 8e3 1, '' 9e3 1, '10⁴' 1e4, '' 2e4 1, '' 3e4 1, '' 4e4 1, '' 5e4 1, '' 6e4 1, '' 7e4 1, '' 8e4 1, '' 9e4 1, '10⁵' 1e5, '' 2e5 1, '' 3e5 1, '' 4e5 1, '' 5e5 1, '' 6e5 1, '' 7e5 1, '' 8e5 1, '' 9e5 1, '10⁶' 1e6, '' 2e6 1, '' 3e6 1, '' 4e6 1, '' 5e6 1, '' 6e6 1, '' 7e6 1, '' 8e6 1, '' 9e6 1, '10⁷' 1e7, '' 2e7 1, '' 3e7 1, '' 4e7 1, '' 5e7 1, '' 6e7 1, '' 7e7 1, '' 8e7 1, '' 9e7 1, '10⁸' 1e8, '' 2e8 1, '' 3e8 1, '' 4e8 1, '' 5e8 1, '' 6e8 1, '' 7e8 1, '' 8e8 1)
set yrange [-0.195069:0.020588]
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
