"""Models with trees of bodies against the same mechanisms written as energies, and their build's proof."""

import numpy as np
import pytest
import sympy
from eigenmotion.codegen.equations.derive import derive
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from tests.support.random_trees import RandomTree

t = em.t


def spring_pendulum():
    """A rod on a slider, with a spring at its tip and friction in its pin, as a tree and as energies."""
    m, l, k, M, g = symbols("m l k M g", positive=True)
    tree = em.Tree(gravity=(0, 0, -g))
    cart = tree.body("cart", joint="prismatic", axis="x", mass=M)
    rod = tree.body(
        "rod", cart, joint="revolute", axis="y", mass=m, center=(0, 0, -l / 2), inertia=(0, m * l**2 / 12, 0)
    )
    x, q = tree.coordinates
    tip = rod.position((0, 0, -l))
    values = {m: 1.3, l: 0.7, k: 40.0, M: 2.0, g: 9.81}
    rest = {"parameters": values, "initial": {q: 0.8, x.diff(): 0.3}, "forces": {q: -q.diff() / 20}}
    made = em.Model(name="spring_tree", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy + k * tip[0] ** 2 / 2,
                    outputs={"height": tip[2], "speed": rod.velocity((0, 0, -l))[0], "rate": tip[0].diff(t),
                             "turn": rod.rotation[0, 2], "spin": rod.angular_velocity[1]}, **rest)  # fmt: skip
    centre, end = sympy.Matrix([x - l / 2 * sin(q), -l / 2 * cos(q)]), sympy.Matrix([x - l * sin(q), -l * cos(q)])
    v = centre.diff(t)
    by_hand = em.Model(name="spring_energies", coordinates=tree.coordinates,
                       kinetic_energy=M * x.diff() ** 2 / 2 + m * v.dot(v) / 2 + m * l**2 * q.diff() ** 2 / 24,
                       potential_energy=m * g * centre[1] + k * end[0] ** 2 / 2,
                       outputs={"height": end[1], "speed": end[0].diff(t), "rate": end[0].diff(t), "turn": sin(q),
                                "spin": q.diff()}, **rest)  # fmt: skip
    return made, by_hand


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange", "inverse", "articulated_body"])
def test_a_tree_moves_as_its_energies_say(formulation):
    tree, energies = spring_pendulum()
    made, by_hand = em.build(tree, formulation=formulation), em.build(energies)
    at = np.linspace(0.0, 3.0, 31)
    first, second = (em.simulate(one, (0, 3), t_eval=at, rtol=1e-11, atol=1e-12) for one in (made, by_hand))
    assert np.abs(first.x - second.x).max() < 1e-9
    assert np.abs(first.energy - second.energy).max() < 1e-9
    for name in ("height", "speed", "rate", "turn", "spin"):
        assert np.abs(first.outputs[name] - second.outputs[name]).max() < 1e-9


@pytest.mark.parametrize("seed", [3, 5, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(6, 40))])
def test_builds_of_random_trees_are_proved(seed):
    """The proof compares M, forces, energies and outputs with forward kinematics; a mass at the end of each branch."""
    made = RandomTree(seed, moments=seed % 2 == 1)
    tree, last = made.tree, made.bodies[-1]
    for body in made.bodies:
        tree.body(f"load of {body.name}", body, joint="fixed", at=(0.2, 0.1, 0), mass=0.7, inertia=(0.1, 0.2, 0.15))
    model = em.Model(name=f"tree{seed}", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=tree.potential_energy, parameters=made.parameters,
                     outputs={"x": last.position((1, 2, 3))[0], "v": last.velocity((1, 2, 3))[1]})  # fmt: skip
    system = em.build(model)
    x, v = np.full(system.n, 0.2), np.full(system.n, 0.3)
    start = em.simulate(system, (0, 0.2), x0=x, v0=v, rtol=1e-10)
    assert start.success
    assert np.ptp(start.energy) < 1e-7 * max(1.0, np.abs(start.energy).max())


