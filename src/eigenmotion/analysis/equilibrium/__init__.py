"""States in which a mechanism stays, and closed loops from rough guesses."""
