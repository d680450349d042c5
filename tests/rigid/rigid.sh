#!/bin/bash
# Rigid bodies: mass and inertia of spheres, momentum, periodic faces, loss of a member, coming apart.
# That restarts and threads change nothing is seen with in.rigid.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Two bodies of three and two spheres that overlap, and a single sphere between them.
cat >in.scene <<'END'
units si
boundary ${faces}
newton off
communicate single vel yes
region box block 0 1 0 1.2 0 0.9 units box
create_box 2 box
create_atoms 1 single 0.41 0.50 0.30
create_atoms 1 single 0.45 0.53 0.32
create_atoms 2 single 0.47 0.57 0.34
create_atoms 2 single 0.71 0.52 0.33
create_atoms 1 single 0.76 0.50 0.31
create_atoms 1 single 0.59 0.54 0.32
set type 1 diameter 0.0865 density 2470
set type 2 diameter 0.0785 density 1830
group left id 1 2 3
group right id 4 5
group free id 6
velocity left set 1.3 0.2 0.1
velocity right ramp vy -0.7 0.9 x 0.7 0.8
pair_style gran model hooke tangential history
pair_coeff * *
fix m1 all property/global youngsModulus peratomtype 5e6 7e6
fix m2 all property/global poissonsRatio peratomtype 0.31 0.27
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.7 0.6 0.6 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.4 0.4 0.2
fix m5 all property/global characteristicVelocity scalar 2
fix n free nve/sphere
fix r all rigid group 2 left right
timestep 1e-4
END

agree 'mass, centre and moments of a dumbbell' '
variable faces index "p p p"
include in.scene
unfix r
region one block 0.5 0.52 0.5 0.52 0.5 0.52 units box
group r2 id 4 5
fix d right rigid single
compute m all multisphere property masstotal
compute i all multisphere property inertia
compute x all multisphere property xcm
compute mass all reduce sum c_m
compute trace all reduce sum c_i[1] c_i[2] c_i[3]
compute centre all reduce sum c_x[1] c_x[2] c_x[3]
variable a equal 1830*PI*0.0785^3/6
variable b equal 2470*PI*0.0865^3/6
variable mu equal v_a*v_b/(v_a+v_b)
variable d2 equal 0.05^2+2*0.02^2
variable own equal 0.1*(v_a*0.0785^2+v_b*0.0865^2)
print "is mass $(c_mass:%.17g) $(v_a+v_b:%.17g)"
print "is centre $(c_centre[1]:%.17g) $((v_a*0.71+v_b*0.76)/(v_a+v_b):%.17g)"
print "is moments $(c_trace[1]+c_trace[2]+c_trace[3]:%.17g) $(2*v_mu*v_d2+3*v_own:%.17g)"'

agree 'momenta are kept in a collision' '
variable faces index "p p p"
include in.scene
compute lx all reduce sum vx
variable px atom mass*vx
variable pz atom mass*vz
compute p all reduce sum v_px v_pz
variable before equal $(c_p[1]:%.17g)
variable beforez equal $(c_p[2]:%.17g)
compute touch all contact/atom
compute most all reduce max c_touch
fix met all ave/time 1 1 1 c_most mode scalar
run 900
print "is px $(c_p[1]:%.17g) $(v_before:%.17g)"
print "is pz $(c_p[2]:%.17g) $(v_beforez:%.17g)"
variable met equal xcm(free,x)>0.6
print "is met ${met} 1"'

agree 'distances in a body stay, across periodic faces too' '
variable faces index "p p p"
include in.scene
velocity left set 3 -2 4
fix r all rigid group 2 left right
variable d equal sqrt((xcm(a,x)-xcm(b,x))^2+(xcm(a,y)-xcm(b,y))^2+(xcm(a,z)-xcm(b,z))^2)
group a id 1
group b id 3
variable was equal $(v_d:%.17g)
run 5000
print "is distance $(v_d:%.17g) ${was}"
print "is crossed $(xcm(a,z)>0.9) 1"'

prints 'variable faces index "p p f"
include in.scene
fix g left gravity 40 vector 0 0 1
thermo_style custom step atoms
run 2000' '*    2000        3'

prints 'variable faces index "p p p"
include in.scene
fix r all rigid group 2 left right force * off on on torque 2 off off off
fix g all gravity 40 vector 1 1 0
unfix n
run 0
compute v all multisphere property vcm
compute w all multisphere property omega
run 50
compute vx all reduce max c_v[1]
compute wz all reduce min c_w[3]
compute mx all reduce min c_v[1]
print "$(c_vx:%.4f) $(c_mx:%.4f)"' '1.3000 0.0000'

