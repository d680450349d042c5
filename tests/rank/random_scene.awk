# A random scene, the same for the same seed: awk -v seed=N -f random_scene.awk. Lengths are multiples of a grain's diameter, so
# that scenes of micrometres and of metres are the same problem. Its files are ${out}.*.

# chance(P): true once in P
function chance(p) { return rand() * p < 1 }
function between(low, high) { return low + (high - low) * rand() }
function whole(low, high) { return low + int((high - low + 1) * rand()) }
function pick(words,   list, n) { n = split(words, list, " "); return list[whole(1, n)] }
# len(X): a length of X diameters; pos(...): three of them
function len(x) { return sprintf("%.10g", x * diameter) }
function two(x, y) { return len(x) " " len(y) }
function pos(x, y, z) { return len(x) " " len(y) " " len(z) }
# speed(X): X m/s in the units of the scene
function speed(x) { return sprintf("%.10g", x * metre) }
function random_number() { return pick("87287 32452843 15485863 49979687 67867967 86028121") }

function units_and_box(   axis, n, edge) {
	cgs = chance(3)
	metre = cgs ? 100 : 1
	gram = cgs ? 1000 : 1 # kilograms of a unit of mass, inverted
	diameter = pick("2e-5 5e-3 5e-3 0.4") * metre
	size = diameter / metre / 5e-3 # times the grain of 5 mm
	print "units " (cgs ? "cgs" : "si")
	print "atom_style " pick("sphere granular")
	n = split("x y z", axis, " ")
	edge["x"] = whole(8, 16); edge["y"] = whole(5, 9); edge["z"] = whole(8, 14)
	for (k = 1; k <= n; k++) {
		high[axis[k]] = edge[axis[k]]
		low[axis[k]] = chance(2) ? 0 : -whole(1, 5)
		high[axis[k]] += low[axis[k]]
		face[axis[k]] = pick(axis[k] == "z" ? "f f f p m" : "f p p s m")
	}
	print "boundary " face["x"], face["y"], face["z"]
	print "newton off"
	print "communicate single vel yes"
	if (chance(3)) print "processors " pick("1 * *") " * " pick("* 1")
	print "region box block " len(low["x"]), len(high["x"]), len(low["y"]), len(high["y"]), len(low["z"]), len(high["z"]) " units box"
	types = whole(1, 3)
	print "create_box " types " box"
	print "neighbor " len(between(0.1, 0.4)) " bin"
	if (chance(4)) print "neigh_modify delay 0 every " whole(1, 4) " check " pick("yes yes no")
}

function values(x, n,   s) { s = ""; while (n-- > 0) s = s " " x; return s }

function materials(   pa) {
	liggghts = chance(1.6)
	pa = 5e6 * (cgs ? 10 : 1)
	step = 2e-5 * size
	print "timestep " step
	if (!liggghts) {
		# stiffness of a linear spring: force a length; of hertz: pressure
		if (chance(2)) law = pick("gran/hooke gran/hooke/history") " " 2000 * size * gram " NULL " 50 / size " NULL 0.5 " pick("0 1")
		else law = "gran/hertz/history " pa " NULL 0 NULL 0.5 " pick("0 1")
		print "pair_style " law
		print "pair_coeff * *"
		return
	}
	print "fix m1 all property/global youngsModulus peratomtype" values(pa, types)
	print "fix m2 all property/global poissonsRatio peratomtype" values(0.3, types)
	print "fix m3 all property/global coefficientRestitution peratomtypepair " types values(between(0.3, 0.9), types * types)
	print "fix m4 all property/global coefficientFriction peratomtypepair " types values(between(0.1, 0.8), types * types)
	print "fix m5 all property/global coefficientRollingFriction peratomtypepair " types values(0.1, types * types)
	print "fix m6 all property/global characteristicVelocity scalar " speed(1)
	model = "model " pick("hertz hertz hooke") " tangential " pick("history history no_history off")
	if (chance(3)) model = model " rolling_friction " pick("cdt epsd2")
	print "pair_style gran " model
	print "pair_coeff * *"
}

