"""Proof of a build: check of the compiled model against the user's expressions, before it is cached (docs/proof.md)."""

from .verdict import ProofError as ProofError
from .verdict import prove as prove
from .verdict import prove_methods as prove_methods
