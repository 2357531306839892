"""`eigenmotion cache`."""

import click

from eigenmotion.building.cache import clear, contents, location


@click.command("cache")
@click.option("--clear", "emptied", is_flag=True, help="Empty the cache; entries of running builds are kept.")
def command(emptied: bool) -> None:
    """Show the cache of compiled models: its folder and its size.

    Removed models are compiled again when needed. $EIGENMOTION_CACHE names another folder.
    """
    sizes_by_kind = clear() if emptied else contents()
    click.echo(location())
    for kind, sizes in sizes_by_kind.items():
        count = f"{len(sizes)} {'entry' if len(sizes) == 1 else 'entries'}"
        click.echo(f"  {kind:<9} {count:>13} {sum(sizes) / 1e6:>9.2f} MB{' removed' if emptied else ''}")
