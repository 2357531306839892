"""The record that templates print, and how it is made."""
