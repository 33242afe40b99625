"""The papers' printed figures, each beside ours and beside a second method's: a file a paper."""
