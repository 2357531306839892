"""Compilers, the cache, parts compiled on demand, and the proof of a build."""
