"""The laboratory: what measures, tabulates and draws plants; a module for each command of `isochron` that it has."""
