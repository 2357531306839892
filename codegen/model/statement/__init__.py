"""Parts of a model as users state them: coordinates, events, contacts, constraint rows, a drawing; each in one form."""
