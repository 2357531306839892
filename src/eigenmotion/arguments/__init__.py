"""What users hand over, checked: names and arrays, inputs, options and methods of a run."""
