"""Problems of the papers, a file each."""