def test_a_free_body_keeps_its_angular_momentum():
    tree = em.Tree(gravity=(0, 0, 0))
    body = tree.body("box", joint="free", mass=2.0, center=(0.1, 0, 0), inertia=(1.0, 2.0, 2.5))
    R, w = body.rotation, body.angular_velocity
    J = R * sympy.diag(1.0, 2.0, 2.5) * R.T
    c, vc = body.position((0.1, 0, 0)), body.velocity((0.1, 0, 0))
    L = J * w + 2.0 * c.cross(vc)
    model = em.Model(name="box", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     initial={q.diff(): rate for q, rate in zip(tree.coordinates, (1, 0, 0, 0.1, 0.4, 0), strict=True)},
                     outputs={f"L{k}": L[k] for k in range(3)} | {f"P{k}": 2.0 * vc[k] for k in range(3)})  # fmt: skip
    run = em.simulate(em.build(model), (0, 3), rtol=1e-11, atol=1e-13)
    for name in model.outputs:
        assert np.ptp(run.outputs[name[0]]) < 1e-9
    assert np.ptp(run.energy) < 1e-9


@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange", "articulated_body"])
def test_the_place_of_a_closed_loop_is_a_constraint(formulation):
    """A four-bar: two rods on the ground and a coupler, whose end is held at the second rod."""
    tree = em.Tree(gravity=(0, -9.81, 0))
    rod = {"joint": "revolute", "axis": "z", "mass": 1.0, "inertia": (0, 0, 0.02)}
    crank = tree.body("crank", center=(0.15, 0, 0), **rod)
    coupler = tree.body("coupler", crank, at=(0.3, 0, 0), center=(0.4, 0, 0), **rod)
    rocker = tree.body("rocker", at=(0.7, 0, 0), center=(0.3, 0, 0), **rod)
    gap = (coupler.position((0.8, 0, 0)) - rocker.position((0.6, 0, 0)))[:2]
    a, b, c = tree.coordinates
    fourbar = em.Model(name="fourbar_tree", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                       potential_energy=tree.potential_energy, holonomic_constraints={"pin": gap},
                       initial={a: 1.0, b: -0.6, c: 1.5, a.diff(): 2.0})  # fmt: skip
    by_hand_gap = [0.3 * cos(a) + 0.8 * cos(a + b) - 0.7 - 0.6 * cos(c), 0.3 * sin(a) + 0.8 * sin(a + b) - 0.6 * sin(c)]
    places = [sympy.Matrix([0.15 * cos(a), 0.15 * sin(a)]),
              sympy.Matrix([0.3 * cos(a) + 0.4 * cos(a + b), 0.3 * sin(a) + 0.4 * sin(a + b)]),
              sympy.Matrix([0.7 + 0.3 * cos(c), 0.3 * sin(c)])]  # fmt: skip
    T = sum(p.diff(t).dot(p.diff(t)) / 2 for p in places)
    T += 0.01 * (a.diff() ** 2 + (a + b).diff(t) ** 2 + c.diff() ** 2)
    by_hand = em.Model(name="fourbar_energies", coordinates=tree.coordinates, kinetic_energy=T,
                       potential_energy=9.81 * sum(p[1] for p in places), holonomic_constraints={"pin": by_hand_gap},
                       initial=dict(fourbar.initial))  # fmt: skip
    systems = [em.build(fourbar, formulation=formulation), em.build(by_hand)]
    starts = [em.assemble(system) for system in systems]
    at = np.linspace(0.0, 2.0, 21)
    first, second = (em.simulate(system, (0, 2), x0=start[0], v0=start[1], t_eval=at, rtol=1e-11, atol=1e-12)
                     for system, start in zip(systems, starts, strict=True))  # fmt: skip
    assert np.abs(first.x - second.x).max() < 1e-8
    assert np.abs(first.multipliers - second.multipliers).max() < 1e-6


@pytest.mark.parametrize(("change", "words"), [
    ({"joint": "ball"}, "joint is 'ball'. Give one of fixed, revolute"),
    ({"name": "first"}, "has a body of this name"),
    ({"parent": "frist"}, "Did you mean 'first'?"),
    ({"axis": (0, 0, 0)}, "its axis is zero"),
    ({"rotation": [[1, 0, 0], [0, 1, 0], [0, 1, 1]]}, "rotation is no rotation"),
    ({"rotation": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}, "determinant is -1"),
    ({"inertia": [[1, 2, 0], [0, 1, 0], [0, 0, 1]]}, "not symmetric"),
    ({"at": (1, 2)}, "has 2 entries. Give 3"),
    ({"coordinates": [symbols("q")]}, "a function of time"),
    ({"center": (1, 0, 0), "moment": (1, 0, 0)}, "it has a center and a moment"),
])  # fmt: skip
def test_mistakes_are_named(change, words):
    tree = em.Tree()
    tree.body("first", joint="revolute", mass=1.0)
    arguments = {"name": "second", "parent": "first", "joint": "revolute"} | change
    with pytest.raises(em.ModelError, match=words.replace("(", r"\(").replace(")", r"\)").replace("?", r"\?")):
        tree.body(**arguments)


