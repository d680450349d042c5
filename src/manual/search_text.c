#include "manual/search_text.h"

#include <string.h>

#include "manual/help.h"
#include "manual/page_text.h"
#include "manual/search_query.h"
#include "manual/topics.h"

#include "base/banned.h"

/* Begins a page; NULL: out of memory. */
static struct ts_search_page *add_page(struct ts_search_text *all, const char *command, const char *title)
{
	struct ts_search_page *page;

	all->failed |= TS_GROW(all->page, all->page_capacity, all->pages + 1) != TS_OK;
	if (all->failed)
		return NULL;
	page = &all->page[all->pages++];
	*page = (struct ts_search_page){ 0 };
	ts_str_add(&page->command, command);
	ts_query_small_letters(title, &page->title);
	return page;
}

/* A passage of the last page; the text is already there. */
static void add_passage(struct ts_search_text *all, size_t begin, size_t length, const char *heading,
			bool example)
{
	all->failed |= TS_GROW(all->passage, all->passage_capacity, all->passages + 1) != TS_OK;
	if (all->failed || !length)
		return;
	all->passage[all->passages++] =
		(struct ts_search_passage){ all->pages - 1, begin, length, heading, example };
}

/* Whether a line of a page begins a passage: a paragraph, or an argument in a list. */
static bool begins_passage(const char *line, bool after_blank)
{
	bool item = line[0] == ' ' && line[1] == ' ' && strchr("[abcdefghijklmnopqrstuvwxyzINM", line[2]) &&
		    line[2];

	return after_blank || item || line[0] != ' ';
}

/* Cuts the text of the last page into paragraphs and items. In the description the lines of a paragraph look like
 * items, so that it is cut at blank lines only. */
static void cut_page(struct ts_search_text *all, const char *text)
{
	size_t begin = 0;
	bool after_blank = false, prose = true, example = false;

	for (size_t k = 0; text[k];) {
		size_t n = strcspn(text + k, "\n");
		bool heading = n && text[k] != ' ';

		if (heading)
			prose = strncmp(text + k, "Description", n) == 0 || k == 0;
		if (strncmp(text + k, "  Related: ", 11) == 0 && after_blank && k > begin) {
			add_passage(all, begin, k - begin, "", example);
			begin = k;
			example = true;
		}
		if (n && k > begin &&
		    (prose ? after_blank || heading : begins_passage(text + k, after_blank))) {
			add_passage(all, begin, k - begin, "", example);
			begin = k;
		}
		if (heading)
			example = strncmp(text + k, "Example", n) == 0;
		after_blank = n == 0;
		k += n + (text[k + n] == '\n');
		if (!text[k])
			add_passage(all, begin, k - begin, "", example);
	}
}

static void add_cut_page(struct ts_search_text *all, const char *command, const char *title,
			 struct ts_str *text)
{
	struct ts_search_page *page = add_page(all, command, title);

	if (!page)
		return;
	page->text = *text;
	*text = (struct ts_str){ 0 };
	ts_query_small_letters(ts_str_text(&page->text), &page->small);
	all->failed |= page->text.failed || page->small.failed;
	if (!all->failed)
		cut_page(all, ts_str_text(&page->text));
}

static void add_documents(struct ts_search_text *all)
{
	struct ts_search_page *page = NULL;
	struct ts_str title = { 0 };
	const char *last = "";

	for (const struct ts_page_text *t = ts_page_texts; t->page && !all->failed; t++) {
		size_t begin;

		if (!ts_streq(t->page, last)) {
			ts_str_clear(&title);
			ts_str_addf(&title, "%s %s", t->title, t->page);
			page = add_page(all, t->page, ts_str_text(&title));
			if (page)
				page->shown = t->title;
		}
		last = t->page;
		if (!page)
			break;
		begin = page->text.length;
		ts_str_addf(&page->text, "%s\n\n", t->text);
		add_passage(all, begin, page->text.length - begin, t->heading, false);
	}
	for (size_t k = 0; k < all->pages; k++)
		if (!all->page[k].small.length)
			ts_query_small_letters(ts_str_text(&all->page[k].text), &all->page[k].small);
	all->failed |= title.failed;
	ts_str_release(&title);
}

void ts_search_text_make(const struct ts_tables *tables, struct ts_search_text *out)
{
	struct ts_str text = { 0 }, command = { 0 }, title = { 0 };

	*out = (struct ts_search_text){ 0 };
	for (const struct ts_style *const *s = tables->styles; *s; s++) {
		ts_str_clear(&command);
		ts_str_clear(&title);
		ts_str_addf(&command, "%s %s", ts_kind_name((*s)->kind), (*s)->name);
		ts_str_addf(&title, "%s %s", ts_str_text(&command), (*s)->summary);
		ts_help_page(*s, false, &text);
		add_cut_page(out, ts_str_text(&command), ts_str_text(&title), &text);
	}
	for (const struct ts_topic *t = ts_topics; t->name; t++) {
		t->page(tables, false, &text);
		add_cut_page(out, t->name, t->name, &text);
	}
	out->failed |= command.failed || title.failed;
	ts_str_release(&text);
	ts_str_release(&command);
	ts_str_release(&title);
	add_documents(out);
}

void ts_search_text_release(struct ts_search_text *text)
{
	for (size_t k = 0; k < text->pages; k++) {
		ts_str_release(&text->page[k].command);
		ts_str_release(&text->page[k].title);
		ts_str_release(&text->page[k].text);
		ts_str_release(&text->page[k].small);
	}
	ts_free(text->page);
	ts_free(text->passage);
	*text = (struct ts_search_text){ 0 };
}
