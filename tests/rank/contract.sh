#!/bin/bash
# Every style works on any number of ranks or is refused before a run, with its name and the reason: each one that is not
# refused occurs in a scene whose files are the same, byte for byte, on other numbers of ranks. TS_RANKS: these numbers, 2x2 is
# two ranks of two threads; "turns": each scene on 2x2 and, by turns, on 3, 4 or 7. Without them the scenes are not run
# (tests/rank/contract_ranks.sh runs them).
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
export OMP_NUM_THREADS=1
scenes=$top_srcdir/tests/rank/scenes
decks=$top_srcdir/tests/decks
numbers=${TS_RANKS-}

cp "$scenes"/in.* .
for deck in insertion rigid tracers heat pour clumps receding surface_heat multicontact sheared automaton wafer; do cp "$decks/in.$deck" .; done
cp "$decks/in.jet" in.nozzle
sed 's/^run.*/run 250/' "$decks/in.gap" >in.gap
# Liquid, and contacts as in LIGGGHTS.
sed 's/^run.*/run 120/; s/^dump.*/&\ndump_modify wet format float %.17g/
	s/^fix.*floor.*/&\nfix tilt all mesh\/surface primitive plate length 0.008 width 0.006 rotate axis 0 1 0 angle 30 move 0.006 0.006 0.004 type 2\nfix tilted all wall\/gran model hertz tangential history cohesion easo\/capillary\/viscous mesh n_meshes 1 meshes tilt/' "$decks/in.bridges" >in.bridges
sed '1s/^/legacy yes\n/; s/^run.*/run 200/' in.drum >in.legacy
# Height fields, one of which is pressed on a plane.
sed 's/^dump_modify.*/&\ncompute pressed all surface\/contact rough winkler 1e6 pressure 5e3\ncompute pi all active\/pi pressed radius 0.005 fraction 0.1 deviation 0.001 hardness 1e9\ncompute pml all active\/pml pressed radius 0.005 fraction 0.1/
	s/^thermo_style.*/& c_pressed c_pi c_pml/' "$decks/in.voxels" >in.voxels
# Bonds that contacts make and that break at once, in a periodic box; bonded particles have no contacts. `clear` does not begin the random
# numbers of variables again: scenes that are started together (in_turn) have seeds of their own.
sed '/energy\/ledger/d; s/ f_books.*//; s/^boundary.*/boundary p p p/; s/^newton.*/&\nspecial_bonds lj 0 1 1/
	s/createDistanceBond.*/createDistanceBond peratomtypepair 2 0.02 0.0821 0.0821 0.02/; s/random(-1,1,4711)/random(-6,6,4712)/
	s/random 200/random 300/; s/overlap 0.08/overlap 0.085/; s/6e4/1e5/g' "$decks/in.cohesion_bonds" >in.glue
# Bonds that are made in each step and break in the same one, while the contact list has their pairs, whose contacts go on.
sed '/maxSigma/d; /maxTau/d; s/stressBreak on //; s/^fix.*createDistanceBond.*/fix b4 all property\/global createDistanceBond peratomtypepair 2 0.0899 0.0899 0.0899 0.0899/
	s/^pair_style/fix b5 all property\/global maxDistanceBond peratomtypepair 2 0.084 0.087 0.087 0.088\n&/
	s/random(-6,6,4712)/random(-1,1,4711)/; s/overlap 0.085/overlap 0.07/; s/local 50/local 1/; s/^run.*/run 60/' in.glue >in.brief
# Exact impacts of a crowd, some of which touch each other, on a plane and a mesh that moves.
sed 's/^boundary.*/boundary p p f/; s/-2e-3 2e-3 -2e-3 2e-3/-3e-4 3e-4 -3e-4 3e-4/; s/0\.002/0.0003/g; /^fix.*c all/d; s/ f_c\[1\]//
	s/^region.*jet.*/region jet block -3e-4 3e-4 -3e-4 3e-4 1.3e-5 8.7e-5 units box/; s/random 100 12345 jet/random 500 12345 jet overlap 25e-6/
	s/^fix.*step.*/pair_style spring\/dashpot\npair_coeff * * stiffness 5e-3 damping 0\n&/; s/^timestep.*/timestep 2e-8/; s/^run.*/run 25/
	s/^fix.*plough.*/&\nfix hits all surface\/impacts surface target\ncompute hits all reduce sum f_hits[1] f_hits[2] f_hits[3]/
	s/f_plough /&c_hits[*] /' "$decks/in.exact" >in.crowd
