/* Compute active/pi: active particles in polishing by the particle indentation model. */
#include "polish/slurry.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_slurry_contact_init(self, sim, ts_active_indentation);
}

static const struct ts_arg args[] = {
	TS_SLURRY_ARGS(struct ts_slurry_contact),
	TS_REAL("deviation", struct ts_slurry_contact, slurry.deviation, .range = TS_NOT_NEGATIVE,
		.unit = "length", .help = "standard deviation of the diameters of the particles"),
	TS_REAL("hardness", struct ts_slurry_contact, wafer_hardness, .range = TS_POSITIVE,
		.unit = "pressure", .help = "hardness of the wafer"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_active_pi)
const struct ts_style ts_compute_active_pi = {
	.name = "active/pi",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Active particles in chemical-mechanical polishing: particle indentation model",
	.doc = "Number of abrasive particles that are pressed between a pad and a wafer. The particles, of "
	       "the volume V_p of one with the mean radius, fill the volume fraction phi of the slurry. "
	       "Eligible are those that would be in the volume of the asperities that touch the wafer; "
	       "active are those with a diameter above the distance t at which the largest particle, of "
	       "radius a_max, keeps wafer and asperities apart:\n\n"
	       "  N_all = phi V_gap/V_p, N_elig = phi V_asp/V_p, N_act = N_elig (1 - F(t)),\n"
	       "  t = 2 a_max - D_wafer - D_pad, D = p a_max/(2 H)\n\n"
	       "F is the normal distribution of the diameters, and a_max the mean radius and 1.5 of their "
	       "standard `deviation`. D is the indentation of a solid of hardness H under p pi a_max^2, p "
	       "being the pressure in the real contacts; the area of the indentation is 2 pi a_max D. The "
	       "indentation of an elastic pad (no `hardness` in compute surface/contact) is 0.\n\n"
	       "The volume of the asperities that touch is V_asp = A_real h, where h = V_gap/A_nom is the "
	       "mean gap: they stand in slurry of that thickness. It grows with the area of the contacts and "
	       "with the gap, of which one falls and the other rises with the stiffness of the pad: N_elig "
	       "has a maximum at one stiffness.\n\n"
	       "Volume of the gap and area of the contacts are those of a compute surface/contact. Particles "
	       "do not change the contact, and no particle is simulated.\n\n"
	       "Equations typeset: doc/theory-rough.md.\n\n"
	       "Related: compute active/pml, compute active/paml, compute surface/contact.",
	.example = "compute press all surface/contact pad winkler 2.7e10 pressure 41400 hardness 5e6\n"
		   "compute pi all active/pi press radius 0.272e-6 fraction 0.04 deviation 0.086e-6 hardness "
		   "2e9",
	.cite = "J. Luo, D. A. Dornfeld, IEEE Trans. Semicond. Manuf. 14 (2001) 112",
	.args = args,
	.state_size = sizeof(struct ts_slurry_contact),
	.values = ts_slurry_values,
	.init = init,
};