function grains(   spacing) {
	density = cgs ? 2.5 : 2500
	spacing = between(1.01, 1.3)
	print "lattice sc " len(spacing)
	print "region fill " fill_region()
	print "create_atoms 1 region fill"
	print "set group all diameter " len(1) " density " density
	if (types > 1) {
		print "set group all type/fraction 2 " between(0.1, 0.6), random_number()
		print "set type 2 diameter " len(pick("0.5 0.3 0.15"))
	}
	if (types > 2) {
		print "set group all type/fraction 3 0.1 " random_number()
		print "set type 3 diameter " len(pick("0.5 0.9"))
	}
	# the temperature of grains of about 0.2 m/s
	print "velocity all create " 2500 * 0.52 * (diameter / metre) ^ 3 * 0.04 / 1.38e-23 " " random_number() " dist gaussian"
	print "velocity all set " speed(between(-1, 1)), speed(between(-0.5, 0.5)), speed(between(-1, 1)) " sum yes units box"
}
function fill_region(   shape, x, y, z) {
	x = (low["x"] + high["x"]) / 2; y = (low["y"] + high["y"]) / 2; z = (low["z"] + high["z"]) / 2
	shape = pick("block block half cylinder sphere")
	if (shape == "cylinder") return "cylinder z " pos(x, y, between(1.5, 3)) " " two(low["z"] + 0.6, high["z"] - 0.6) " units box"
	if (shape == "sphere") return "sphere " pos(x, y, z) " " len(between(2, 3.5)) " units box"
	return "block " two(low["x"] + 0.6, shape == "half" ? x : high["x"] - 0.6) " " two(low["y"] + 0.6, high["y"] - 0.6) " " \
		two(low["z"] + 0.6, high["z"] - 0.6) " units box"
}

