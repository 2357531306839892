"""Rules that sources keep: dependencies, lengths, what the architecture names."""
