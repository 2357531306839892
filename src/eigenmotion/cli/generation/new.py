"""`eigenmotion new`."""

import re
from importlib.resources import files
from pathlib import Path

import click

from eigenmotion.codegen.model import ModelError
from eigenmotion.codegen.model.check.checks import check_name
from eigenmotion.files import write

from ..options import check_writable

TEMPLATES = {"pendulum": "pendulum", "arm": "spatial_arm", "rolling": "rolling_disk", "loop": "four_bar"}
"""Name of a template -> the model that it copies."""


@click.command("new")
@click.argument("name")
@click.option("--template", type=click.Choice(list(TEMPLATES)), default="pendulum", show_default=True,
              help="A swinging mass, links in space, rolling without slip, or a closed loop.")  # fmt: skip
def command(name: str, template: str) -> None:
    """Write NAME.py, a complete model to start from."""
    check_name(name)
    target = Path(f"{name}.py")
    if target.exists():
        raise ModelError(f"{target} is there already, and stays as it is. Choose another name.")
    check_writable(Path.cwd(), "NAME")
    write(target, model_file(name, TEMPLATES[template]).encode())
    click.echo(f"wrote {target}. Next: eigenmotion run {target}; eigenmotion page {target}")


def model_file(name: str, template: str) -> str:
    """Return one of the package's models under another name, without the lines about its tests."""
    text = files("eigenmotion.models").joinpath(f"{template}.py").read_text(encoding="utf-8")
    text = re.sub(r"\nOracles?: .*?(?=\"\"\")", "", text, count=1, flags=re.DOTALL)
    return re.sub(rf'name=(f?)"{template}', rf'name=\1"{name}', text, count=1)
