# Colours and lines that the charts of this folder share.
set style line 1 lc rgb '#0b3c5d' lw 1.8 pt 7 ps 0.7
set style line 2 lc rgb '#d9782d' lw 1.8 pt 5 ps 0.7
set style line 3 lc rgb '#328cc1' lw 1.8 pt 9 ps 0.9
set style line 4 lc rgb '#7a9e3f' lw 1.8 pt 13 ps 0.9
set style line 5 lc rgb '#8a4f7d' lw 1.8 pt 11 ps 0.9
set style line 9 lc rgb '#999999' lw 1 dt 2
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#e5e5e5' lt 1
set key reverse Left samplen 2
# the lines of a file that begin with a key
of(key, file) = sprintf('< awk ''$1 == "%s"'' %s', key, file)
