"""Parts of a model as users state them, normalised: events, contacts, constraint rows, states, drawings."""
