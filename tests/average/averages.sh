#!/bin/bash
# Fixes ave/...: files and outputs against numbers known beforehand.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# holds FILE LINES...: the file is just these lines
holds() {
	local file=$1
	shift
	printf '%s\n' "$@" >expected
	same "$file" expected "$file"
}

# two grains fly through a periodic box, one stands
box='units si
atom_style granular
boundary p f f
region box block 0 1 0 1.1 0 1.2 units box
create_box 2 box
neighbor 0.05 bin
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0
timestep 1e-3
create_atoms 1 single 0.3 0.2 0.3 units box
create_atoms 1 single 0.6 0.8 0.3 units box
create_atoms 2 single 0.6 0.5 0.9 units box
set type 1 diameter 0.1 density 1000
set type 2 diameter 0.2 density 2385
velocity all set 0 0 0
set atom 1 vx 1
set atom 2 vx -0.5
group fast type 1
fix move all nve'

agree 'layers: sums over chunks are totals' "$box
compute l all chunk/atom bin/1d x lower 0.25 units box
compute lf fast chunk/atom bin/1d x lower 0.25 units box
fix a all ave/chunk 10 3 100 l vx density/mass density/number mass file a.txt
fix s all ave/spatial 10 3 100 x lower 0.25 vx density/mass units box file s.txt
fix n all ave/chunk 100 1 100 l vx mass norm none
fix f all ave/chunk 100 1 100 lf mass norm none
compute v all vcm/chunk l
compute p all property/chunk l count coord1
variable bin equal 0.25*1.1*1.2
run 100
variable rho equal f_a[1][4]+f_a[2][4]+f_a[3][4]+f_a[4][4]
print \"is mass \$(v_rho*v_bin) \$(mass(all))\"
print \"is sum \$(f_n[1][4]+f_n[2][4]+f_n[3][4]+f_n[4][4]) \$(mass(all))\"
print \"is momentum \$(f_n[1][3]+f_n[2][3]+f_n[3][3]+f_n[4][3]) 0.5\"
print \"is group \$(f_f[1][3]+f_f[2][3]+f_f[3][3]+f_f[4][3]) \$(mass(fast))\"
print \"is count \$(f_a[3][2]) 2\"
print \"is coord \$(f_a[3][1]) 0.625\"
print \"is vx \$(f_a[3][3]) -0.25\"
print \"is number \$(f_a[2][5]) \$(1/v_bin)\"
print \"is vcm \$(c_v[2][1]) 1\"
print \"is vcm \$(c_v[3][1]) \$(-0.5*mass[2]/(mass[2]+mass[3]))\"
print \"is counted \$(c_p[3][1]) 2\"
print \"is spatial \$(f_s[3][4]) \$(f_a[3][4])\""
sed -n '3p;5,9p' a.txt >a.part
holds a.part '# Chunk Coord1 Ncount vx density/mass density/number mass' \
	'  1 0.125 0 0 0 0 0' '  2 0.375 1 1 1.58666 3.0303 0.523599' \
	'  3 0.625 2 -0.25 31.8602 6.06061 5.25693' '  4 0.875 0 0 0 0 0'

