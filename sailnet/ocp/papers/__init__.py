"""Every figure that the papers print, beside ours and an independent second method's."""
