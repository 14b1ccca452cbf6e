"""Small changes to the source of a checker, each of which should let something false pass.

A guard is deleted, a test negated, one of several conditions dropped, a bound widened, a table of
signs changed, a loop ended after its first turn, success returned at once. A mutant is applied to
the functions in memory; no file is touched.
"""

from __future__ import annotations

import ast
import hashlib
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import CodeType
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
SIGNS = ("+", "-", "0", ">=0", "<=0")
WIDER: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
}
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


class Mutant(NamedTuple):
    """A change of one place of a function or table: which node of it, what is done, and where."""

    file: str
    piece: str
    node: int
    kind: str
    part: Any
    line: int
    was: str

    @property
    def key(self) -> str:
        """Stays the same while the function does."""
        text = ast.unparse(_pieces(_tree(self.file))[self.piece])
        parts = (self.file, self.piece, text, self.node, self.kind, self.part)
        return hashlib.sha1(repr(parts).encode()).hexdigest()[:16]


def mutants(file: str) -> list[Mutant]:
    """All mutants of a file, in the order of its lines."""
    found = []
    for piece, top in _pieces(_tree(file)).items():
        nodes = enumerate(ast.walk(top))
        for n, node in nodes:
            for kind, part, shown in _changes(node, isinstance(top, FUNCTIONS)):
                line = getattr(shown, "lineno", getattr(top, "lineno", 0))
                found.append(Mutant(file, piece, n, kind, part, line, _short(shown)))
    return sorted(found, key=lambda m: (m.line, m.kind, str(m.part)))


def _short(node: ast.AST) -> str:
    if isinstance(node, FUNCTIONS):
        return f"def {node.name}"
    return ast.unparse(node.test if isinstance(node, ast.If) else node).split("\n")[0][:120]


@cache
def _tree(file: str) -> ast.Module:
    return ast.parse((ROOT / file).read_text(encoding="utf-8"))


def _pieces(tree: ast.Module) -> dict[str, ast.AST]:
    """Functions and methods by qualified name, and the tables of signs at the top of the file."""
    found: dict[str, ast.AST] = {}
    for node in tree.body:
        if isinstance(node, FUNCTIONS):
            found[node.name] = node
        elif isinstance(node, ast.ClassDef):
            methods = (m for m in node.body if isinstance(m, FUNCTIONS))
            found |= {f"{node.name}.{m.name}": m for m in methods}
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found[node.targets[0].id] = node.value
    return found


def _changes(node: ast.AST, inside: bool) -> Iterator[tuple[str, Any, ast.AST]]:
    """What can be done to one node: kind, which part of it, and what to show."""
    if isinstance(node, ast.Tuple | ast.List | ast.Set) and len(node.elts) < 6:
        values = [getattr(e, "value", None) for e in node.elts]
        if values and all(v in SIGNS for v in values):
            yield from (("sign added", s, node) for s in SIGNS if s not in values)
            yield from (("sign dropped", k, node) for k in range(len(values)))
    if not inside:
        return
    if isinstance(node, ast.If | ast.IfExp):
        yield "negated", None, node
        if isinstance(node, ast.If) and not node.orelse and _refuses(node.body[-1]):
            yield "guard deleted", None, node
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield "negated", None, node
    if isinstance(node, ast.BoolOp):
        yield from (("dropped", k, value) for k, value in enumerate(node.values))
    if isinstance(node, ast.comprehension):
        yield from (("filter dropped", k, test) for k, test in enumerate(node.ifs))
    if isinstance(node, ast.match_case) and node.guard is not None:
        yield "case guard dropped", None, node.guard
    if isinstance(node, ast.Compare):
        yield from (("bound", k, node) for k, op in enumerate(node.ops) if type(op) in WIDER)
        for k, value in enumerate(node.comparators):
            if isinstance(value, ast.Constant) and type(value.value) is int:
                yield from (("constant", (k, step), node) for step in (1, -1))
    if isinstance(node, ast.Call) and ast.unparse(node.func) in ("all", "any"):
        yield "all or any", None, node
    if isinstance(node, ast.For):
        yield "first turn only", None, node.iter
    if isinstance(node, FUNCTIONS) and node.returns is not None:
        text = ast.unparse(node.returns)
        if text == "bool":
            yield from (("returned at once", value, node) for value in (True, False))
        elif text.endswith("| None"):
            yield "returned at once", None, node


def _refuses(last: ast.stmt) -> bool:
    """Whether a branch ends by refusing: an error, None, False, a sentence, UNDECIDED."""
    if isinstance(last, ast.Return):
        value = last.value
        plain = value is None or isinstance(value, ast.JoinedStr)
        words = isinstance(value, ast.Constant) and value.value is not True
        return plain or words or "UNDECIDED" in ast.unparse(value)
    return isinstance(last, ast.Raise | ast.Continue | ast.Break)


def apply(mutant: Mutant) -> None:
    """Change the function or the table in this process, wherever it has been imported."""
    tree = ast.parse((ROOT / mutant.file).read_text(encoding="utf-8"))
    top = _pieces(tree)[mutant.piece]
    _change(list(ast.walk(top))[mutant.node], mutant.kind, mutant.part)
    code = compile(ast.fix_missing_locations(tree), str(ROOT / mutant.file), "exec")
    name = mutant.file.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    live: Any = sys.modules[name]
    if isinstance(top, FUNCTIONS):
        for part in mutant.piece.split("."):
            live = vars(live)[part]
            code = next(c for c in code.co_consts if isinstance(c, CodeType) and c.co_name == part)
        for inner in ("__func__", "fget", "func", "__wrapped__"):
            live = getattr(live, inner, None) or live
        live.__code__ = code
        return
    old = vars(live)[mutant.piece]
    fresh = dict(vars(live))
    assert isinstance(top, ast.expr)
    new = eval(compile(ast.fix_missing_locations(ast.Expression(top)), name, "eval"), fresh)
    for module in [m for n, m in sys.modules.items() if n.startswith("tresym")]:
        vars(module).update({k: new for k, v in vars(module).items() if v is old})


def _change(node: Any, kind: str, part: Any) -> None:
    match kind:
        case "negated" if isinstance(node, ast.UnaryOp):
            node.operand = ast.UnaryOp(ast.Not(), node.operand)
        case "negated":
            node.test = ast.UnaryOp(ast.Not(), node.test)
        case "guard deleted":
            node.test = ast.Constant(False)
        case "dropped":
            node.values[part] = ast.Constant(isinstance(node.op, ast.And))
        case "filter dropped":
            node.ifs[part] = ast.Constant(True)
        case "case guard dropped":
            node.guard = ast.Constant(True)
        case "bound":
            node.ops[part] = WIDER[type(node.ops[part])]()
        case "constant":
            node.comparators[part[0]] = ast.Constant(node.comparators[part[0]].value + part[1])
        case "all or any":
            node.func = ast.Name("any" if node.func.id == "all" else "all", ast.Load())
        case "first turn only":
            node.body.append(ast.Break())
        case "returned at once":
            node.body.insert(0, ast.Return(ast.Constant(part)))
        case "sign added":
            node.elts.append(ast.Constant(part))
        case "sign dropped":
            del node.elts[part]