# A wall at each face that is not periodic, or none
function walls(   axis, n, k, a, style) {
	n = split("x y z", axis, " ")
	for (k = 1; k <= n; k++) {
		a = axis[k]
		if (face[a] == "p" || chance(5)) continue
		if (liggghts) {
			print "fix w" a "0 all wall/gran " model " primitive type " whole(1, types) " " a "plane " len(low[a]) (chance(4) ? " shear " pick(a == "x" ? "y z" : a == "y" ? "x z" : "x y") " " speed(0.3) : "")
			print "fix w" a "1 all wall/gran " model " primitive type 1 " a "plane " len(high[a])
		} else {
			style = law
			sub(/^gran\//, "", style)
			print "fix w" a " all wall/gran " style " " a "plane " len(low[a]), len(high[a]) (chance(4) ? " wiggle " a " " len(0.1) " " 0.01 * size : "")
		}
		read_walls = read_walls " f_w" a (liggghts ? "0" : "") "[" whole(1, 3) "]"
	}
}

function mesh(   x, y, z, shape) {
	if (!liggghts || !chance(2)) return
	x = (low["x"] + high["x"]) / 2; y = (low["y"] + high["y"]) / 2; z = (low["z"] + high["z"]) / 2
	shape = pick("plate drum box")
	if (shape == "plate") shape = "plate length " len(between(1, 8)) " width " len(between(1, 5))
	else if (shape == "drum") shape = "drum radius " len(between(2, 3)) " length " len(between(2, 6)) " lifters " whole(0, 4) " axis 0 1 0"
	else shape = "box " two(-1, 1) " " two(-1, 1) " 0 " len(between(0.5, 3))
	print "fix solid all mesh/surface primitive " shape " move " pos(x + between(-1, 1), y, z - between(0, 3)) " type " whole(1, types)
	if (chance(2)) print "fix swing all move/mesh mesh solid " pick("wiggle") " amplitude " pos(0.1, 0, 0.2) " period " between(0.005, 0.05) * size
	if (chance(2)) print "fix turn all move/mesh mesh solid rotate origin " pos(x, y, z) " axis 0 1 0 period " between(0.05, 0.3) * size
	print "fix solids all wall/gran " model " mesh n_meshes 1 meshes solid"
	read_walls = read_walls " f_solids[" whole(1, 3) "]"
}

function forces(   list, n, k, x, z) {
	x = (low["x"] + high["x"]) / 2; z = (low["z"] + high["z"]) / 2
	print "region part block " pick("INF " len(x)), "INF INF INF INF " len(z) " units box"
	print "group part region part"
	print "group odd id 1:100000:2"
	integrator = pick("nve/sphere nve/sphere nve/sphere nve/symplectic")
	print "fix move all " integrator
	print "fix down all gravity " 9.81 / size * metre " vector " pick("0 1 -1") " 0 -1"
	kilo = gram * metre # newtons in units of force
	if (chance(4)) print "fix push " pick("all part odd") " addforce 0 " 1e-4 * kilo * size ^ 2 " 0" (chance(2) ? " region part" : "")
	if (chance(5)) print "fix slow odd damping/cundall 0.1 0.1"
	if (chance(5)) print "fix rail part " pick("lineforce planeforce") " 0 1 " pick("0 1")
	if (chance(6)) print "fix still part freeze"
	if (chance(6)) print "fix hold odd setforce NULL 0 NULL"
	if (chance(6)) print "fix same odd aveforce NULL NULL 0"
	if (chance(6)) print "fix calm all momentum " whole(10, 40) " linear 1 1 0 angular"
	if (chance(6)) print "fix tie part spring/self " 0.5 * gram * size
	if (chance(5)) print "fix felt all store/force"
	if (chance(6)) print "fix mirror all wall/reflect zhi " len(high["z"] - 0.2) " zlo " len(low["z"] + 0.2)
}

function insertion() {
	if (!chance(3)) return
	print "fix t1 all particletemplate/sphere 15485863 volume_limit " 1e-3 * diameter ^ 3 " atom_type 1 density constant " density " radius constant " len(0.5)
	print "fix t2 all particletemplate/sphere 32452843 volume_limit " 1e-4 * diameter ^ 3 " atom_type " types " density constant " density " radius " t2_radius()
	print "fix mix all particledistribution/discrete 32452867 2 t1 0.6 t2 0.4"
	print "region gap block " len(low["x"] + 1), len(high["x"] - 1), len(low["y"] + 1), len(high["y"] - 1), len(high["z"] - 3), len(high["z"] - 1) " units box"
	if (chance(2)) print "fix ins all insert/pack seed 49979687 distributiontemplate mix insert_every " whole(40, 120) " overlapcheck yes all_in " pick("yes no") " vel constant 0 0 " speed(-0.5) " region gap particles_in_region " whole(5, 40)
	else print "fix ins all insert/rate/region seed 86028121 distributiontemplate mix nparticles " whole(20, 90) " particlerate " 2 / step / 20 " insert_every " whole(30, 90) " overlapcheck yes all_in yes vel constant 0 0 " speed(-0.3) " region gap"
}
function t2_radius() { return chance(2) ? "constant " len(0.2) : "uniform " two(0.15, 0.4) }

function outputs(   columns, touching) {
	print "compute er all erotate/sphere"
	print "compute top all reduce max z vx"
	columns = "step atoms ke c_er c_top[1] nbuild" read_walls
	if (chance(2)) { print "compute touch all contact/atom"; print "compute most all reduce sum c_touch"; columns = columns " c_most" }
	if (chance(2)) { print "compute msd part msd com yes"; columns = columns " c_msd[4]" }
	if (chance(3)) columns = columns " press pxx pyz"
	if (chance(3)) { print "compute some part reduce/region box sum mass radius"; columns = columns " c_some[1]" }
	if (chance(3)) {
		print "compute layers all chunk/atom bin/1d z lower " len(2) " units box"
		print "fix layers all ave/chunk 5 4 40 layers vx density/mass file ${out}.layers"
	}
	if (chance(3)) {
		print "compute pairs all pair/gran/local pos id force"
		print "dump pairs all local " whole(50, 90) " ${out}.pairs c_pairs[1] c_pairs[7] c_pairs[10]"
		print "dump_modify pairs format float %.17g"
	}
	if (chance(3)) print "fix histo all ave/histo 10 4 80 0 1 12 vz file ${out}.histo"
	if (chance(3)) print "compute_modify thermo_temp dynamic yes"
	print "fix mean all ave/time 5 " whole(2, 8) " 40 c_er c_top[2] file ${out}.mean"
	print "thermo_style custom " columns
	print "thermo " whole(20, 60)
	print "thermo_modify format float %.17g lost ignore"
	print "dump grains " pick("all all part odd") " custom " whole(60, 120) " ${out}.dump id type x y z ix iy iz vx vy vz omegax omegay omegaz fx fy fz tqx tqz radius"
	print "dump_modify grains format float %.17g sort id"
}

# Commands between two runs
function between_runs() {
	if (chance(3)) print "velocity part set " speed(0.5) " NULL NULL"
	if (chance(4)) print "set type 1 density " density * 1.2
	if (chance(5)) { print "group gone id 10:40"; print "delete_atoms group gone" }
	if (chance(5)) print "displace_atoms odd move 0 0 " len(0.02) " units box"
	if (chance(5)) print "timestep " step / 2
	if (chance(6)) print "unfix move\nfix move all nve/sphere"
	if (chance(5)) print "group odd clear\ngroup odd id 1:100000:3"
	if (chance(5)) print "balance 1.1 shift xz 10 1.05"
}

BEGIN {
	srand(seed); rand(); rand()
	print "# random scene " seed
	units_and_box()
	materials()
	grains()
	walls()
	mesh()
	forces()
	insertion()
	outputs()
	print "run " whole(60, 300)
	between_runs()
	print "write_restart ${out}.restart"
	print "run " whole(40, 300)
}
