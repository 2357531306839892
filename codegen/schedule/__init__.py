"""From expressions of the graph to statements in an order."""
