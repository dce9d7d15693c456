"""Denavit-Hartenberg tables as answers: their frames beside the true motion of the links, and what is off in them."""