prints 'variable faces index "p p p"
include in.scene
run 10
unfix r
run 0
variable m equal count(all)
compute b all property/atom mol
compute most all reduce max c_b
print "bodies left: $(c_most)"' 'bodies left: 0'

rejects 'variable faces index "p p p"
include in.scene
fix again left rigid single' 'belongs to a rigid body already'
rejects 'variable faces index "p p p"
include in.scene
fix again all rigid group 3 left right' 'expected 3 groups, found 2'
rejects 'variable faces index "p p p"
include in.scene
group none id 77
fix again none rigid single' 'no particles'
rejects 'variable faces index "p p p"
include in.scene
fix r all rigid group 2 left right torque 3 on on on' 'expected one of the 2 bodies'
rejects 'variable faces index "p p p"
include in.scene
fix r all rigid group 2 left right force 1 on maybe on' 'expected on or off'
rejects 'variable faces index "p p p"
include in.scene
unfix r
fix r all rigid molecule' 'particles belong to no molecules'

# bodies by molecules, in the order of their numbers: right is the first, the single sphere the last
agree 'molecules' 'variable faces index "p p p"
include in.scene
unfix r
unfix n
fix m all property/atom mol ghost yes
set group right mol 3
set group left mol 8
set group free mol 11
fix r all rigid molecule force 1 off on on
run 0
variable centre equal xcm(left,x)
compute m all multisphere property masstotal
compute least all reduce min c_m
print "is lightest $(c_least:%.17g) $(mass(free):%.17g)"
print "is left $(f_r[2][1]:%.17g) $(v_centre:%.17g)"
print "is free $(f_r[3][1]:%.17g) 0.59"
run 100
print "is held $(vcm(right,x):%.17g) $(f_r[1][4]:%.17g) 1"'

# Where nobody looks at bodies between two steps, the end of one and the beginning of the next are one pass: the same bits as
# in steps in each of which something looks, with a step that changes, and with gravity, which acts on bodies as a whole.
cat >in.looks <<'END'
variable faces index "p p p"
include in.scene
fix g all gravity 9.81 vector 0 0 -1
variable speed equal vcm(left,x)
${look}
run 170
timestep 0.7e-4
run 130
dump d all custom 1 ${out} id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz
dump_modify d sort id format float %.17g
run 0
END
moved() { # moved THREADS LOOK NAME
	"$TSIM" -in in.looks -log none -threads "$1" -var look "$2" -var out "$3" >out 2>&1
	report "bodies: $3, $1 threads" $? out
}
moved 1 'print nothing' none
for threads in 1 2; do
	moved $threads 'thermo 1' thermo
	moved $threads 'fix p all print 3 "${speed}" screen no' print
	moved $threads 'restart 1 step.restart' saved
	moved $threads 'print nothing' again
	for look in thermo print saved again; do same "bodies: $look, $threads threads: the same bits" none $look; done
done
# two: a body of two spheres that touch; its centre of mass at x = 0.054
two() {
	echo "units si
boundary $1
region box block 0 0.1 0 0.1 0 0.1 units box
create_box 1 box
create_atoms 1 single 0.05 0.05 0.05 units box
create_atoms 1 single 0.058 0.05 0.05 units box
set group all diameter 0.008 density 2500
timestep 1e-5
group body id 1 2"
}

# In a box that changes its length bodies keep their place, as single particles do, or are mapped by their centre of mass;
# also after they have crossed a face, with parts of them on both sides.
# deformed REMAP SHIFT PLACE...: places of both members and of a single particle, the body moved by SHIFT before
deformed() {
	prints "$(two 'p p p')
create_atoms 1 single 0.05 0.08 0.05 units box
set atom 3 diameter 0.008 density 2500
group one id 3
fix one one nve/sphere
fix body body rigid single
velocity all set 1 0 0 units box
run $2
velocity all set 0 0 0 units box
fix deform all deform 1 x erate -10 remap $1
run 1000
print \"at \$(lx:%.6f) \$(x[1]:%.6f) \$(x[2]:%.6f) \$(x[3]:%.6f)\"" "at 0.090000 $3"
}
deformed none 0 '0.050000 0.058000 0.050000'
deformed none 7000 '0.020000 0.028000 0.020000'
# The box is from 0.005 to 0.095. The centre at 0.054 stays at the ratio 0.54: at 0.0536; that at 0.024 moves to 0.0266.
deformed x 0 '0.049600 0.057600 0.050000'
deformed x 7000 '0.022600 0.030600 0.023000'
# Of a body across the face the second member is the image of the one beyond it, a length of the box away.
deformed none 4500 '0.095000 0.013000 0.095000'
rejects "$(two 'p p p')
fix body body rigid single
fix deform all deform 1 x erate -10 remap v
run 1" 'cannot be used with fix rigid'

