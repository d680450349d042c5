# shellcheck shell=bash disable=SC2034,SC2154
# For bench/race and bench/profile: how scenes are prepared, run, and compared. Sourced in an empty folder, with
# $tsim, $bench and $size (tiny, quick or full) set.
all_scenes='packing block shaken shaker shear filling chute drum hopper bonded rock bidisperse hot'
scenes=$bench/scenes

# pick TINY QUICK FULL: the one for this size
pick() { case $size in tiny) echo "$1" ;; quick) echo "$2" ;; *) echo "$3" ;; esac; }

# data TYPES XLO XHI YLO YHI ZLO ZHI: `id type diameter x y z [vx vy vz wx wy wz]` on standard input, and bonds where
# there is a file of them, become start.data
data() {
	cat >state
	{
		printf 'spheres\n\n%d atoms\n%d atom types\n' "$(wc -l <state)" "$1"
		[ ! -s bonds ] || printf '%d bonds\n1 bond types\n12 extra bond per atom\n' "$(wc -l <bonds)"
		printf '\n%s %s xlo xhi\n%s %s ylo yhi\n%s %s zlo zhi\n\nAtoms\n\n' "${@:2}"
		if [ -s bonds ]; then # the columns of atom_style hybrid sphere bond
			awk '{ print $1, $2, $4, $5, $6, $3, 1, 1 }' state
		else
			awk '{ print $1, $2, $3, 1, $4, $5, $6 }' state
		fi
		awk 'NF > 6 { if (!n++) print "\nVelocities\n"; print $1, $7, $8, $9, $10, $11, $12 }' state
		[ ! -s bonds ] || { printf '\nBonds\n\n' && cat bonds; }
	} >start.data
}

# rows of a dump
spheres() { awk 'NR > 9' "$1"; }

# packed WIDE LAYERS STEPS [CELL]: packed.dump, spheres of diameter 1 at rest in a box; with CELL one of diameter 10
# in each cube of this side
packed() {
	awk -v n="$1" -v layers="$2" -v cell="${4:-0}" 'function put(d, x, y, z) { print ++id, 1, d, x, y, z }
	BEGIN {
		srand(7)
		for (x = cell / 2; cell && x < n; x += cell) for (y = cell / 2; y < n; y += cell)
			for (z = cell / 2; z < layers; z += cell) put(10, x, y, z)
		for (k = 0; 1.08 * k + 0.6 < layers; k++) for (j = 0; j < int(n / 1.0); j++) for (i = 0; i < int(n / 1.0); i++) {
			x = 0.5 + 0.98 * i * (n - 1.02) / (0.98 * (int(n) - 1)) + 0.02 * rand()
			y = 0.5 + 0.98 * j * (n - 1.02) / (0.98 * (int(n) - 1)) + 0.02 * rand()
			z = 0.6 + 1.08 * k + 0.05 * rand()
			if (cell) {
				a = x % cell - cell / 2; b = y % cell - cell / 2; c = z % cell - cell / 2
				if (a * a + b * b + c * c < 5.5 * 5.5) continue
			}
			put(1, x, y, z)
		}
	}' | data 1 -0.5 "$1.5" -0.5 "$1.5" -0.5 "$(($2 + 10))"
	by_tsim "$scenes/common/pack" -var wide "$1" -var steps "$3" -var skin 0.25
}

# by_tsim SCRIPT WORDS...: a run that prepares
by_tsim() {
	"$tsim" -in "$1" -var scenes "$scenes" "${@:2}" -threads 2 -log prepare.log -screen none >output 2>&1 ||
		{ tail -n 5 output; exit 1; }
}

# mirrored IMAGES WIDE: packed.dump and its mirror images, IMAGES by IMAGES
mirrored() {
	spheres packed.dump | awk -v n="$1" -v w="$2" '{
		for (a = 0; a < n; a++) for (b = 0; b < n; b++)
			printf "%d %d %s %.12g %.12g %s\n", ++id, $2, $3, a % 2 ? (a + 1) * w - $4 : a * w + $4,
				b % 2 ? (b + 1) * w - $5 : b * w + $5, $6
	}'
}

