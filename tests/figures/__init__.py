"""Tests of the drawing vocabulary."""
