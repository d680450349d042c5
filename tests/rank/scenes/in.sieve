# Rods as rigid bodies and grains fall through meshes that count and delete them, some through two in turn.
units si
atom_style sphere
boundary p f f
newton off
region box block 0 0.12 0 0.06 0 0.08 units box
create_box 2 box
neighbor 0.001 bin
region fill block 0.0 0.119 0.002 0.058 0.004 0.07 units box
lattice sc 0.006
create_atoms 1 region fill
set group all diameter 0.005 density 2500
set group all type/fraction 2 0.3 4711
set type 2 diameter 0.004
fix mol all property/atom mol
variable m atom 1+floor((id-1)/5)
set group all mol v_m
group parts id 1:800
group free subtract all parts
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.7 0.7 0.7 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
pair_style gran model hertz tangential history
pair_coeff * *
timestep 2e-5
velocity all create 0.1 87287 dist gaussian
velocity all set 1.3 -1.1 -0.9 sum yes units box
fix r parts rigid molecule
fix n free nve/sphere
fix 2 all gravity 9.81 vector 0 0 -1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
fix own all property/atom own scalar yes no no 0.5
set group parts property/atom own 0.3
fix gate all mesh/surface primitive plate length 0.2 width 0.1 move 0.06 0.03 0.031 type 1
fix last all mesh/surface primitive plate length 0.2 width 0.1 move 0.06 0.03 0.012 type 1
fix tilt all mesh/surface primitive plate length 0.03 width 0.02 rotate axis 0 1 0 angle 30 move 0.05 0.03 0.05 type 1
fix moved all move/mesh mesh tilt linear 0.3 0 0.1
fix pass all massflow/mesh mesh gate vec_side 0 0 -1 count multiple file ${out}.gate sum_property own writeTime
fix out all massflow/mesh mesh last vec_side 0 0 -1 count once delete_atoms yes file ${out}.csv interval 50
fix some free massflow/mesh mesh tilt vec_side -1 0 -1 count multiple sum_property own screen yes
fix deck all mesh/surface primitive plate length 0.2 width 0.1 move 0.06 0.03 0.04 type 1
fix shake all move/mesh mesh deck wiggle amplitude 0 0 0.001 period 0.01
fix screen all massflow/mesh/sieve mesh deck point_at_outlet 0.06 0.03 -1 count once sieveSize 0.008 sieveSpacing 0.006 sieveStiffness 500 sieveDamping 0.05
compute k all ke/multisphere
compute e all erotate/multisphere
thermo_style custom step atoms ke f_pass[1] f_pass[2] f_pass[3] f_pass[7] f_out[1] f_out[2] f_out[4] f_out[5] f_out[6] f_screen[1] f_screen[2] f_some[1] f_some[2] f_some[7] press
thermo_modify lost ignore format float %20.15g
thermo 50
dump d all custom 100 ${out}.dump id mol f_massflow_out f_massflow_some f_sieve_screen type x y z ix vx vy vz omegax omegay fx fy fz tqx
dump_modify d format float %.17g sort id
run 400
run 400
