"""Solutions: fields, pictures, pickles."""
