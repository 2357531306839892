"""The page of a report: charts to point at, tables, sentences."""
