"""Accuracy: how far small errors of what moves a mechanism carry its point."""
