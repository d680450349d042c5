/* Compute active/pml: active particles in polishing by the particle mono-layer model. */
#include "polish/slurry.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	return ts_slurry_contact_init(self, sim, ts_active_monolayer);
}

static const struct ts_arg args[] = {
	TS_SLURRY_ARGS(struct ts_slurry_contact),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_active_pml)
const struct ts_style ts_compute_active_pml = {
	.name = "active/pml",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Active particles in chemical-mechanical polishing: particle mono-layer model",
	.doc = "Number of abrasive particles that are pressed between a pad and a wafer. The particles, of "
	       "the volume V_p of one with the mean radius, fill the volume fraction phi of the slurry "
	       "evenly; those of the layer next to the wafer are eligible, and active are those in the real "
	       "contacts of pad and wafer:\n\n"
	       "  N_all = phi V_gap/V_p, lambda = (phi/V_p)^(1/3), N_elig = lambda^2 A_nom, N_act = lambda^2 "
	       "A_real.\n\n"
	       "Volume of the gap and area of the contacts are those of a compute surface/contact. Particles "
	       "do not change the contact, and no particle is simulated.\n\n"
	       "Equations typeset: doc/theory-rough.md.\n\n"
	       "Related: compute active/pi, compute active/paml, compute surface/contact.",
	.example = "compute press all surface/contact pad winkler 2.7e10 pressure 41400 hardness 5e6\n"
		   "compute pml all active/pml press radius 0.272e-6 fraction 0.04\n"
		   "print \"active: $(c_pml), in the gap: $(c_pml[1])\"",
	.cite = "Y. Zhao, L. Chang, Wear 252 (2002) 220",
	.args = args,
	.state_size = sizeof(struct ts_slurry_contact),
	.values = ts_slurry_values,
	.init = init,
};
