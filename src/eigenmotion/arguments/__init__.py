"""What users hand over, checked: names and arrays, inputs, options of a run."""
