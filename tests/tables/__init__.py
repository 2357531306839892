"""Tables: values, motions under them, and what is refused."""
