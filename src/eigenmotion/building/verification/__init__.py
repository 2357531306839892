"""A build proves itself: its System against the user's own expressions, before anything is kept (docs/proof.md)."""

from .verdict import ProofError as ProofError
from .verdict import prove as prove
from .verdict import prove_methods as prove_methods
