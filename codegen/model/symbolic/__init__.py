"""The equations of a model in SymPy; nothing compiled comes of them."""
