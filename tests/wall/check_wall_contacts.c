/* Lists of wall contacts: the next list keeps the history of the last one, in little more memory than it needs. */
#include "deck.h"

#include "core/sim.h"
#include "wall/wall_contacts.h"

enum { N = 3000, WIDTH = 2 };

static void list_all(struct tsim *sim, struct ts_wall_contacts *c, bool backwards)
{
	for (size_t k = 0; k < N; k++)
		ck_assert_int_eq(ts_wall_contacts_add(sim, c, backwards ? N - 1 - k : k, 7, 0), TS_OK);
}

/* Room that a list may have: a quarter more than it needs, where doubled arrays would have a third more or twice as much. */
static void room_is_small(size_t capacity, size_t need)
{
	ck_assert_uint_ge(capacity, need);
	ck_assert_uint_lt(capacity, need + need / 4);
}

START_TEST(next_list)
{
	struct tsim *sim = deck_open("region box block 0 1 0 1 0 1 units box\ncreate_box 1 box\n"
				     "create_atoms 1 random %d 49979687 box\n",
				     N);
	struct ts_wall_contacts c = { .width = WIDTH };
	struct ts_wall_rebuild rebuild;
	const void *forces;

	list_all(sim, &c, false);
	for (size_t k = 0; k < N; k++)
		ts_wall_memory(&c, k)[1] = 1 + (double)k;
	for (int turn = 0; turn < 3; turn++) {
		forces = c.force;
		ts_wall_contacts_start(&c, &rebuild, WIDTH);
		list_all(sim, &c, turn % 2 == 0);
		ck_assert_int_eq(ts_wall_contacts_finish(sim, &c, &rebuild), TS_OK);
		ck_assert_ptr_eq(c.force, forces);
		room_is_small(c.key_capacity, N);
		room_is_small(c.last_capacity, N);
		room_is_small(c.memory_capacity, N * WIDTH);
		for (size_t k = 0; k < N; k++) {
			ck_assert(c.row[k] == (int32_t)(turn % 2 == 0 ? N - 1 - k : k));
			ck_assert(ts_wall_memory(&c, k)[1] == 1 + (double)c.row[k]);
			ck_assert(c.force[k][0] == 0 && ts_wall_memory(&c, k)[0] == 0);
		}
	}
	ts_wall_contacts_release(&c);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("wall contacts");
	TCase *tests = tcase_create("lists");

	tcase_add_test(tests, next_list);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
