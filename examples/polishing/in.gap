# The converging gap between a pad that slides and a wafer that is inclined: height K h at the inlet and h at the outlet,
# length L = aspect h. The same scene by a closed form, by the film, flow_style reynolds, or by the full equations,
# flow_style projection; doc/charts.md has their errors and prices (gap-ladder):
#	tsim -in in.gap [-var model analytic|film|cfd] [-var K 2] [-var aspect 20] [-var M 200] [-var N 12]
#	tsim -report run.html -in in.gap		a page with pictures and plots (doc/report.md)
# Load, friction and largest pressure are compared with the exact solution of Reynolds' equation,
#	d/dx (h^3 dp/dx) = 6 mu U dh/dx,  p = 0 at both ends,
# from which the full equations differ by terms of (h/L)^2 and Re h/L.
# RESULT lines: name, value, reference, how far they may be apart, ok or off. Units: h of the outlet, U, viscosity.

variable	model index film
variable	K index 2		# gap at the inlet by that at the outlet
variable	aspect index 20		# length by gap at the outlet
variable	Re index 0.1
variable	within index 0.03	# for the RESULT lines
variable	L equal ${aspect}

units		si
include		gap.${model}

variable	k2 equal (${K}-1)^2
variable	scale equal v_reference
variable	name string gap.${model}.load
variable	value equal v_load
variable	reference equal 6*v_L^2/v_k2*(ln(${K})-2*(${K}-1)/(${K}+1))
include		../flow/result
variable	name string gap.${model}.friction
variable	value equal v_friction
variable	reference equal v_L/(${K}-1)*(4*ln(${K})-6*(${K}-1)/(${K}+1))
include		../flow/result
variable	name string gap.${model}.pressure
variable	value equal v_pressure
variable	reference equal 1.5*v_L*(${K}-1)/(${K}*(${K}+1))
include		../flow/result
