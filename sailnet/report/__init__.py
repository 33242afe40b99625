"""The report: Section 5 of the paper flown with what was trained, beside the paper's figures."""
