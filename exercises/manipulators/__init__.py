"""Manipulators: Denavit-Hartenberg matrices, position and motion of open chains."""
