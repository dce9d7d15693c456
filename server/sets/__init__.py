"""Task sets: their rules, dealing and publishing, handing in, building."""
