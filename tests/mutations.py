"""Small changes to the source of a checker, each of which may let something false pass.

A guard or a need is deleted, a test negated, one of several conditions dropped, a bound widened, a
sign allowed, a loop of guards ended after its first turn, success returned at once. Where a change
has two ways, it is made the way that lets more pass. A mutant is applied to the functions in
memory; no file is touched.
"""

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
        leaning, table = _leanings(top), not isinstance(top, ast.FunctionDef)
        for n, node in enumerate(ast.walk(top)):
            for kind, part, shown in _signs(node, node) if table else _changes(node, leaning):
                line = getattr(shown, "lineno", getattr(top, "lineno", 0))
                found.append(Mutant(file, piece, n, kind, part, line, _short(shown)))
    return sorted(found, key=lambda m: (m.line, m.kind, str(m.part)))


def _short(node: ast.AST) -> str:
    if isinstance(node, ast.FunctionDef):
        return f"def {node.name}"
    return ast.unparse(node.test if isinstance(node, ast.If) else node).split("\n")[0][:120]


@cache
def _tree(file: str) -> ast.Module:
    return ast.parse((ROOT / file).read_text(encoding="utf-8"))


def _pieces(tree: ast.Module) -> dict[str, ast.AST]:
    """Functions and methods by qualified name, and the tables of signs at the top of the file."""
    found: dict[str, ast.AST] = {}
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            found[node.name] = node
        elif isinstance(node, ast.ClassDef):
            methods = (m for m in node.body if isinstance(m, ast.FunctionDef))
            found |= {f"{node.name}.{m.name}": m for m in methods}
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found[node.targets[0].id] = node.value
    return found


def _changes(node: Any, leaning: dict[int, int]) -> Iterator[tuple[str, Any, ast.AST]]:
    """What can be done to one node of a function: kind, which part of it, and what to show.

    Args:
        leaning: 1 for an expression whose truth lets something pass, -1 where it refuses.
    """
    way = leaning.get(id(node), 0)
    match node:
        case ast.If() | ast.IfExp():
            yield "negated", None, node
            if isinstance(node, ast.If) and not node.orelse and leaning[id(node.test)] < 0:
                yield "guard deleted", None, node
        case ast.BoolOp() if way == (1 if isinstance(node.op, ast.And) else -1):
            yield from (("dropped", k, value) for k, value in enumerate(node.values))
        case ast.comprehension():
            tests = enumerate(node.ifs)
            yield from (("filter dropped", k, t) for k, t in tests if leaning.get(id(t), 1) > 0)
        case ast.match_case() if node.guard is not None:
            yield "case guard dropped", None, node.guard
        case ast.Compare() if way:
            yield from _widened(node, way)
        case ast.Call() if ast.unparse(node.func) == ("any" if way < 0 else "all") and way:
            yield "all or any", None, node
        case ast.For() if any(isinstance(n, ast.stmt) and _refuses(n) for n in ast.walk(node)):
            yield "first turn only", None, node.iter
        case ast.Expr(ast.Call(ast.Name(name), [first, *_])) if name in ("need", "_need"):
            yield "need dropped", None, first
        case ast.FunctionDef() if node.returns is not None:
            returns = ast.unparse(node.returns)
            if returns == "bool" or returns.endswith("| None"):
                yield "returned at once", returns == "bool" or None, node


def _widened(node: ast.Compare, way: int) -> Iterator[tuple[str, Any, ast.AST]]:
    """A comparison that lets more pass: its bound included, moved by one, a sign allowed."""
    for k, (op, value) in enumerate(zip(node.ops, node.comparators, strict=True)):
        up = way * (1 if isinstance(op, ast.Lt | ast.LtE) else -1)
        if isinstance(op, (ast.Lt, ast.Gt) if way > 0 else (ast.LtE, ast.GtE)):
            yield "bound", k, node
        if isinstance(value, ast.Constant) and type(value.value) is int and type(op) in WIDER:
            yield "constant", (k, up), node
        if isinstance(op, ast.In | ast.NotIn) and isinstance(value, ast.Tuple):
            more = isinstance(op, ast.In) == (way > 0)
            yield from ((k, p, n) for k, p, n in _signs(value, node) if (k == "sign added") == more)


def _signs(node: ast.AST, shown: ast.AST) -> Iterator[tuple[str, Any, ast.AST]]:
    """Signs to add to a table of signs, or to drop from it."""
    if isinstance(node, ast.Tuple):
        values = [getattr(e, "value", None) for e in node.elts]
        if values and all(v in SIGNS for v in values):
            yield from (("sign added", s, shown) for s in SIGNS if s not in values)
            yield from (("sign dropped", k, shown) for k in range(len(values)))


def _leanings(top: ast.AST) -> dict[int, int]:
    """For each truth value in a function: 1 where it lets something pass, -1 where it refuses."""
    found: dict[int, int] = {}

    def mark(node: ast.AST, way: int) -> None:
        found[id(node)] = way
        match node:
            case ast.UnaryOp(op=ast.Not()):
                mark(node.operand, -way)
            case ast.BoolOp():
                for value in node.values:
                    mark(value, way)
            case ast.Call(args=[ast.GeneratorExp() as inner]):
                name = ast.unparse(node.func)
                if name in ("all", "any", "bool"):
                    mark(inner.elt, way)
                    for test in inner.generators[0].ifs:
                        mark(test, way if name == "any" else -way)
            case ast.Call(args=[inner]) if ast.unparse(node.func) == "bool":
                mark(inner, way)

    for node in ast.walk(top):
        match node:
            case ast.If():
                mark(node.test, -1 if _refuses(node.body[-1]) else 1)
            case ast.IfExp():
                mark(node.test, -1 if ast.unparse(node.body) in ("None", "False") else 1)
            case ast.Return(value=ast.BoolOp() | ast.Compare() | ast.Call() | ast.UnaryOp()):
                mark(node.value, 1)
    return found


def _refuses(last: ast.stmt) -> bool:
    """Whether a branch ends by refusing: an error, None, False, a name, a sentence, UNDECIDED."""
    if isinstance(last, ast.Return):
        plain = isinstance(last.value, ast.JoinedStr | ast.Name | ast.Constant | None)
        text = "" if last.value is None else ast.unparse(last.value)
        return (plain and text != "True") or "UNDECIDED" in text
    return isinstance(last, ast.Raise | ast.Continue | ast.Break)


def apply(mutant: Mutant) -> None:
    """Change the function or the table in this process, wherever it has been imported."""
    tree = ast.parse((ROOT / mutant.file).read_text(encoding="utf-8"))
    top = _pieces(tree)[mutant.piece]
    _change(list(ast.walk(top))[mutant.node], mutant.kind, mutant.part)
    code = compile(ast.fix_missing_locations(tree), str(ROOT / mutant.file), "exec")
    name = mutant.file.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    live: Any = sys.modules[name]
    if isinstance(top, ast.FunctionDef):
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
    for module in [live, *(m for n, m in sys.modules.items() if n.startswith("tresym"))]:
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
        case "need dropped":
            node.value = ast.Constant(None)
        case "first turn only":
            node.body.append(ast.Break())
        case "returned at once":
            node.body.insert(0, ast.Return(ast.Constant(part)))
        case "sign added":
            node.elts.append(ast.Constant(part))
        case "sign dropped":
            del node.elts[part]
