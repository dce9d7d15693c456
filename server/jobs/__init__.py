"""Jobs: long work in batches, by an engine in the server or by workers on any number of hosts."""
