"""From the terms of the equations to the text of C files."""
