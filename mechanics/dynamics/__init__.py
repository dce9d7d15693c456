"""Forces in moving machines: kinetostatics, reduction, balancing, vibration."""