def test_an_inertia_is_a_tuple_an_array_or_a_matrix():
    entries = [1.0, 2.0, 3.0]
    given = (tuple(entries), np.array(entries), np.diag(entries), sympy.diag(*entries), (1.0, 0, 0, 2.0, 0, 3.0))
    tree = em.Tree()
    for number, inertia in enumerate(given):
        body = tree.body(f"b{number}", joint="revolute", inertia=inertia)
        assert body.link.inertia == (1, 0, 0, 2, 0, 3)


def test_articulated_bodies_take_rotors_and_coordinates_beside_trees():
    """A motor's rotor, a mass outside the tree, a state, friction in a joint: against Lagrange's equations."""
    tree = em.Tree()
    arm = tree.body("arm", joint="revolute", axis="y", mass=1.0, center=(0.2, 0, 0), inertia=(0.01, 0.02, 0.02))
    hand = {"mass": 0.5, "center": (0, 0, -0.1), "inertia": (0.01, 0.01, 0.005)}
    tree.body("hand", arm, joint="spherical", at=(0.4, 0, 0), **hand)
    cart, current = dynamicsymbols("cart current")
    q, *s = tree.coordinates
    spring = 15 * (cart - arm.position((0.4, 0, 0))[0]) ** 2
    model = em.Model(
        name="rotor", coordinates=[*tree.coordinates, cart],
        kinetic_energy=tree.kinetic_energy + q.diff() ** 2 / 20 + 0.7 * cart.diff() ** 2,
        potential_energy=tree.potential_energy + spring, forces={q: 0.3 * current - 0.1 * q.diff()},
        states={current: 2 - current - q.diff()}, initial={q: 0.5, s[0]: 0.2},
    )  # fmt: skip
    runs = [
        em.simulate(em.build(model, formulation=one), (0, 2), t_eval=[1.0, 2.0], rtol=1e-11, atol=1e-12)
        for one in ("lagrange", "articulated_body")
    ]
    assert np.abs(runs[0].x - runs[1].x).max() < 1e-9
    assert np.abs(runs[0].v - runs[1].v).max() < 1e-9


def test_articulated_bodies_refuse_what_they_cannot_take():
    tree = em.Tree()
    one = tree.body("one", joint="revolute", mass=1.0, center=(1, 0, 0))
    tree.body("light", one, joint="revolute")
    a, b = tree.coordinates

    def built(T, coordinates=(a, b)):
        model = em.Model(name="refused", coordinates=coordinates, kinetic_energy=T)
        return em.build(model, formulation="articulated_body")

    with pytest.raises(em.ModelError, match="couples one and light"):
        built(tree.kinetic_energy + (a + b).diff(t) ** 2)
    with pytest.raises(em.ModelError, match="'light' moves no mass"):
        built(tree.kinetic_energy)
    with pytest.raises(em.ModelError, match="for masses in trees of bodies"):
        built(a.diff() ** 2 + b.diff() ** 2)


def test_a_free_body_lands_on_the_ground():
    """A contact at a point of a body: rest at the ground, its force the weight, while the body slides on and turns."""
    tree = em.Tree()
    ball = tree.body("ball", joint="free", mass=2.0, inertia=(0.1, 0.1, 0.1))
    x, _, z, *s = tree.coordinates
    model = em.Model(name="ball_of_bodies", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=tree.potential_energy, contacts={"ground": em.Contact(ball.position()[2] - 0.2)},
                     outputs={"force": -em.multiplier("ground")},
                     initial={z: 1.2, x.diff(): 1.0, s[1].diff(): 0.3})  # fmt: skip
    run = em.simulate(em.build(model), (0, 2), t_eval=[0.25, 1.0, 2.0], rtol=1e-10, atol=1e-12)
    assert np.abs(run.x[0] - [0.25, 1.0, 2.0]).max() < 1e-9
    assert np.abs(run.x[2] - [1.2 - 9.81 * 0.25**2 / 2, 0.2, 0.2]).max() < 1e-9
    assert np.abs(run.outputs["force"] - [0.0, 2 * 9.81, 2 * 9.81]).max() < 1e-8
    assert np.abs(run.x[4] - np.tan(0.3 * np.array([0.25, 1.0, 2.0]))).max() < 1e-8