agree 'ways to combine averages' "$box
compute t all chunk/atom type
variable s equal step
fix one all ave/chunk 1 2 10 t x norm all
fix run all ave/chunk 1 2 10 t x ave running
fix win all ave/chunk 1 2 10 t x ave window 2
fix t1 all ave/time 1 2 10 v_s ave running start 20
fix t2 all ave/time 1 2 10 v_s v_s off 2 ave window 2
run 30
print \"is one \$(f_one[1][2]) \$((0.3+0.0295+0.6-0.01475)/2)\"
print \"is running \$(f_run[1][2]) \$((0.9+0.5*(0.0095+0.0195+0.0295)/3)/2)\"
print \"is window \$(f_win[1][2]) \$((0.9+0.5*(0.0195+0.0295)/2)/2)\"
print \"is time \$(f_t1) \$((19.5+29.5)/2)\"
print \"is window \$(f_t2[1]) \$((19.5+29.5)/2)\"
print \"is off \$(f_t2[2]) 30\""
agree 'chunks of other kinds' "$box
region left block INF 0.5 INF INF INF INF units box
variable half atom 10*x+0.5
variable id atom id*100
compute s all chunk/atom bin/sphere 0.6 0.5 0.52 0 0.6 3 units box
compute c all chunk/atom bin/cylinder z lower 0.6 0.6 0.5 0 0.6 3 units box discard yes
compute v all chunk/atom v_id compress yes limit 2 max
compute x all chunk/atom v_id compress yes limit 5 exact discard no
compute r all chunk/atom type region left
compute h all chunk/atom v_half
compute ps all property/chunk s count coord1
compute pc all property/chunk c count coord1 coord2
compute pv all property/chunk v id count
compute px all property/chunk x id count
compute pr all property/chunk r count
compute ph all property/chunk h count
compute n all reduce max c_v c_h
print \"is shell \$(c_ps[2][1]) 2\"
print \"is radius \$(c_ps[2][2]) 0.3\"
print \"is far \$(c_ps[3][1]) 1\"
print \"is ring \$(c_pc[2][1]) 1\"
print \"is middle \$(c_pc[2][2]) 0.1\"
print \"is height \$(c_pc[2][3]) 0.9\"
print \"is kept \$(c_n[1]) 2\"
print \"is before \$(c_pv[2][1]) 200\"
print \"is padded \$(c_px[5][2]) 0\"
print \"is left \$(c_pr[1]) 1\"
print \"is none \$(c_pr[2]) 0\"
print \"is whole_part \$(c_ph[6]) 2\"
print \"is last \$(c_n[2]) 6\""
# A box that grows with a grain at 5 a unit of time: the bins of an average are those of its first sample. At the samples of
# the first average, steps 60 to 100, the grain is at 10.999 (+0.25 each), in bin 11 of 11 twice and then above it; the first
# of the second average are at 13.499 ... The numbers of LAMMPS (2022-01-06).
growing='units lj
atom_style sphere
boundary f f s
region reg block 0 10 0 10 0 10 units box
create_box 1 reg
create_atoms 1 single 1 1 0.5 units box
create_atoms 1 single 3 1 4.5 units box
create_atoms 1 single 5 1 9.5 units box
set group all diameter 1 density 1
group top id 3
velocity top set 0 0 5 units box
timestep 0.005'
averaged='pair_style gran/hooke/history 2000.0 NULL 50.0 NULL 0.5 1
pair_coeff * *
fix 1 all nve/sphere
compute l all chunk/atom bin/1d z lower 1 units box
compute v all vcm/chunk l
compute m all chunk/atom bin/1d z lower 1 units box
fix a all ave/chunk 10 5 100 l vz file a.txt
fix t all ave/time 10 5 100 c_v[3] mode vector file t.txt
fix r all ave/chunk 10 5 100 m vz ave running file r.txt'
agree 'bins of a growing box' "$growing
$averaged
run 80
write_restart grown.restart
run 320
print \"is rows \$(f_t[19]) 4\""
awk '/^[0-9]/ { print $1, $2, $3 }' a.txt >a.part
holds a.part '100 11 2.4' '200 14 2.8' '300 16 2.4' '400 19 2.8'
awk '/^[0-9]/ { print $1, $2, $3 }' r.txt >r.part
holds r.part '100 11 2.4' '200 11 4.4' '300 11 6.4' '400 11 8.4'
for file in a r t; do mv $file.txt $file.whole; done
agree 'bins of a growing box, from a restart file within an average' "read_restart grown.restart
$averaged
run 320
print \"is rows \$(f_t[19]) 4\""
for file in a r t; do same "restart: $file.txt" $file.whole $file.txt; done

