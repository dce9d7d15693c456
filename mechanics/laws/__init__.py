"""Laws of motion: of drives, by finite differences, as transfer functions."""
