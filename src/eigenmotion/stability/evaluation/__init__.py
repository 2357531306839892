"""Every run of every case, and what becomes of it."""