agree 'chunks that stay' "$box
compute e all chunk/atom bin/1d x lower 0.25 units box
compute o all chunk/atom bin/1d x lower 0.25 units box ids once nchunk once
compute m all msd/chunk o
compute pe all property/chunk e count
compute po all property/chunk o count
compute com all com/chunk o
print \"is here \$(c_pe[2]) 1\"
print \"is here \$(c_po[2]) 1\"
run 900
print \"is gone \$(c_pe[2]) 0\"
print \"is stays \$(c_po[2]) 1\"
print \"is com \$(c_com[2][1]) 1.2\"
print \"is msd \$(c_m[2][4]) 0.81\"
print \"is msd \$(c_m[3][1]) \$((0.45*mass[2]/(mass[2]+mass[3]))^2)\""
agree 'moments of chunks' "$box
set atom 1 vy 0.3
compute t all chunk/atom type
compute g all gyration/chunk t
compute gt all gyration/chunk t tensor
compute i all inertia/chunk t
compute l all angmom/chunk t
compute w all omega/chunk t
compute f all torque/chunk t
compute k all temp/chunk t temp kecom internal com yes
compute d all gyration
compute gf fast gyration
variable m equal mass[1]
run 0
print \"is radius \$(c_g[1]) \$(c_gf)\"
print \"is radius \$(c_g[1]) \$(sqrt(0.3^2+0.6^2)/2)\"
print \"is xy \$(c_gt[1][4]) \$(0.3*0.6/4)\"
print \"is ixx \$(c_i[1][1]) \$(2*v_m*0.09)\"
print \"is ixy \$(c_i[1][4]) \$(-2*v_m*0.15*0.3)\"
print \"is lz \$(c_l[1][3]) \$(v_m*(0.3*1+0.3*0.5-0.15*0.3))\"
print \"is wz \$(c_w[1][3]) \$(c_l[1][3]/(2*v_m*0.1125))\"
print \"is wx \$(c_w[1][1]) 0\"
print \"is torque \$(c_f[1][2]) 0\"
print \"is kecom \$(c_k[1][2]) \$(v_m*(0.5^2+0.3^2)/4)\"
print \"is internal \$(c_k[1][3]) \$(v_m*(1.5^2+0.3^2)/4)\"
print \"is kelvin \$(c_k[1][1]*1.380649e-23) \$(2*c_k[1][3]/6)\""
agree 'averages of each particle' "$box
fix a all ave/atom 10 3 100 x vx
fix f fast ave/atom 1 1 100 vx
compute x all reduce sum f_a[1] f_a[2] f_f
run 50
print \"is early \$(c_x[1]) 0\"
run 50
print \"is x \$(c_x[1]) \$(1.5+0.5*0.09)\"
print \"is v \$(c_x[2]) 0.5\"
print \"is now \$(c_x[3]) 0.5\"
create_atoms 1 single 0.1 0.1 1.0 units box
set atom 4 diameter 0.1 density 1000 vy 0.01
run 100
print \"is four \$(c_x[1]) \$(1.6+0.5*0.19)\""
agree 'histograms' "$box
fix h all ave/histo 10 3 100 -1 1 4 vx vy file h.txt
fix e all ave/histo 100 1 100 -0.25 0.25 2 vx beyond end
fix x all ave/histo 100 1 100 -0.25 0.25 2 vx beyond extra
fix r all ave/histo 10 3 100 0 1.06 2 x ave running
fix w fast ave/histo/weight 100 1 100 0 1 2 x mass
variable step equal step
fix k all ave/histo 100 1 100 0 1000 10 v_step
run 200
print \"is total \$(f_h[1]) 18\"
print \"is missing \$(f_x[2]) 0\"
print \"is ends \$(f_e[1][2]+10*f_e[2][2]) 21\"
print \"is extra \$(f_x[1][2]+10*f_x[2][2]+100*f_x[3][2]+1000*f_x[4][2]) 1101\"
print \"is least \$(f_h[3]) -0.5\"
print \"is largest \$(f_h[4]) 1\"
print \"is coord \$(f_h[4][1]) 0.75\"
print \"is count \$(f_h[4][2]) 3\"
print \"is part \$(f_h[3][3]) \$(12/18)\"
print \"is sum \$(f_r[1]) 18\"
print \"is left \$(f_r[1][2]) 9\"
print \"is weight \$(f_w[1]) \$(mass(fast))\"
print \"is scalar \$(f_k[3][2]) 1\""
sed -n '3,8p' h.txt >h.part
holds h.part '# Bin Coord Count Count/Total' '100 4 18 0 -0.5 1' '1 -0.75 0 0' '2 -0.25 3 0.166667' \
	'3 0.25 12 0.666667' '4 0.75 3 0.166667'
