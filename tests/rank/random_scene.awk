# A random scene, the same for the same seed: awk -v seed=N -f random_scene.awk. With -v again=1 the script goes on from the
# restart file that it has written before its last run.
#
# Lengths are given in grain diameters and times in those of the scale, so that scenes of micrometres and of metres are the
# same problem. Output files are ${out}.*; the restart file is ${saved}.

# chance(N): true once in N
function chance(n) { return rand() * n < 1 }
function between(low, high) { return low + (high - low) * rand() }
function whole(low, high) { return low + int((high - low + 1) * rand()) }
function pick(words,   list, n) { n = split(words, list, " "); return list[whole(1, n)] }
function random_seed() { return pick("87287 32452843 15485863 49979687 67867967 86028121") }
function repeated(word, n,   s) { s = ""; while (n-- > 0) s = s " " word; return s }

# Lengths in diameters
function len(x) { return sprintf("%.10g", x * diameter) }
function two(x, y) { return len(x) " " len(y) }
function pos(x, y, z) { return two(x, y) " " len(z) }
function edge_of(axis) { return high[axis] - low[axis] }
function middle(axis) { return (low[axis] + high[axis]) / 2 }
# A speed in m/s
function speed(x) { return sprintf("%.10g", x * metre) }

# once(LINE): not given again after read_restart
function once(line) { if (!again) print line }

function units_and_box(   k, a, edge, names) {
	cgs = chance(3)
	metre = cgs ? 100 : 1
	kilogram = cgs ? 1000 : 1
	diameter = pick("2e-5 5e-3 5e-3 0.4") * metre
	scale = diameter / metre / 5e-3 # times grains of 5 mm
	step = 2e-5 * scale
	density = 2500 * kilogram / metre ^ 3
	once("units " (cgs ? "cgs" : "si"))
	once("atom_style " pick("sphere granular"))
	edge["x"] = whole(8, 16); edge["y"] = whole(5, 9); edge["z"] = whole(8, 14)
	split("x y z", names, " ")
	for (k = 1; k <= 3; k++) {
		a = names[k]
		low[a] = chance(2) ? 0 : -whole(1, 5)
		high[a] = low[a] + edge[a]
		face[a] = pick(a == "z" ? "f f f p m" : "f p p s m")
	}
	once("boundary " face["x"] " " face["y"] " " face["z"])
	once("newton off")
	once("communicate single vel yes")
	if (chance(3)) once("processors " pick("1 * *") " * " pick("* 1"))
	once("region box block " two(low["x"], high["x"]) " " two(low["y"], high["y"]) " " two(low["z"], high["z"]) " units box")
	types = whole(1, 3)
	once("create_box " types " box")
	print "neighbor " len(between(0.1, 0.4)) " bin"
	if (chance(4)) print "neigh_modify delay 0 every " whole(1, 4) " check " pick("yes yes no")
	print "timestep " step
}

function contact_law(   modulus) {
	liggghts = chance(1.6)
	modulus = 5e6 * kilogram / metre
	if (!liggghts) {
		law = chance(2) ? pick("hooke hooke/history") " " 2000 * scale * kilogram " NULL " 50 / scale " NULL 0.5 " pick("0 1") : \
			"hertz/history " modulus " NULL 0 NULL 0.5 " pick("0 1")
		print "pair_style gran/" law
		print "pair_coeff * *"
		return
	}
	print "fix m1 all property/global youngsModulus peratomtype" repeated(modulus, types)
	print "fix m2 all property/global poissonsRatio peratomtype" repeated(0.3, types)
	print "fix m3 all property/global coefficientRestitution peratomtypepair " types repeated(between(0.3, 0.9), types * types)
	print "fix m4 all property/global coefficientFriction peratomtypepair " types repeated(between(0.1, 0.8), types * types)
	print "fix m5 all property/global coefficientRollingFriction peratomtypepair " types repeated(0.1, types * types)
	print "fix m6 all property/global characteristicVelocity scalar " speed(1)
	law = "model " pick("hertz hertz hooke") " tangential " pick("history history no_history off") \
		(chance(3) ? " rolling_friction " pick("cdt epsd2") : "")
	print "pair_style gran " law
	print "pair_coeff * *"
}

