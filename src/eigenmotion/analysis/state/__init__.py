"""A mechanism at one state: its derivatives, the contacts that are active, the directions it can take."""
