/* Arguments common to several commands of the fluid. */
#include "flow/flow_arguments.h"
#include "base/axes.h"
#include "region/region.h"

#include "base/banned.h"

struct vector {
	struct ts_number number[3];
};

static const struct ts_arg vector_rows[] = {
	TS_NUMBER("x", struct vector, number[0], .flags = TS_POSITIONAL, .help = "along x, or v_NAME"),
	TS_NUMBER("y", struct vector, number[1], .flags = TS_POSITIONAL, .help = "along y, or v_NAME"),
	TS_NUMBER("z", struct vector, number[2], .flags = TS_POSITIONAL, .help = "along z, or v_NAME"),
	TS_ARGS_END,
};

enum ts_status ts_flow_read_vector(struct tsim *sim, const char *what, struct ts_words words,
				   const struct ts_place *where, struct ts_arena *arena,
				   struct ts_number out[3])
{
	struct vector vector = { 0 };

	TS_TRY(ts_args_parse(sim, what, vector_rows, words, where, arena, &vector));
	for (int d = 0; d < 3; d++)
		out[d] = vector.number[d];
	return TS_OK;
}

enum ts_status ts_flow_refuse_depth(struct tsim *sim, const char *what, struct ts_words words,
				    const struct ts_number vector[3])
{
	const struct ts_place *where = &words.word[2].place;
	double value;

	TS_TRY(ts_number_now(sim, &vector[2], where, &value));
	if (value == 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "%s is %g along z, expected 0: in a grid of one cell along z nothing flows along z",
		       what, value);
}

struct setting {
	int dim;
	const char *name;
};

static const struct ts_arg setting_rows[] = {
	TS_ENUM("dim", struct setting, dim, ts_axis_names, .flags = TS_POSITIONAL, .help = "coordinate"),
	TS_WORD("name", struct setting, name, .flags = TS_POSITIONAL,
		.help = "internal-style variable that gets it"),
	TS_ARGS_END,
};

enum ts_status ts_flow_read_set(struct tsim *sim, const char *what, struct ts_words words,
				const struct ts_place *where, struct ts_arena *arena, const char *out[3])
{
	out[0] = out[1] = out[2] = NULL;
	for (size_t k = 0; k < words.n; k += 2) {
		struct ts_words pair = ts_words_from(words, k);
		struct setting one = { 0 };

		if (pair.n > 2)
			pair.n = 2;
		TS_TRY(ts_args_parse(sim, what, setting_rows, pair, where, arena, &one));
		for (int d = 0; d < 3; d++)
			if (out[d] && (d == one.dim || ts_streq(out[d], one.name)))
				return ts_fail(&sim->error, TS_SYNTAX, &pair.word[0].place,
					       "%s %s %s: %s; give each coordinate one variable of its own",
					       what, ts_axis_names[one.dim], one.name,
					       d == one.dim ? "this coordinate has one already"
							    : "this variable has another coordinate already");
		out[one.dim] = one.name;
	}
	return TS_OK;
}

enum ts_status ts_flow_set_coordinates(struct tsim *sim, const char *const set[3], const double x[3],
				       const struct ts_place *where)
{
	for (int d = 0; d < 3; d++)
		if (set[d])
			TS_TRY(sim->script_api->set(sim->script_api_data, set[d], where, x[d]));
	return TS_OK;
}