# Bonds with given lengths, which tear and are made again.
sed 's/^bond_style.*/bond_style harmonic/; s/^bond_coeff 1 .*/bond_coeff 1 1000 0.00495/; s/^bond_coeff 2 .*/bond_coeff 2 500 0.0052/' in.springs >in.harmonic
# Files that libraries and other programs write.
awk '/^run/ && !n++ { print "dump film all movie 60 ${out}.mp4 type type size 80 80\ndump track all h5md 60 ${out}.h5 position velocity radius" }
	{ print }' "$scenes/in.outlet" >in.film
sed 's/heat\/gran\/conduction/heat\/gran/; s/initial_temperature 293.15/& scheme exact/' in.heat >in.heat_exact
sed 's/tangential history/& cohesion sjkr/; s/^pair_style/fix m5 all property\/global cohesionEnergyDensity peratomtypepair 2 3e4 2e4 2e4 1e4\n&/' in.bed >in.sticky
sed 's,gran/hooke 2000.0 NULL 5.0,gran/hertz/history 2e6 NULL 50.0,; s,nve/euler,nve/noforce,' in.forces >in.forces_hertz
# Contacts that yield and adhere.
awk '/^pair_style/ { split("UnloadingStiffness surfaceEnergy pullOffForce", p); split("3 5 0", v)
		for (k = 1; k <= 3; k++) print "fix y" k " all property/global " p[k] " peratomtypepair 2 " v[k], v[k], v[k], v[k]
		print "fix y4 all property/global overlapExponent scalar 1.5\nfix y5 all property/global adhesionExponent scalar 1.5" } { print }' in.bed |
	sed 's/model hertz/model edinburgh/' >in.yielding
sed "s;^flow_style.*;flow_style stagnation axisymmetric point 0.03 0.02 0 normal 0 0 1 rate 20 profile viscous viscosity 2e-3 density 300;" in.stream >in.jet

# Wafers on a film and on the pad.
sed -E "s/^fix\t\tmean.*/$(grep 'fix.*w2 all wafer' "$decks/in.wafer")/; s/f_mean.*/f_w2[1] f_w2[2] f_w2[3] f_w2[4]/; s/^run.*/run 7/; s/^thermo\t.*/thermo 3/" "$decks/in.floating" >in.floating

for solver in cg direct hypre multigrid sor; do
	sed "s;^flow_boundary;pressure_style $solver\n&;" in.duct >in.$solver
done

sed 's/^pressure_style.*/pressure_style cg preconditioner diagonal/; s/boundary f p p/boundary p p p/; /^flow_boundary/d' in.slabs >in.slabs_cg
# An outlet whose ghosts depend on what comes from the other end of a periodic axis: apart, and with a formula that may read it.
sed 's/boundary f p p/boundary p f p/; s/^flow_boundary.*/flow_boundary ylo outlet/; s/^pressure_style.*/pressure_style sor/
	s/vtk 20/vtk 10/; s/^run 40/run 11/; s/^run 30/run 12/' in.slabs >in.slabs_out
sed 's/^fix stop.*/variable energy equal flow_ke\nfix stop all print 7 "at $(v_energy)" file ${out}.print/' in.slabs_out >in.slabs_told
# The direct solver eliminates along x: ranks have rows, and then columns of three sets of modes along y. A run that begins with
# another field, of which each has its planes.
sed 's/cells 17 14 13/cells 17 40 13/; s/^run 40/variable z internal 0\nvariable w equal sin(6.28*v_z)\nflow_set velocity 0 v_w 0.2 set z z\nrun 12/
	s/^run 30/flow_set velocity 0 0.1 0\nrun 11/' in.slabs >in.slabs_columns
# Another solver, another boundary, and a fix that feels the fluid for one run: then all ranks have all planes.
sed 's/^run 40/run 8\npressure_style multigrid\nrun 6\nflow_boundary xhi slip\nfix d all drag\/stokes\nrun 7\nunfix d/
	s/^run 30/pressure_style sor\nrun 9\nflow_grid z tanh 1.2\nrun 5/; s/vtk 20/vtk 5/; s/boundary f p p/boundary f p f/
	s/^pressure_style.*/pressure_style cg/' in.slabs >in.slabs_change
