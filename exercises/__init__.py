"""The catalogue of exercises and the machinery that serves and grades them."""
