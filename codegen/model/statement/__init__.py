"""What a user states: coordinates, events, contacts, constraint rows, a drawing; each in one form."""
