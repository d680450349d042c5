#!/bin/bash
# Particles coupled to a fluid outside: nobody there, the forces against their formulas, restart, heat; and the program
# of examples/library/fluid.c.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
box='units si
boundary p p p
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.2 0.5 0.7 units box
set group all diameter 0.06 density 2500
group a id 1
timestep 1e-5
fix i all nve/sphere
fix cfd all couple/cfd couple_every 10 mpi'

# nobody is coupled: as LIGGGHTS, nothing acts; told once
prints "$box
velocity all set 0.5 0 0
fix f all couple/cfd/force/implicit
dump d all custom 10 c.dump id f_Ksl f_uf[1] f_dragforce[3] vx
run 10
run 10
print 'speed \$(vx[1]) force \$(f_f[1])'" 'speed 0.5 force 0'
[ "$(grep -c 'no program is coupled' out)" = 1 ] && [ "$(tail -n 1 c.dump)" = '2 0 0 0 0.5 ' ]
report 'told once, columns are zero' $? out

# what a program would write; f = dragforce + K (u - v)
fields='set group a property/atom Ksl 7.5
set group a property/atom uf 1 2 3
set group a property/atom dragforce 0.1 0.2 0.3'
agree 'explicit force' "$box
fix f a couple/cfd/force/implicit
$fields
velocity all set 0.5 0 0
run 0
print 'is fx \$(fx[1]) \$(0.1+7.5*(1-0.5))'
print 'is fy \$(fy[1]) \$(0.2+7.5*2)'
print 'is sum \$(f_f[3]) \$(0.3+7.5*3)'
print 'is other \$(fx[2]) 0'"
agree 'Crank-Nicolson' "$box
fix f a couple/cfd/force/implicit CrankNicolson 0.5
$fields
run 0
variable m equal mass(a)
print 'is fx \$(fx[1]) \$(0.1+7.5/(1+0.5*7.5*1e-5/v_m))'"
agree 'force' "$box
fix f all couple/cfd/force
set group a property/atom dragforce 0.1 0.2 0.3
run 0
print 'is fz \$(fz[1]) 0.3'"

# to the velocity of the fluid as 1 - exp(-K t/m)
prints "$box
fix f a couple/cfd/force/implicit
set group a property/atom Ksl 40
set group a property/atom uf 1 0 0
run 1000
print 'off \$(abs(vx[1]-(1-exp(-40*0.01/mass(a))))<1e-3)'" 'off 1'

# a step that the drag cannot bear is refused, with Crank-Nicolson it is none
stiff="fix f a couple/cfd/force/implicit
set group a property/atom Ksl 1e6
run 1"
rejects "$box
$stiff" '2 m/Ksl'
prints "$box
${stiff/implicit/implicit CrankNicolson yes}
print 'runs'" 'runs'

# cut by a restart file
printf '%s\n' "$box
fix f a couple/cfd/force/implicit
$fields
run 10
write_restart half.restart
run 10
print 'end \$(vx[1]:%.17g)'" >in.whole
printf '%s\n' "read_restart half.restart
timestep 1e-5
fix i all nve/sphere
fix cfd all couple/cfd couple_every 10 mpi
fix f a couple/cfd/force/implicit
run 10
print 'end \$(vx[1]:%.17g)'" >in.rest
for run in whole rest; do
	"$TSIM" -in in.$run -log none 2>&1 </dev/null | grep '^end' >$run.out
done
same 'restart' whole.out rest.out

# heat: c_p m dT/dt = flux
agree 'convection' "$box
fix p1 all property/global thermalConductivity peratomtype 100
fix p2 all property/global thermalCapacity peratomtype 10
fix p3 all property/global youngsModulus peratomtype 5e6
fix p4 all property/global poissonsRatio peratomtype 0.3
fix p5 all property/global coefficientRestitution peratomtypepair 1 0.3
fix p6 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
fix h all heat/gran initial_temperature 300
fix c all couple/cfd/convection T0 300
set group a property/atom convectiveHeatFlux 2.5
compute t all reduce max f_Temp
run 100
variable m equal mass(a)
print 'is T \$(c_t) \$(300+2.5*100*1e-5/(10*v_m))'"

rejects "${box/fix cfd/#}
fix f all couple/cfd/force" 'needs a fix couple/cfd before it'
rejects "$box
fix cfd2 all couple/cfd couple_every 10 file data" 'exchange through files is not supported'
rejects "$box
fix f all couple/cfd/force/implicit CrankNicolson 2" 'a number from 0 to 1'
rejects "$box
fix f all couple/cfd/radiation" 'is known from LIGGGHTS'

# shellcheck disable=SC2086
$CC -std=c11 -Wall -Wextra -Werror -pedantic -I"$top_srcdir/src" $CFLAGS "$top_srcdir/examples/library/fluid.c" \
	"$top_builddir/libtsim.a" $TSIM_LIBS -o fluid >out 2>&1 && ./fluid >out 2>&1 && ! grep -q warning out
report 'fluid.c' $? out
finish
