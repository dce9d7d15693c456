"""Marks: the gradebook, marks by hand, their export, and what the answers of a class tell."""