function filled_region(   shape) {
	shape = pick("block block half cylinder sphere")
	if (shape == "cylinder")
		return "cylinder z " pos(middle("x"), middle("y"), between(1.5, 3)) " " two(low["z"] + 0.6, high["z"] - 0.6)
	if (shape == "sphere")
		return "sphere " pos(middle("x"), middle("y"), middle("z")) " " len(between(2, 3.5))
	return "block " two(low["x"] + 0.6, shape == "half" ? middle("x") : high["x"] - 0.6) " " \
		two(low["y"] + 0.6, high["y"] - 0.6) " " two(low["z"] + 0.6, high["z"] - 0.6)
}

function grains(   kelvin) {
	once("lattice sc " len(between(1.01, 1.3)))
	once("region fill " filled_region() " units box")
	once("create_atoms 1 region fill")
	once("set group all diameter " len(1) " density " density)
	if (types > 1) {
		once("set group all type/fraction 2 " between(0.1, 0.6) " " random_seed())
		once("set type 2 diameter " len(pick("0.5 0.3 0.15")))
	}
	if (types > 2) {
		once("set group all type/fraction 3 0.1 " random_seed())
		once("set type 3 diameter " len(pick("0.5 0.9")))
	}
	kelvin = 1300 * (diameter / metre) ^ 3 * 0.04 / 1.38e-23 # of grains of about 0.2 m/s
	once("velocity all create " kelvin " " random_seed() " dist gaussian")
	once("velocity all set " speed(between(-1, 1)) " " speed(between(-0.5, 0.5)) " " speed(between(-1, 1)) " sum yes units box")
}

# Bonds between near grains, some of which break.
function bonds(   modulus) {
	if (!chance(3)) return
	modulus = 1e9 * kilogram / metre ^ 2 / scale
	if (chance(2)) {
		print "bond_style parallel"
		print "bond_coeff 1 kn " modulus " ks " 0.4 * modulus " sigma_c " 1e5 * between(0.2, 2) * kilogram / metre " tau_c " 1e5 * kilogram / metre
	} else {
		print "bond_style contact"
		print "bond_coeff 1 stiffness " 2000 * scale * kilogram " ultimate " between(0.01, 0.1) * scale ^ 2 * kilogram * metre
	}
	once("create_bonds many all all 1 0 " len(between(1.05, 1.35)))
	if (chance(2)) print "special_bonds lj 0 1 1"
	bonded = " bonds brokenbonds"
}

# Conduction of heat through contacts; the left half is warmer.
function heat() {
	if (!liggghts || !chance(4)) return
	print "fix k1 all property/global thermalConductivity peratomtype" repeated(5 * kilogram * metre, types)
	print "fix k2 all property/global thermalCapacity peratomtype" repeated(10 * metre ^ 2, types)
	print "fix warmth all heat/gran initial_temperature 300"
	print "region warm block INF " len(middle("x")) " INF INF INF INF units box"
	once("run 0")
	once("set region warm property/atom Temp 400")
	temperatures = " f_Temp f_heatFlux"
	warmth = " f_warmth"
}

# Rigid bodies: a few layers of grains, each a body.
function bodies(   k, n) {
	if (bonded || !chance(4)) return
	n = whole(1, 3)
	for (k = 1; k <= n; k++) {
		print "region layer" k " block INF INF INF INF " two(low["z"] + 2 * k, low["z"] + 2 * k + 1.1) " units box"
		once("group body" k " region layer" k)
		names = names " body" k
	}
	once("group free subtract all" names)
	print "fix bodies all rigid group " n names
	moved = "free"
}

function variables() {
	print "variable rise equal " 0.1 * diameter "*sin(" 400 / scale "*time)"
	print "variable size equal " 2 * diameter "+v_rise"
	print "variable load equal " 1e-4 * scale ^ 2 * kilogram * metre "*(1+step%5)"
	print "variable blow atom v_load*(z>" len(middle("z")) ")*sin(x/" len(1) ")"
}

