#include "crosscheck/frame.h"

#include <ctype.h>
#include <string.h>

#include "base/hash.h"

#include "base/banned.h"

bool ts_printed_is_number(const char *word)
{
	double value;
	const char *bare = word + (*word == '-' || *word == '+');

	return ts_parse_real(word, &value) || ts_streq(bare, "nan") || ts_streq(bare, "inf");
}

static double hash_value(const char *word)
{
	struct ts_hash hash = ts_hash_start();

	ts_hash_text(&hash, word);
	return 1e30 * (1.0 + (double)(ts_hash_value(&hash) >> 12) / 4503599627370496.0);
}

struct ts_printed ts_printed(const char *word)
{
	struct ts_printed p = { .decimals = -1 };
	bool leading = true, exponent = false;

	if (!ts_parse_real(word, &p.value)) {
		p.value = hash_value(word + (*word == '-' && ts_printed_is_number(word)));
		p.word = true;
		return p;
	}
	for (const char *c = word; *c && !exponent; c++) {
		if (*c == '.' || *c == 'e' || *c == 'E')
			p.decimals = p.decimals < 0 ? 0 : p.decimals;
		exponent = *c == 'e' || *c == 'E';
		if (!isdigit((unsigned char)*c))
			continue;
		leading &= *c == '0';
		p.digits += !leading;
		p.decimals += p.decimals >= 0;
		p.padded = p.decimals > 0 && *c == '0';
	}
	p.padded &= !exponent;
	return p;
}

size_t ts_frame_column(const struct ts_frame *frame, const char *name)
{
	for (size_t k = 0; k < frame->columns; k++)
		if (frame->name[k] == name)
			return k;
	return SIZE_MAX;
}
