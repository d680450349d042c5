/* Text and style of the page. */
#include <math.h>
#include <string.h>

#include "report/page.h"

#include "base/banned.h"

/* A sequence of UTF-8 that begins here: its length, 0: it is none (RFC 3629). */
static size_t sequence(const unsigned char *c, size_t n)
{
	const size_t length = c[0] >= 0xc2 && c[0] < 0xe0   ? 2
			      : (c[0] & 0xf0) == 0xe0	    ? 3
			      : c[0] >= 0xf0 && c[0] < 0xf5 ? 4
							    : 0;

	if (!length || length > n)
		return 0;
	for (size_t k = 1; k < length; k++)
		if ((c[k] & 0xc0) != 0x80)
			return 0;
	if ((c[0] == 0xe0 && c[1] < 0xa0) || (c[0] == 0xed && c[1] >= 0xa0) ||
	    (c[0] == 0xf0 && c[1] < 0x90) || (c[0] == 0xf4 && c[1] >= 0x90))
		return 0;
	return length;
}

static const char *entity(unsigned char c)
{
	switch (c) {
	case '<':
		return "&lt;";
	case '>':
		return "&gt;";
	case '&':
		return "&amp;";
	case '"':
		return "&quot;";
	default:
		return NULL;
	}
}

void ts_page_text_n(struct ts_str *out, const char *text, size_t n)
{
	const unsigned char *c = (const unsigned char *)text;

	for (size_t k = 0; k < n;) {
		const char *name = entity(c[k]);
		const size_t length = c[k] < 0x80 ? 0 : sequence(c + k, n - k);

		if (name)
			ts_str_add(out, name);
		else if (length)
			ts_str_add_n(out, text + k, length);
		else if (c[k] >= 0x80 || c[k] == 0x7f || (c[k] < 0x20 && !strchr("\t\n", (int)c[k])))
			ts_str_add(out, "?");
		else
			ts_str_add_n(out, text + k, 1);
		k += length ? length : 1;
	}
}

void ts_page_text(struct ts_str *out, const char *text)
{
	ts_page_text_n(out, text, strlen(text));
}

void ts_page_section(struct ts_str *out, const char *id, const char *title)
{
	ts_str_addf(out, "<section id=\"%s\">\n<h2>%s</h2>\n", id, title);
}

void ts_page_end_section(struct ts_str *out)
{
	ts_str_add(out, "</section>\n");
}

void ts_page_number(struct ts_str *out, double value)
{
	if (isfinite(value))
		ts_str_addf(out, "%.6g", value);
	else
		ts_str_add(out, "-");
}

void ts_page_duration(struct ts_str *out, double seconds)
{
	const double minutes = floor(seconds / 60), hours = floor(seconds / 3600);

	if (seconds < 1)
		ts_str_addf(out, "%.0f ms", 1000 * seconds);
	else if (seconds < 60)
		ts_str_addf(out, "%.1f s", seconds);
	else if (seconds < 3600)
		ts_str_addf(out, "%.0f min %.0f s", minutes, floor(seconds - 60 * minutes));
	else
		ts_str_addf(out, "%.0f h %.0f min", hours, floor(minutes - 60 * hours));
}

const char *ts_page_time_unit(const struct tsim *sim)
{
	static const char *const unit[] = {
		[TS_UNITS_LJ] = NULL, [TS_UNITS_SI] = "s", [TS_UNITS_CGS] = "s", [TS_UNITS_MICRO] = "µs"
	};

	return unit[sim->units];
}

