"""Tests: one file per stage, and the oracles they trust."""
