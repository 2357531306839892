"""Long kernels in parts: the same statements, each once, with the values that cross from one part to another."""

import random
import re

import pytest
from eigenmotion.codegen.kernel import parts

ARGUMENTS = {"x": "const real *restrict x", "c": "const real *restrict c", "out": "real out[40]"}


def straight_line(seed, count):
    """A random kernel: reads of arguments, values of earlier ones, outputs."""
    chance = random.Random(seed)
    known, statements = [], []
    for k in range(count):
        if chance.random() < 0.1 or not known:
            array = chance.choice("xc")
            statements.append(f"const real {array}_{k} = {array}[{chance.randrange(9)}];")
            known.append(f"{array}_{k}")
            continue
        reach = known[-12:] if chance.random() < 0.9 else known
        a, b = chance.choice(reach), chance.choice(reach)
        statements.append(f"const real z_{k} = {a}*0.5 + {b} /* x[{k}], z_0 */ - 1e-3;")
        known.append(f"z_{k}")
        if chance.random() < 0.05:
            statements.append(f"out[{chance.randrange(40)}] = out[{chance.randrange(40)}] = {known[-1]};")
    return [*statements, f"out[0] = {known[-1]};"]


def run(statements, values):
    for statement in statements:
        text = re.sub(r"/\*.*?\*/", "", statement).removeprefix("const real ").removesuffix(";")
        exec(text, {}, values)


@pytest.mark.parametrize("seed", range(30))
def test_parts_compute_what_the_whole_does(seed):
    statements = straight_line(seed, random.Random(seed).randrange(500, 2500))
    functions, calls = parts.cut("f", "real", statements, ARGUMENTS)
    chance = random.Random(seed)
    x, c = ([chance.uniform(-1, 1) for _ in range(9)] for _ in "xc")
    whole, kept, out = [0.0] * 40, [float("nan")] * len(statements), [0.0] * 40
    run(statements, {"x": x, "c": c, "out": whole})
    assert len(calls) == len(functions) + 1
    for function, call in zip(functions, calls[1:], strict=True):
        arguments = dict(zip(re.findall(r"(\w+)(?=[\[,)])", function.head.partition("(")[2]), ("x", "c"), strict=False))
        given = call.partition("(")[2]
        names = {one for one in ("x", "c", "out") if re.search(rf"\b{one}\b", given)}
        assert arguments
        run(function.statements, {"kept": kept} | {k: v for k, v in (("x", x), ("c", c), ("out", out)) if k in names})
        assert len(function.statements) <= 2 * parts.CUT
    assert out == whole
    computed = [line for function in functions for line in function.statements if line.startswith("const real z")]
    assert sorted(line for line in computed if "kept" not in line) == sorted(
        line for line in statements if line.startswith("const real z")
    )


def test_a_short_kernel_stays_whole():
    statements = straight_line(1, parts.CUT // 2)
    assert parts.cut("f", "real", statements, ARGUMENTS) == ((), tuple(statements))


def test_cuts_are_where_few_values_are_alive():
    """A kernel of independent groups is cut between them: nothing crosses but what the last statement takes."""
    group = 230
    statements = []
    for k in range(8):
        statements += [f"const real x_{k} = x[{k}];", f"const real z_{k}_0 = x_{k} + 1.0;"]
        statements += [f"const real z_{k}_{j} = z_{k}_{j - 1}*1.01;" for j in range(1, group - 2)]
        statements.append(f"out[{k}] = z_{k}_{group - 3};")
    functions, calls = parts.cut("f", "real", statements, ARGUMENTS)
    assert len(functions) > 3
    assert calls[0] == "real kept[1];"


def test_names_as_long_as_a_line_are_known():
    statements = straight_line(5, 600)
    long = "z" * 150
    told = [
        line.replace("z_", f"{long}_").replace("const real ", "const real\n    ").replace(" = ", " =\n    ", 1)
        for line in statements
    ]
    functions, calls = parts.cut("f", "real", statements, ARGUMENTS)
    longer, same = parts.cut("f", "real", told, ARGUMENTS)
    assert calls == same
    assert [len(one.statements) for one in functions] == [len(one.statements) for one in longer]
