"""Structure and mobility: pairs, loops, groups, passive constraints."""
