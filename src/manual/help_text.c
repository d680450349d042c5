/* Text of manual pages: headings, wrapped lines, items of lists, paragraphs; for the terminal or as Markdown. */
#include "manual/help_text.h"

#include <string.h>

#include "base/banned.h"

void ts_help_heading(const char *text, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "\n## %s\n\n" : "\n%s\n", text);
}

void ts_help_subheading(const char *text, bool markdown, struct ts_str *out)
{
	ts_str_addf(out, markdown ? "\n### %s\n\n" : "\n %s\n", text);
}

/* Length up to the next blank; text in brackets is not broken. */
static size_t word_length(const char *text)
{
	size_t n = strcspn(text, " \n"), all = *text == '[' ? strcspn(text, "]") : 0;

	return all > n && all < 40 && text[all] ? all + strcspn(text + all, " \n") : n;
}

void ts_help_wrapped(const char *text, size_t indent, size_t more, struct ts_str *out)
{
	size_t column = 0;

	while (*text) {
		size_t blanks = strspn(text, " \n"), n = word_length(text + blanks);

		if (column && blanks > 1 && text[0] == '\n' && text[1] == '\n') {
			ts_str_add(out, "\n");
			column = 0;
		}
		if (!column || column + 1 + n > 78) {
			size_t pad = column ? indent + more : indent;

			ts_str_addf(out, "%s%*s", out->length ? "\n" : "", (int)pad, "");
			column = pad;
		} else {
			ts_str_add(out, " ");
			column++;
		}
		ts_str_add_n(out, text + blanks, n);
		column += n;
		text += blanks + n;
	}
}

void ts_help_entry(const struct ts_str *name, const struct ts_str *text, size_t depth, bool markdown,
		   struct ts_str *out)
{
	if (markdown) {
		ts_str_addf(out, "%*s- `%s` — %s\n", (int)(2 * depth), "", ts_str_text(name),
			    ts_str_text(text));
		return;
	}
	ts_str_addf(out, "%*s%s", (int)(2 + 4 * depth), "", ts_str_text(name));
	ts_help_wrapped(ts_str_text(text), 6 + 4 * depth, 0, out);
	ts_str_add(out, "\n");
}

void ts_help_lines(const char *text, const char *indent, struct ts_str *out)
{
	while (*text) {
		size_t n = strcspn(text, "\n");

		ts_str_add(out, n ? indent : "");
		ts_str_add_n(out, text, n);
		ts_str_add(out, "\n");
		text += n + (text[n] == '\n');
	}
}

void ts_help_block(const char *text, bool markdown, struct ts_str *out)
{
	ts_str_add(out, markdown ? "```\n" : "");
	ts_help_lines(text, markdown ? "" : "  ", out);
	ts_str_add(out, markdown ? "```\n" : "");
}

/* Lines that begin with blanks, such as formulas and tables, are preformatted. */
static bool is_preformatted(const char *line)
{
	return line[0] == ' ' && line[1] == ' ';
}

/* Whether the line is the first one of an item of a list. */
static bool begins_item(const char *text)
{
	return text[0] == '*' && text[1] == ' ';
}

/* Length of the lines up to an empty one, the next item of a list, or one of the other kind (preformatted
 * or not), with the line end. */
static size_t part_length(const char *text)
{
	bool preformatted = is_preformatted(text);
	size_t n = 0;

	while (text[n] && text[n] != '\n' && is_preformatted(text + n) == preformatted &&
	       !(n && begins_item(text + n))) {
		n += strcspn(text + n, "\n");
		n += text[n] == '\n';
	}
	return n;
}

static void add_part(const char *text, bool markdown, struct ts_str *out)
{
	struct ts_str lines = { 0 };

	if (is_preformatted(text)) {
		ts_str_add(out, markdown ? "```\n" : "");
		ts_help_lines(text, markdown ? "" : "  ", out);
		ts_str_add(out, markdown ? "```\n" : "");
	} else if (markdown) {
		ts_str_addf(out, "%s\n", text);
	} else {
		ts_help_wrapped(text, 2, begins_item(text) ? 2 : 0, &lines);
		ts_str_addf(out, "%s\n", ts_str_text(&lines));
	}
	out->failed |= lines.failed;
	ts_str_release(&lines);
}

void ts_help_paragraphs(const char *text, bool markdown, struct ts_str *out)
{
	struct ts_str part = { 0 };

	while (*text) {
		size_t n = part_length(text);

		ts_str_clear(&part);
		ts_str_add_n(&part, text, n && text[n - 1] == '\n' ? n - 1 : n);
		if (n)
			add_part(ts_str_text(&part), markdown, out);
		text += n;
		if (*text == '\n')
			ts_str_add(out, "\n");
		text += strspn(text, "\n");
	}
	out->failed |= part.failed;
	ts_str_release(&part);
}

void ts_help_item(const char *name, const char *text, bool markdown, struct ts_str *out)
{
	size_t n = strlen(name);

	if (markdown)
		ts_str_addf(out, "- `%s` — %s\n", name, text);
	else if (n <= 22)
		ts_str_addf(out, "  %-22s %s\n", name, text);
	else
		ts_str_addf(out, "  %s\n  %-22s %s\n", name, "", text);
}
