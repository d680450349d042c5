# For bench/profile: the part of a step to which each sample of perf belongs. It is that of the file of the function;
# what is inlined into the loop over pairs counts as law if its file is one of a contact law.
# Input: `addr2line -i -a` of all addresses, then lines of `number address`; a sample is half a millisecond.
# Output: a row of nanoseconds per particle and step (`steps`: particles times steps). Start, reading and writing
# are left out.
function part_of(file)
{
	if (file ~ /\/(wall|mesh|region)\//) return "walls"
	if (file ~ /\/bond\//) return "bonds"
	if (file ~ /\/heat\//) return "heat"
	if (file ~ /\/(contact_sums|force_slots|touching_sums)\./) return "sums"
	if (file ~ /\/law\/|\/(contact_roots|contact_stages|law_stages)\./) return "law"
	if (file ~ /\/contact\/|\/(active_pairs|contact_memory)\./) return "pairs"
	if (file ~ /\/neigh\//) return "lists"
	if (file ~ /\/(integrate|force|core|particle|kinetic|run|limits|box|math|base)\//) return "motion"
	return "rest"
}

function end_of_address()
{
	if (address != "") part[address] = outer == "pairs" && law ? "law" : outer
}

FNR == NR && /^0x/ { end_of_address(); address = $1; law = 0; next }
FNR == NR { outer = part_of($0); if (outer == "law") law = 1; next } # the last line is the function itself
FNR == 1 { end_of_address() }
{ samples[$2 in part ? part[$2] : "rest"] += $1 }
END {
	printf "| %s | %s |", scene, dialect
	count = split("lists pairs law sums motion walls bonds heat", name, " ")
	for (i = 1; i <= count; i++) {
		ns = samples[name[i]] * 5e5 / steps
		together += ns
		printf " %s |", ns ? sprintf("%.1f", ns) : "-"
	}
	printf " %.1f |\n", together
}
