/* The style sheet of the page. */
#include "report/page.h"

#include "plot/plot.h"

#include "base/banned.h"

static const char *const rules[] = {
	":root{color-scheme:light dark;--ground:#f6f6f3;--card:#fff;--ink:#1d2126;--soft:#626a73;",
	"--line:#dfe0dc;--accent:#1f5f99;--ok:#18794e;--off:#b3261e;--warn:#8a5a00;--okground:#e3f4ea;",
	"--offground:#fbe6e4;--warnground:#fbf0d9}",
	"@media screen and (prefers-color-scheme:dark){",
	":root{--ground:#15181c;--card:#1d2126;--ink:#e4e6e8;--soft:#98a1aa;--line:#333a41;",
	"--accent:#7db7ea;--ok:#5fd39a;--off:#ff8f86;--warn:#eabf66;--okground:#16352a;",
	"--offground:#43201e;--warnground:#3a2f17}",
	"img{filter:brightness(.88)}",
	"}",
	"*{box-sizing:border-box}",
	"html{-webkit-text-size-adjust:100%;scroll-behavior:smooth}",
	"body{margin:0;background:var(--ground);color:var(--ink);",
	"font:16px/1.5 system-ui,-apple-system,'Segoe UI',Roboto,'Noto Sans','Liberation Sans',",
	"sans-serif}",
	"header,main,footer{max-width:72rem;margin:0 auto;padding:0 1.1rem}",
	"header{padding-top:1.6rem}",
	"h1{font-size:1.7rem;line-height:1.2;margin:0 0 .3rem;overflow-wrap:anywhere}",
	"h2{font-size:1.2rem;margin:2.2rem 0 .7rem}",
	"h3{font-size:.95rem;margin:0 0 .1rem;overflow-wrap:anywhere}",
	"p{margin:.4rem 0}",
	".soft,figcaption,small{color:var(--soft);font-size:.86rem}",
	"a{color:var(--accent);text-decoration:none}",
	"a:hover{text-decoration:underline}",
	".badge{display:inline-block;padding:.1rem .65rem;border-radius:1rem;font-weight:600;",
	"font-size:.86rem}",
	".ok{color:var(--ok)}",
	".off{color:var(--off)}",
	".warn{color:var(--warn)}",
	".badge.ok,td.ok{background:var(--okground)}",
	".badge.off,td.off{background:var(--offground)}",
	".badge.warn{background:var(--warnground)}",
	"nav{display:flex;gap:.4rem;overflow-x:auto;margin:1rem 0 0;padding-bottom:.3rem}",
	"nav a{white-space:nowrap;padding:.2rem .7rem;border:1px solid var(--line);border-radius:1rem;",
	"background:var(--card);font-size:.86rem}",
	".tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(9.3rem,1fr));gap:.6rem;",
	"margin-top:1.1rem}",
	".tile,.card,.box{background:var(--card);border:1px solid var(--line);border-radius:.6rem}",
	".tile{padding:.55rem .7rem}",
	".tile b{display:block;font-size:1.1rem;line-height:1.35;font-weight:600}",
	".tile span{color:var(--soft);font-size:.8rem}",
	".box{padding:.7rem .9rem;margin:.6rem 0;overflow-x:auto}",
	".box.off{background:var(--offground);border-color:var(--off)}",
	".box.warn{background:var(--warnground);border-color:var(--warn)}",
	".box.off,.box.warn{color:var(--ink)}",
	".plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));",
	"gap:.8rem}",
	".card{padding:.7rem .7rem .3rem;min-width:0}",
	".card svg,.card .ts-plot{width:100%;height:auto;display:block}",
	".card .ts-plot{color:var(--ink)}",
	".card .ts-plot .ground{fill:transparent}",
	".pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,17rem),1fr));",
	"gap:.8rem}",
	"figure{margin:0}",
	"figure img{width:100%;height:auto;display:block;border-radius:.5rem;",
	"border:1px solid var(--line)}",
	"figcaption{padding:.25rem .2rem}",
	".scroll{overflow-x:auto}",
	".scroll+.plots,details+.plots{margin-top:.8rem}",
	"table{border-collapse:collapse;width:100%;font-size:.9rem;font-variant-numeric:tabular-nums}",
	"th{text-align:left;color:var(--soft);font-weight:600;font-size:.8rem;white-space:nowrap}",
	"th,td{padding:.3rem .7rem .3rem 0;border-bottom:1px solid var(--line);vertical-align:top}",
	"td.n,th.n{text-align:right;white-space:nowrap}",
	"td.ok,td.off{text-align:center;font-weight:600;padding:.3rem .5rem}",
	"td.bar{width:32%;min-width:6rem}",
	".bar i{display:block;height:.75rem;border-radius:.2rem;background:var(--p1);min-width:1px;",
	"margin-top:.3rem}",
	".bar i.minus{background:var(--p2)}",
	".stack{display:flex;height:1.6rem;border-radius:.4rem;overflow:hidden;margin:.5rem 0}",
	".stack i{display:block}",
	".key{display:flex;flex-wrap:wrap;gap:.2rem 1.1rem;font-size:.86rem}",
	".key i{display:inline-block;width:.75rem;height:.75rem;border-radius:.2rem;margin-right:.35rem}",
	".q0{background:var(--p1)}",
	".q1{background:var(--p2)}",
	".q2{background:var(--p3)}",
	".q3{background:var(--p4)}",
	".q4{background:var(--p5)}",
	".q5{background:var(--p6)}",
	".q6{background:var(--soft)}",
	"details{background:var(--card);border:1px solid var(--line);border-radius:.6rem;margin:.6rem 0}",
	"summary{cursor:pointer;padding:.5rem .9rem;font-weight:600;overflow-wrap:anywhere}",
	"details>div{padding:0 .9rem .7rem;overflow-x:auto}",
	"pre{font:.8rem/1.5 ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace;margin:0;tab-size:8}",
	"pre.wrap{white-space:pre-wrap;overflow-wrap:anywhere}",
	"pre.code{counter-reset:l}",
	"pre.code b{font-weight:inherit;display:inline-block;min-width:100%}",
	"pre.code b::before{counter-increment:l;content:counter(l);display:inline-block;width:2.8em;",
	"margin-right:1em;text-align:right;color:var(--soft);opacity:.7}",
	"pre.code i{color:var(--soft)}",
	"pre.code b.bad{background:var(--offground)}",
	"ul{margin:.3rem 0;padding-left:1.2rem}",
	"li{overflow-wrap:anywhere}",
	"footer{padding-top:2rem;padding-bottom:2rem;color:var(--soft);font-size:.8rem}",
	"@media(max-width:40rem){",
	"h1{font-size:1.35rem}",
	"header,main,footer{padding-left:.8rem;padding-right:.8rem}",
	".tiles{grid-template-columns:repeat(2,1fr)}",
	"}",
	"@media print{",
	":root{--ground:#fff;--card:#fff;--ink:#000;--soft:#555;--line:#bbb;--accent:#000;--ok:#18794e;",
	"--off:#b3261e}",
	"nav{display:none}",
	"body{font-size:10.5pt}",
	".card,figure,.tile,tr{break-inside:avoid}",
	"h2,p.soft{break-after:avoid}",
	"img{filter:none}",
	"details::details-content{content-visibility:visible;height:auto}",
	".badge,.stack,.bar i,.key i,td{-webkit-print-color-adjust:exact;print-color-adjust:exact}",
	"pre{white-space:pre-wrap}",
	"}",
};

/* Bars have the colours of curves: --p1, --p2 ... */
static void add_colours(struct ts_str *out, bool dark)
{
	ts_str_add(out, ":root{");
	for (size_t k = 0; k < TS_PLOT_COLOURS; k++)
		ts_str_addf(out, "--p%zu:#%06x;", k + 1, ts_plot_colour(k, dark));
	ts_str_add(out, "}");
}

void ts_page_style(struct ts_str *out)
{
	add_colours(out, false);
	ts_str_add(out, "\n@media screen and (prefers-color-scheme:dark){");
	add_colours(out, true);
	ts_str_add(out, "}\n");
	for (size_t k = 0; k < sizeof rules / sizeof *rules; k++)
		ts_str_addf(out, "%s\n", rules[k]);
}
