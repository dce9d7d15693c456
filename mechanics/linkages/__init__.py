"""Planar linkages: closed forms, and any mechanism as bodies and joints by Newton's method."""
