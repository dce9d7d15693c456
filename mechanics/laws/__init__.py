"""How drives move, and how what they move follows."""
