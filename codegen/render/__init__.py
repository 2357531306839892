"""From the record to text, through the templates."""
