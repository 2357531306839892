"""Expressions as a graph in which every subexpression stands once."""
