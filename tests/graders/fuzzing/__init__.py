"""Texts to attack the reader and the judges with, and what is done with each."""
