"""Structure of mechanisms: pairs, loops, groups, and what is really free to move."""
