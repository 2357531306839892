"""`eigenmotion cache`."""

import click

from eigenmotion.building.cache import clear, contents, location


@click.command("cache")
@click.option("--clear", "emptied", is_flag=True, help="Remove what it holds; builds under way keep theirs.")
def command(emptied: bool) -> None:
    """Show where compiled models are kept, and how much room they take.

    What is removed is made again when it is asked for. $EIGENMOTION_CACHE names another folder.
    """
    held = clear() if emptied else contents()
    click.echo(location())
    for kind, sizes in held.items():
        count = f"{len(sizes)} {'entry' if len(sizes) == 1 else 'entries'}"
        click.echo(f"  {kind:<9} {count:>13} {sum(sizes) / 1e6:>9.2f} MB{' removed' if emptied else ''}")
