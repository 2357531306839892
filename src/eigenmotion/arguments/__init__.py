"""Arguments of users, checked: names and arrays, inputs, options and methods of a run."""
