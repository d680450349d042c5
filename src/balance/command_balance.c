/* Command balance: changes the blocks of ranks. */
#include "balance/rank_balance.h"
#include "core/ranks.h"
#include "io/textfile.h"

#include "base/banned.h"

static enum ts_status write_file(struct ts_rank_balance *b, struct tsim *sim, const struct ts_place *where)
{
	struct ts_textfile file = { 0 };
	struct ts_rank_blocks *blocks;
	enum ts_status status;

	if (!b->file)
		return TS_OK;
	TS_TRY(ts_balance_blocks(b, sim, &blocks));
	TS_TRY(ts_textfile_open(&file, sim, where, b->file, false));
	status = ts_balance_write(&file, sim, blocks);
	return ts_textfile_close(&file) == TS_OK ? status : TS_IO;
}

static enum ts_status balance(struct ts_rank_balance *b, struct tsim *sim, const struct ts_place *where)
{
	struct ts_balance_result result;

	TS_TRY(ts_balance_read(b, sim, where));
	TS_TRY(ts_weights_check(&b->weights, sim));
	TS_TRY(ts_balance_apply(b, sim, where, &result));
	if (ts_ranks(sim) > 1)
		ts_log(&sim->log,
		       "Balance of %d ranks: imbalance %.6g, before %.6g; the largest load is %.10g; %d "
		       "iterations\n",
		       ts_ranks(sim), result.after, result.before, result.most, result.iterations);
	return write_file(b, sim, where);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_rank_balance *b = state;
	enum ts_status status;

	b->what = "balance";
	status = balance(b, sim, where);
	ts_balance_release(b);
	return status;
}

/* clang-format off */
#define CUTS(letter, d) TS_SOME_KEYWORD(letter, struct ts_rank_balance, cuts[d], 0, \
	.help = "`uniform`, or where to cut along " letter ", between 0 and 1, one number less than there are blocks")
/* clang-format on */

static const struct ts_arg args[] = {
	TS_REAL("threshold", struct ts_rank_balance, threshold, .flags = TS_POSITIONAL,
		.range = TS_NOT_NEGATIVE,
		.help = "imbalance above which the blocks are changed; less than 1: always"),
	CUTS("x", 0),
	CUTS("y", 1),
	CUTS("z", 2),
	TS_SOME_KEYWORD("shift", struct ts_rank_balance, shift, 0, .least = 3,
			.help = "the dimensions, such as xz, along which cuts are moved, the largest number "
				"of "
				"bisections for each, and the imbalance at which to stop"),
	TS_FLAG("rcb", struct ts_rank_balance, rcb, .help = "recursive bisection"),
	TS_SOME_KEYWORD("weight", struct ts_rank_balance, weight, TS_REPEAT, .least = 2,
			.help = "`group N group1 weight1 ...`, `neigh factor`, `time factor`, `var name` or "
				"`store name`"),
	TS_WORD("out", struct ts_rank_balance, file, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file for the corners of the blocks"),
	TS_ARGS_END,
};

static const char *const more[] = {
	"Weights: the load is the sum of the weights of the particles, which are 1 without the keyword. "
	"Several keywords "
	"`weight` multiply.\n\n"
	"* `group N group1 weight1 ...`: a factor for the particles of each group.\n"
	"* `neigh factor`: one plus the number of neighbors of the particle in the neighbor list, whose skin "
	"tsim chooses (see neighbor). LAMMPS takes the mean of each process.\n"
	"* `time factor`: the time that the rank has needed for forces in the last run, divided by the "
	"number of its particles.\n"
	"* `var name`: an atom-style variable.\n"
	"* `store name`: no factor; the product so far is stored in the property d_NAME of fix "
	"property/atom.\n\n"
	"A factor of `neigh` or `time` stretches the weights linearly: the ratio of the largest to the least "
	"becomes so many times "
	"as large.",
	"The file has the corners of all blocks, in LAMMPS' format: `ITEM: NODES` with number, 1, x, y and "
	"z, eight for each "
	"rank (four in two dimensions), and `ITEM: CUBES` (`SQUARES`) with the numbers of its corners. The "
	"log tells the imbalance "
	"before and after.",
	NULL,
};

TS_STYLE(command, ts_command_style, ts_command_balance)
const struct ts_command_style ts_command_balance = {
	.style = {
		.name = "balance",
		.kind = TS_KIND_COMMAND,
		.summary = "Changes the blocks of space that ranks have",
		.doc = "With several ranks (mpirun) each of them has the particles of a block of the box. The imbalance is the "
		       "largest load of a rank divided by the mean; the load is the number of particles, or the sum of "
		       "their weights. If it is larger than the threshold the blocks are changed:\n\n"
		       "* `x`, `y`, `z` set the cuts along these dimensions, as parts of the box. Others stay.\n"
		       "* `shift` moves the cuts along each dimension named, one dimension after the other, so that slabs have equal "
		       "loads. Each cut is found by bisection of its place; it ends when the imbalance is small enough.\n"
		       "* `rcb` cuts the space that particles fill across its longest extent, so that both parts have loads in "
		       "proportion to the numbers of their ranks, half of them each; then each part likewise. These are no "
		       "blocks of a grid: `processors` has no effect, until `x`, `y`, `z` or `shift` make a grid again.\n\n"
		       "Without this command tsim itself cuts the box so that each rank has the same number of particles: into "
		       "slabs along x, these along y at places of their own, and these along z (doc/ranks.md). So "
		       "the imbalance is near 1 unless particles have weights. Blocks that this command or fix balance has "
		       "changed stay as they are, until these or `processors` change them.\n\n"
		       "Results do not depend on the blocks, to the last bit. With one rank the words are checked, and "
		       "nothing is changed.",
		.doc_more = more,
		.example = "balance 1.1 shift xy 10 1.05\n"
			   "balance 0.9 x uniform y 0.25 0.5 0.8\n"
			   "balance 1.05 rcb weight group 1 bonded 3.0 weight neigh 0.8 out blocks.txt",
		.cite = "M. J. Berger, S. H. Bokhari, IEEE Trans. Comput. C-36, 570 (1987): recursive bisection",
		.args = args,
		.state_size = sizeof(struct ts_rank_balance),
	},
	.needs_box = true,
	.run = run,
};