# Gravity is the sum of the weights of the members: what changes the forces on them changes it, too.
# falls LINES WHAT: velocity of the body after 100 steps, by that of a free fall
falls() {
	prints "$(two 'f f f')
fix gravity all gravity 10 vector 0 0 -1
$1
fix body body rigid single
run 100
print \"falls \$(abs(vcm(body,z))/0.01:%.6f)\"" "falls $2"
}
falls '' 1.000000
falls 'fix stop all setforce 0 0 0' 0.000000
falls 'fix stop all setforce NULL NULL 0' 0.000000
falls 'fix stop all planeforce 0 0 1' 0.000000
falls 'fix stop all lineforce 1 0 0' 0.000000
falls 'group half id 1
fix stop half setforce 0 0 0' 0.500000
falls 'fix stop all freeze' 0.000000

# Force and torque of a body are those on its members, in directions in which it is held, too.
prints "$(two 'f f f')
fix push all addforce 0 0 -3
fix body body rigid single force * off off off torque * off off off
run 10
print \"force \$(f_body[1][9]:%g), moved \$(f_body[1][3]-0.05:%g)\"" 'force -6, moved 0'

prints "$(two 'f f f')
fix body body rigid single
fix w all wall/reflect xhi 0.09
run 1" '*2 particles of its group belong to rigid bodies, which it does not reflect'
prints "$(two 'f f f')
fix body body rigid single
run 1
group g id 2
delete_atoms group g compress no
run 1
print \"\$(count(all)) left\"" '*1 rigid bodies lack members, which delete_atoms has deleted' '0 left'

# A ball of mass m that spins at the end of a body of two balls: the dashpot of rolling friction takes the reduced inertia
# of m and 2 m about the contact.
cat >in.roll <<'END'
units si
boundary f f f
newton off
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
create_atoms 1 single -0.2 0 0 units box
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 0.19 0 0 units box
set group all diameter 0.2 density 2500
group body id 1 2
group ball id 3
set atom 3 omegaz 0.1
fix k1 all property/global kn peratomtypepair 1 1e4
fix k2 all property/global kt peratomtypepair 1 0
fix k3 all property/global gamman peratomtypepair 1 0
fix k4 all property/global gammat peratomtypepair 1 0
fix k5 all property/global coefficientFriction peratomtypepair 1 0
fix k6 all property/global coefficientRollingFriction peratomtypepair 1 0.5
fix k7 all property/global coefficientRollingViscousDamping peratomtypepair 1 0.3
fix k8 all property/global rollingStiffness scalar 1.5
pair_style gran model hooke/stiffness tangential off rolling_friction ${law}
pair_coeff * *
fix r body rigid single
fix i ball nve/sphere
timestep 1e-5
run 0
variable m equal 2500*4/3*PI*0.1^3
variable k equal v_factor*1e4*0.5^2*0.05^2
variable inertia equal 1.4*(2*v_m*v_m)/(3*v_m)*0.1^2
print "is torque $(-tqz[3]:%.17g) $(0.1*(v_k*dt+2*0.3*sqrt(v_inertia*v_k)):%.17g)"
END
agree 'rolling friction epsd takes the mass of the body' 'variable law index epsd
variable factor index 2.25
include in.roll'
agree 'rolling friction epsd3 takes the mass of the body' 'variable law index epsd3
variable factor index 1.5
include in.roll'

# A clump whose spheres overlap: its centre of mass is not that of the spheres. It flies with 1 m/s in x and rotates with 20/s.
cat >in.clump <<'END'
units si
boundary p p p
newton off
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
pair_style gran model hertz
pair_coeff * *
timestep 1e-4
fix stone all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 3 ntry 20000 &
	spheres 0 0 0 0.1  0.1 0 0 0.1  0.12 0 0 0.1 type 1
fix pd all particledistribution/discrete 32452843 1 stone 1.0
region r block -0.3 0.3 -0.3 0.3 -0.3 0.3 units box
fix ins all insert/pack seed 32452867 distributiontemplate pd insert_every once overlapcheck yes &
	vel constant 1 0 0 omega constant 0 0 20 particles_in_region 1 region r
fix ms all multisphere
compute x all multisphere/single id 1 property xcm
compute v all multisphere/single id 1 property vcm
compute w all multisphere/single id 1 property omega
compute l all multisphere/single id 1 property angmom
compute i all multisphere/single id 1 property inertia
compute m all multisphere/single id 1 property masstotal
compute com all com
compute gyration all gyration
run 1
END