# Walls at faces that are not periodic; one in five is open.
function plane_walls(   names, k, a, shear) {
	split("x y z", names, " ")
	for (k = 1; k <= 3; k++) {
		a = names[k]
		if (face[a] == "p" || chance(5)) continue
		if (liggghts) {
			shear = chance(4) ? " shear " pick(a == "x" ? "y z" : a == "y" ? "x z" : "x y") " " speed(0.3) : ""
			print "fix w" a "0 all wall/gran " law " primitive type " whole(1, types) " " a "plane " len(low[a]) shear
			print "fix w" a "1 all wall/gran " law " primitive type 1 " a "plane " len(high[a])
			wall_forces = wall_forces " f_w" a "0[" whole(1, 3) "]"
		} else {
			print "fix w" a " all wall/gran " law " " a "plane " two(low[a], high[a]) \
				(chance(4) ? " wiggle " a " " len(0.1) " " 0.01 * scale : "")
			wall_forces = wall_forces " f_w" a "[" whole(1, 3) "]"
		}
	}
}

function mesh_wall(   shape) {
	if (!liggghts || !chance(2)) return
	shape = pick("plate drum box")
	if (shape == "plate") shape = "plate length " len(between(1, 8)) " width " len(between(1, 5))
	else if (shape == "drum") shape = "drum radius " len(between(2, 3)) " length " len(between(2, 6)) " lifters " whole(0, 4) " axis 0 1 0"
	else shape = "box " two(-1, 1) " " two(-1, 1) " 0 " len(between(0.5, 3))
	loaded = chance(2)
	worn = loaded && chance(2)
	if (worn) print "fix m7 all property/global k_finnie peratomtypepair " types repeated(1e-9 / kilogram * metre, types * types)
	print "fix solid all mesh/surface" (loaded ? "/stress" : "") " primitive " shape " move " \
		pos(middle("x") + between(-1, 1), middle("y"), middle("z") - between(0, 3)) " type " whole(1, types) \
		(worn ? " wear finnie" : "")
	if (loaded) wall_forces = wall_forces " f_solid[" whole(1, 3) "] f_solid[" whole(4, 6) "]"
	if (chance(2)) print "fix swing all move/mesh mesh solid wiggle amplitude " pos(0.1, 0, 0.2) " period " between(0.005, 0.05) * scale
	if (chance(2)) print "fix turn all move/mesh mesh solid rotate origin " pos(middle("x"), middle("y"), middle("z")) \
		" axis 0 1 0 period " between(0.05, 0.3) * scale
	print "fix solids all wall/gran " law " mesh n_meshes 1 meshes solid"
	wall_forces = wall_forces " f_solids[" whole(1, 3) "]"
	if (chance(3)) {
		print "fix hits all surface/impacts surface solid"
		wall_forces = wall_forces " f_hits f_hits[" whole(2, 4) "]"
	}
	if (chance(3)) {
		print "fix rubbed all wear/archard surface solid k 1e-6 hardness " 1e9 * kilogram / metre
		wall_forces = wall_forces " f_rubbed"
	}
	if (chance(4)) {
		print "fix press all mesh/surface/stress/servo primitive plate length " len(3) " width " len(2) " move " \
			pos(middle("x"), middle("y"), high["z"] - 1) " type 1 com " pos(middle("x"), middle("y"), high["z"] - 1) \
			" ctrlPV force axis 0 0 -1 target_val " (chance(2) ? "v_load" : 0.01 * scale ^ 2 * kilogram * metre) \
			" vel_max " speed(0.2) (chance(2) ? " mode auto ratio 0.01" : "")
		print "fix pressed all wall/gran " law " mesh n_meshes 1 meshes press"
		wall_forces = wall_forces " f_press[3] f_press[9]"
	}
}

# A mesh that counts, and may delete, what passes.
function gate() {
	if (!liggghts || !chance(4)) return
	print "fix frame all mesh/surface primitive plate length " len(30) " width " len(30) " move " pos(middle("x"), middle("y"), middle("z") - 1) " type 1"
	print "fix gate all massflow/mesh mesh frame vec_side 0 0 -1 count " (chance(2) ? "multiple" : "once" (chance(2) ? " delete_atoms yes" : "")) \
		" file ${out}.gate"
	wall_forces = wall_forces " f_gate[1] f_gate[2] f_gate[5]"
}

