#!/bin/bash
# compute granular/shear: units, variables, the energy balance, radial distributions; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

grains='density 2550 restitution 0.9'

# near NAME FORMULA VALUE TOLERANCE: a line of a script that prints whether they agree
near() {
	echo "if \"abs(($2)-($3)) <= $4\" then \"print '$1 ok'\" else \"print '$1: \$($2:%.10g), expected \$($3:%.10g)'\""
}

# Other units; a Monte Carlo solution of the Enskog equation has T 1.834(3), K_xx/T 1.073, K_yy/T 0.963, K_xy/T -0.275,
# p/(n T) 2.383, P_xy/p -0.273 at nu 0.2; g2/g5 is 1.9655
prints "compute c all granular/shear solid_fraction 0.2 shear_rate 100 diameter 1e-3 $grains
$(near T 'c_c[1]/0.01' 1.834 0.02)
$(near Kxx 'c_c[2]' 1.073 0.005)
$(near Kyy 'c_c[3]' 0.963 0.005)
$(near trace 'c_c[2]+c_c[3]+c_c[4]' 3 1e-13)
$(near Kxy 'c_c[5]' -0.275 0.01)
$(near pressure 'c_c[6]/(2550*0.2*c_c[1])' 2.383 0.01)
$(near traction 'c_c[8]' 0.273 0.005)
$(near N1 'c_c[9]' '(c_c[11]-c_c[12])/c_c[6]' 1e-13)
$(near N2 'c_c[10]' '(c_c[12]-c_c[13])/c_c[6]' 1e-13)
$(near kinetic 'c_c[14]' '2550*0.2*c_c[1]/c_c[6]' 1e-13)
$(near energy 'c_c[15]/(100*c_c[7])' 1 1e-11)
$(near balance 'c_c[17]' 0 1e-11)
$(near lun 'c_c[18]/0.01' 1.9655 1e-4)
compute m all granular/shear solid_fraction 0.2 shear_rate 1e-4 diameter 1000 density 2.55e-3 restitution 0.9
$(near units 'c_m[1]/c_c[1]*100^2*1e-6/(1e-4*1000)^2' 1 1e-12)
$(near stress 'c_m[7]/c_c[7]*(2550*0.1^2)/(2.55e-3*0.1^2)' 1 1e-12)" 'T ok' 'Kxx ok' 'Kyy ok' 'trace ok' 'Kxy ok' 'pressure ok' \
	'traction ok' 'N1 ok' 'N2 ok' 'kinetic ok' 'energy ok' 'balance ok' 'lun ok' 'units ok' 'stress ok'
"$TSIM" -check -log none -in in.script >out 2>&1
report 'check' $? out

# Variables; radial distributions
prints "variable nu equal 0.2
variable u equal 100
compute c all granular/shear solid_fraction v_nu shear_rate v_u diameter 1e-3 $grains
variable T equal \$(c_c[1]:%.15g)
variable u equal 300
$(near square 'c_c[1]' '9*v_T' '1e-12*v_T')
variable nu equal 0.55
compute t all granular/shear solid_fraction v_nu shear_rate v_u diameter 1e-3 $grains radial torquato
compute l all granular/shear solid_fraction v_nu shear_rate v_u diameter 1e-3 $grains radial lun/savage
$(near denser 'c_c[6]<c_t[6]&&c_t[6]<c_l[6]' 1 0)
variable nu equal 0.3
$(near dilute 'c_c[6]/c_t[6]' 1 1e-15)" 'square ok' 'denser ok' 'dilute ok'

rejects "compute c all granular/shear solid_fraction 0.64 shear_rate 1 diameter 1 $grains" 'solid_fraction 0.64, expected less than that at closest packing, 0.64'
rejects "compute c all granular/shear solid_fraction 0 shear_rate 1 diameter 1 $grains" 'solid_fraction 0, expected > 0'
rejects "compute c all granular/shear solid_fraction 0.2 shear_rate -1 diameter 1 $grains" 'shear_rate -1, expected > 0'
rejects "compute c all granular/shear solid_fraction 0.2 shear_rate 1 diameter 0 $grains" 'diameter 0, expected > 0'
rejects "compute c all granular/shear solid_fraction 0.2 shear_rate 1 diameter 1 density 1 restitution 1" 'there is no steady state'
rejects "compute c all granular/shear solid_fraction 0.2 shear_rate 1 diameter 1 density 1 restitution 1.2" 'restitution'
rejects "compute c all granular/shear solid_fraction 0.2 shear_rate 1 diameter 1 $grains radial torquato packing 0.4" 'at freezing, 0.49'
rejects "compute c all granular/couette gap 10 solid_fraction 0.2 speed 1 diameter 1 $grains wall_restitution 0.6 roughness 0.6 radial torquato packing 0.4" 'freezing, 0.49'
rejects "variable nu equal 0.7
compute c all granular/shear solid_fraction v_nu shear_rate 1 diameter 1 $grains
print \"\$(c_c[1])\"" 'solid_fraction 0.7, expected less'

finish
