#!/bin/bash
# Bodies in a fluid, examples/flow at reduced size: cylinders free and in a channel, a sphere that sinks; their own
# checks hold.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

flow_case 'cylinder, Re 20' cylinder -var Re 20 -var cells 10 -var begin 25 -var time euler
flow_case 'cylinder, Re 100' cylinder -var cells 12 -var begin 60 -var length 25 -var to "$PWD/restart"
flow_case 'cylinder, Re 150 from there' cylinder -var Re 150 -var from "$PWD/restart" -var cells 12 -var begin 15 \
	-var length 15 -var part 0.12
flow_case 'cylinder in a channel' channel_cylinder -var cells 8 -var begin 3 -var part 14
flow_case 'cylinder in a channel' channel_cylinder -var cells 16 -var begin 3 -var part 4
awk '$2 == "dfg1.Cd" { error[++n] = $3 > $4 ? $3 - $4 : $4 - $3 } END { exit !(log(error[1] / error[2]) / log(2) > 1.7) }' all
report 'order of the drag in a channel' $? all
flow_case 'sphere' settling_sphere -var cells 4 -var longest 0.5 -var within 0.16

# the references beside the example are those of the data
awk -F, '/^[0-9]/ { print $1, $2 + 0, $5 + 0 }' "$top_srcdir/tests/data/cylinder_computed.csv" | awk '$1 >= 60 && $1 < 200' >data
awk '/"variable Cd equal [0-9]/ { gsub(/"/, ""); print $4, $9 + 0, $13 + 0 }' \
	"$top_srcdir/examples/flow/cylinder/in.cylinder" | awk '$1 >= 60' >script
same 'references of the cylinder' data script
finish
