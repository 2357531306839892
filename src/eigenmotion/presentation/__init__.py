"""Parts of pictures, tables and pages; they know no model."""
