"""What a run checks of itself: singularities, drift, and how it ends where it fails."""
