/* Coefficient tables of pair_coeff and bond_coeff: one entry per pair of particle types or per bond type. */
#ifndef TS_CORE_COEFF_H
#define TS_CORE_COEFF_H

#include "core/sim.h"

struct ts_coeffs {
	const struct ts_arg *rows; /* the arguments of one entry */
	size_t size;		   /* bytes of one entry */
	size_t n;		   /* entries */
	char *data;
	bool *given;	       /* by entry: the script has set it */
	struct ts_arena arena; /* strings of the arguments */
};

/* Enlarges the table to n entries, keeping those given. */
enum ts_status ts_coeffs_resize(struct tsim *sim, struct ts_coeffs *c, size_t n);
void ts_coeffs_release(struct ts_coeffs *c);

static inline void *ts_coeff(const struct ts_coeffs *c, size_t k)
{
	return c->data + k * c->size;
}

/* Parses the words of one entry into `entry`. The words `file NAME` stand for the contents of a
 * coefficient file: keyword-value lines, `#` comments. The file is searched under NAME itself, then in the
 * folder of the script, in the folder given by the environment variable TSIM_POTENTIALS, in ./potentials,
 * in potentials/ of the source tree of the program, and where the potentials have been installed. */
enum ts_status ts_coeff_parse(struct tsim *sim, const char *what, struct ts_coeffs *c, struct ts_words words,
			      const struct ts_place *where, void *entry);

/* All words of such a file; it is also searched with `ending` appended to its name. */
enum ts_status ts_coeff_words(struct tsim *sim, const struct ts_word *name, const char *ending,
			      struct ts_arena *arena, struct ts_words *out);

/* Saved as text that parses back to the same bits. */
enum ts_status ts_coeffs_archive(struct ts_archive *archive, struct tsim *sim, struct ts_coeffs *c);
void ts_coeffs_fingerprint(const struct ts_coeffs *c, const struct tsim *sim, struct ts_hash *hash);

#endif
