"""The matrix in words, pictures and files."""