def test_a_joint_that_another_drives_follows_it():
    """A crank lifts a rack by a pinion of radius r: T and V by hand, with the rack at r q + h."""
    J, M, r, h, g = symbols("J M r h g", positive=True)
    tree = em.Tree(gravity=(0, 0, -g))
    crank = tree.body("crank", joint="revolute", axis="y", inertia=(0, J, 0))
    (q,) = tree.coordinates
    rack = tree.body("rack", joint="prismatic", axis="z", mass=M, coordinates=[r * q + h])
    assert tree.coordinates == (q,) == crank.coordinates == rack.coordinates
    values = {J: 0.3, M: 2.0, r: 0.25, h: 0.4, g: 9.81}
    model = em.Model(name="rack", coordinates=[q], kinetic_energy=tree.kinetic_energy, parameters=values,
                     potential_energy=tree.potential_energy, outputs={"z": rack.position()[2],
                     "v": rack.velocity()[2]}, initial={q.diff(): 3.0})  # fmt: skip
    run = em.simulate(em.build(model), (0, 1), t_eval=np.linspace(0, 1, 5), rtol=1e-11, atol=1e-12)
    a = -2.0 * 0.25 * 9.81 / (0.3 + 2.0 * 0.25**2)
    turned = 3.0 * run.t + a * run.t**2 / 2
    assert np.abs(run.x[0] - turned).max() < 1e-10
    assert np.abs(run.outputs["z"] - (0.25 * turned + 0.4)).max() < 1e-10
    assert np.abs(run.outputs["v"] - 0.25 * (3.0 + a * run.t)).max() < 1e-10


def test_right_angles_in_floating_point_are_proved():
    """The cosine of a right angle is 6e-17 in a rotation; at the place 0 of all coordinates nothing else is left."""
    c, s = np.cos(np.pi / 2), np.sin(np.pi / 2)
    tree = em.Tree()
    arm = tree.body("arm", joint="revolute", rotation=[[1, 0, 0], [0, c, -s], [0, s, c]], at=(0, 0, 0.3))
    hand = tree.body("hand", arm, joint="revolute", rotation=[[1, 0, 0], [0, c, s], [0, -s, c]], at=(0, -0.3, 0),
                     mass=1.0, center=(0.1, 0, 0), inertia=(0.01, 0.02, 0.02))  # fmt: skip
    model = em.Model(name="angles", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     outputs={"y": hand.position()[1]})  # fmt: skip
    system = em.build(model, formulation="lagrange")
    assert system.n == 2


def test_a_rotation_contains_roots():
    """Half of a right angle about z, as SymPy writes it, and with numbers."""
    root, number = sympy.sqrt(2) / 2, 0.5**0.5
    places = []
    for one in (root, number):
        body = em.Tree().body("one", joint="fixed", rotation=[[one, -one, 0], [one, one, 0], [0, 0, 1]])
        places.append(np.array(body.position((1, 2, 3)), dtype=float).ravel())
    np.testing.assert_allclose(places[0], [-number, 3 * number, 3], rtol=1e-15)
    np.testing.assert_allclose(places[1], places[0], rtol=1e-15)


def test_what_drives_a_joint_is_checked():
    tree = em.Tree()
    x = tree.body("arm", joint="revolute").coordinates[0]
    for wrong in (x**2, x.diff(), t * x, 3, x + sympy.Function("y")(t)):
        with pytest.raises(em.ModelError, match="k q"):
            tree.body("hand", joint="revolute", coordinates=[wrong])
    with pytest.raises(em.ModelError, match="not driven"):
        tree.body("hand", joint="spherical", coordinates=[2 * x, x, x])
    tree.body("hand", joint="planar")
    with pytest.raises(em.ModelError, match="another body has the coordinate"):
        tree.body("hand_1", joint="revolute")


def test_bodies_fixed_to_the_ground_are_at_numbers():
    tree = em.Tree()
    foot = tree.body("foot", joint="fixed", at=(1, 2, 3), rotation=[[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    assert list(foot.position((1, 0, 0))) == [1, 3, 3]
    assert list(foot.velocity()) == [0, 0, 0]
    assert foot.rotation == sympy.ImmutableDenseMatrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]])


MASSLESS = {
    "empty": {"joint": "revolute", "axis": (1, 2, 3)},
    "on its axis": {"joint": "revolute", "axis": (1, 2, 3), "mass": 1.0, "center": (0.1, 0.2, 0.3)},
    "a point": {"joint": "spherical", "mass": 1.0, "center": (0.1, 0.2, 0.3)},
}