agree 'files: overwrite, format, titles' "$box
variable s equal step/8
compute t all chunk/atom type
fix o all ave/time 1 1 10 v_s file o.txt overwrite format %12.6f title1 one title2 two
fix v all ave/chunk 1 1 10 t x file v.txt overwrite title3 '# three'
run 30
print 'is done 1 1'"
holds o.txt one two '30     3.750000'
sed -n '2,4p' v.txt >v.part
holds v.part '# Timestep Number-of-chunks Total-count' '# three' '30 2 3'

layers="$box
compute l all chunk/atom bin/1d x lower 0.25 units box"
rejects "$box
compute l all chunk/atom bin/4d x lower 0.25" "did you mean 'bin/"
rejects "$box
compute l all chunk/atom bin/1d x bottom 0.25" "origin 'bottom' is not"
rejects "$box
compute l all chunk/atom bin/1d x lower 0" 'delta'
rejects "$box
compute l all chunk/atom bin/2d x lower 0.1 x lower 0.1" 'the same axis twice'
rejects "$box
compute l all chunk/atom bin/1d x lower 0.1 limit 5 max" 'needs compress yes'
rejects "$box
compute l all chunk/atom bin/sphere 0 0 0 2 1 5" 'rmax must be larger'
rejects "$box
compute l all chunk/atom bin/1d x lower 0.1 bound x 0" 'two bounds'
rejects "$box
compute l all chunk/atom type x" 'type: '
rejects "$box
compute g all gyration
fix a all ave/chunk 1 1 1 g vx" 'of style gyration, expected chunk/atom'
rejects "$layers
fix a all ave/chunk 3 1 10 l vx" 'must be a multiple'
rejects "$layers
fix a all ave/chunk 1 1 10 l ke" 'ke'
rejects "$layers
fix a all ave/chunk 1 1 10 l vx file a overwrite append b" 'expected either file or append'
rejects "$layers
fix a all ave/chunk 1 1 10 l vx file a format %s" "format '%s' is not a format"
rejects "$box
fix a all ave/spatial 1 1 10 lower 0.1 vx" 'expected x, y or z'
rejects "$box
fix a all ave/spatial 1 1 10 x lower 0.1" 'no value is named'
rejects "$box
fix a all ave/histo 1 1 10 1 0 5 vx" 'lo must be less than hi'
rejects "$box
fix a all ave/histo/weight 1 1 10 0 1 5 vx" 'expected two values'
rejects "$box
fix a all ave/time 1 1 10 ke off 2" 'from 1 to 1'
rejects "$box
compute p all property/chunk l count" "there is no compute 'l'"
rejects "$layers
compute p all property/chunk l coord2
compute s all slice 1 1 1 c_p
print \$(c_s[1])" 'the chunks have 1 coordinates'
rejects "$box
variable n atom 1+id*(step>0)
compute c all chunk/atom v_n compress yes
fix a all ave/chunk 1 1 1 c vx ave running
run 1" 'averages cannot be combined'
rejects "$box
variable n atom 1+id*(step>1)
compute c all chunk/atom v_n compress yes
fix a all ave/chunk 1 2 2 c vx
run 2" 'use `ids nfreq`'
# an array by its name alone: all of its columns
cat >in.script <<'END'
units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 random 900 4711 NULL
set group all diameter 0.05 density 1000
neighbor 0.05 bin
pair_style gran/hooke 1e4 NULL 3 NULL 0.4 0
pair_coeff * *
fix m all nve/sphere
timestep 1e-4
compute r all rdf 7
fix a all ave/time 1 2 2 c_r mode vector file all.txt
fix b all ave/time 1 2 2 c_r[*] mode vector file star.txt
run 4
END
"$TSIM" -in in.script -log none >out 2>&1
report 'all columns of an array run' $? out
grep -v 'data for' all.txt >all
grep -v 'data for' star.txt >star
[ "$(awk 'NF == 4 && $3 > 0 && $1 > 0' all | wc -l)" -gt 4 ]
report 'rows of all columns' $? all
same 'all columns of an array' star all
# Before the first sample the elements of columns are 0, whether the style tells their number or not. The radii are 0.5 and 6.5 of
# seven parts of the cutoff, 0.05.
sed -e '/^fix a/,$d' in.script >in.rows
cat >>in.rows <<'END'
fix a all ave/time 1 2 2 c_r mode vector
fix b all ave/time 1 2 2 c_r[1] mode vector
compute c all chunk/atom bin/1d z lower 0.25 units box
compute n all property/chunk c count
fix c all ave/time 1 2 2 c_n mode vector
compute k all chunk/atom type nchunk once
compute m all property/chunk k count
fix d all ave/time 1 2 2 c_m mode vector
thermo 2
thermo_style custom step f_a[7][1] f_a[1][1] f_b[7] f_b[1] f_c[4] f_d[1]
run 2
END
"$TSIM" -in in.rows -log none >out 2>&1
report 'rows before the first sample' $? out
[ "$(awk '$1 ~ /^[02]$/ && NF == 7 { print $2, $3, $4, $5, ($1 ? $6 > 150 : $6), $7 }' out | tr '\n' ' ')" = \
	'0 0 0 0 0 0 0.046428571 0.0035714286 0.046428571 0.0035714286 1 900 ' ]