# The surface of a region that may move is a wall.
function region_wall(   moves) {
	if (!chance(4)) return
	moves = pick("1 2 3")
	print "region lump sphere " pos(middle("x"), middle("y"), low["z"] - 1) " " (moves == 2 ? "v_size" : len(2)) " side out units box" \
		(moves == 3 ? " move v_rise NULL NULL" : "")
	print "fix lump all wall/gran/region hooke/history " 2000 * scale * kilogram " NULL " 50 / scale " NULL 0.5 1 region lump contacts"
	wall_forces = wall_forces " f_lump[" whole(1, 3) "]"
	contacts = " f_lump[1] f_lump[4]"
}

function motion_and_forces() {
	print "region part block " pick("INF " len(middle("x"))) " INF INF INF INF " len(middle("z")) " units box"
	once("group part region part")
	once("group odd id 1:100000:2")
	print "fix move " (moved ? moved : "all") " " pick("nve/sphere nve/sphere nve/sphere nve/symplectic")
	print "fix down all gravity " 9.81 / scale * metre " vector " pick("0 1 -1") " 0 -1"
	if (chance(4)) print "fix blow " pick("all part odd") " addforce " pick("0 v_load") " v_blow 0"
	if (chance(4)) {
		once("group low dynamic all region part every " whole(3, 20))
		print "fix lift low addforce 0 0 v_load"
	}
	if (chance(5)) print "fix marks all property/atom/tracer region_mark part mark_step 20 marker_style heaviside check_mark_every " whole(5, 20)
	if (chance(5)) {
		print "fix stay all property/atom/regiontracer/time add_region part check_region_every " whole(2, 9)
		contacts = contacts " f_stay[1] f_stay[2]"
	}
	if (!bonded && !moved && chance(6)) print "fix dry odd evaporate " whole(20, 60) " 2 part 49892"
	if (chance(4)) print "fix push " pick("all part odd") " addforce 0 " 1e-4 * scale ^ 2 * kilogram * metre " 0" (chance(2) ? " region part" : "")
	if (chance(5)) print "fix slow odd damping/cundall 0.1 0.1"
	if (chance(5)) print "fix rail part " pick("lineforce planeforce") " 0 1 " pick("0 1")
	if (chance(6)) print "fix still part freeze"
	if (chance(6)) print "fix hold odd setforce NULL 0 NULL"
	if (chance(6)) print "fix same odd aveforce NULL NULL 0"
	if (chance(6)) print "fix calm all momentum " whole(10, 40) " linear 1 1 0 angular"
	if (chance(6)) print "fix tie part spring/self " 0.5 * scale * kilogram
	if (chance(5)) print "fix felt all store/force"
	if (face["z"] != "p" && chance(6)) print "fix mirror all wall/reflect zhi " len(high["z"] - 0.2) " zlo " len(low["z"] + 0.2)
}

# A fluid with drag, and what acts in it; in half of the boxes that stay as they are one that is solved for.
function fluid(   weight, viscosity, scheme) {
	if (!chance(2)) return
	weight = density / 4
	viscosity = " viscosity " 2e-3 * kilogram / metre * scale " density " weight
	solved = face["x"] face["y"] face["z"] !~ /[sm]/ && chance(1.3)
	scheme = pick("explicit exact implicit")
	if (solved) {
		print "flow_style projection cells " int(edge_of("x") / 2) " " int(edge_of("y") / 2) " " int(edge_of("z") / 2) \
			viscosity " substeps auto time " pick("euler ab2 rk3")
		if (chance(2)) {
			print "fix e all void_fraction method " pick("divided kernel")
			print "fix press all flow/pressure_gradient"
			streams = " f_e[1] f_e[2] f_press[1]"
			print "fix flow all drag/di_felice scheme " pick("exact implicit")
		} else print "fix flow " pick("all part odd") " drag/schiller_naumann scheme " scheme (chance(3) ? " lagged yes" : "")
		streams = streams " flow_ke flow_pz"
	} else {
		print "flow_style uniform velocity " speed(between(-0.5, 0.5)) " 0 " speed(between(0, 2)) viscosity
		print "fix flow " pick("all part odd") " drag/" pick("stokes schiller_naumann") " scheme " scheme \
			(chance(2) ? " axes " pick("z xy") : "")
	}
	if (!moved && chance(3)) print "fix heavy part added_mass"
	if (chance(3)) print "fix spin all lift/" pick("magnus saffman")
	streams = streams " f_flow[3] f_flow[4]"
	print "region low block INF INF INF INF INF " len(middle("z")) " units box"
	print "compute gone " pick("all odd") " leave low"
	streams = streams " c_gone c_gone[3]"
}

