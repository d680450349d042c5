/* Contact laws whose constants are arguments of the style, as in LAMMPS' pair styles and walls gran/...: kn
 * kt gamma_n gamma_t xmu dampflag [limit_damping]. */
#ifndef TS_CONTACT_GRAN_NUMBERS_H
#define TS_CONTACT_GRAN_NUMBERS_H

#include "contact/pair.h"
#include "core/arg.h"

struct ts_gran_numbers {
	double kn, gamman, xmu;
	struct ts_number kt, gammat; /* may be NULL: 2/7 kn, 1/2 gamma_n */
	int64_t damping;	     /* 0: no tangential damping */
	bool limit_damping;
};

#define TS_GRAN_NUMBERS_ARGS(T, f)                                                                         \
	TS_REAL("kn", T, f.kn, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .unit = "force/length",   \
		.help = "normal stiffness (hertz: a pressure)"),                                           \
		TS_NUMBER("kt", T, f.kt, .flags = TS_POSITIONAL | TS_NULLABLE, .range = TS_NOT_NEGATIVE,   \
			  .unit = "force/length", .help = "tangential stiffness; NULL: 2/7 of kn"),        \
		TS_REAL("gamma_n", T, f.gamman, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,          \
			.unit = "1/time", .help = "normal damping (hertz: per length)"),                   \
		TS_NUMBER("gamma_t", T, f.gammat, .flags = TS_POSITIONAL | TS_NULLABLE,                    \
			  .range = TS_NOT_NEGATIVE, .unit = "1/time",                                      \
			  .help = "tangential damping; NULL: half of gamma_n"),                            \
		TS_REAL("xmu", T, f.xmu, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0, .hi = 10000, \
			.unit = "", .help = "coefficient of friction"),                                    \
		TS_INT("dampflag", T, f.damping, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 0,      \
		       .hi = 1, .help = "0: no tangential damping, 1: tangential damping gamma_t"),        \
		TS_FLAG("limit_damping", T, f.limit_damping, .help = "no attractive normal force")

/* Model and constants of the three laws gran/hooke, gran/hooke/history, gran/hertz/history. */
struct ts_granular_model ts_gran_numbers_model(int normal, int tangential,
					       const struct ts_gran_numbers *numbers);
enum ts_status ts_gran_numbers_law(struct tsim *sim, const struct ts_gran_numbers *numbers,
				   const struct ts_place *where, struct ts_granular_pair *out);

/* State of the three pair styles. */
struct ts_gran_numbers_pair {
	struct ts_pair pair; /* first, as in every pair style */
	struct ts_gran_numbers numbers;
	bool generic;
};
enum ts_status ts_gran_numbers_init(struct ts_instance *self, struct tsim *sim, int normal, int tangential);
/* Hook of stage FORCE. */
enum ts_status ts_gran_numbers_force(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_gran_numbers_complete(struct tsim *sim, void *coeff, const struct ts_place *where);
extern const struct ts_arg ts_gran_numbers_args[], ts_gran_numbers_coeff[];

#define TS_GRAN_NUMBERS_DOC                                                                                \
	"kn and gamma_n are stiffness and damping of the normal force, kt and gamma_t of the tangential "  \
	"force; all pairs of types have the same ones. `kt NULL` is 2/7 kn, `gamma_t NULL` half of "       \
	"gamma_n, and dampflag 0 sets gamma_t to 0. With delta the overlap, n the unit normal towards i, " \
	"R* = R_i R_j/(R_i+R_j), m* = m_i m_j/(m_i+m_j), v_n the normal velocity (negative while "         \
	"approaching) and v_t the tangential velocity at the contact, "

#endif
