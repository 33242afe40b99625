"""What papers 000 to 004 print, beside ours and a second method's: figures, tables and a page."""
