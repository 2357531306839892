"""Expression graph: a directed acyclic graph (DAG) in which every subexpression is stored once."""
