"""Many runs of one system as one call."""