# Ranks have planes of the fluid and what is near their grains: with forms and schemes that keep other fields, across periodic faces;
# with sums over three steps, more cells than grains, and steps in which all ranks have all grains; with drag that adds nothing to the
# fluid, and grains farther from the block of their rank than a cell.
sed 's/boundary p p f/boundary p p p/; /^flow_boundary/d; /^fix floor/d; s/density 900/& form conservative time rk2/; s/all void_fraction/& method kernel/
	s/^run 110/run 50/; s/^run 60/run 40/' in.current >in.current_kernel
sed 's/density 900/& every 3/; s/12 6 30/18 12 40/; s/scheme implicit/& lagged yes/; s/^fix even.*/variable fast atom vz>-2.49\ngroup fast dynamic all var fast every 25\nfix push2 fast addforce 0 0 1e-5/
	s/^run 110/run 50/; s/^run 60/run 40/' in.current >in.current_whole
sed '/^fix e /d; /^fix heavy/d; s/ f_heavy\[3\] f_e\[2\]//; s/drag\/di_felice.*/drag\/stokes two_way no/; s/^fix lift.*/fix lift all lift\/magnus two_way no/; s/12 6 30/24 12 60/; /^fix even/d
	s/^run 110/neigh_modify every 60 delay 0 check no\nrun 50/; s/^run 60/run 40/' in.current >in.current_apart
# Adams-Bashforth, whose history each rank has for its planes: in the first scene all are gathered for outputs only, in the other
# one a fix makes some steps with all particles.
sed 's/ time rk2/ time ab2/' in.slabs >in.slabs_ab2
sed 's/^flow_style.*/& time ab2/; s/^run 200/variable d equal 0.002*(1+0.1*sin(1000*time))\nfix grow all adapt 9 atom diameter v_d\n&/' in.fluid >in.fluid_ab2
# Implicit viscosity: ranks have planes to solve along x and y, and rows to solve along z, which is periodic, or ends at an outlet or
# at walls; in the last scene all get all planes, for drag and a body.
sed 's/ time rk2/ time ab2 viscous implicit/' in.slabs >in.slabs_implicit
sed 's/boundary f p p/boundary f p f/; s/ time rk2/ time euler viscous backward/; s/^flow_boundary.*/&\nflow_boundary zhi outlet hydrostatic yes\nflow_boundary zlo wall velocity 0.1 0 0/
	s/^pressure_style.*/pressure_style cg/' in.slabs >in.slabs_backward
sed 's/ time rk2/ time ab2 viscous implicit/' in.duct >in.duct_implicit
# So large that two ranks divide two levels of the multigrid.
sed 's/^pressure_style.*/pressure_style multigrid/; s/cells 17 14 13/cells 64 62 37/; s/ substeps auto time rk2//; s/^timestep.*/timestep 1e-4/
	s/^thermo .*/thermo 1/; s/flow\/vtk 20/flow\/vtk 2/; s/print 7/print 1/; s/^run.*/run 2/' in.slabs >in.slabs_grids

# bonds NAME STYLE COEFFICIENTS: in.NAME, the fabric of in.beams with other bonds
bonds() {
	sed "s|^bond_style.*|bond_style $2|; s|^bond_coeff.*|bond_coeff 1 $3|" in.beams >"in.$1"
}
# The fabric as it breaks, with the balance of its energy.
bonds cement parallel 'kn 1e9 ks 4e8 sigma_c 8e3 tau_c 9e3 soften 0.5 soften_by both friction_angle 20 damping 0.1'
sed -i 's;^fix crack.*;&\nfix books all energy/ledger every 10 file ${out}.books tolerance 1;' in.cement
bonds fibres gran '1.0 0.0 1e6 1e6 1 0.1 1 6e3 5e3'
bonds turning bpm/rotational '50 20 0.02 0.02 2e-1 1e-1 2e-4 2e-4 0.01 0.01 1e-6 1e-6'
bonds stretched bpm/spring '500 0.02 0.01'
sed -i 's,^pair_style.*,pair_style bpm/spring,; s,^pair_coeff.*,pair_coeff * * 1000 0.005 0.01,' in.stretched

