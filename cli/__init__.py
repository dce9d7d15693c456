"""The grubler command."""