@pytest.mark.parametrize("kind", MASSLESS)
def test_a_joint_that_moves_no_mass_is_named(kind):
    tree = em.Tree()
    tree.body("arm", joint="revolute", axis="y", mass=1.0, center=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    tree.body("tip", "arm", at=(0, 0.3, -1), **MASSLESS[kind])
    model = em.Model(name="massless", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy)
    with pytest.raises(em.ModelError, match=r"'tip.*' moves no mass"):
        derive(model)
    rotors = sum(q.diff() ** 2 for q in tree.coordinates[1:]) / 20
    geared = em.Model(name="geared", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy + rotors)
    assert derive(geared).trees is not None


def test_a_build_at_a_symmetric_start_is_proved():
    """A factor of a row is zero there; by recursion it is rounding, in proportion to the other factors of the row."""
    tree, turn = em.Tree(), {"joint": "revolute", "axis": "y"}
    trunk = tree.body("trunk", joint="free", mass=12.0, inertia=(0.12, 0.4, 0.5))
    thigh = tree.body(
        "hip", trunk, at=(0.25, 0.15, 0), mass=1.0, center=(0, 0, -0.1), inertia=(0.006, 0.006, 0.001), **turn
    )
    shank = tree.body("knee", thigh, at=(0, 0, -0.25), mass=0.3, inertia=(0.002, 0.002, 0.001), **turn)
    model = em.Model(name="symmetric_start", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     nonholonomic_constraints=list(shank.velocity((0, 0, -0.25))[:2]),
                     initial={tree.coordinates[6]: 0.6, tree.coordinates[7]: -1.2})  # fmt: skip
    A, _ = em.build(model, formulation="lagrange").pfaffian(model.initial_x)
    assert abs(A[0, 3]) < 1e-15
    assert A[0, 6] == pytest.approx(-0.5 * np.cos(0.6))


def test_a_parameter_of_a_body_is_replaced_in_an_expression():
    """A place with another length is that of a body of this length."""
    l, k = symbols("l k", positive=True)
    tree = em.Tree(gravity=(0, 0, 0))
    rod = tree.body("rod", joint="revolute", axis="z", mass=1.0, inertia=(0, 0, 1.0))
    tip = tree.body("tip", rod, joint="fixed", at=(l, 0, 0), mass=0)
    place = tip.position()[0]
    (q,) = tree.coordinates
    model = em.Model(name="replaced", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=0, parameters={l: 2.0, k: 3.0}, initial={q: 0.5},
                     outputs={"as stated": place, "k": place.subs(l, k), "twice": place.subs(l, 2 * l),
                              "k + l": place.subs(l, k + l), "slope": place.diff(l).subs(l, k)})  # fmt: skip
    values = em.build(model).simulate((0, 0.1)).outputs
    for name, length in {"as stated": 2.0, "k": 3.0, "twice": 4.0, "k + l": 5.0, "slope": 1.0}.items():
        assert values[name][0] == pytest.approx(length * np.cos(0.5), rel=1e-14)


def test_trees_are_articulated_bodies_unless_another_mass_couples():
    """The default formulation; a formulation that is asked for is taken."""
    tree = em.Tree()
    for name in "ab":
        tree.body(name, joint="prismatic", axis="x", mass=1.0)
    a, b = (q.diff() for q in tree.coordinates)

    def formulation(T, **options):
        model = em.Model(name="two", coordinates=tree.coordinates, kinetic_energy=T, potential_energy=0)
        return em.build(model, **options).formulation

    assert formulation(tree.kinetic_energy + a**2 + b**2) == "articulated_body"
    assert formulation(tree.kinetic_energy + (a + b) ** 2) == "eigenfactor"
    assert formulation(a**2 + b**2) == "eigenfactor"
    assert formulation(tree.kinetic_energy, formulation="eigenfactor") == "eigenfactor"


def test_jacobians_of_articulated_bodies_are_slopes_of_their_right_hand_side():
    made, energies = spring_pendulum()
    tree, other = em.build(made, formulation="articulated_body"), em.build(energies, formulation="lagrange")
    y = [0.2, 0.7, -0.4, 1.3]
    np.testing.assert_allclose(tree.jacobian(0.0, y), other.jacobian(0.0, y), rtol=1e-12, atol=1e-12)
