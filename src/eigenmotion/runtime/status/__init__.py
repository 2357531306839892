"""Messages about how calls and runs end."""