const char *const ts_page_style[] = {
	":root{color-scheme:light "
	"dark;--ground:#f6f6f3;--card:#fff;--ink:#1d2126;--soft:#626a73;--line:#dfe0dc;--accent:#1f5f99;--ok:"
	"#18794e;--off:#b3261e;--warn:#8a5a00;--okground:#e3f4ea;--offground:#fbe6e4;--warnground:#fbf0d9;--"
	"p1:#0072b2;--p2:#e69f00;--p3:#009e73;--p4:#d55e00;--p5:#cc79a7;--p6:#56b4e9}@media(prefers-color-"
	"scheme:dark){:root{--ground:#15181c;--card:#1d2126;--ink:#e4e6e8;--soft:#98a1aa;--line:#333a41;--"
	"accent:#7db7ea;--ok:#5fd39a;--off:#ff8f86;--warn:#eabf66;--okground:#16352a;--offground:#43201e;--"
	"warnground:#3a2f17}img{filter:brightness(.88)}}",
	"*{box-sizing:border-box}html{-webkit-text-size-adjust:100%;scroll-behavior:smooth}body{margin:0;"
	"background:var(--ground);color:var(--ink);font:16px/1.5 system-ui,-apple-system,'Segoe "
	"UI',Roboto,'Noto Sans','Liberation Sans',sans-serif}header,main,footer{max-width:72rem;margin:0 "
	"auto;padding:0 1.1rem}header{padding-top:1.6rem}h1{font-size:1.7rem;line-height:1.2;margin:0 0 "
	".3rem;overflow-wrap:anywhere}h2{font-size:1.2rem;margin:2.2rem 0 .7rem}h3{font-size:.95rem;margin:0 "
	"0 .1rem;overflow-wrap:anywhere}p{margin:.4rem "
	"0}.soft,figcaption,small{color:var(--soft);font-size:.86rem}a{color:var(--accent);text-decoration:"
	"none}a:hover{text-decoration:underline}",
	".badge{display:inline-block;padding:.1rem "
	".65rem;border-radius:1rem;font-weight:600;font-size:.86rem}.ok{color:var(--ok)}.off{color:var(--off)"
	"}.warn{color:var(--warn)}.badge.ok,td.ok{background:var(--okground)}.badge.off,td.off{background:"
	"var(--offground)}.badge.warn{background:var(--warnground)}nav{display:flex;gap:.4rem;overflow-x:"
	"auto;margin:1rem 0 0;padding-bottom:.3rem}nav a{white-space:nowrap;padding:.2rem .7rem;border:1px "
	"solid "
	"var(--line);border-radius:1rem;background:var(--card);font-size:.86rem}.tiles{display:grid;grid-"
	"template-columns:repeat(auto-fit,minmax(8.5rem,1fr));gap:.6rem;margin-top:1.1rem}.tile,.card,.box{"
	"background:var(--card);border:1px solid var(--line);border-radius:.6rem}.tile{padding:.55rem "
	".8rem}.tile b{display:block;font-size:1.22rem;line-height:1.25;font-weight:600}.tile "
	"span{color:var(--soft);font-size:.8rem}",
	".box{padding:.7rem .9rem;margin:.6rem "
	"0;overflow-x:auto}.box.off{background:var(--offground);border-color:var(--off)}.box.warn{background:"
	"var(--warnground);border-color:var(--warn)}.box.off,.box.warn{color:var(--ink)}.plots{display:grid;"
	"grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));gap:.8rem}.card{padding:.7rem "
	".7rem .3rem;min-width:0}.card svg,.card .ts-plot{width:100%;height:auto;display:block}.card "
	".ts-plot{color:var(--ink)}.ts-plot "
	".ground{fill:transparent}.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min("
	"100%,17rem),1fr));gap:.8rem}figure{margin:0}figure "
	"img{width:100%;height:auto;display:block;border-radius:.5rem;border:1px solid "
	"var(--line)}figcaption{padding:.25rem .2rem}.scroll{overflow-x:auto}",
	"table{border-collapse:collapse;width:100%;font-size:.9rem;font-variant-numeric:tabular-nums}th{text-"
	"align:left;color:var(--soft);font-weight:600;font-size:.8rem;white-space:nowrap}th,td{padding:.3rem "
	".7rem .3rem 0;border-bottom:1px solid "
	"var(--line);vertical-align:top}td.n,th.n{text-align:right;white-space:nowrap}td.ok,td.off{text-"
	"align:center;font-weight:600;padding:.3rem .5rem}td.bar{width:32%;min-width:6rem}.bar "
	"i{display:block;height:.75rem;border-radius:.2rem;background:var(--p1);min-width:1px;margin-top:."
	"3rem}.bar "
	"i.minus{background:var(--p4)}.stack{display:flex;height:1.6rem;border-radius:.4rem;overflow:hidden;"
	"margin:.5rem 0}.stack i{display:block}.key{display:flex;flex-wrap:wrap;gap:.2rem "
	"1.1rem;font-size:.86rem}.key "
	"i{display:inline-block;width:.75rem;height:.75rem;border-radius:.2rem;margin-right:.35rem}.q0{"
	"background:var(--p1)}.q1{background:var(--p2)}.q2{background:var(--p6)}.q3{background:var(--p3)}.q4{"
	"background:var(--p4)}.q5{background:var(--p5)}.q6{background:var(--soft)}",
	"details{background:var(--card);border:1px solid var(--line);border-radius:.6rem;margin:.6rem "
	"0}summary{cursor:pointer;padding:.5rem "
	".9rem;font-weight:600;overflow-wrap:anywhere}details>div{padding:0 .9rem "
	".7rem;overflow-x:auto}pre{font:.8rem/1.5 ui-monospace,'DejaVu Sans "
	"Mono',Menlo,Consolas,monospace;margin:0;tab-size:8}pre.wrap{white-space:pre-wrap;overflow-wrap:"
	"anywhere}pre.code{counter-reset:l}pre.code "
	"b{font-weight:inherit;display:inline-block;min-width:100%}pre.code "
	"b::before{counter-increment:l;content:counter(l);display:inline-block;width:2.8em;margin-right:1em;"
	"text-align:right;color:var(--soft);opacity:.7}pre.code i{color:var(--soft)}pre.code "
	"b.bad{background:var(--offground)}ul{margin:.3rem "
	"0;padding-left:1.2rem}li{overflow-wrap:anywhere}footer{padding-top:2rem;padding-bottom:2rem;color:"
	"var(--soft);font-size:.8rem}",
	"@media(max-width:40rem){h1{font-size:1.35rem}header,main,footer{padding-left:.8rem;padding-right:."
	"8rem}.tiles{grid-template-columns:repeat(2,1fr)}table.wide thead{display:none}}@media "
	"print{:root{--ground:#fff;--card:#fff;--ink:#000;--soft:#555;--line:#bbb;--accent:#000;--ok:#18794e;"
	"--off:#b3261e}nav{display:none}body{font-size:10.5pt}.card,figure,.tile,tr{break-inside:avoid}h2{"
	"break-after:avoid}img{filter:none}details::details-content{content-visibility:visible;height:auto}."
	"badge,.stack,.bar i,.key "
	"i,td{-webkit-print-color-adjust:exact;print-color-adjust:exact}pre{white-space:pre-wrap}}",
	NULL,
};
