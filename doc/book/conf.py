"""The book: doc/*.md and doc/styles/*.md as HTML and PDF, by Sphinx with MyST. `make book` runs it.

The pages are Markdown that is read as it is, too. What a book has beyond that is made here, before Sphinx
reads a page: the contents from the lists of doc/index.md and doc/styles/index.md, links to pages and styles that
the text names, entries of the index, formulas (```math, and $`...`$ in a line). HTML has formulas as MathML, made by
pandoc, which browsers typeset themselves; nothing is fetched from the network.
"""
import gc
import json
import os
import re
import shutil
import subprocess

from docutils import nodes
from sphinx import addnodes
from sphinx.environment.adapters.toctree import TocTree
from sphinx.util import logging

logger = logging.getLogger(__name__)

# Trees of hundreds of pages are kept: looking through them for cycles again and again takes a third of the time.
gc.set_threshold(1000000, 50, 1000)

project = "tsim"
author = "the tsim authors"
copyright = "the tsim authors; GNU General Public License, version 3 or later"
release = version = os.environ.get("TSIM_VERSION", "")
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
exclude_patterns = ["book/*", "charts/*", "figures/*"]
myst_heading_anchors = 4
# A heading may follow one that is two levels higher; footnotes are not used.
suppress_warnings = ["myst.header"]
nitpicky = True
highlight_language = "none"

html_theme = "alabaster"
html_title = "tsim " + release
html_static_path = ["static"]
html_css_files = ["book.css"]
html_js_files = ["book.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_theme_options = {"description": "grains, bonds, fluids, friction, wear and fracture", "fixed_sidebar": True,
                      "page_width": "84rem", "sidebar_width": "17rem", "show_powered_by": False,
                      "font_family": "system-ui, sans-serif", "head_font_family": "system-ui, sans-serif"}
pygments_style = "default"


def fonts():
    """DejaVu has all letters and signs of the pages; without it some signs are missing in the PDF."""
    try:
        known = subprocess.run(["fc-list", ":", "family"], capture_output=True, text=True, check=False).stdout
    except OSError:
        known = ""
    if "DejaVu Serif" not in known or "DejaVu Sans Mono" not in known:
        return ""
    return (r"\setmainfont[Scale=0.92]{DejaVu Serif}\setsansfont[Scale=0.92]{DejaVu Sans}"
            r"\setmonofont[Scale=0.85]{DejaVu Sans Mono}")


def braille():
    """Curves of `tsim -plot` on the terminal: DejaVu Sans has these signs, the font of equal widths has not."""
    if not fonts():
        return ""
    signs = "".join(rf"\newunicodechar{{{chr(n)}}}{{\braille{{{n:04X}}}}}" for n in range(0x2800, 0x2900))
    return (r"\usepackage{newunicodechar}\newfontfamily\braillefont[Scale=0.7]{DejaVu Sans}\newlength\braillewidth"
            r"\newcommand\braille[1]{\settowidth\braillewidth{0}\hbox to\braillewidth{\hss\braillefont\char"
            '"#1'
            r"\hss}}" + signs)


latex_engine = "xelatex"
latex_use_xindy = False
latex_table_style = ["booktabs", "colorrows"]
latex_documents = [("index", "tsim.tex", "tsim: the book", author.replace("&", "and"), "manual")]
latex_show_urls = "no"
latex_elements = {
    "papersize": "a4paper", "pointsize": "10pt", "figure_align": "H", "extraclassoptions": "openany,oneside",
    "fontpkg": fonts(), "sphinxsetup": "hmargin={2cm,2cm}, vmargin={2.3cm,2.3cm}",
    "preamble": r"\setcounter{tocdepth}{1}\sloppy\usepackage{enumitem}\setlistdepth{9}\renewlist{itemize}{itemize}{9}"
                r"\setlist[itemize]{label=\textbullet}\makeatletter\renewcommand\@pnumwidth{2.2em}\makeatother"
                # long words of scripts may be broken behind | and _
                r"\renewcommand\sphinxbreaksafteractivelist{\do\.\do\,\do\;\do\?\do\!\do\/\do\|}"
                r"\AtBeginDocument{\let\wholeunderscore\_\protected\def\_{\wholeunderscore\discretionary{}{}{}}}"
                + braille(),
}

