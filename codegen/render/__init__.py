"""Rendering of a program to text by templates."""
