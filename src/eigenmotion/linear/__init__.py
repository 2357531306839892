"""What deviations from a motion obey, and where mechanisms rest."""
