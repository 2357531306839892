"""Building blocks of pictures, tables and pages, independent of any model."""