agree 'sums over a group that is a clump are those of the clump' '
include in.clump
variable x equal $(xcm(all,x):%.17g)
run 700
print "is x $(xcm(all,x):%.17g) $(c_x[1]:%.17g)"
print "is flight $(xcm(all,x)-v_x:%.17g) 0.07 1"
print "is com $(c_com[2]:%.17g) $(c_x[2]:%.17g)"
print "is vx $(vcm(all,x):%.17g) 1"
print "is vy $(vcm(all,y):%.17g) 0 1"
print "is l $(angmom(all,z):%.17g) $(c_l[3]:%.17g)"
print "is spin $(omega(all,z):%.17g) $(c_w[3]:%.17g)"
print "is trace $(inertia(all,xx)+inertia(all,yy)+inertia(all,zz):%.17g) $(c_i[1]+c_i[2]+c_i[3]:%.17g)"
print "is gyration $(c_gyration:%.17g) $(sqrt((c_i[1]+c_i[2]+c_i[3])/2/c_m):%.17g)"
print "is gyration $(gyration(all):%.17g) $(c_gyration:%.17g)"'

agree 'sums over a chunk that is a clump are those of the clump' '
include in.clump
compute piece all chunk/atom type
compute at all com/chunk piece
compute speed all vcm/chunk piece
compute momentum all angmom/chunk piece
compute spin all omega/chunk piece
compute tensor all inertia/chunk piece
compute size all gyration/chunk piece
run 700
print "is x $(c_at[1][1]:%.17g) $(c_x[1]:%.17g)"
print "is y $(c_at[1][2]:%.17g) $(c_x[2]:%.17g)"
print "is vx $(c_speed[1][1]:%.17g) 1"
print "is vy $(c_speed[1][2]:%.17g) 0 1"
print "is l $(c_momentum[1][3]:%.17g) $(c_l[3]:%.17g)"
print "is spin $(c_spin[1][3]:%.17g) $(c_w[3]:%.17g)"
print "is trace $(c_tensor[1][1]+c_tensor[1][2]+c_tensor[1][3]:%.17g) $(c_i[1]+c_i[2]+c_i[3]:%.17g)"
print "is xy $(c_tensor[1][4]:%.17g) $(inertia(all,xy):%.17g) $(c_i[1]:%.17g)"
print "is xz $(c_tensor[1][6]:%.17g) $(inertia(all,xz):%.17g) $(c_i[1]:%.17g)"
print "is gyration $(c_size[1]:%.17g) $(c_gyration:%.17g)"'

# After `velocity` a clump has the velocity of its spheres, at once; what is zeroed is that of the clump.
agree 'velocity set makes a clump rest' '
include in.clump
velocity all set 0 0 0
print "is at_once $(vcm(all,x):%.17g) 0 1"
run 100
print "is vx $(c_v[1]:%.17g) 0 1"
print "is vy $(c_v[2]:%.17g) 0 1"'
agree 'velocity zero linear stops a clump, which rotates as before' '
include in.clump
run 300
variable l equal $(c_l[3]:%.17g)
velocity all zero linear
print "is at_once $(vcm(all,x):%.17g) 0 1"
run 100
print "is vx $(c_v[1]:%.17g) 0 1"
print "is vy $(c_v[2]:%.17g) 0 1"
print "is l $(c_l[3]:%.17g) ${l}"'
agree 'velocity zero angular stops its rotation' '
include in.clump
velocity all zero angular
run 100
print "is vx $(c_v[1]:%.17g) 1"
print "is omega $(c_w[3]:%.17g) 0 20"
print "is l $(angmom(all,z):%.17g) 0 20"'
ball='create_atoms 1 single 0.7 0.1 0.8\
set atom 1 diameter 0.2 density 2500\
group ball id 1\
fix n ball nve/sphere'
agree 'two clumps with a ball: no momentum is left, nor angular momentum' "$(
	sed "s/particles_in_region 1 /particles_in_region 2 /; s|^fix ms|$ball\\n&|" in.clump)
velocity all set 1 0 NULL
velocity ball set -3 1 5
velocity all zero linear
velocity all zero angular
run 20
print \"is count \$(count(all)) 7\"
print \"is p \$(vcm(all,x)+vcm(all,y)+vcm(all,z):%.17g) 0 1\"
print \"is l \$(angmom(all,x):%.17g) 0 50\"
print \"is l \$(angmom(all,y):%.17g) 0 50\"
print \"is l \$(angmom(all,z):%.17g) 0 50\"
variable moves equal \$(vz[1])>1
print \"is moves \${moves} 1\""