# of_scene NAME: what its file says (see bench/scenes/*/scene), and its start in this folder
of_scene() {
	dialects='liggghts lammps' why='' period='0 0 0' near=1e-9 far=1e-6 centre='' energy=1e-6 column='' words=() peers='' compared=yes bond_bytes=16
	scene=$1
	rm -f bonds ./*.dump ./*.usage ./*.log ./*.loop
	# shellcheck source=/dev/null
	. "$scenes/$scene/scene"
	prepare
}

# run_of WAY STEPS NAME: `command` becomes a run that writes NAME.log and NAME.dump; WAY is program.threads.dialect
run_of() {
	local program threads dialect n count form columns="id x y z vx vy vz $column"
	IFS=. read -r program threads dialect <<<"$1"
	form='format float %.15g'
	case $program in
	tsim) command=("$tsim" -threads "$threads") ;;
	legacy) # for the comparison with LIGGGHTS: its contacts that end, runs that begin, and skin
		command=("$tsim" -threads "$threads" -legacy)
		program=tsim
		;;
	liggghts)
		command=(liggghts) count=$(wc -w <<<"$columns")
		form="format \"%d$(for ((n = 1; n < count; n++)); do printf ' %%.15g'; done)\""
		;;
	lammps) command=(lmp) ;;
	esys) # a master and one worker, which does the work; root is refused without these two words
		command=(env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1
			mpirun --oversubscribe -np 2 bash "$scenes/common/worker" esysparticle "$scenes/$scene/with_esys.py"
			"$2" "$3.dump" "$3.log")
		return
		;;
	yade) command=(yade -j1 -n -x "$scenes/$scene/with_yade.py" "$2" "$3.dump" "$3.log") && return ;;
	esac
	command+=(-in "$scenes/$scene/in" -log "$3.log" -var scenes "$scenes" -var program "$program" -var dialect "$dialect"
		-var steps "$2" -var after "${after:-nothing}" -var out "$3.dump" -var columns "$columns" -var form "$form"
		"${words[@]}")
}

# go WAY: a run of `warm` steps, and one of `steps` more. What they took goes to WAY.warm.usage and WAY.all.usage,
# lines of seconds of processor time, seconds of the loop of steps, kilobytes.
go() {
	local how TIMEFORMAT='%3U %3S'
	for how in warm all; do
		run_of "$1" "$([ $how = all ] && echo $((warm + steps)) || echo "$warm")" "$1.$how"
		rm -f worker.seconds
		{ time command time -f %M -o memory "${command[@]}" >output 2>&1; } 2>seconds ||
			{ echo "$scene: $1:"; tail -n 5 output; return 1; }
		[ ! -e worker.seconds ] || mv worker.seconds seconds
		echo "$(awk '{ print $1 + $2 }' seconds)" "$(loop_time "$1.$how.log")" "$(tail -n 1 memory)" >>"$1.$how.usage"
	done
}

loop_time() { sed -n 's/^Loop time of \([^ ]*\).*/\1/p' "$1" | tail -n 1; }

command_of() {
	case $1 in
	lammps) echo lmp ;;
	esys) echo esysparticle ;;
	*) echo "$1" ;;
	esac
}
name_of() {
	case $1 in
	tsim.1.*) echo 'tsim, 1 thread' ;;
	tsim.*) echo "tsim, $(cut -d . -f 2 <<<"$1") threads" ;;
	liggghts.*) echo LIGGGHTS ;;
	lammps.*) echo LAMMPS ;;
	esys.*) echo ESyS-Particle ;;
	yade.*) echo Yade ;;
	esac
}

# rows of a table of step, atoms, energies
rows_of() { awk '$1 ~ /^[0-9]+$/ && NF == 4 && $3 ~ /^[-+.0-9e]+$/' "$1"; }

# particles a step, summed over the steps of a run: numbers between rows of the table change evenly
counted() {
	rows_of "$1" | awk '{ if (n++) sum += ($1 - step) * ($2 + atoms) / 2; step = $1; atoms = $2 } END { print sum + 0 }'
}
