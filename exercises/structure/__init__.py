"""Structure of mechanisms: mobility, loops, structural groups."""
