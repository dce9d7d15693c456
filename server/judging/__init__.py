"""Where exercises are computed: beside the thread that answers requests."""
