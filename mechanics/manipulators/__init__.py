"""Serial chains, in the plane and by Denavit-Hartenberg, forwards and backwards."""