# The force of a spring on a group acts at its centre of mass.
agree 'a spring does not turn a clump' '
include in.clump
fix pull all spring tether 300 0.5 0.3 0.1 0
variable l equal $(c_l[3]:%.17g)
run 200
print "is l $(c_l[3]:%.17g) ${l}"
variable pulled equal abs(c_v[2])>1e-3
print "is pulled ${pulled} 1"'

# Bodies follow fixes that change the motion, or the place, of particles: a pair and a ball that meets it.
cat >in.pair <<'END'
units si
boundary p p p
newton off
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.4
pair_style gran model hertz tangential history
pair_coeff * *
timestep 2e-5
create_atoms 1 single 0.0 0 0
create_atoms 1 single 0.15 0 0
create_atoms 1 single 0.15 0.12 0.01
set group all diameter 0.1 density 2500
group pair id 1 2
group ball id 3
velocity all set 0.3 0 0
set atom 3 vy -1
fix r pair rigid single
fix i ball nve/sphere
END
# seen PREFIX: places relative to particle 1, rotation and energy at the end
seen() {
	printf 'print "%s $(xu[3]-xu[1]:%%.9f) $(yu[3]-yu[1]:%%.9f) $(xu[2]-xu[1]:%%.9f) $(yu[2]-yu[1]:%%.9f) $(omegaz[1]:%%.8f) $(ke-v_drift:%%.8f)"\n' "$1"
}
{ cat in.pair; echo 'variable drift equal 0
run 3000'; seen alone; } >in.alone
"$TSIM" -in in.alone -log none >out 2>&1
set -- $(grep '^alone ' out)
shift
[ $# = 6 ] && [ "${5%.*}" -lt -2 ]
report 'the ball turns the pair' $? out
prints "$(cat in.pair)
fix c ball recenter 0.05 NULL 0 shift all
fix d all recenter 0.05 0.02 0
variable drift equal 0
run 3000
$(seen moved)
print \"centre \$(xcm(all,x):%.9f) \$(xcm(all,y):%.9f) body \$(abs(f_r[1][1]-(x[1]+x[2])/2):%.9f)\"" "moved $*" 'centre 0.050000000 0.020000000 body 0.000000000'
prints "$(cat in.pair)
fix still all momentum 5 linear 1 1 1
variable m equal mass(all)
variable drift equal -v_m/2*(0.3^2+(1/3)^2)
run 3000
$(seen still)
print \"momentum \$(abs(vcm(all,x)+vcm(all,y)):%.12f)\"" "still $*" 'momentum 0.000000000000'
agree 'momentum and angular momentum of bodies are removed' '
include in.pair
velocity pair ramp vz -1 2 x 0 0.15
fix still all momentum 5 linear 1 1 0 angular
run 20
print "is vx $(vcm(all,x):%.17g) 0 1"
print "is vz $(vcm(all,z):%.17g) $((0.5*2)/3)"
print "is l $(angmom(all,x):%.17g) 0 1"
print "is l $(angmom(all,z):%.17g) 0 1"
print "is body $(f_r[1][4]:%.17g) $((vx[1]+vx[2])/2:%.17g) 1"'
rejects "$(cat in.pair)
group some id 2 3
fix still some momentum 5 linear 1 1 1
run 1" 'fix momentum: the rigid body of particle 1 has 1 of its 2 members in group some'

# What takes particles from bodies, or changes their size or mass, is refused before the run, and by -check.
lose='belongs to a rigid body, which cannot lose'
follow='belongs to a rigid body, whose mass and inertia would not follow'
for fix in "evaporate 100 1 all 49892/$lose particles" "remove nevery 100 massrate 1 style delete seed 4999/$lose mass" \
	"adapt 10 atom diameter v_size/$follow" "adapt 10 atom mass v_size/$follow" "scale/diameter 10 region all scale 0.5/$follow"; do
	rejects "$(cat in.pair)
region all sphere 0 0 0 5 units box
variable size equal 0.1
fix out all ${fix%/*}
run 1" "${fix##*/}"
	case $fix in scale*) continue ;; esac
	refused "-check: ${fix%% *}" "${fix##*/}" -check -in in.script
done
prints "$(cat in.pair)
region all block INF INF INF INF INF INF
variable size equal 0.1
variable soft equal 2e6
fix size ball adapt 10 atom diameter v_size
fix out ball evaporate 100 1 all 49892
run 100
print \"\$(count(all)) left\"" '2 left'
finish