report 'values before the first sample' $? out
# a vector whose elements are not there at the set-up
cat >in.later <<'END'
units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
timestep 1
fix v all vector 1 step
compute s all slice 2 3 1 f_v
fix a all ave/time 1 1 4 c_s mode vector start 1
run 4
print "later $(f_a[1]) $(f_a[2])"
END
"$TSIM" -in in.later -log none >out 2>&1
report 'elements that come later' $? out
grep -q '^later 1 2$' out
report 'values that come later' $? out
# Faces of style s follow the particles only when lists are built: what is below them is in the lowest bin, with any skin.
for skin in 0.03 0.002; do
	cat >in.shrink <<END
units si
boundary f f s
region b block 0 1 0 1 0 1 units box
create_box 1 b
$(for z in 0.2 0.2 0.2 0.8 0.8; do n=$((n + 1)); echo "create_atoms 1 single 0.$n 0.$n $z units box"; done)
set group all diameter 0.05 density 1000
neighbor $skin bin
region low block INF INF INF INF INF 0.5 units box
group low region low
velocity all set 0 0 1 units box
velocity low set 0 0 -1 units box
fix m all nve/sphere
timestep 1e-4
compute c all chunk/atom bin/1d z lower 0.1 units box
compute n all property/chunk c count
variable s equal sum(c_n)
thermo_style custom step v_s
thermo 10
run 40
END
	"$TSIM" -in in.shrink -log none >out 2>&1
	[ "$(awk '/^ +[0-9]+ +[0-9]+ *$/ { printf "%s ", $2 }' out)" = '5 5 5 5 5 ' ]
	report "bins in a box that shrinks, skin $skin" $? out
done
finish
