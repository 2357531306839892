"""Tests, in folders as the product's rooms; `support` is shared, `oracles` shares nothing with the package."""
