/* -plot on the command line. */
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "program/program.h"
#include "view/view.h"

#include "base/banned.h"

enum { COLUMNS = 80, ROWS = 24, MOST_FILES = 16 };

/* Whether text is UTF-8: the first of these variables that is set decides. */
static bool is_utf8(void)
{
	static const char *const names[] = { "LC_ALL", "LC_CTYPE", "LANG" };

	for (int k = 0; k < 3; k++) {
		const char *value = getenv(names[k]);

		if (value && *value)
			return strstr(value, "UTF-8") || strstr(value, "utf8") || strstr(value, "utf-8");
	}
	return false;
}

static struct ts_plot_terminal terminal_of(void)
{
	const char *type = getenv("TERM"), *plain = getenv("NO_COLOR");
	struct ts_plot_terminal t = { .columns = COLUMNS, .rows = ROWS, .unicode = is_utf8() };
	struct winsize size;

	if (!isatty(STDOUT_FILENO))
		return t;
	t.colour = type && !ts_streq(type, "dumb") && !(plain && *plain);
	if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
		t.columns = size.ws_col;
		t.rows = size.ws_row - 5 < 40 ? size.ws_row - 5 : 40; /* title, legend, prompt */
	}
	return t;
}

/* Options of runs. */
static int refuse_conflicts(const struct ts_setup *setup)
{
	const char *other = setup->input	  ? "-in"
			    : setup->studied	  ? "-sweep or -calibrate"
			    : setup->check	  ? "-check"
			    : setup->explain	  ? "-explain"
			    : setup->advised	  ? "-advise"
			    : setup->crosscheck.n ? "-crosscheck"
			    : setup->sandboxed	  ? "-sandbox"
			    : setup->screen	  ? "-screen"
			    : setup->variables.n  ? "-var"
						  : NULL;

	return other ? ts_program_usage_error("-plot and %s cannot be given together%s", other, "") : 0;
}

/* The options that the list of words has. */
static bool begins_words(const char *text)
{
	return ts_streq(text, "-plot") || ts_streq(text, "-right") || ts_streq(text, "-x") ||
	       ts_streq(text, "-style");
}

/* The words up to the next option. */
static struct ts_words take_words(const struct ts_word_list *list, size_t *k)
{
	struct ts_words words = { &list->word[*k], 0 };

	for (; *k < list->n && !begins_words(list->word[*k].text); ++*k)
		words.n++;
	return words;
}

/* The words are "-plot" FILE COLUMN ..., "-right" COLUMN ..., "-x" COLUMN, "-style" STYLE. The last two hold for the file before them; for all
 * files if they are given once. */
static int read_sources(const struct ts_word_list *list, struct ts_view_source *source, size_t *n)
{
	const char *x = NULL, *style = NULL;
	size_t xs = 0, styles = 0;

	*n = 0;
	for (size_t k = 0; k < list->n;) {
		const char *option = list->word[k].text, *value = list->word[k + 1].text;
		struct ts_view_source *last = *n ? &source[*n - 1] : NULL;

		k += 2;
		if (ts_streq(option, "-plot")) {
			if (*n == MOST_FILES)
				return ts_program_usage_error("-plot is given more than 16 times%s%s", "",
							      "");
			source[*n] =
				(struct ts_view_source){ .path = value, .columns = take_words(list, &k) };
			++*n;
		} else if (ts_streq(option, "-right")) {
			if (!last || last->right.n)
				return ts_program_usage_error("-right %s%s",
							      last ? "is given twice for "
								   : "follows -plot FILE, ",
							      last ? last->path
								   : "of which it names columns");
			k--; /* its first value is a column as the others */
			last->right = take_words(list, &k);
		} else if (ts_streq(option, "-x")) {
			x = value;
			xs++;
			if (last)
				last->x = value;
		} else {
			style = value;
			styles++;
			if (last)
				last->style = value;
		}
	}
	for (size_t k = 0; k < *n; k++) {
		source[k].x = xs == 1 ? x : source[k].x;
		source[k].style = styles == 1 ? style : source[k].style;
	}
	return 0;
}

int ts_program_plot(struct tsim *sim, const struct ts_setup *setup)
{
	const struct ts_plot_words *w = &setup->plotted;
	struct ts_view_source source[MOST_FILES];
	struct ts_view_input in = { .source = source,
				    .out = w->out,
				    .log = setup->log_given ? setup->log : NULL,
				    .by = w->by,
				    .part = w->part,
				    .title = w->title,
				    .xlabel = w->xlabel,
				    .ylabel = w->ylabel,
				    .right_label = w->right_label,
				    .right_range = w->right_range,
				    .size = w->size,
				    .panels = w->panels,
				    .marks = { setup->marks.word, setup->marks.n },
				    .xrange = w->xrange,
				    .yrange = w->yrange,
				    .terminal = terminal_of() };
	struct ts_str text = { 0 };
	int status = refuse_conflicts(setup);

	if (!status)
		status = read_sources(&setup->plot, source, &in.n);
	if (status)
		return status;
	sim->log.screen = stdout;
	status = ts_view(sim, &in, &text) == TS_OK ? EXIT_SUCCESS : EXIT_FAILURE;
	if (ts_program_print(&text))
		status = EXIT_FAILURE;
	return status;
}