# ---- contents, links and index: the text before Sphinx reads it

KINDS = "command|fix|pair|bond|compute|region|dump|flow|pressure|automaton"
ITEM = re.compile(r"^\s*[-*] \[([^\]]+)\]\(([A-Za-z0-9_/.-]+)\.md\)")


def contents(text):
    """Behind each list of pages under a heading, the same list for the contents of the book."""
    out, pages, caption = [], [], ""

    def close():
        if pages:
            listed = "\n".join(f"{name} <{page}>" for name, page in pages)
            out.append(f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n:maxdepth: 1\n\n{listed}\n```\n")
        pages.clear()

    for line in text.split("\n"):
        if line.startswith("## "):
            close()
            caption = line[3:]
        item = ITEM.match(line)
        if item:
            pages.append((item.group(1), item.group(2)))
        out.append(line)
    close()
    return "\n".join(out)


class Names:
    """Styles by name, and pages of doc/, as links from a page in `folder`."""

    def __init__(self, source):
        self.styles, self.titles = {}, {}
        for page in sorted(os.listdir(os.path.join(source, "styles"))):
            with open(os.path.join(source, "styles", page), encoding="utf-8") as file:
                words = file.readline().lstrip("# ").split()
            if len(words) == 2 and page.startswith(words[0] + "_"):
                self.styles[" ".join(words)] = page
        for page in sorted(os.listdir(source)):
            if page.endswith(".md"):
                with open(os.path.join(source, page), encoding="utf-8") as file:
                    self.titles[page] = file.readline().lstrip("# ").strip()
        names = "|".join(re.escape(n) for n in sorted(self.styles, key=len, reverse=True))
        self.style = re.compile(r"(?<![\w/`\[])(`?)(%s)(`?)(?![\w/*\]])" % names)
        self.page = re.compile(r"(?<![\w/\[])(`?)doc/([\w-]+\.md)(`?)(?![\w/])")

    def linked(self, line, folder, own):
        def style(match):
            page = self.styles[match.group(2)]
            if page == own or match.group(1) != match.group(3):
                return match.group(0)
            return f"[{match.group(2)}]({'' if folder else 'styles/'}{page})"

        def page(match):
            name = match.group(2)
            if name not in self.titles or match.group(1) != match.group(3) or name == own:
                return match.group(0)
            return f"[{self.titles[name]}]({'../' if folder else ''}{name})"

        # parts that are code or links already stay as they are
        parts = re.split(r"(\[[^\]]*\]\([^)]*\)|``[^`]+``|`[^`]+`)", line)
        for k, part in enumerate(parts):
            named = re.fullmatch(r"\[([\w-]+\.md)\]\((\1(?:#[\w-]*)?)\)", part)
            if named and named.group(1) in self.titles:  # a link is shown by the title of its page
                parts[k] = f"[{self.titles[named.group(1)]}]({named.group(2)})"
            elif k % 2 == 0:
                parts[k] = self.style.sub(style, self.page.sub(page, part))
            elif re.fullmatch(r"`doc/[\w-]+\.md`", part):
                parts[k] = self.page.sub(page, part)
            elif part.strip("`") in self.styles:
                parts[k] = self.style.sub(style, part)
        return "".join(parts)


# headings that each page of a model has
PARTS = {"Equations", "Assumptions", "Order", "Limits", "Cost", "Sources", "Source"}


def index_entries(text, name):
    """A style is found by its name, a page by its headings, a term of the glossary by itself."""
    if name.startswith("styles/") and name != "styles/index":
        kind, _, style = text.split("\n", 1)[0].lstrip("# ").partition(" ")
        words = [f"single: {style} ({kind})", f"single: {kind}; {style}"] if style else []
    elif name == "glossary":
        words = [f"single: {term.strip()}" for term in re.findall(r"^\*\*([^*]+)\*\*", text, re.M)]
    else:
        block = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
        titles = [re.sub(r"^(A|An|The) (?=\w)", "", title) for title in re.findall(r"^#+ (.+)$", block, re.M)]
        words = [f"single: {title}" for title in titles if title not in PARTS]
    words = [w.replace("`", "") for w in words]
    return "".join(f"```{{index}} {w}\n```\n" for w in words)


def before_reading(app, name, source):
    text = source[0]
    folder, own = os.path.dirname(name), os.path.basename(name) + ".md"
    out, fence = [], None
    for line in text.split("\n"):
        mark = re.match(r"\s*(```+)(\w*)", line)
        if mark:
            if fence is None:
                fence = mark.group(2)
                line = line.replace("```math", "```{math}")
            else:
                fence = None
        elif fence is None and not line.startswith("    ") and not line.startswith("#"):
            line = re.sub(r"\$`([^`]+)`\$", r"{math}`\1`", line)
            line = app.names.linked(line, folder, own)
            line = re.sub(r"^(\s*)%", r"\1\\%", line)  # MyST takes such a line for a comment
        out.append(line)
    text = "\n".join(out)
    entries = index_entries(source[0], name)
    if name.endswith("index"):
        text = contents(text)
    head, _, rest = text.partition("\n")
    source[0] = head + "\n\n" + entries + rest


# ---- formulas

def pandoc(text):
    done = subprocess.run(["pandoc", "-f", "markdown", "-t", "html", "--mathml"], input=text, text=True,
                          capture_output=True, check=True)
    return done.stdout, done.stderr.strip()


def source_of(tex, display):
    return f"$${tex}$$" if display else f"${tex}$"


def mathml(tex, display):
    key = (tex, display)
    if key not in mathml.known:
        made, message = pandoc(source_of(tex, display))
        if message:
            logger.warning("formula %s: %s", tex, message)
        mathml.known[key] = re.sub(r"^<p>|</p>$", "", made.strip())
    return mathml.known[key]


mathml.known = {}


def formulas_of_page(app, tree, name):
    """All formulas of a page by one run of pandoc, a paragraph each; what it complains of is made one by one."""
    if app.builder.format != "html":
        return
    keys = [(node.astext(), isinstance(node, nodes.math_block)) for node in tree.findall()
            if isinstance(node, (nodes.math, nodes.math_block))]
    keys = [key for key in dict.fromkeys(keys) if key not in mathml.known]
    made, message = pandoc("\n\n".join(source_of(*key) for key in keys)) if keys else ("", "")
    parts = re.findall(r"<p>(.*?)</p>", made, re.S)
    if len(parts) == len(keys) and not message:
        mathml.known.update(zip(keys, parts))


def visit_inline(self, node):
    self.body.append(mathml(node.astext(), False))
    raise nodes.SkipNode


def visit_display(self, node):
    self.body.append(f'<div class="formula">{mathml(node.astext(), True)}</div>\n')
    raise nodes.SkipNode


# ---- pictures of the PDF: drawings as pixels, where there is a program for it

def pictures_for_latex(app, tree):
    if app.builder.format != "latex":
        return
    for image in list(tree.findall(nodes.image)):
        uri = image["uri"]
        if not uri.endswith(".svg"):
            continue
        path = os.path.join(app.srcdir, uri)
        if os.path.exists(path[:-4] + ".png"):
            image["uri"] = uri[:-4] + ".png"
        else:
            name = os.path.join("pixels", os.path.basename(uri)[:-4] + ".png")
            target = os.path.join(app.outdir, name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            for program in (["rsvg-convert", "-z", "2", "-o", target, path], ["convert", "-density", "150", path, target]):
                if shutil.which(program[0]) and subprocess.run(program, capture_output=True).returncode == 0:
                    break
            else:
                image.replace_self(nodes.emphasis(text="(drawing: see the HTML of this page)"))
                continue
            image["uri"] = name  # LaTeX runs in app.outdir
        image["candidates"] = {"*": image["uri"]}


# ---- tables of the PDF: columns as wide as their texts need, in a type that is small enough for the page

TYPES = [("", 84), (r"\footnotesize", 104), (r"\scriptsize", 120)]  # letters in a line
GAP = 2  # letters between two columns


def letters(text):
    """How many small letters are as wide."""
    return len(text) + 0.4 * sum(c.isupper() for c in text)


def widths(table):
    """Of each column the longest text, and the longest part that is not broken, both in letters."""
    columns = len(list(table.findall(nodes.colspec)))
    whole, word = [1] * columns, [1] * columns
    for row in table.findall(nodes.row):
        for k, entry in enumerate(row.children[:columns]):
            text = entry.astext()
            breaks = r"[\s_/|.,]" if entry.next_node(nodes.literal) else r"[\s_-]"
            parts = re.split(breaks, text) + [node.astext()[:len(node.astext()) * 2 // 3] for node in entry.findall(nodes.math)]
            whole[k] = max(whole[k], letters(text))
            word[k] = max(word[k], *(letters(part) + 1 for part in parts))
    return whole, word


def layout(table):
    """The type, and what LaTeX is to know of the columns."""
    whole, word = widths(table)
    gaps = GAP * len(whole)
    for size, line in TYPES[:2]:
        if sum(whole) + gaps <= line:
            return size, "l" * len(whole)
    for size, line in TYPES[len(whole) > 3:]:
        if sum(word) + gaps <= line:
            break
    spare = max(line - gaps - sum(word), 0)
    wanted = [a - b if a > b else 0 for a, b in zip(whole, word)]
    # a column of long texts does not take all from those of short ones
    wanted = [w ** 0.6 for w in wanted]
    share = [b + spare * w / max(sum(wanted), 1) for b, w in zip(word, wanted)]
    share = [min(s, a + 1) for s, a in zip(share, whole)]
    room = max(sum(share) + gaps, line) * 1.04
    return size, "".join(rf">{{\raggedright\arraybackslash}}p{{{s / room:.4f}\linewidth}}" for s in share)


def tables_for_latex(app, tree, name):
    if app.builder.format != "latex":
        return
    for table in list(tree.findall(nodes.table)):
        size, columns = layout(table)
        if len(list(table.findall(nodes.row))) > 12:
            table["classes"].append("longtable")
        around = table.parent, table.parent.index(table)
        around[0].insert(around[1] + 1, nodes.raw("", r"\endgroup", format="latex"))
        around[0].insert(around[1], [
            nodes.raw("", rf"\begingroup{size}\setlength{{\tabcolsep}}{{{GAP * 2}pt}}", format="latex"),
            addnodes.tabular_col_spec(spec=columns)])


# ---- excerpts of the search in a book that is opened as a file: browsers do not let it fetch its pages (static/book.js)

def texts_for_search(app, failed):
    if app.builder.format != "html" or failed:
        return
    texts = {name: re.sub(r"\s+", " ", app.env.get_doctree(name).astext()) for name in sorted(app.env.found_docs)}
    with open(os.path.join(app.outdir, "searchtexts.js"), "w", encoding="utf-8") as out:
        out.write("window.searchTexts = " + json.dumps(texts, ensure_ascii=False, indent=0) + ";\n")


# ---- navigation

def title_only(toc):
    toc = toc.deepcopy()
    for item in toc.children:
        if isinstance(item, nodes.list_item):
            del item[1:]
    return toc


def way_only(toc, pages):
    toc = toc.deepcopy()
    for tree in toc.findall(addnodes.toctree):
        tree["entries"] = [entry for entry in tree["entries"] if entry[1] in pages]
        tree["includefiles"] = [name for name in tree["includefiles"] if name in pages]
    return toc


def quick_navigation(app, page, template, context, doctree):
    """The list of pages beside each page shows the titles of those in the list of the book, and marks the one that leads here.
    Sphinx copies what each of these pages contains, and the pages of their lists, before it leaves that out, which is most of
    the time of a book with hundreds of pages: here it gets titles to copy, and the way to this page."""
    render = context.get("toctree")
    if not render:
        return
    if not hasattr(app, "page_titles"):
        app.page_titles = {name: title_only(toc) for name, toc in app.env.tocs.items()}

    def toctree(**words):
        whole = app.env.tocs
        if words.get("collapse"):
            above = TocTree(app.env).get_toctree_ancestors(page)
            way = {name: way_only(whole[name], above) for name in above if name != app.config.root_doc}
            app.env.tocs = {**app.page_titles, **way, app.config.root_doc: whole[app.config.root_doc]}
        try:
            return render(**words)
        finally:
            app.env.tocs = whole

    context["toctree"] = toctree


def setup(app):
    app.names = Names(app.srcdir)
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_display, None))
    app.connect("source-read", before_reading)
    app.connect("doctree-read", pictures_for_latex)
    app.connect("doctree-resolved", tables_for_latex)
    app.connect("doctree-resolved", formulas_of_page)
    app.connect("html-page-context", quick_navigation)
    app.connect("build-finished", texts_for_search)


html_math_renderer = "mathml"