function insertion(   at) {
	if (!chance(3)) return
	print "fix t1 all particletemplate/sphere 15485863 volume_limit " 1e-3 * diameter ^ 3 " atom_type 1 density constant " density \
		" radius constant " len(0.5)
	print "fix t2 all particletemplate/sphere 32452843 volume_limit " 1e-4 * diameter ^ 3 " atom_type " types " density constant " \
		density " radius " (chance(2) ? "constant " len(0.2) : "uniform " two(0.15, 0.4))
	print "fix mix all particledistribution/discrete 32452867 2 t1 0.6 t2 0.4"
	print "region gap block " two(low["x"] + 1, high["x"] - 1) " " two(low["y"] + 1, high["y"] - 1) " " \
		two(high["z"] - 3, high["z"] - 1) " units box"
	at = " overlapcheck yes all_in " pick("yes no") " vel constant 0 0 " speed(-0.5) " region gap"
	if (chance(2)) print "fix ins all insert/pack seed 49979687 distributiontemplate mix insert_every " whole(40, 120) at \
		" particles_in_region " whole(5, 40)
	else print "fix ins all insert/rate/region seed 86028121 distributiontemplate mix nparticles " whole(20, 90) \
		" particlerate " 0.1 / step " insert_every " whole(30, 90) at
}

function outputs(   columns) {
	if (seed % 3 == 0) print "fix books all energy/ledger every 7 file ${out}.books tolerance 1"
	print "compute er all erotate/sphere"
	print "compute top all reduce max z vx"
	columns = "step atoms ke c_er c_top[1] nbuild" wall_forces bonded warmth streams
	if (chance(2)) { print "compute touch all contact/atom"; print "compute most all reduce sum c_touch"; columns = columns " c_most" }
	if (chance(2)) { print "compute msd part msd com yes"; columns = columns " c_msd[4]" }
	if (chance(3)) columns = columns " press pxx pyz"
	if (chance(3)) { print "compute some part reduce sum mass radius"; columns = columns " c_some[1]" }
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
	print "fix mean all ave/time 5 " whole(2, 8) " 40 c_er c_top[2] file ${out}.mean"
	print "thermo_style custom " columns
	print "thermo " whole(20, 60)
	print "thermo_modify format float %.17g lost ignore"
	print "dump grains " pick("all all part odd") " custom " whole(60, 120) \
		" ${out}.dump id type x y z ix iy iz vx vy vz omegax omegay omegaz fx fy fz tqx tqz radius" temperatures contacts
	print "dump_modify grains format float %.17g sort id"
}

function between_runs() {
	if (chance(3)) once("velocity part set " speed(0.5) " NULL NULL")
	if (chance(4)) once("set type 1 density " density * 1.2)
	if (chance(5)) { once("group gone id 10:40"); once("delete_atoms group gone") }
	if (chance(5)) once("displace_atoms odd move 0 0 " len(0.02) " units box")
	if (chance(5)) print "timestep " step / 2
	if (chance(5)) { once("group odd clear"); once("group odd id 1:100000:3") }
}

BEGIN {
	srand(seed); rand(); rand()
	if (again) print "read_restart ${saved}"
	units_and_box()
	contact_law()
	grains()
	bonds()
	plane_walls()
	variables()
	mesh_wall()
	gate()
	region_wall()
	heat()
	bodies()
	motion_and_forces()
	fluid()
	insertion()
	outputs()
	once("run " whole(60, 300))
	between_runs()
	once("write_restart ${saved}")
	print "run " whole(130, 300) # longer than the steps between dumps
}
