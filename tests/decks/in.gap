# Particles between a rough pad and a wafer that slides, in the frame of the pad, with slurry; seeded later than the start.
units		si
boundary	p p f
atom_style	granular
newton		off
region		box block 0 5e-6 0 4e-6 -1e-6 4e-6 units box
create_box	3 box
soft_particles	yes
fix		pad all surface/voxel gaussian mean 0.5e-6 deviation 0.4e-6 correlation 0 seed 3 type 2 cells 5 4
fix		m1 all property/global youngsModulus peratomtype 5e8 5e7 5e8
fix		m2 all property/global poissonsRatio peratomtype 0.17 0.2 0.35
fix		m3 all property/global coefficientRestitution peratomtypepair 3 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3 0.3
fix		m4 all property/global coefficientFriction peratomtypepair 3 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5
pair_style	gran model hertz tangential history
pair_coeff	* *
neighbor	0.1e-6 bin
fix		low all wall/gran model hertz tangential history voxels pad
fix		top all wall/gran model hertz tangential history primitive type 3 zplane 1.2e-6 shear x -0.8
fix		grains all particletemplate/sphere 15485863 atom_type 1 density constant 2000 radius gaussian number 0.25e-6 0.02e-6 volume_limit 1e-25
fix		mix all particledistribution/discrete 32452843 1 grains 1.0
fix		seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper top fraction 0.25 count volume contact yes start 170 maxattempt 10000
flow_style	reynolds cells 10 8 lower_voxel pad upper 1.2e-6 upper_velocity -0.8 0 0 viscosity 1e-3 density 1000 gap stepped touching solid floating yes update run
fix		drag all drag/stokes scheme exact two_way no
fix		go all nve/sphere
compute		paml all active/paml low top threshold 1e-10
compute		nip all squeeze/atom low top
compute		most all reduce max c_nip[1]
fix		mean all ave/time 1 100 100 c_paml c_paml[5]
thermo_style	custom step atoms ke c_paml c_paml[4] c_paml[6] c_most f_mean[1] f_mean[2] f_seed[1] f_seed[3] f_seed[5]
thermo		100
thermo_modify	format float %.17g
dump		all all custom 500 ${out}.dump id radius x y z vx vy vz c_nip[1]
timestep	5e-10
run		2000
run		1500
