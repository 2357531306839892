"""C text that solves M a + A^T lambda = b, A a = b' without operations on structural zeros.

The whole symmetric matrix is factored as L D L^T: coordinates from the last to the first, which fills nothing in in
trees, then the rows of constraints, whose pivots are negative.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Elimination:
    """The order of elimination, and the nonzero places of L.

    order : numbers of coordinates and rows; below : for each, those behind it in the order whose L is not zero
    """

    n: int
    order: tuple[int, ...]
    below: tuple[tuple[int, ...], ...]
    entries: tuple[tuple[int, int], ...]

    def factors(self) -> Iterator[str]:
        """Yield statements that declare L and the reciprocals r of D from K; they return 1 at a pivot that vanishes."""
        place = {tuple(sorted(pair)): k for k, pair in enumerate(self.entries)}
        before: dict[int, list[int]] = {i: [] for i in self.order}
        for j, below in zip(self.order, self.below, strict=True):
            inner = "".join(f" - w_{j}_{k}*L_{j}_{k}" for k in before[j])
            diagonal = f"K[{place[j, j]}]" if (j, j) in place else "0.0"
            yield f"const double d_{j} = {diagonal}{inner};"
            if j < self.n:
                yield f"if (!(d_{j} > EM_SINGULAR_PIVOT*{diagonal})) return 1;"
            else:
                size = " + ".join(f"w_{j}_{k}*L_{j}_{k}" for k in before[j] if k < self.n) or "0.0"
                yield f"if (!(-d_{j} > EM_SINGULAR_PIVOT*({size}))) return 1;"
            yield f"const double r_{j} = 1.0/d_{j};"
            for i in below:
                pair = (min(i, j), max(i, j))
                products = "".join(f" - w_{i}_{k}*L_{j}_{k}" for k in before[j] if k in before[i])
                yield f"const double w_{i}_{j} = {f'K[{place[pair]}]' if pair in place else '0.0'}{products};"
                yield f"const double L_{i}_{j} = w_{i}_{j}*r_{j};"
            for i in below:
                before[i].append(j)

    def vector(self) -> Iterator[str]:
        """Yield statements that replace b by the solution."""
        for j, below in zip(self.order, self.below, strict=True):
            yield from (f"b[{i}] -= L_{i}_{j}*b[{j}];" for i in below)
        for j, below in zip(reversed(self.order), reversed(self.below), strict=True):
            yield f"b[{j}] = b[{j}]*r_{j}{''.join(f' - L_{i}_{j}*b[{i}]' for i in below)};"

    def columns(self, name: str, width: int, rows: Iterable[int]) -> Iterator[str]:
        """Yield statements that replace the columns of a matrix (n + m, width) by minus the solutions.

        rows : those that are not zero at first
        """
        filled = set(rows)
        for j, below in zip(self.order, self.below, strict=True):
            if j in filled:
                filled.update(below)
                yield from (
                    f"em_add_row({width}, -L_{i}_{j}, {name} + {j * width}, {name} + {i * width});" for i in below
                )
        for j, below in zip(reversed(self.order), reversed(self.below), strict=True):
            if j in filled:
                yield f"em_scale_row({width}, -r_{j}, {name} + {j * width});"
            behind = [i for i in below if i in filled]
            yield from (f"em_add_row({width}, -L_{i}_{j}, {name} + {i * width}, {name} + {j * width});" for i in behind)
            if behind:
                filled.add(j)


def elimination(n: int, m: int, entries: tuple[tuple[int, int], ...]) -> Elimination:
    """Return the elimination of a system of n coordinates and m rows with these entries in its lower triangle."""
    order = (*reversed(range(n)), *range(n, n + m))
    neighbours: dict[int, set[int]] = {i: set() for i in order}
    for i, j in entries:
        neighbours[i].add(j)
        neighbours[j].add(i)
    below = []
    for k, j in enumerate(order):
        behind = [i for i in order[k + 1 :] if i in neighbours[j]]
        below.append(tuple(behind))
        for i in behind:
            neighbours[i].update(one for one in behind if one != i)
    return Elimination(n, order, tuple(below), entries)
