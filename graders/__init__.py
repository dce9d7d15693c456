"""The answer language, units and the judges of one answer."""