# names KIND: of the styles of this kind, the last block of its page
names() {
	"$TSIM" -help "$1" | awk '/^.tsim -help .* NAME/ { exit } /^  [^ ]/ { if (!inside) n = 0; inside = 1; name[n++] = $1; next }
		{ inside = 0 } END { for (k = 0; k < n; k++) print name[k] }'
}

# asked KIND STYLE: a line that names the style
asked() {
	case $1 in
	fix | compute) echo "$1 x all $2" ;;
	dump) echo "dump x all $2 10 x.file" ;;
	region) echo "region x $2" ;;
	*) echo "$1_style $2" ;;
	esac
}

# The styles of all scenes: "KIND STYLE".
awk '$1 ~ /^(fix|compute|dump)$/ { print $1, $4 } $1 == "region" { print $1, $3 }
	/ cohesion bond/ { print "bond cohesion" }
	$1 ~ /^(pair|bond|flow|pressure|automaton)_style$/ { sub(/_style/, "", $1); print $1, $2 }' in.* | sort -u >covered

# What is refused, and what must be the same; a style that is neither fails.
tell_styles() {
	: >table
	for kind in fix compute pair bond region dump flow pressure automaton; do
		names $kind >styles
		[ -s styles ]
		report "there are styles of the kind $kind" $?
		while read -r style; do
			{
				printf 'units si\nregion box block 0 1 0 1 0 1\ncreate_box 1 box\n'
				asked $kind "$style"
			} >asked
			"$TSIM" -explain -ranks 2 -in asked -log none >out 2>&1
			if grep -q "asked:4:[0-9]*: error: $kind $style does not work with several ranks yet (there are 2)" out; then
				echo "$kind $style refused" >>table
				continue
			fi
			grep -qx "$kind $style" covered
			report "$kind $style is refused, or occurs in a scene" $?
			echo "$kind $style same" >>table
		done <styles
	done
	cat table
	awk '{ n[$3]++ } END { for (what in n) print n[what], "styles:", what }' table
}
if [ -z "$numbers" ]; then
	tell_styles
	finish
fi
has_ranks || finish

film=film # needs HDF5 and ffmpeg
"$TSIM" -check -in in.film -var out x 2>&1 | grep -E 'was built without HDF5|ffmpeg, which is not on the PATH' && film=
hypre=hypre # needs hypre
"$TSIM" -check -in in.hypre -var out x 2>&1 | grep 'built without hypre' && hypre=
# Of three scenes that follow each other the one that takes the longest time runs on 3 ranks, the shortest one on 7.
same_scenes 2x2 averages drum stones halves waves mill sieve voxels squeezed sorted tracers receding forces stream forces_hertz flat oil jet wafer fluid floating automaton submerged eddies sluice shut cg direct multigrid sor slabs slabs_told slabs_out slabs_cg slabs_columns slabs_change fluid_ab2 slabs_implicit slabs_ab2 duct_implicit slabs_grids slabs_backward current current_kernel current_whole current_apart rock insertion pour beams springs harmonic glue cement brief fibres bit turning stretched rigid bodies clumps surface_heat heat_exact heat sticky yielding warm host gap nozzle multicontact bridges legacy seam $film sheared crowd $hypre
# The solver of hypre divided among ranks: results to its tolerance.
for n in ${hypre:+1 $(numbers_of 2 0)}; do
	n=${n%x2}
	sed 's/pressure_style hypre/& ranks yes tolerance 1e-10/' in.hypre >in.hypre_ranks
	on_ranks "$n" "$TSIM" -in in.hypre_ranks -var out y -log log -screen none >out 2>&1 </dev/null
	report "hypre divided among $n ranks" $? out
	rows log | tail -n 1 >"hypre.$n"
	awk 'NR == FNR { for (k = 1; k <= NF; k++) alone[k] = $k; next }
		{ for (k = 1; k <= NF; k++) differ += ($k - alone[k])^2 > (1e-6 * alone[k])^2 && k != NF - 1; seen = NF } END { exit differ || seen < 9 }' hypre.1 "hypre.$n"
	report "hypre divided among $n ranks: the same to its tolerance" $? "hypre.$n"
done
finish
