"""Soil that moves: published laws and exact answers."""
