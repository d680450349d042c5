/* Any bytes as a restart file. Files that begin as such are read as they are; else the input is the
 * content of sections without checksums and compression, which are added here:
 * kind + 1 (u32; 1000 the clock), lengths of the three names (3 x u8), length of the block (u32),
 * names, block. Styles take up their state, and the run goes on for a few steps. */
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "sandbox.h"

#include "core/sim.h"
#include "tsim.h"

static const char script[] = "read_restart input\n"
			     "pair_style spring/dashpot\n"
			     "bond_style contact\n"
			     "pair_coeff * * stiffness 2385.0 restitution 0.6\n"
			     "bond_coeff * stiffness 1931.0 ultimate 0.35\n"
			     "region low block INF INF INF INF INF 0.045 units box\n"
			     "fix move all nve\n"
			     "compute com all com\n"
			     "compute nc all contacts\n"
			     "compute nb all bonds\n"
			     "compute out all leave low\n"
			     "fix crack all bond/breakage file a\n"
			     "fix mean all ave/time 7 9 105 c_nc ke\n"
			     "fix window all ave/time 5 3 20 c_com[3] ave window 4\n"
			     "fix trace all vector 13 ke\n"
			     "dump d all custom 1 d id type x y z vx vy vz\n"
			     "dump b all local 1 b c_nb[1] c_nb[2]\n"
			     "thermo_style custom step atoms ke c_nc c_out[1] f_mean[1] f_window\n"
			     "thermo_modify lost ignore\n"
			     "run 3\n"
			     "write_restart again\n";

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	return 0;
}

struct buffer {
	uint8_t *bytes;
	size_t n, room;
};

static void add(struct buffer *b, const void *bytes, size_t n)
{
	if (b->n + n > b->room) {
		b->room = 2 * (b->n + n);
		b->bytes = realloc(b->bytes, b->room);
		if (!b->bytes)
			abort();
	}
	if (n)
		memcpy(b->bytes + b->n, bytes, n);
	b->n += n;
}

static void add_u32(struct buffer *b, uint32_t value)
{
	add(b, &value, sizeof value);
}

static uint32_t sum_of(const void *bytes, size_t n)
{
	return (uint32_t)crc32_z(crc32_z(0, NULL, 0), bytes, n);
}

struct section {
	uint32_t kind, length[3], plain;
	const uint8_t *names, *block;
};

/* The section at *at, cut where the input ends; false at its end. */
static int take(const uint8_t *data, size_t size, size_t *at, struct section *s)
{
	size_t names = 0;

	if (size - *at < 11)
		return 0;
	memcpy(&s->kind, data + *at, 4);
	for (int k = 0; k < 3; k++)
		names += s->length[k] = data[*at + 4 + (size_t)k];
	memcpy(&s->plain, data + *at + 7, 4);
	*at += 11;
	if (size - *at < names)
		return 0;
	s->names = data + *at;
	*at += names;
	s->block = data + *at;
	if (s->plain > size - *at)
		s->plain = (uint32_t)(size - *at);
	*at += s->plain;
	return 1;
}

static void pack(struct buffer *out, const struct section *s)
{
	struct buffer plain = { 0 };
	uint32_t names = s->length[0] + s->length[1] + s->length[2];
	uint64_t sizes[2];
	uLongf packed;
	uint8_t *bytes;

	add(&plain, s->block, s->plain);
	add_u32(&plain, sum_of(s->block, s->plain));
	packed = compressBound(plain.n);
	bytes = malloc(packed);
	if (!bytes || compress2(bytes, &packed, plain.bytes, plain.n, 1) != Z_OK)
		abort();
	add_u32(out, s->kind);
	add(out, s->length, sizeof s->length);
	sizes[0] = plain.n;
	sizes[1] = packed;
	add(out, sizes, sizeof sizes);
	add_u32(out, sum_of(bytes, packed));
	add_u32(out, 0);
	add(out, s->names, names);
	add(out, bytes, packed);
	free(bytes);
	free(plain.bytes);
}

static void make_file(struct buffer *out, const uint8_t *data, size_t size)
{
	static const char magic[] = "tsim restart 2\n";
	struct section s;
	size_t at = 0;

	add(out, magic, sizeof magic - 1);
	add_u32(out, 0x01020304);
	add_u32(out, 2);
	while (take(data, size, &at, &s))
		pack(out, &s);
	add_u32(out, 0);
	add_u32(out, sum_of(out->bytes, out->n - 4));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct tsim *sim = tsim_open();
	struct buffer file = { 0 };

	if (!sim)
		return 0;
	if (size > 5 && memcmp(data, "tsim ", 5) == 0)
		add(&file, data, size);
	else
		make_file(&file, data, size);
	sandbox_enter(sim, file.bytes, file.n);
	tsim_string(sim, script);
	sandbox_report(sim);
	tsim_close(sim);
	sandbox_leave();
	free(file.bytes);
	return 0;
}
