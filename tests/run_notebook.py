"""Runs the code cells of a notebook one after another, as Jupyter does, without Jupyter; run by tests/library/python.sh.

The last expression of a cell is shown: its picture must be a PNG, its table HTML. Prints each cell that fails."""
import ast
import json
import sys
import traceback


def shown(value):
    """What a notebook would display, checked."""
    if hasattr(value, "_repr_png_"):
        assert value._repr_png_()[:4] == b"\x89PNG"
    if hasattr(value, "_repr_html_"):
        assert "<" in (value._repr_html_() or "<") or "&lt;" in value._repr_html_()
    return repr(value)


def run(source, names):
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is not None:
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
        if value is not None:
            print(shown(value))


with open(sys.argv[1]) as file:
    notebook = json.load(file)
assert notebook["nbformat"] == 4
names, passed, failed = {"__name__": "__main__"}, 0, 0
for cell in notebook["cells"]:
    if cell["cell_type"] != "code":
        continue
    assert not cell["outputs"], "outputs are not kept in the notebook"
    try:
        run("".join(cell["source"]), names)
        passed += 1
    except Exception:
        traceback.print_exc()
        failed += 1
print("%d passed, %d failed" % (passed, failed))
sys.exit(failed != 0)
