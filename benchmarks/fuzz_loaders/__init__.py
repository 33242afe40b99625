"""Hostile files for every loader: whole files of ours, spoilt where their structure allows, and signed again.

What a loader may do with one is to take it or to raise the project's error, in 20 s and 1 GB.
"""
