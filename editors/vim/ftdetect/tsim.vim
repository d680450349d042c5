" Scripts of tsim, LIGGGHTS and LAMMPS: in.NAME, NAME.in, NAME.tsim
au BufRead,BufNewFile in.*,*.in,*.tsim,*.liggghts setfiletype tsim
