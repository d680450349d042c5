/* Pictures: the first state, states in between, the last state. */
#include <inttypes.h>
#include <string.h>

#include "report/page.h"

#include "base/banned.h"

static void add_picture(struct ts_page *page, const struct ts_record_picture *picture, const char *what)
{
	const char *unit = ts_page_time_unit(page->sim);
	struct ts_str *out = &page->out;

	if (!picture->data)
		return;
	ts_str_addf(out,
		    "<figure><img alt=\"state at step %" PRId64 "\" width=\"%" PRIu32 "\" height=\"%" PRIu32
		    "\" src=\"data:image/png;base64,",
		    picture->step, picture->width, picture->height);
	ts_str_add_n(out, picture->data, picture->length);
	ts_str_addf(out, "\"><figcaption>%sstep %" PRId64 ", time %.4g%s%s</figcaption></figure>\n", what,
		    picture->step, picture->time, unit ? " " : "", unit ? unit : "");
}

static bool has_any(const struct ts_record_view *view)
{
	return view->first.data || view->last.data || view->n;
}

static void add_words(struct ts_str *out, const struct ts_record_view *view)
{
	if (view->automatic)
		return;
	ts_str_add(out, "<p class=\"soft\">");
	for (size_t k = 0; k < view->words.n; k++) {
		ts_str_add(out, k ? " " : "");
		ts_page_text(out, view->words.word[k].text);
	}
	ts_str_add(out, "</p>\n");
}

static void add_remarks(struct ts_str *out, const struct ts_record_view *view)
{
	if (view->stride > 1)
		ts_str_addf(out,
			    "<p class=\"soft\">One picture in %" PRId64 " steps is shown, not one in %" PRId64
			    ": their number and size are limited.</p>\n",
			    view->stride * view->every, view->every);
	if (view->too_large)
		ts_str_addf(out,
			    "<p class=\"soft\">%" PRId64
			    " pictures are left out: they are too large. Choose a smaller size.</p>\n",
			    view->too_large);
	if (!view->trouble)
		return;
	ts_str_add(out, "<p class=\"warn\">The last state could not be drawn: ");
	ts_page_text(out, view->trouble);
	ts_str_add(out, "</p>\n");
}

/* Nothing has changed: one picture is enough. */
static bool is_same(const struct ts_record_picture *a, const struct ts_record_picture *b)
{
	return a->data && b->data && a->step == b->step && a->length == b->length &&
	       !memcmp(a->data, b->data, a->length);
}

static void add_view(struct ts_page *page, const struct ts_record_view *view)
{
	struct ts_str *out = &page->out;

	const bool same = is_same(&view->first, &view->last);

	add_words(out, view);
	ts_str_add(out, "<div class=\"pictures\">\n");
	add_picture(page, &view->first, same ? "first and last state, " : "first state, ");
	for (size_t k = 0; k < view->n; k++)
		if (!view->last.data || view->picture[k].step != view->last.step)
			add_picture(page, &view->picture[k], "");
	if (!same)
		add_picture(page, &view->last, "last state, ");
	ts_str_add(out, "</div>\n");
	add_remarks(out, view);
}

void ts_page_pictures(struct ts_page *page)
{
	const struct ts_record *r = page->record;
	bool any = false;

	for (size_t k = 0; k < r->nviews; k++)
		any |= has_any(&r->view[k]) || (r->view[k].trouble && !r->view[k].automatic);
	if (!any)
		return;
	ts_page_section(&page->out, "pictures", "Pictures");
	for (size_t k = 0; k < r->nviews; k++)
		add_view(page, &r->view[k]);
	ts_page_end_section(&page->out);
}
